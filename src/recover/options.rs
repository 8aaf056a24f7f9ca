//! What a caller may choose about a fit.

use std::num::NonZeroUsize;

/// Options of [`fit`](super::fit).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FitOptions {
    /// Seed of the choice of the points that the first, coarse fits look at.
    pub seed: u64,
    /// Threads to use; by default as many as the machine offers. The result's bytes do not
    /// depend on it.
    pub threads: Option<NonZeroUsize>,
}
