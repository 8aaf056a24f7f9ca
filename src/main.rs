//! The command line `superquadric`.

use std::process::ExitCode;

fn main() -> ExitCode {
    superquadric::cli::main()
}
