//! Values that differ between the worlds of one model. They outlive resets and are part of the state.
use crate::constants::{Kind, Quantity};
use crate::error::Result;
use crate::world::World;

impl World {
    /// The face that an infant shows; "" for a body without faces.
    pub fn face(&self, agent: usize) -> Result<String> {
        let face = self.get(Quantity::AGENT_FACE, &[agent as i32])?[0];
        if face < 0.0 {
            return Ok(String::new());
        }
        self.name(Kind::FACE, face as i32)
    }

    /// Gives an infant another face, see [`faces`](crate::faces); the next picture shows it.
    pub fn set_face(&mut self, agent: usize, name: &str) -> Result<()> {
        let face = self.find(Kind::FACE, name)?;
        self.set(Quantity::AGENT_FACE, &[agent as i32], &[face as f64])
    }

    /// Holds a joint (its id) at an angle (rad), softly, from the next step on.
    pub fn lock(&mut self, joint: i32, angle: f64) -> Result<()> {
        self.set(Quantity::JOINT_LOCK, &[joint], &[1.0, angle])
    }

    /// Releases a joint, also one that the scene has locked.
    pub fn unlock(&mut self, joint: i32) -> Result<()> {
        let angle = self.get(Quantity::JOINT_LOCK, &[joint])?[1];
        self.set(Quantity::JOINT_LOCK, &[joint], &[0.0, angle])
    }

    /// The angle at which a joint is locked; None if it is not.
    pub fn locked(&self, joint: i32) -> Result<Option<f64>> {
        let lock = self.get(Quantity::JOINT_LOCK, &[joint])?;
        Ok(if lock[0] == 1.0 { Some(lock[1]) } else { None })
    }

    /// Gravity, m/s^2, world frame.
    pub fn gravity(&self) -> Result<[f64; 3]> {
        let gravity = self.get_all(Quantity::WORLD_GRAVITY)?;
        Ok([gravity[0], gravity[1], gravity[2]])
    }

    /// Sets gravity, m/s^2, world frame.
    pub fn set_gravity(&mut self, gravity: [f64; 3]) -> Result<()> {
        self.set_all(Quantity::WORLD_GRAVITY, &gravity)
    }

    /// The number of physics steps with each warning since the world was made, by the number of the
    /// [`WarningCode`](crate::WarningCode). All 0: no warnings.
    pub fn warnings(&self) -> Result<Vec<u64>> {
        Ok(self.get_all(Quantity::WARNING_STEPS)?.iter().map(|count| *count as u64).collect())
    }
}
