//! What is asked of the machine: the registers of its instruction set, and large pages of memory.
//! The only part with `unsafe` code.
//!
//! Invariants:
//! - a function compiled for a target feature is called only where the processor has been asked
//!   for it (`vectorized`);
//! - a register is loaded only from a slice, and stored only to an array, that is as long as the
//!   register is wide (`products`);
//! - what is asked of the system never changes what memory holds or whose it is (`room`).
//!
//! `tests/miri` has Miri interpret all but the last.
#![allow(unsafe_code)]

mod instruction_set;
mod products;
pub(crate) mod room;
pub(crate) mod vectorized;

pub use instruction_set::{InstructionSet, InstructionSetError, instruction_set};
pub(crate) use products::{Products, TILE};
