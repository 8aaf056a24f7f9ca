//! Long work that Ctrl-C can end.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// How often Python is asked for signals.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(50);

/// Runs work on a thread of its own, detached from the interpreter, while this one waits for
/// signals. The work is handed a question, whether it should give up, and should ask it often.
///
/// # Errors
/// What a signal handler raises, such as `KeyboardInterrupt`, once the work has given up.
pub(super) fn interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T + Send,
) -> PyResult<T> {
    let stop = AtomicBool::new(false);
    py.detach(|| {
        thread::scope(|scope| {
            let (done, finished) = channel();
            let stop = &stop;
            let worker = scope.spawn(move || {
                let result = work(&|| stop.load(Ordering::Relaxed));
                drop(done);
                result
            });
            while finished.recv_timeout(SIGNAL_INTERVAL) == Err::<(), _>(RecvTimeoutError::Timeout)
            {
                if let Err(raised) = Python::attach(|py| py.check_signals()) {
                    stop.store(true, Ordering::Relaxed);
                    // Whatever the work has come to, the signal goes before.
                    let _ = worker.join();
                    return Err(raised);
                }
            }
            worker.join().map_err(|_| PyRuntimeError::new_err("the computation has failed"))
        })
    })
}
