//! Structs of C, which start with their size.
use crate::constants::Status;
use crate::error::{c_string, check, text, Error, Result};
use crate::sys;
use std::ffi::CString;
use std::mem::{size_of, MaybeUninit};
use std::os::raw::c_char;
use std::ptr::null;

type Init<T> = unsafe extern "C" fn(*mut T, usize) -> sys::mimo_status;

/// A struct that is zero except for its size.
pub(crate) fn sized<T>() -> T {
    let mut raw = MaybeUninit::<T>::zeroed();
    // The first member is the size. All others are numbers and pointers, for which zeros are valid.
    unsafe {
        raw.as_mut_ptr().cast::<u32>().write(size_of::<T>() as u32);
        raw.assume_init()
    }
}

/// A struct with the defaults of its _init function.
pub(crate) fn defaults<T>(init: Init<T>) -> Result<T> {
    let mut raw = sized();
    check(unsafe { init(&mut raw, size_of::<T>()) })?;
    Ok(raw)
}

/// A struct that a function of the library fills.
pub(crate) fn described<T>(describe: impl FnOnce(*mut T) -> sys::mimo_status) -> Result<T> {
    let mut raw = sized();
    check(describe(&mut raw))?;
    Ok(raw)
}

/// A string for a config; NULL for none.
pub(crate) fn pointer(text: &Option<CString>) -> *const c_char {
    text.as_ref().map_or(null(), |text| text.as_ptr())
}

/// A string of a config; None for NULL.
pub(crate) fn given(string: *const c_char) -> Result<Option<CString>> {
    if string.is_null() {
        return Ok(None);
    }
    c_string(&text(string)).map(Some)
}

/// An array for C; NULL for none.
pub(crate) fn array<T>(elements: &[T]) -> *const T {
    if elements.is_empty() {
        null()
    } else {
        elements.as_ptr()
    }
}

/// The length that arrays have in common: each is empty, or has so many numbers for each of them.
pub(crate) fn common_length(arrays: &[(usize, usize, &str)]) -> Result<usize> {
    let given: Vec<_> = arrays.iter().filter(|(length, _, _)| *length > 0).collect();
    let count = given.first().map_or(0, |(length, width, _)| length / width);
    match given.iter().find(|(length, width, _)| *length != count * width) {
        None => Ok(count),
        Some((length, width, name)) => Err(Error::new(
            Status::INVALID_ARGUMENT,
            format!(
                "{} has {} elements, expected {} times {}, as {} has",
                name, length, count, width, given[0].2
            ),
        )),
    }
}
