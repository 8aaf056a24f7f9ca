//! Products for processors with AVX2 and FMA.

use std::arch::x86_64::{
    __m256d, _mm256_fmadd_pd, _mm256_loadu_pd, _mm256_setzero_pd, _mm256_storeu_pd,
};

super::path::vector_path! {
    Avx2: "avx2,fma",
    register: __m256d = 4 lanes,
    operations: _mm256_setzero_pd, _mm256_loadu_pd, _mm256_fmadd_pd, horizontal_sum,
}

#[inline]
#[target_feature(enable = "avx2,fma")]
fn horizontal_sum(lanes: __m256d) -> f64 {
    let mut values = [0.0; 4];
    // SAFETY: the array holds as many values as are written; it needs no alignment.
    unsafe { _mm256_storeu_pd(values.as_mut_ptr(), lanes) };
    (values[0] + values[1]) + (values[2] + values[3])
}
