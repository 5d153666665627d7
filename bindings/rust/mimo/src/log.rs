//! Messages of the library, delivered to a closure.
use crate::sys;
use std::fmt;
use std::os::raw::{c_char, c_void};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::Arc;

/// How much a message matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Something is not as the user probably meant it.
    Warning,
    /// Worth knowing, once.
    Info,
}

/// A closure behind a thin pointer that the library keeps. Whoever owns a handle made with it owns a share of it.
/// `Sync`, because clones of a world share it, and each may be on a thread of its own.
#[derive(Clone)]
pub(crate) struct Log(Arc<Closure>);

type Closure = Box<dyn Fn(Level, &str) + Send + Sync>;

impl Log {
    pub(crate) fn new(log: impl Fn(Level, &str) + Send + Sync + 'static) -> Log {
        Log(Arc::new(Box::new(log)))
    }
}

impl fmt::Debug for Log {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str("Log")
    }
}

/// The pair that goes into a config; the pointer is good as long as a share of the log lives.
pub(crate) fn raw(log: &Option<Log>) -> (sys::mimo_log_fn, *mut c_void) {
    match log {
        Some(log) => (Some(forward), Arc::as_ptr(&log.0) as *mut c_void),
        None => (None, std::ptr::null_mut()),
    }
}

/// A panic must not cross the C frames above: the closure's message is lost then, nothing else.
unsafe extern "C" fn forward(user: *mut c_void, level: i32, message: *const c_char) {
    let log = &*(user as *const Closure);
    let level = if level == sys::MIMO_LOG_WARNING as i32 { Level::Warning } else { Level::Info };
    let _ = catch_unwind(AssertUnwindSafe(|| log(level, &crate::error::text(message))));
}
