//! The choice of instruction set for loops that the compiler turns into vector code.
//!
//! Invariant: the function compiled for a target feature is called only after the processor was
//! found to have that feature.
#![allow(unsafe_code)]

/// Loops to be compiled for each instruction set.
pub(crate) trait Kernel {
    /// What the loops yield.
    type Output;

    /// Runs the loops; `FMA` says whether the target fuses `a b + c`. To be compiled for the
    /// target, it and all that it calls must be `#[inline(always)]`.
    fn run<const FMA: bool>(self) -> Self::Output;
}

/// Runs a kernel by the best path that the processor has.
pub(crate) fn run<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        // SAFETY: the features that the function is compiled for have just been detected.
        return unsafe { run_avx2(kernel) };
    }
    kernel.run::<false>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<true>()
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Sum<'a>(&'a [f64]);

    impl Kernel for Sum<'_> {
        type Output = f64;

        #[inline(always)]
        fn run<const FMA: bool>(self) -> f64 {
            self.0.iter().sum()
        }
    }

    #[test]
    fn a_kernel_gives_the_same_by_every_path() {
        let numbers: Vec<f64> = (0..100).map(f64::from).collect();
        assert_eq!(run(Sum(&numbers)), 4950.0);
        assert_eq!(Sum(&numbers).run::<false>(), 4950.0);
    }
}
