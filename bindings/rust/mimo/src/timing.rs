//! Where the time of steps goes.
use crate::error::{check, Result};
use crate::structs::described;
use crate::sys;
use crate::world::World;
use std::time::Duration;

/// Where the time of steps went, with [`EnvConfig::timing`](crate::EnvConfig::timing).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Timing {
    /// Steps counted.
    pub steps: u64,
    /// Everything.
    pub total: Duration,
    /// MuJoCo's steps.
    pub physics: Duration,
    /// Sense of touch.
    pub touch: Duration,
    /// Drawing the eyes' pictures.
    pub vision: Duration,
    /// Joint senses.
    pub proprioception: Duration,
    /// Accelerometer and gyroscope.
    pub vestibular: Duration,
    /// What sounds, and what reaches ears.
    pub hearing: Duration,
}

impl World {
    /// Where the time of steps went since the last [`reset_timing`](Self::reset_timing); all zero in a world that was made
    /// without [`EnvConfig::timing`](crate::EnvConfig::timing).
    pub fn timing(&self) -> Result<Timing> {
        let raw: sys::mimo_timing = described(|raw| unsafe { sys::mimo_env_timing(self.handle(), raw) })?;
        Ok(Timing {
            steps: raw.steps,
            total: Duration::from_secs_f64(raw.total),
            physics: Duration::from_secs_f64(raw.physics),
            touch: Duration::from_secs_f64(raw.touch),
            vision: Duration::from_secs_f64(raw.vision),
            proprioception: Duration::from_secs_f64(raw.proprioception),
            vestibular: Duration::from_secs_f64(raw.vestibular),
            hearing: Duration::from_secs_f64(raw.hearing),
        })
    }

    /// Starts counting anew.
    pub fn reset_timing(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_env_timing_reset(self.handle()) })
    }
}
