//! The time that the parts of steps take.
use crate::error::{check, Result};
use crate::records::Timing;
use crate::structs::described;
use crate::sys;
use crate::world::World;

impl World {
    /// The time that the parts of steps took since the last [`reset_timing`](Self::reset_timing); all zero in
    /// a world without [`EnvConfig::timing`](crate::EnvConfig::timing).
    pub fn timing(&self) -> Result<Timing> {
        Ok(Timing::of(&described(|raw| unsafe { sys::mimo_env_timing(self.handle(), raw) })?))
    }

    /// Starts counting from zero.
    pub fn reset_timing(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_env_timing_reset(self.handle()) })
    }
}
