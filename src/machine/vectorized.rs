//! The choice of instruction set for loops that the compiler turns into vector code.

#[cfg(target_arch = "x86_64")]
use super::products::{Avx2, Avx512};
use super::products::{Portable, Products};
use super::{InstructionSet, instruction_set};

/// Loops to be compiled for each instruction set.
pub(crate) trait Kernel {
    /// What the loops yield.
    type Output;

    /// Runs the loops; `FMA` says whether the target fuses `a b + c`, and P sums products in its
    /// registers. To be compiled for the target, it and all that it calls must be
    /// `#[inline(always)]`.
    fn run<const FMA: bool, P: Products>(self) -> Self::Output;
}

/// Runs a kernel by the path of the instruction set in use.
pub(crate) fn run<K: Kernel>(kernel: K) -> K::Output {
    // A wish that cannot be met is an error of the fit, which has asked before.
    run_by(instruction_set().unwrap_or(InstructionSet::Portable), kernel)
}

/// Runs a kernel by the path of an instruction set; by the portable one where the processor lacks
/// the set.
pub(crate) fn run_by<K: Kernel>(set: InstructionSet, kernel: K) -> K::Output {
    match set {
        // SAFETY: the processor has been asked.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx512 if set.is_available() => unsafe { run_avx512(kernel) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx2 if set.is_available() => unsafe { run_avx2(kernel) },
        _ => kernel.run::<false, Portable>(),
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<true, Avx2>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,fma")]
fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<true, Avx512>()
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Sum<'a>(&'a [f64]);

    impl Kernel for Sum<'_> {
        type Output = f64;

        #[inline(always)]
        fn run<const FMA: bool, P: Products>(self) -> f64 {
            self.0.iter().sum()
        }
    }

    #[test]
    fn a_kernel_gives_the_same_by_every_path() {
        let numbers: Vec<f64> = (0..100).map(f64::from).collect();
        assert_eq!(run(Sum(&numbers)), 4950.0);
        for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
            assert_eq!(run_by(set, Sum(&numbers)), 4950.0);
        }
    }
}
