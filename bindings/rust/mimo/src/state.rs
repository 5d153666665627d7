//! States of worlds.
use crate::error::{check, text, Result};
use crate::structs::described;
use crate::sys;
use crate::world::World;
use std::os::raw::{c_char, c_void};

/// Names of sections of a state, see [`World::load`](crate::World::load).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct LoadReport {
    /// Memories of delayed senses and motors that the state lacked: they start fresh.
    pub fresh: Vec<String>,
    /// Memories in the state that this world does not have.
    pub ignored: Vec<String>,
}

impl LoadReport {
    /// The report of a call that loads a state.
    pub(crate) fn of(
        load: impl FnOnce(*mut sys::mimo_load_report) -> sys::mimo_status,
    ) -> Result<LoadReport> {
        let raw = described(load)?;
        Ok(LoadReport { fresh: names(raw.fresh_names), ignored: names(raw.ignored_names) })
    }
}

impl World {
    /// Everything that the world's future depends on, as bytes.
    pub fn save(&self) -> Result<Vec<u8>> {
        let mut bytes = 0;
        check(unsafe { sys::mimo_env_state_size(self.handle(), &mut bytes) })?;
        let mut state = vec![0; bytes];
        check(unsafe { sys::mimo_env_state_save(self.handle(), state.as_mut_ptr() as *mut c_void, bytes) })?;
        Ok(state)
    }

    /// Loads a state of a world of the same model, agents and task, and continues exactly as that world did.
    /// Memories of delays that the state lacks start fresh.
    pub fn load(&mut self, state: &[u8]) -> Result<LoadReport> {
        let from = state.as_ptr() as *const c_void;
        LoadReport::of(|report| unsafe { sys::mimo_env_state_load(self.handle(), from, state.len(), report) })
    }
}

fn names(joined: *const c_char) -> Vec<String> {
    text(joined).split(", ").filter(|name| !name.is_empty()).map(str::to_string).collect()
}
