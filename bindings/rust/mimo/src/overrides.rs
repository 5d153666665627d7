//! What differs from world to world, though all share one model. It outlives resets and is part of the state.
use crate::error::{c_string, check, text, Result};
use crate::sys;
use crate::world::World;
use std::ptr::null;

impl World {
    /// The face that an infant shows; "" for a body without faces.
    pub fn face(&self, agent: usize) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_face(self.handle(), agent, &mut name) })?;
        Ok(text(name))
    }

    /// Gives an infant another face, see [`faces`](crate::faces); pictures show it from the next one on.
    pub fn set_face(&mut self, agent: usize, name: &str) -> Result<()> {
        let name = c_string(name)?;
        check(unsafe { sys::mimo_env_set_face(self.handle(), agent, name.as_ptr()) })
    }

    /// Holds a joint (its id) at an angle (rad), softly, from the next step on.
    pub fn lock(&mut self, joint: i32, angle: f64) -> Result<()> {
        check(unsafe { sys::mimo_env_lock(self.handle(), joint, angle) })
    }

    /// Lets a joint go, also one that the scene has locked.
    pub fn unlock(&mut self, joint: i32) -> Result<()> {
        check(unsafe { sys::mimo_env_unlock(self.handle(), joint) })
    }

    /// The angle at which a joint is held; None if it is not.
    pub fn locked(&self, joint: i32) -> Result<Option<f64>> {
        let (mut locked, mut angle) = (0, 0.0);
        check(unsafe { sys::mimo_env_lock_state(self.handle(), joint, &mut locked, &mut angle) })?;
        Ok(if locked == 1 { Some(angle) } else { None })
    }

    /// Gravity, m/s^2, world frame.
    pub fn gravity(&self) -> Result<[f64; 3]> {
        let mut gravity = [0.0; 3];
        check(unsafe { sys::mimo_env_gravity(self.handle(), gravity.as_mut_ptr(), gravity.len()) })?;
        Ok(gravity)
    }

    /// Sets gravity, m/s^2, world frame.
    pub fn set_gravity(&mut self, gravity: [f64; 3]) -> Result<()> {
        let [x, y, z] = gravity;
        check(unsafe { sys::mimo_env_set_gravity(self.handle(), x, y, z) })
    }
}
