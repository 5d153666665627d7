//! Contacts.
use crate::constants::Quantity;
use crate::error::Result;
use crate::rows::row;
use crate::world::World;

/// Two geoms that touch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Contact {
    /// Ids of geom 1 and geom 2.
    pub geoms: [i32; 2],
    /// Ids of their bodies.
    pub bodies: [i32; 2],
    /// Metres, world frame.
    pub position: [f64; 3],
    /// Rows: normal from geom 1 to geom 2, two tangents; world frame.
    pub frame: [f64; 9],
    /// Metres; negative: overlap.
    pub distance: f64,
    /// Force on body 2 in that frame, N.
    pub force: [f64; 3],
    /// Torque on body 2 in that frame, Nm.
    pub torque: [f64; 3],
}

/// Two geoms that touched during a step; world frame.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StepContact {
    /// Ids of geom 1 and geom 2.
    pub geoms: [i32; 2],
    /// Ids of their bodies.
    pub bodies: [i32; 2],
    /// When they first touched, seconds since the step began.
    pub start: f64,
    /// When they last touched, seconds since the step began.
    pub end: f64,
    /// Impulse on body 2 over the whole step, N s.
    pub impulse: [f64; 3],
    /// The largest force on body 2 of any physics step, N.
    pub peak_force: [f64; 3],
    /// Position of the strongest contact at that time, metres.
    pub peak_position: [f64; 3],
}

impl World {
    /// The contacts of the last physics step, with their forces.
    pub fn contacts(&self) -> Result<Vec<Contact>> {
        let geoms = self.get_all(Quantity::CONTACT_GEOMS)?;
        let bodies = self.get_all(Quantity::CONTACT_BODIES)?;
        let positions = self.get_all(Quantity::CONTACT_POSITION)?;
        let frames = self.get_all(Quantity::CONTACT_FRAME)?;
        let distances = self.get_all(Quantity::CONTACT_DISTANCE)?;
        let forces = self.get_all(Quantity::CONTACT_FORCE)?;
        let torques = self.get_all(Quantity::CONTACT_TORQUE)?;
        let contact = |i: usize| Contact {
            geoms: row(&geoms, i).map(|id| id as i32),
            bodies: row(&bodies, i).map(|id| id as i32),
            position: row(&positions, i),
            frame: row(&frames, i),
            distance: distances[i],
            force: row(&forces, i),
            torque: row(&torques, i),
        };
        Ok((0..distances.len()).map(contact).collect())
    }

    /// All pairs of geoms that touched during the last step, in worlds made with
    /// [`EnvConfig::step_contacts`](crate::EnvConfig).
    pub fn step_contacts(&self) -> Result<Vec<StepContact>> {
        let geoms = self.get_all(Quantity::STEP_CONTACT_GEOMS)?;
        let bodies = self.get_all(Quantity::STEP_CONTACT_BODIES)?;
        let starts = self.get_all(Quantity::STEP_CONTACT_START)?;
        let ends = self.get_all(Quantity::STEP_CONTACT_END)?;
        let impulses = self.get_all(Quantity::STEP_CONTACT_IMPULSE)?;
        let forces = self.get_all(Quantity::STEP_CONTACT_PEAK_FORCE)?;
        let positions = self.get_all(Quantity::STEP_CONTACT_PEAK_POSITION)?;
        let contact = |i: usize| StepContact {
            geoms: row(&geoms, i).map(|id| id as i32),
            bodies: row(&bodies, i).map(|id| id as i32),
            start: starts[i],
            end: ends[i],
            impulse: row(&impulses, i),
            peak_force: row(&forces, i),
            peak_position: row(&positions, i),
        };
        Ok((0..starts.len()).map(contact).collect())
    }
}
