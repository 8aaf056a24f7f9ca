//! Products for processors with AVX-512.

use std::arch::x86_64::{
    __m512d, _mm512_fmadd_pd, _mm512_loadu_pd, _mm512_reduce_add_pd, _mm512_setzero_pd,
};

super::path::vector_path! {
    Avx512: "avx512f,avx512dq,avx512vl,fma",
    register: __m512d = 8 lanes,
    operations: _mm512_setzero_pd, _mm512_loadu_pd, _mm512_fmadd_pd, _mm512_reduce_add_pd,
}
