//! Versions of the loaded library.
use crate::error::{c_string, text};
use crate::sys;

/// Version of the loaded library, "major.minor.patch".
pub fn version() -> String {
    text(unsafe { sys::mimo_version() })
}

/// Version of the MuJoCo that the library runs on.
pub fn mujoco_version() -> String {
    text(unsafe { sys::mimo_mujoco_version() })
}

/// ABI version of the loaded library; compare with [`MIMO_ABI_VERSION`](sys::MIMO_ABI_VERSION).
pub fn abi_version() -> u32 {
    unsafe { sys::mimo_abi_version() }
}

/// API version of the loaded library; compare with [`MIMO_API_VERSION`](sys::MIMO_API_VERSION).
pub fn api_version() -> u32 {
    unsafe { sys::mimo_api_version() }
}

/// Whether the loaded library knows a function ("mimo_env_step"), a constant ("MIMO_BODY_MASS"), a struct ("mimo_field")
/// or a member of one ("mimo_field.period") of its C interface.
pub fn supports(name: &str) -> bool {
    c_string(name).map_or(false, |name| unsafe { sys::mimo_supports(name.as_ptr()) } == 1)
}
