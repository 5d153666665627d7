//! How a world goes on: its time steps, what their rewards consist of, and where the time goes.
use crate::error::{check, text, Result};
use crate::sys;
use crate::world::World;
use std::ptr::null;
use std::time::Duration;

/// One part of a reward.
#[derive(Clone, Debug, PartialEq)]
pub struct RewardTerm {
    /// "distance".
    pub name: String,
    /// What it adds to the reward.
    pub value: f64,
}

/// Where the time of steps went, with [`EnvConfig::timing`](crate::EnvConfig::timing).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
}

impl World {
    /// Name of the task.
    pub fn task(&self) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_task(self.handle(), &mut name) })?;
        Ok(text(name))
    }

    /// Physics steps in a step.
    pub fn frame_skip(&self) -> Result<u32> {
        let mut steps = 0;
        check(unsafe { sys::mimo_env_frame_skip(self.handle(), &mut steps) })?;
        Ok(steps)
    }

    /// Length of one physics step, seconds.
    pub fn timestep(&self) -> Result<f64> {
        let mut seconds = 0.0;
        check(unsafe { sys::mimo_env_timestep(self.handle(), &mut seconds) })?;
        Ok(seconds)
    }

    /// Bare physics: so many physics steps with the controls as they are, without senses or task.
    pub fn physics_step(&mut self, count: usize) -> Result<()> {
        check(unsafe { sys::mimo_env_physics_step(self.handle(), count) })
    }

    /// The terms of the last step's reward, which is their sum; 0 after a reset.
    pub fn reward_terms(&self, agent: usize) -> Result<Vec<RewardTerm>> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_reward_term_count(self.handle(), agent, &mut count) })?;
        let mut values = vec![0.0; count];
        check(unsafe { sys::mimo_env_reward_terms(self.handle(), agent, values.as_mut_ptr(), count) })?;
        let term = |(index, value)| Ok(RewardTerm { name: self.term_name(agent, index)?, value });
        values.into_iter().enumerate().map(term).collect()
    }

    fn term_name(&self, agent: usize, index: usize) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_reward_term_name(self.handle(), agent, index, &mut name) })?;
        Ok(text(name))
    }

    /// Where the time of steps went since the last [`reset_timing`](Self::reset_timing); all zero in a world that was made
    /// without [`EnvConfig::timing`](crate::EnvConfig::timing).
    pub fn timing(&self) -> Result<Timing> {
        let mut raw: sys::mimo_timing = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of_val(&raw) as u32;
        check(unsafe { sys::mimo_env_timing(self.handle(), &mut raw) })?;
        Ok(Timing {
            steps: raw.steps,
            total: Duration::from_secs_f64(raw.total),
            physics: Duration::from_secs_f64(raw.physics),
            touch: Duration::from_secs_f64(raw.touch),
            vision: Duration::from_secs_f64(raw.vision),
            proprioception: Duration::from_secs_f64(raw.proprioception),
            vestibular: Duration::from_secs_f64(raw.vestibular),
        })
    }

    /// Starts counting anew.
    pub fn reset_timing(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_env_timing_reset(self.handle()) })
    }
}
