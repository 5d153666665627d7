//! Status codes of the library as errors.
use crate::sys;
use std::{ffi::CStr, ffi::CString, fmt, os::raw::c_char};

/// What kind of thing went wrong; each stands for the `MIMO_E_` constant of its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// An argument is out of range or not finite; nothing was changed.
    InvalidArgument,
    /// The handle was destroyed, or is of another kind.
    BadHandle,
    /// A buffer is shorter than needed; nothing was written.
    BufferTooSmall,
    /// A struct is of a size that the library does not know.
    StructSize,
    /// No body, joint, scene, file... of that name; the message lists names that are there.
    NotFound,
    /// A model does not compile.
    Model,
    /// The simulation failed or diverged; reset makes the world usable again.
    Simulation,
    /// The renderer failed.
    Render,
    /// Not possible here, or not known to the loaded library: the message says which.
    Unsupported,
    /// An allocation failed.
    OutOfMemory,
    /// The handle was made in the parent process, before `fork()`.
    Forked,
    /// A defect in libmimo; please report the message.
    Internal,
    /// A file cannot be written, or is not what it should be.
    File,
    /// A [`Task`](crate::Task) failed or panicked, or said what cannot be meant.
    Task,
    /// Not now, and nothing was changed: another thread is using it, or another call has to come first.
    Busy,
    /// A status that this crate does not know.
    Unknown,
}

const STATUSES: [(i32, Kind); 15] = [
    (sys::MIMO_E_INVALID_ARGUMENT, Kind::InvalidArgument),
    (sys::MIMO_E_BAD_HANDLE, Kind::BadHandle),
    (sys::MIMO_E_BUFFER_TOO_SMALL, Kind::BufferTooSmall),
    (sys::MIMO_E_STRUCT_SIZE, Kind::StructSize),
    (sys::MIMO_E_NOT_FOUND, Kind::NotFound),
    (sys::MIMO_E_MODEL, Kind::Model),
    (sys::MIMO_E_SIMULATION, Kind::Simulation),
    (sys::MIMO_E_RENDER, Kind::Render),
    (sys::MIMO_E_UNSUPPORTED, Kind::Unsupported),
    (sys::MIMO_E_OUT_OF_MEMORY, Kind::OutOfMemory),
    (sys::MIMO_E_FORKED, Kind::Forked),
    (sys::MIMO_E_INTERNAL, Kind::Internal),
    (sys::MIMO_E_FILE, Kind::File),
    (sys::MIMO_E_TASK, Kind::Task),
    (sys::MIMO_E_BUSY, Kind::Busy),
];

impl Kind {
    fn of(status: sys::mimo_status) -> Kind {
        STATUSES.iter().find(|entry| entry.0 == status).map_or(Kind::Unknown, |entry| entry.1)
    }

    /// For the library, as the result of a callback.
    pub(crate) fn status(self) -> sys::mimo_status {
        STATUSES.iter().find(|entry| entry.1 == self).map_or(sys::MIMO_E_TASK, |entry| entry.0)
    }
}

/// What became of one world of a batch in a step. Prints as the library's name for it, "MIMO_E_SIMULATION".
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct Status(sys::mimo_status);

impl Status {
    /// It did what was asked.
    pub const OK: Status = Status(sys::MIMO_OK as i32);

    /// Why it did not; None if it did.
    pub fn error(self) -> Option<Kind> {
        (self != Status::OK).then(|| Kind::of(self.0))
    }
}

impl fmt::Debug for Status {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str(&text(unsafe { sys::mimo_status_name(self.0) }))
    }
}

/// What the library complained about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    kind: Kind,
    message: String,
}

impl Error {
    /// An error of one's own, for example of a [`Task`](crate::Task).
    pub fn new(kind: Kind, message: impl Into<String>) -> Error {
        let message = message.into();
        Error { kind, message }
    }

    /// What kind of thing went wrong.
    pub fn kind(&self) -> Kind {
        self.kind
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
    match Status(status).error() {
        None => Ok(()),
        Some(kind) => Err(Error::new(kind, text(unsafe { sys::mimo_last_error() }))),
    }
}

/// The same for a message that the library gave otherwise.
pub(crate) fn told(status: sys::mimo_status, message: *const c_char) -> Option<Error> {
    Status(status).error().map(|kind| Error::new(kind, text(message)))
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
        .map_err(|_| Error::new(Kind::InvalidArgument, format!("a zero inside the text {:?}", text)))
}
