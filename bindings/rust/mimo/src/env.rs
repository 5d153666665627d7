//! Single worlds.
use crate::configs::EnvConfig;
use crate::error::{c_string, check, Result};
use crate::log::Log;
use crate::scene::Scene;
use crate::sys;
use crate::task::Shared;
use crate::world::World;
use std::ops::{Deref, DerefMut};
use std::ptr::{null_mut, NonNull};

/// A single world.
#[derive(Debug)]
pub struct Env {
    handle: NonNull<sys::mimo_env>,
    // Both outlive the handle, which points to them.
    log: Option<Log>,
    task: Option<Shared>,
}

// As World; log and task are Send and Sync.
unsafe impl Send for Env {}
unsafe impl Sync for Env {}

impl Env {
    /// A world of a built-in scene with its default infant and task.
    pub fn make(scene: &str) -> Result<Env> {
        let scene = c_string(scene)?;
        let mut handle = null_mut();
        check(unsafe { sys::mimo_env_make(scene.as_ptr(), &mut handle) })?;
        Ok(Env::own(handle, None, None))
    }

    /// Compiles a scene and makes a world in its initial state.
    pub fn new(scene: &Scene, config: &EnvConfig) -> Result<Env> {
        let mut handle = null_mut();
        config.with_raw(|raw| check(unsafe { sys::mimo_env_create(scene.handle(), raw, &mut handle) }))?;
        Ok(Env::own(handle, config.log.clone(), scene.task.clone()))
    }

    /// Another world of the same scene and config, in the same state. The two share the model.
    pub fn try_clone(&self) -> Result<Env> {
        let mut handle = null_mut();
        check(unsafe { sys::mimo_env_clone(self.handle.as_ptr(), &mut handle) })?;
        Ok(Env::own(handle, self.log.clone(), self.task.clone()))
    }

    pub(crate) fn own(handle: *mut sys::mimo_env, log: Option<Log>, task: Option<Shared>) -> Env {
        Env { handle: NonNull::new(handle).expect("a handle"), log, task }
    }
}

impl Deref for Env {
    type Target = World;
    fn deref(&self) -> &World {
        unsafe { World::of(self.handle.as_ptr()) }
    }
}

impl DerefMut for Env {
    fn deref_mut(&mut self) -> &mut World {
        unsafe { World::of(self.handle.as_ptr()) }
    }
}

impl Drop for Env {
    fn drop(&mut self) {
        unsafe { sys::mimo_env_destroy(self.handle.as_ptr()) }
    }
}
