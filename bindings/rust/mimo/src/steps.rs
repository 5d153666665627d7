//! Steps of a world.
use crate::block::{memory, Block};
use crate::constants::Quantity;
use crate::error::{c_string, check, text, Result};
use crate::reset::Reset;
use crate::results::{Results, Step};
use crate::sys;
use crate::world::World;
use std::ptr::null;

impl World {
    /// Starts an episode. Without a block the senses are skipped.
    pub fn reset(&mut self, how: Reset, block: Option<&mut Block>) -> Result<()> {
        let (bytes, count) = memory(block);
        how.with_raw(|how| check(unsafe { sys::mimo_env_reset(self.handle(), how, bytes, count) }))
    }

    /// Makes one step in a world of one agent. Actions are clipped to their bounds, NaN is an error; without
    /// actions the controls do not change. Without a block the senses are skipped. For several agents, or the
    /// terms of the reward, use [`step_into`](Self::step_into).
    pub fn step(&mut self, action: &[f32], block: Option<&mut Block>) -> Result<Step> {
        let mut step = Step::new();
        let raw = step.raw();
        self.step_raw(action, block, &raw)?;
        Ok(step)
    }

    /// Makes one step. `action` holds the actions of all agents, `results` receives their rewards and flags.
    pub fn step_into(
        &mut self,
        action: &[f32],
        block: Option<&mut Block>,
        results: &mut Results,
    ) -> Result<()> {
        let raw = results.raw()?;
        self.step_raw(action, block, &raw)
    }

    fn step_raw(
        &mut self,
        action: &[f32],
        block: Option<&mut Block>,
        results: &sys::mimo_env_results,
    ) -> Result<()> {
        let (bytes, count) = memory(block);
        let values = if action.is_empty() { null() } else { action.as_ptr() };
        check(unsafe { sys::mimo_env_step(self.handle(), values, action.len(), bytes, count, results) })
    }

    /// Observes the current state, without changing the trajectory.
    pub fn observe(&mut self, block: &mut Block) -> Result<()> {
        let (bytes, count) = memory(Some(block));
        check(unsafe { sys::mimo_env_observe(self.handle(), bytes, count) })
    }

    /// Simulated seconds since reset.
    pub fn time(&self) -> Result<f64> {
        let mut seconds = 0.0;
        check(unsafe { sys::mimo_env_time(self.handle(), &mut seconds) })?;
        Ok(seconds)
    }

    /// Name of the task.
    pub fn task(&self) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_task(self.handle(), &mut name) })?;
        Ok(text(name))
    }

    /// Number of physics steps in a step.
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

    /// Makes a number of physics steps with unchanged controls, without senses or task.
    pub fn physics_step(&mut self, count: usize) -> Result<()> {
        check(unsafe { sys::mimo_env_physics_step(self.handle(), count) })
    }

    /// Makes one step of a known movement: `positions` has frame_skip x the positions of all joints, at the
    /// end of each physics step. The senses respond as in any step. Returns frame_skip x the forces that the
    /// movement takes, one for each degree of freedom, N or Nm.
    pub fn follow(&mut self, positions: &[f64], block: Option<&mut Block>) -> Result<Vec<f64>> {
        let degrees = self.get_all(Quantity::JOINT_VELOCITY)?.len();
        let mut forces = vec![0.0; self.frame_skip()? as usize * degrees];
        let movement = sys::mimo_movement {
            struct_size: std::mem::size_of::<sys::mimo_movement>() as u32,
            reserved: 0,
            positions: positions.as_ptr(),
            position_count: positions.len(),
            forces: forces.as_mut_ptr(),
            force_count: forces.len(),
        };
        let (place, bytes) = memory(block);
        check(unsafe { sys::mimo_env_follow(self.handle(), &movement, place, bytes) })?;
        Ok(forces)
    }

    /// Makes a body play samples, Pa at 1 m, from the next physics step on, after the sound that it plays
    /// already. Without samples the sound stops. The rate is
    /// [`Field::sample_rate`](crate::Field::sample_rate) of the ears.
    pub fn play(&mut self, body: &str, samples: &[f32], rate: f64) -> Result<()> {
        let body = c_string(body)?;
        check(unsafe {
            sys::mimo_env_play(self.handle(), body.as_ptr(), samples.as_ptr(), samples.len(), rate)
        })
    }
}
