//! What a state did not hold of the world that loaded it.
use crate::error::{check, text, Result};
use crate::sys;

/// Names of sections of a state, see [`World::load`](crate::World::load).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LoadReport {
    /// What the state did not hold of senses and motors with a delay: they start fresh.
    pub fresh: Vec<String>,
    /// What the state holds, and nobody here has.
    pub ignored: Vec<String>,
}

impl LoadReport {
    /// Of a call that loads.
    pub(crate) fn of(
        load: impl FnOnce(*mut sys::mimo_load_report) -> sys::mimo_status,
    ) -> Result<LoadReport> {
        let mut raw: sys::mimo_load_report = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of_val(&raw) as u32;
        check(load(&mut raw))?;
        Ok(LoadReport { fresh: names(raw.fresh_names), ignored: names(raw.ignored_names) })
    }
}

fn names(joined: *const std::os::raw::c_char) -> Vec<String> {
    text(joined).split(", ").filter(|name| !name.is_empty()).map(str::to_string).collect()
}
