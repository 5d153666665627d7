//! MIMo, the multimodal infant model: the body of an 18-month-old infant, its senses and its tasks.
//!
//! ```
//! # fn main() -> mimo::Result<()> {
//! let mut env = mimo::Env::make("reach")?;
//! let mut block = env.new_block()?;
//! let action = vec![0.0; env.action_size()?];
//! env.reset(Some(7), Some(&mut block))?;
//! let step = env.step(&action, Some(&mut block))?;
//! println!("{} {:?}", step.reward, block.f32("proprioception/position")?);
//! # Ok(()) }
//! ```
//!
//! A [`Scene`] describes a room, objects and infants; an [`Env`] is one world made of it, a [`Batch`] many. What the
//! senses gave stands in a [`Block`], whose fields are slices into it. Whatever can fail gives an [`Error`] with the
//! library's message. Units are SI units and radians; quaternions are w x y z; x forward, y left, z up.
//!
//! # Threads
//! Every type is `Send`: a handle may move between threads. Every type is `Sync`, for `&self` methods call functions
//! that may run at the same time on one handle, and `&mut self` methods those that need it for themselves.
//!
//! Constants (`MIMO_BODY_POSITION`, ...) and everything that has no safe form yet are in [`sys`].
#![warn(missing_docs, missing_debug_implementations)]

pub use mimo_sys as sys;

mod batch;
mod block;
mod camera;
mod config;
mod env;
mod error;
mod field;
mod gaze;
mod limits;
mod lists;
mod log;
mod overrides;
mod picture;
mod scene;
mod senses;
mod state;
mod steps;
mod task;
mod world;

pub use batch::{Batch, BatchConfig, BatchResults};
pub use block::{Block, Observation};
pub use camera::Camera;
pub use config::{AgentConfig, EnvConfig, Model, Object};
pub use env::Env;
pub use error::{Error, Kind, Result};
pub use field::{Field, Type};
pub use gaze::{Gaze, Look, LookAngles, Sightline};
pub use limits::Limits;
pub use lists::{builtin_scenes, faces, parameters, rooms, tasks, Parameter};
pub use log::Level;
pub use picture::Picture;
pub use scene::{DocumentLimits, Scene};
pub use senses::{Senses, SensesConfig};
pub use state::LoadReport;
pub use steps::{RewardTerm, Timing};
pub use task::{Moment, Task, TaskField, Verdict};
pub use world::{Contact, Outcome, Step, StepContact, TouchSensor, World};

/// Version of the loaded library, "major.minor.patch".
pub fn version() -> String {
    error::text(unsafe { sys::mimo_version() })
}

/// Version of the MuJoCo that the library runs on.
pub fn mujoco_version() -> String {
    error::text(unsafe { sys::mimo_mujoco_version() })
}
