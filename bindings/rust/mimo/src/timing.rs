//! Where the time of steps goes.
use crate::error::{check, Result};
use crate::records::Timing;
use crate::structs::described;
use crate::sys;
use crate::world::World;

impl World {
    /// Where the time of steps went since the last [`reset_timing`](Self::reset_timing); all zero in a world that was made
    /// without [`EnvConfig::timing`](crate::EnvConfig::timing).
    pub fn timing(&self) -> Result<Timing> {
        Ok(Timing::of(&described(|raw| unsafe { sys::mimo_env_timing(self.handle(), raw) })?))
    }

    /// Starts counting anew.
    pub fn reset_timing(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_env_timing_reset(self.handle()) })
    }
}
