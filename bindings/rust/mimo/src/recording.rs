//! Recordings of runs in HDF5 files, and their replay.
use crate::block::{memory, Block};
use crate::configs::{AgentConfig, EnvConfig, RecorderConfig};
use crate::constants::Replay;
use crate::env::Env;
use crate::error::{c_string, check, Result};
use crate::records::{RecordingInfo, ReplayReport};
use crate::results::Step;
use crate::sense::{Sense, SenseTable};
use crate::structs::{described, pointer};
use crate::sys;
use crate::world::World;
use std::os::raw::c_void;
use std::ptr::{null, null_mut, NonNull};

/// Records all steps of a world, also after the world was moved, until the recorder or the world is closed or
/// dropped. A recorder is neither `Send` nor `Sync`: closing it needs the world alone, so both stay on one
/// thread.
#[derive(Debug)]
pub struct Recorder {
    handle: Option<NonNull<sys::mimo_recorder>>,
}

impl Recorder {
    /// Records a world from now on. If the file exists, this is an error, unless the config says
    /// [`replace`](RecorderConfig::replace).
    pub fn open(world: &mut World, path: &str, config: &RecorderConfig) -> Result<Recorder> {
        let path = c_string(path)?;
        let mut handle = null_mut();
        config.with_raw(|config| {
            check(unsafe { sys::mimo_recorder_open(world.handle(), path.as_ptr(), config, &mut handle) })
        })?;
        Ok(Recorder { handle: NonNull::new(handle) })
    }

    fn handle(&self) -> *mut sys::mimo_recorder {
        self.handle.map_or(null_mut(), |handle| handle.as_ptr())
    }

    /// Writes everything to the file now.
    pub fn flush(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_recorder_flush(self.handle()) })
    }

    /// Writes the last state and closes the file; an error says what could not be written.
    pub fn close(mut self) -> Result<()> {
        let status = unsafe { sys::mimo_recorder_close(self.handle()) };
        self.handle = None;
        check(status)
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        unsafe { sys::mimo_recorder_close(self.handle()) };
    }
}

/// A recording that is read, and replayed in a world like the recorded one.
#[derive(Debug)]
pub struct Recording {
    handle: NonNull<sys::mimo_recording>,
}

// `&self` methods call functions whose handle is const, `&mut self` methods call the others: the header's
// rule.
unsafe impl Send for Recording {}
unsafe impl Sync for Recording {}

/// Types of numbers in recordings.
pub trait Recorded: Copy + Default + private::Sealed {}
macro_rules! recorded {
    ($($number:ty)*) => { $(impl private::Sealed for $number {} impl Recorded for $number {})* };
}
recorded!(u8 i32 i64 u64 f32 f64);
mod private {
    pub trait Sealed {}
}

impl Recording {
    /// Opens a recording. `hdf5` is the path of the HDF5 library; None: the system's.
    pub fn open(path: &str, hdf5: Option<&str>) -> Result<Recording> {
        let (path, hdf5) = (c_string(path)?, hdf5.map(c_string).transpose()?);
        let mut handle = null_mut();
        check(unsafe { sys::mimo_recording_open(path.as_ptr(), pointer(&hdf5), &mut handle) })?;
        Ok(Recording { handle: NonNull::new(handle).expect("a handle") })
    }

    fn handle(&self) -> *mut sys::mimo_recording {
        self.handle.as_ptr()
    }

    /// Its contents.
    pub fn info(&self) -> Result<RecordingInfo> {
        Ok(RecordingInfo::of(&described(|info| unsafe {
            sys::mimo_recording_describe(self.handle(), info)
        })?))
    }

    /// The number of rows of a dataset, and their length in bytes.
    pub fn size(&self, dataset: &str) -> Result<(usize, usize)> {
        let (name, mut rows, mut bytes) = (c_string(dataset)?, 0, 0);
        check(unsafe { sys::mimo_recording_size(self.handle(), name.as_ptr(), &mut rows, &mut bytes) })?;
        Ok((rows, bytes))
    }

    /// Rows of a dataset, one after the other, as numbers of the type in the file: `f32` for actions and most
    /// fields, `f64` for joints and rewards.
    pub fn read<T: Recorded>(&self, dataset: &str, first: usize, rows: usize) -> Result<Vec<T>> {
        let (there, row_bytes) = self.size(dataset)?;
        let bytes = rows.saturating_mul(row_bytes);
        let name = c_string(dataset)?;
        // For rows that do not exist the library returns the error, before memory is allocated.
        let known = first <= there && rows <= there - first;
        let mut values = vec![T::default(); if known { bytes / std::mem::size_of::<T>() } else { 0 }];
        let to = if values.is_empty() { null_mut() } else { values.as_mut_ptr() as *mut c_void };
        let room = values.len() * std::mem::size_of::<T>();
        check(unsafe { sys::mimo_recording_read(self.handle(), name.as_ptr(), first, rows, to, room) })?;
        Ok(values)
    }

    /// Brings along a sense of your own that the recorded world had, by its name.
    pub fn add_sense<S: Sense>(&mut self, name: &str) -> Result<()> {
        let table = SenseTable::<S>::new(name)?;
        check(unsafe { sys::mimo_recording_add_sense(self.handle(), table.raw()) })
    }

    /// The same for a sense in a shared library.
    pub fn load_sense(&mut self, path: &str) -> Result<()> {
        let path = c_string(path)?;
        check(unsafe { sys::mimo_recording_load_sense(self.handle(), path.as_ptr()) })
    }

    /// Makes the recorded world from the file alone. A custom task is not in the file: the world gets one that does
    /// nothing, and a replay returns the recorded results. `senses`: what each infant senses, where a sense may be
    /// `sys::MIMO_AS_RECORDED`; None: as recorded.
    pub fn env(&self, config: &EnvConfig, senses: Option<&AgentConfig>) -> Result<Env> {
        let mut handle = null_mut();
        let make = |config, senses, env| {
            check(unsafe { sys::mimo_recording_env(self.handle(), config, senses, env) })
        };
        config.with_raw(|config| match senses {
            Some(senses) => senses.with_raw(|senses| make(config, senses, &mut handle)),
            None => make(config, null(), &mut handle),
        })?;
        Ok(Env::own(handle, config.log.clone(), None))
    }

    /// Loads the last kept state that is not later than a step, and returns that state's step. Without
    /// `Replay::FIELDS` the world's senses may differ from the recorded ones; with `Replay::JOINTS` steps set the
    /// recorded joints, which works with any version. Infants get their recorded age.
    pub fn seek(&mut self, world: &mut World, step: usize, how: Replay) -> Result<usize> {
        let mut at = 0;
        check(unsafe { sys::mimo_recording_seek(self.handle(), world.handle(), step, how.raw(), &mut at) })?;
        Ok(at)
    }

    /// Replays the next step in a world of one agent, and compares the result with the recording.
    pub fn step(&mut self, world: &mut World, block: Option<&mut Block>) -> Result<Step> {
        let mut step = Step::new();
        let raw = step.raw();
        self.step_raw(world, block, &raw)?;
        Ok(step)
    }

    /// Replays all remaining steps without results, so with any number of agents.
    pub fn play(&mut self, world: &mut World) -> Result<ReplayReport> {
        let steps = self.info()?.steps;
        while self.report()?.next < steps {
            self.step_raw(world, None, null())?;
        }
        self.report()
    }

    fn step_raw(
        &mut self,
        world: &mut World,
        block: Option<&mut Block>,
        results: *const sys::mimo_env_results,
    ) -> Result<()> {
        let (bytes, count) = memory(block);
        check(unsafe { sys::mimo_recording_step(self.handle(), world.handle(), bytes, count, results) })
    }

    /// The result of all comparisons since the last seek.
    pub fn report(&self) -> Result<ReplayReport> {
        Ok(ReplayReport::of(&described(|report| unsafe {
            sys::mimo_recording_report(self.handle(), report)
        })?))
    }
}

impl Drop for Recording {
    fn drop(&mut self) {
        unsafe { sys::mimo_recording_close(self.handle()) }
    }
}
