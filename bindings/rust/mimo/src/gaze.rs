//! The gaze of infants.
use crate::constants::{Look, Movement};
use crate::error::{check, Result};
use crate::structs::described;
use crate::sys;
use crate::world::World;
use std::ptr::null_mut;

/// One eye's line of sight.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sightline {
    /// Position of the eye's camera, world, m.
    pub position: [f64; 3],
    /// Unit vector, world.
    pub direction: [f64; 3],
}

/// The gaze of both eyes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Gaze {
    /// Line of sight of the left eye.
    pub left: Sightline,
    /// Line of sight of the right eye.
    pub right: Sightline,
    /// Angle between the lines of sight, rad; negative if they diverge.
    pub vergence: f64,
    /// The middle of their closest approach, world, m; None if they diverge.
    pub point: Option<[f64; 3]>,
    /// Their distance there, m.
    pub miss: f64,
}

/// Joints that make an infant look at a point.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LookAngles {
    /// Ids: pan, tilt and torsion of the left eye, then of the right eye. With [`Look::HEAD`] swivel and tilt
    /// of the head come first.
    pub joints: Vec<i32>,
    /// Their angles, rad, within the joints' ranges.
    pub angles: Vec<f64>,
    /// Angles by which the left and the right eye miss the point because of their range, rad.
    pub errors: [f64; 2],
}

impl World {
    /// Fills in what the motors of an infant do by themselves: actions for the next step, as many as it has.
    /// `which` are kinds of movements.
    pub fn spontaneous(&self, agent: usize, which: Movement, actions: &mut [f32]) -> Result<()> {
        let (place, count) = (actions.as_mut_ptr(), actions.len());
        check(unsafe { sys::mimo_env_spontaneous(self.handle(), agent, which.raw(), place, count) })
    }

    /// The gaze of an infant, from the current poses of its eyes' cameras.
    pub fn gaze(&self, agent: usize) -> Result<Gaze> {
        let raw: sys::mimo_gaze = described(|raw| unsafe { sys::mimo_env_gaze(self.handle(), agent, raw) })?;
        Ok(Gaze {
            left: Sightline { position: raw.left_position, direction: raw.left_direction },
            right: Sightline { position: raw.right_position, direction: raw.right_direction },
            vergence: raw.vergence,
            point: if raw.meets == 1 { Some(raw.point) } else { None },
            miss: raw.miss,
        })
    }

    /// Angles of the joints that make an infant look at a point (world, m); nothing moves.
    pub fn look_angles(&mut self, agent: usize, point: [f64; 3], how: Look) -> Result<LookAngles> {
        let (env, at, how, mut count) = (self.handle(), point.as_ptr(), how.raw(), 0);
        let mut ask = |joints, angles, capacity, errors| {
            check(unsafe {
                sys::mimo_env_look_angles(env, agent, at, how, joints, angles, capacity, &mut count, errors)
            })?;
            Ok(count)
        };
        let count = ask(null_mut(), null_mut(), 0, null_mut())?;
        let (mut joints, mut angles, mut errors) = (vec![0; count], vec![0.0; count], [0.0; 2]);
        ask(joints.as_mut_ptr(), angles.as_mut_ptr(), count, errors.as_mut_ptr())?;
        Ok(LookAngles { joints, angles, errors })
    }

    /// Makes an infant look at a point (world, m) at once; springs and motors move its joints again in the
    /// next step. Returns the angles by which the left and the right eye miss the point, rad.
    pub fn look_at(&mut self, agent: usize, point: [f64; 3], how: Look) -> Result<[f64; 2]> {
        let mut errors = [0.0; 2];
        check(unsafe {
            sys::mimo_env_look_at(self.handle(), agent, point.as_ptr(), how.raw(), errors.as_mut_ptr())
        })?;
        Ok(errors)
    }
}
