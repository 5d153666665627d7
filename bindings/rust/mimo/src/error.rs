//! Status codes of the library as errors.
use crate::constants::Status;
use crate::sys;
use std::{ffi::CStr, ffi::CString, fmt, os::raw::c_char};

impl fmt::Display for Status {
    /// As C calls it, "MIMO_E_SIMULATION".
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str(&text(unsafe { sys::mimo_status_name(self.raw()) }))
    }
}

/// What the library complained about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    status: Status,
    message: String,
}

impl Error {
    /// An error of one's own, for example of a [`Task`](crate::Task).
    pub fn new(status: Status, message: impl Into<String>) -> Error {
        let message = message.into();
        Error { status, message }
    }

    /// What kind of thing went wrong.
    pub fn status(&self) -> Status {
        self.status
    }

    /// One line that names the argument, its value and what was expected.
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

/// The result of whatever can fail.
pub type Result<T> = std::result::Result<T, Error>;

/// The error of a status. Has to be called on the thread of the call, before another one fails.
pub(crate) fn check(status: sys::mimo_status) -> Result<()> {
    told(status, || text(unsafe { sys::mimo_last_error() })).map_or(Ok(()), Err)
}

/// The same for a message that the library gave otherwise; None for a call that did what it was asked.
pub(crate) fn told(status: sys::mimo_status, message: impl FnOnce() -> String) -> Option<Error> {
    (status != sys::MIMO_OK).then(|| Error::new(Status::from_raw(status), message()))
}

/// A copy of a string of the library's; "" for NULL.
pub(crate) fn text(string: *const c_char) -> String {
    if string.is_null() {
        return String::new();
    }
    unsafe { CStr::from_ptr(string) }.to_string_lossy().into_owned()
}

/// A string for the library. One with a zero inside cannot be passed on.
pub(crate) fn c_string(text: &str) -> Result<CString> {
    CString::new(text)
        .map_err(|_| Error::new(Status::INVALID_ARGUMENT, format!("a zero inside the text {:?}", text)))
}
