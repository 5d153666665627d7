//! Status codes of the library as errors.
use crate::constants::Status;
use crate::sys;
use std::{ffi::CStr, ffi::CString, fmt, os::raw::c_char};

impl fmt::Display for Status {
    /// The name in C, "MIMO_E_SIMULATION".
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str(&text(unsafe { sys::mimo_status_name(self.raw()) }))
    }
}

/// An error of the library, or of a [`Task`](crate::Task).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    status: Status,
    message: String,
}

impl Error {
    /// Your own error, for example in a [`Task`](crate::Task).
    pub fn new(status: Status, message: impl Into<String>) -> Error {
        let message = message.into();
        Error { status, message }
    }

    /// The kind of error.
    pub fn status(&self) -> Status {
        self.status
    }

    /// One line that names the argument, its value and the expectation.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        write!(out, "{}", self.message)
    }
}

impl std::error::Error for Error {}

/// The result of a call that can fail.
pub type Result<T> = std::result::Result<T, Error>;

/// Turns a status into a result. Has to run on the thread of the call, before another call fails.
pub(crate) fn check(status: sys::mimo_status) -> Result<()> {
    told(status, || text(unsafe { sys::mimo_last_error() })).map_or(Ok(()), Err)
}

/// The error of a status with a message that comes from elsewhere; None if the call succeeded.
pub(crate) fn told(status: sys::mimo_status, message: impl FnOnce() -> String) -> Option<Error> {
    (status != sys::MIMO_OK).then(|| Error::new(Status::from_raw(status), message()))
}

/// A copy of a C string; "" for NULL.
pub(crate) fn text(string: *const c_char) -> String {
    if string.is_null() {
        return String::new();
    }
    unsafe { CStr::from_ptr(string) }.to_string_lossy().into_owned()
}

/// A string for the library. C strings cannot contain zeros.
pub(crate) fn c_string(text: &str) -> Result<CString> {
    CString::new(text)
        .map_err(|_| Error::new(Status::INVALID_ARGUMENT, format!("the text {:?} contains a zero", text)))
}
