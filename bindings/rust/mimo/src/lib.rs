//! MIMo, the multimodal infant model: the body of an 18-month-old infant, its senses and its tasks.
//!
//! ```
//! # use mimo::Reset;
//! # fn main() -> mimo::Result<()> {
//! let mut env = mimo::Env::make("reach")?;
//! let mut block = env.new_block()?;
//! let action = vec![0.0; env.layout()?.action_count()];
//! env.reset(Reset::new().seed(7), Some(&mut block))?;
//! let step = env.step(&action, Some(&mut block))?;
//! println!("{} {:?}", step.reward, block.f32("proprioception/position")?);
//! # Ok(()) }
//! ```
//!
//! A [`Scene`] describes a room, objects and infants; an [`Env`] is one world made of it, a [`Batch`] many. Their [`Layout`]
//! says what is observed, acted with and rewarded. What the senses gave stands in a [`Block`], whose fields are slices
//! into it. Whatever can fail gives an [`Error`] with the
//! library's message. Units are SI units and radians; quaternions are w x y z; x forward, y left, z up.
//!
//! # Threads
//! Every type is `Send`: a handle may move between threads. Every type is `Sync`, for `&self` methods call functions
//! that may run at the same time on one handle, and `&mut self` methods those that need it for themselves.
//!
//! Constants (`MIMO_BODY_POSITION`, ...) and everything that has no safe form yet are in [`sys`].
#![warn(missing_docs, missing_debug_implementations)]

pub use mimo_sys as sys;

mod access;
mod agent;
mod batch;
mod batch_access;
mod block;
mod camera;
mod contacts;
mod env;
mod env_config;
mod error;
mod field;
mod field_config;
mod gaze;
mod geometry;
mod growth;
mod layout;
mod limits;
mod lists;
mod log;
mod maturity;
mod object;
mod overrides;
mod picture;
mod recording;
mod reset;
mod results;
mod rows;
mod scene;
mod scene_config;
mod senses;
mod state;
mod steps;
mod structs;
mod task;
mod timing;
mod version;
mod world;

pub use agent::{AgentConfig, AgentInfo};
pub use batch::{Batch, BatchConfig};
pub use block::{Block, Observation};
pub use camera::Camera;
pub use contacts::{Contact, StepContact};
pub use env::Env;
pub use env_config::EnvConfig;
pub use error::{Error, Kind, Result, Status};
pub use field::{Field, Type};
pub use field_config::FieldConfig;
pub use gaze::{Gaze, Look, LookAngles, Sightline};
pub use geometry::{
    convert_directions, convert_points, Appearance, Axes, Detail, Light, Mesh, Pose, Texture,
};
pub use growth::Growth;
pub use layout::{Action, Layout, Receptor, Term};
pub use limits::Limits;
pub use lists::{builtin_scenes, faces, materials, parameters, rooms, tasks, Parameter};
pub use log::{Level, LogRecord};
pub use maturity::Maturity;
pub use object::{Model, Object};
pub use picture::{Picture, PictureConfig};
pub use recording::{Recorded, Recorder, RecorderConfig, Recording, RecordingInfo, ReplayReport};
pub use reset::{BatchReset, Reset};
pub use results::{BatchResults, Outcome, Results, Step};
pub use scene::Scene;
pub use scene_config::{DocumentLimits, SceneConfig};
pub use senses::{Senses, SensesConfig};
pub use state::LoadReport;
pub use task::{Moment, Task, TaskField, Verdict};
pub use timing::Timing;
pub use version::{abi_version, api_version, mujoco_version, supports, version};
pub use world::World;
