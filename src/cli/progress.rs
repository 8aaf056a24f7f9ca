//! A progress bar on a terminal, nothing off it.

use std::io::{self, IsTerminal};
use std::sync::Mutex;

use kdam::{Bar, BarExt, tqdm};

/// A bar that several threads move on.
pub(super) struct Progress(Mutex<Bar>);

impl Progress {
    /// The bar of so many things of that name; a total of 0 is to be set later.
    pub fn new(name: &str, total: usize) -> Self {
        let is_silent = !io::stderr().is_terminal();
        Self(Mutex::new(tqdm!(total = total, desc = name, disable = is_silent)))
    }

    /// One more is done.
    pub fn step(&self) {
        // What cannot be drawn is not worth an error.
        let _ = self.bar().update(1);
    }

    /// One more is done, of so many.
    pub fn step_of(&self, total: usize) {
        self.bar().total = total;
        self.step();
    }

    /// Leaves the bar's line.
    pub fn end(&self) {
        if io::stderr().is_terminal() {
            eprintln!();
        }
    }

    fn bar(&self) -> std::sync::MutexGuard<'_, Bar> {
        // A bar that a panicking thread has left is only a bar.
        self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}
