//! How worlds are simulated.
use crate::error::{c_string, Result};
use crate::log::{self, Log, LogRecord};
use crate::structs::{defaults, pointer};
use crate::sys;
use std::ffi::CString;

/// How a world is simulated.
#[derive(Clone, Debug)]
pub struct EnvConfig {
    raw: sys::mimo_env_config,
    task: Option<CString>,
    renderer: Option<CString>,
    pub(crate) log: Option<Log>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for EnvConfig {}
unsafe impl Sync for EnvConfig {}

impl EnvConfig {
    /// The scene's own task and frame skip, any renderer, silent.
    pub fn new() -> Result<EnvConfig> {
        let raw = defaults(sys::mimo_env_config_init)?;
        Ok(EnvConfig { raw, task: None, renderer: None, log: None })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_env_config) -> R) -> R {
        let mut raw = self.raw;
        if self.renderer.is_some() {
            raw.renderer = pointer(&self.renderer);
        }
        if self.task.is_some() {
            raw.task = pointer(&self.task);
        }
        (raw.log, raw.log_user) = log::raw(&self.log);
        use_it(&raw)
    }

    /// A task by name, "none", "reach", ..., in place of the scene's; see [`tasks`](crate::tasks).
    pub fn task(&mut self, name: &str) -> Result<&mut Self> {
        self.task = Some(c_string(name)?);
        Ok(self)
    }

    /// "ray", "osmesa", "gl" (a graphics card), "auto", or "none": then eyes must be off.
    pub fn renderer(&mut self, name: &str) -> Result<&mut Self> {
        self.renderer = Some(c_string(name)?);
        Ok(self)
    }

    /// Physics steps of 5 ms per environment step, 1 to 1000; 0: the scene's own.
    pub fn frame_skip(&mut self, steps: u32) -> &mut Self {
        self.raw.frame_skip = steps;
        self
    }

    /// Steps after which an episode is truncated; 0: the task's own.
    pub fn max_steps(&mut self, steps: u32) -> &mut Self {
        self.raw.max_steps = steps;
        self
    }

    /// Whether [`World::timing`](crate::World::timing) counts, which costs a few clock reads a step.
    pub fn timing(&mut self, on: bool) -> &mut Self {
        self.raw.timing = on.into();
        self
    }

    /// `MIMO_RENDER_` bits: what pictures show.
    pub fn render(&mut self, bits: u32) -> &mut Self {
        self.raw.render = bits;
        self
    }

    /// Samples a pixel for smooth edges: 1, 4, 16 or 64; 0: one ray, or what the model tells OpenGL.
    pub fn samples(&mut self, samples: u32) -> &mut Self {
        self.raw.samples = samples;
        self
    }

    /// What touched what during a step is recorded, for [`World::step_contacts`](crate::World::step_contacts).
    pub fn step_contacts(&mut self, recorded: bool) -> &mut Self {
        self.raw.step_contacts = recorded as u32;
        self
    }

    /// Threads that draw one picture, 1 to 64; 1 is best in batches.
    pub fn render_threads(&mut self, threads: u32) -> &mut Self {
        self.raw.render_threads = threads;
        self
    }

    /// A `MIMO_JACOBIAN_` constant.
    pub fn jacobian(&mut self, kind: u32) -> &mut Self {
        self.raw.jacobian = kind as i32;
        self
    }

    /// `MIMO_DISABLE_` bits: what physics leaves out; 0: nothing.
    pub fn disable(&mut self, bits: u32) -> &mut Self {
        self.raw.disable = bits;
        self
    }

    /// Receives the library's messages during create, reset and step, on the calling thread. A panic in it is
    /// caught and dropped. It is shared by clones of the world.
    pub fn log(&mut self, log: impl Fn(&LogRecord) + Send + Sync + 'static) -> &mut Self {
        self.log = Some(Log::new(log));
        self
    }
}
