//! What the vector paths have in common.

/// Products summed in the registers of some target features: the type `$name`.
///
/// `$load` takes a pointer, `$fmadd` is `a b + c` and `$sum` adds the lanes of a register.
macro_rules! vector_path {
    (
        $name:ident: $features:literal,
        register: $register:ty = $lanes:literal lanes,
        operations: $zero:ident, $load:ident, $fmadd:ident, $sum:ident $(,)?
    ) => {
        use super::{Products, TILE};

        /// To be named only in code that is compiled for the features.
        pub(in crate::machine) struct $name;

        impl Products for $name {
            #[inline(always)]
            fn tile<const LENGTH: usize>(
                columns: &[[f64; LENGTH]],
                left: usize,
                right: usize,
            ) -> [[f64; TILE]; TILE] {
                // SAFETY: the type is named only where the features are there.
                unsafe { tile(columns, left, right) }
            }
        }

        // Loops, as the functions that take closures would not be compiled for the features.
        #[inline]
        #[target_feature(enable = $features)]
        fn tile<const LENGTH: usize>(
            columns: &[[f64; LENGTH]],
            left: usize,
            right: usize,
        ) -> [[f64; TILE]; TILE] {
            let mut sums = [[$zero(); TILE]; TILE];
            for start in (0..LENGTH).step_by($lanes) {
                let mut b = [$zero(); TILE];
                for (j, b) in b.iter_mut().enumerate() {
                    *b = load(&columns[right + j], start);
                }
                for (i, row) in sums.iter_mut().enumerate() {
                    let a = load(&columns[left + i], start);
                    for (sum, b) in row.iter_mut().zip(b) {
                        *sum = $fmadd(a, b, *sum);
                    }
                }
            }
            let mut products = [[0.0; TILE]; TILE];
            for (row, sums) in products.iter_mut().zip(sums) {
                for (product, sum) in row.iter_mut().zip(sums) {
                    *product = $sum(sum);
                }
            }
            products
        }

        #[inline]
        #[target_feature(enable = $features)]
        fn load(column: &[f64], start: usize) -> $register {
            let lanes = &column[start..start + $lanes];
            // SAFETY: the slice holds as many values as are read; they need no alignment.
            unsafe { $load(lanes.as_ptr()) }
        }
    };
}

pub(super) use vector_path;
