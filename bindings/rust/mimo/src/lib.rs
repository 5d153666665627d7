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
//! A [`Scene`] describes a room, objects and infants; an [`Env`] is one world made from it, a [`Batch`] has
//! many. Their [`Layout`] describes observations, actions and rewards. A [`Block`] holds an observation; its
//! fields are slices of it. A call that can fail returns an [`Error`] with the library's message. Units are
//! SI units and radians; quaternions are w x y z; x forward, y left, z up.
//!
//! # Threads
//! Every type except [`Recorder`] is `Send`: a handle may move between threads. Every type except
//! [`Recorder`] is `Sync`: functions of C that may run at the same time on one handle are `&self` methods,
//! the others are `&mut self` methods.
//!
//! Each constant of C belongs to a type: [`Quantity::BODY_POSITION`] is `MIMO_BODY_POSITION`, and
//! `Touch::FORCE | Touch::SLIP` are two bits. Functions that have no safe form yet are in [`sys`]. Items that
//! say "Experimental." may change with any version: docs/abi.md.
#![warn(missing_docs, missing_debug_implementations)]

pub use mimo_sys as sys;

#[macro_use]
mod enumerations;

mod access;
mod agent;
mod batch;
mod batch_access;
mod block;
#[rustfmt::skip]
mod configs;
#[rustfmt::skip]
mod constants;
mod constructors;
mod contacts;
mod conversions;
mod env;
mod error;
mod field;
mod gaze;
mod geometry;
mod layout;
mod lists;
mod log;
mod overrides;
mod picture;
mod recording;
#[rustfmt::skip]
mod records;
mod reset;
mod results;
mod rows;
mod scene;
mod sense;
mod senses;
mod stage;
#[rustfmt::skip]
mod stage_parts;
mod state;
mod steps;
mod structs;
mod task;
mod timing;
mod version;
mod world;

pub use agent::AgentInfo;
pub use batch::Batch;
pub use block::{Block, Observation};
pub use configs::*;
pub use constants::*;
pub use contacts::{Contact, StepContact};
pub use conversions::*;
pub use env::Env;
pub use error::{Error, Result};
pub use field::Field;
pub use gaze::{Gaze, LookAngles, Sightline};
pub use geometry::{Detail, Mesh, Pose, Texture};
pub use layout::{Layout, ReceptorInfo};
pub use lists::{builtin_scenes, faces, materials, parameters, rooms, tasks};
pub use log::LogRecord;
pub use picture::Picture;
pub use recording::{Recorded, Recorder, Recording};
pub use records::*;
pub use reset::{BatchReset, Reset};
pub use results::{BatchResults, Results, Step};
pub use scene::Scene;
pub use sense::{
    Sense, SenseField, SenseFields, SenseMoment, SenseNumber, SenseOpening, SenseParameter, SenseTable,
};
pub use senses::Senses;
pub use stage::{Stage, StagePicture, StageView};
pub use stage_parts::*;
pub use state::LoadReport;
pub use task::{Moment, Task, TaskField, Verdict};
pub use version::{abi_version, api_version, mujoco_version, supports, version};
pub use world::World;
