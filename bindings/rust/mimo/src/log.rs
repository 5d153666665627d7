//! Messages of the library, delivered to a closure.
use crate::constants::{LogLevel, WarningCode};
use crate::sys;
use std::ffi::CStr;
use std::fmt;
use std::os::raw::c_void;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::Arc;

/// A message.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct LogRecord<'a> {
    /// Its importance.
    pub level: LogLevel,
    /// The warning of the physics; None for all other messages.
    pub code: Option<WarningCode>,
    /// One line.
    pub text: &'a str,
    /// The world whose physics warns, by its number in its batch (0 for a single world); None for messages of
    /// a scene, a model or a renderer.
    pub world: Option<usize>,
    /// Simulated seconds since that world's reset; 0 without a world.
    pub time: f64,
}

/// A closure behind a thin pointer that the library keeps. The owner of a handle made with it owns a share of
/// it. `Sync`, because clones of a world share it, and each may be on a thread of its own.
#[derive(Clone)]
pub(crate) struct Log(Arc<Closure>);

type Closure = Box<dyn Fn(&LogRecord) + Send + Sync>;

impl Log {
    pub(crate) fn new(log: impl Fn(&LogRecord) + Send + Sync + 'static) -> Log {
        Log(Arc::new(Box::new(log)))
    }
}

impl fmt::Debug for Log {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str("Log")
    }
}

/// The two members of a config; the pointer is valid as long as a share of the log lives.
pub(crate) fn raw(log: &Option<Log>) -> (sys::mimo_log_fn, *mut c_void) {
    match log {
        Some(log) => (Some(forward), Arc::as_ptr(&log.0) as *mut c_void),
        None => (None, std::ptr::null_mut()),
    }
}

/// A panic must not unwind into C: it is caught and dropped here.
unsafe extern "C" fn forward(user: *mut c_void, record: *const sys::mimo_log_record) {
    let (log, told) = (&*(user as *const Closure), &*record);
    let text = CStr::from_ptr(told.text).to_string_lossy();
    let record = LogRecord {
        level: LogLevel::from_raw(told.level),
        code: (told.code != 0).then_some(WarningCode::from_raw(told.code)),
        text: &text,
        world: (told.in_world == 1).then_some(told.world),
        time: told.time,
    };
    let _ = catch_unwind(AssertUnwindSafe(|| log(&record)));
}
