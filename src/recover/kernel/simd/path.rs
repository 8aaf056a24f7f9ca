//! What the vector paths have in common.

/// The pass compiled for some target features, with products summed in that set's registers.
///
/// `$load` takes a pointer, `$fmadd` is `a b + c` and `$sum` adds the lanes of a register.
macro_rules! vector_path {
    (
        features: $features:literal,
        register: $register:ty = $lanes:literal lanes,
        operations: $zero:ident, $load:ident, $fmadd:ident, $sum:ident $(,)?
    ) => {
        use crate::recover::kernel::gram::{BLOCK, Columns, Gram, TILE, TileProducts};
        use crate::recover::kernel::simd::{distances_of, gram_blocks};
        use crate::recover::kernel::view::ModelView;

        #[target_feature(enable = $features)]
        pub(super) fn gram(view: &ModelView, points: [&[f64]; 3], factors: Option<&[f64]>) -> Gram {
            gram_blocks::<Tile, true>(view, points, factors)
        }

        #[target_feature(enable = $features)]
        pub(super) fn geometric_distances(
            view: &ModelView,
            points: [&[f64]; 3],
            distances: &mut [f64],
        ) {
            distances_of::<true>(view, points, distances);
        }

        struct Tile;

        impl TileProducts for Tile {
            #[inline(always)]
            fn products(columns: &Columns, left: usize, right: usize) -> [[f64; TILE]; TILE] {
                // SAFETY: this type is private to the module and named only in `gram`, which is
                // called only where the features are there.
                unsafe { products(columns, left, right) }
            }
        }

        // Loops, as the functions that take closures would not be compiled for the features.
        #[inline]
        #[target_feature(enable = $features)]
        fn products(columns: &Columns, left: usize, right: usize) -> [[f64; TILE]; TILE] {
            let mut sums = [[$zero(); TILE]; TILE];
            for start in (0..BLOCK).step_by($lanes) {
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
        fn load(column: &[f64; BLOCK], start: usize) -> $register {
            let lanes = &column[start..start + $lanes];
            // SAFETY: the slice holds as many values as are read; they need no alignment.
            unsafe { $load(lanes.as_ptr()) }
        }
    };
}

pub(super) use vector_path;
