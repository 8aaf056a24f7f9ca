//! The instruction set that passes use: the best that the processor has, or the one asked for.

use std::sync::OnceLock;

use thiserror::Error;

/// Names the instruction set to use, for comparisons: `portable`, `avx2` or `avx512`.
const VARIABLE: &str = "SUPERQUADRIC_SIMD";

/// What passes over points are compiled for. Results of different sets agree but for rounding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InstructionSet {
    /// What every processor of the target has.
    Portable,
    /// AVX2 and FMA: four numbers at a time.
    Avx2,
    /// AVX-512 F, DQ and VL: eight numbers at a time.
    Avx512,
}

/// A wish for an instruction set that cannot be met.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum InstructionSetError {
    /// No set is called so.
    #[error("{VARIABLE} is {0:?}; expected portable, avx2 or avx512")]
    Unknown(String),
    /// The processor lacks it.
    #[error("{VARIABLE} is {0:?}, which this processor does not have")]
    Missing(&'static str),
}

impl InstructionSet {
    /// All, the fastest first.
    pub const ALL: [Self; 3] = [Self::Avx512, Self::Avx2, Self::Portable];

    /// The name, as it is asked for by.
    pub fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }

    /// Whether this processor has it.
    pub fn is_available(self) -> bool {
        match self {
            Self::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512vl")
                    && is_x86_feature_detected!("fma")
            }
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The set called so, or without a name the best.
    fn chosen(name: Option<&str>) -> Result<Self, InstructionSetError> {
        let Some(name) = name else {
            let best = Self::ALL.into_iter().find(|set| set.is_available());
            return Ok(best.unwrap_or(Self::Portable));
        };
        let named = Self::ALL.into_iter().find(|set| set.name() == name);
        let set = named.ok_or_else(|| InstructionSetError::Unknown(name.to_owned()))?;
        if set.is_available() { Ok(set) } else { Err(InstructionSetError::Missing(set.name())) }
    }
}

/// The set in use: the best that the processor has, unless the environment's variable
/// `SUPERQUADRIC_SIMD` names another. It is settled when it is first asked for.
///
/// # Errors
/// If no set is called so, or this processor lacks it.
pub fn instruction_set() -> Result<InstructionSet, InstructionSetError> {
    static CHOICE: OnceLock<Result<InstructionSet, InstructionSetError>> = OnceLock::new();
    let choose = || {
        let name = std::env::var_os(VARIABLE).map(|name| name.to_string_lossy().into_owned());
        InstructionSet::chosen(name.as_deref())
    };
    CHOICE.get_or_init(choose).clone()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_set_is_chosen_by_its_name_where_the_processor_has_it() {
        for set in InstructionSet::ALL {
            let expected = InstructionSetError::Missing(set.name());
            let expected = if set.is_available() { Ok(set) } else { Err(expected) };
            assert_eq!(InstructionSet::chosen(Some(set.name())), expected);
        }
        assert!(InstructionSet::chosen(None).unwrap().is_available());
    }

    #[cfg(miri)]
    #[test]
    fn miri_is_told_of_every_set() {
        assert!(InstructionSet::ALL.into_iter().all(InstructionSet::is_available));
    }

    #[test]
    fn a_name_that_means_nothing_is_an_error() {
        let error = InstructionSet::chosen(Some("AVX9")).unwrap_err().to_string();
        assert_eq!(error, "SUPERQUADRIC_SIMD is \"AVX9\"; expected portable, avx2 or avx512");
    }
}
