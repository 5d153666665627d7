//! Senses on a simulation that is not this library's.
use crate::block::Block;
use crate::config::EnvConfig;
use crate::error::{check, Error, Kind, Result};
use crate::field::Field;
use crate::log::Log;
use crate::scene::Scene;
use crate::sys;
use crate::world::memory;
use std::os::raw::c_void;
use std::ptr::{null_mut, NonNull};

/// Senses that look at a host's own MuJoCo model, and never change it.
#[derive(Debug)]
pub struct Senses {
    handle: NonNull<sys::mimo_senses>,
    // Outlives the handle, which points to it.
    _log: Option<Log>,
}

// `&self` methods call functions that take the handle as const, `&mut self` methods the others: the header's rule.
unsafe impl Send for Senses {}
unsafe impl Sync for Senses {}

impl Senses {
    /// Attaches senses to a model; the scene describes the agents (with the body "scene"), their skin and the cameras.
    /// Of the config, renderer, picture quality and log count. `mujoco_version` is what the host's `mj_version()` says,
    /// `sizes` are those of its mjModel and mjData; 0 where it cannot know.
    ///
    /// # Safety
    /// `model` is an mjModel of that version. It outlives the senses and keeps its sizes, and nobody writes to it while
    /// a method runs.
    pub unsafe fn attach(
        scene: &Scene,
        config: &EnvConfig,
        model: *const c_void,
        mujoco_version: i32,
        sizes: [usize; 2],
    ) -> Result<Senses> {
        let mut handle = null_mut();
        config.with_raw(|raw| {
            let [model_size, data_size] = sizes;
            check(sys::mimo_senses_attach(
                scene.handle(),
                raw,
                model,
                mujoco_version,
                model_size,
                data_size,
                &mut handle,
            ))
        })?;
        Ok(Senses { handle: NonNull::new(handle).expect("a handle"), _log: config.log.clone() })
    }

    fn handle(&self) -> *mut sys::mimo_senses {
        self.handle.as_ptr()
    }

    /// The fields of its observations, in their order.
    pub fn fields(&self) -> Result<Vec<Field>> {
        let mut count = 0;
        check(unsafe { sys::mimo_senses_observation_size(self.handle(), null_mut(), &mut count) })?;
        (0..count).map(|index| self.field(index)).collect()
    }

    fn field(&self, index: usize) -> Result<Field> {
        let mut raw: sys::mimo_field = unsafe { std::mem::zeroed() };
        raw.struct_size = std::mem::size_of_val(&raw) as u32;
        check(unsafe { sys::mimo_senses_observation_field(self.handle(), index, &mut raw) })?;
        Field::of(&raw).ok_or_else(|| Error::new(Kind::Unsupported, format!("unknown dtype {}", raw.dtype)))
    }

    /// Memory for its observations, zero at first.
    pub fn new_block(&self) -> Result<Block> {
        let mut bytes = 0;
        check(unsafe { sys::mimo_senses_observation_size(self.handle(), &mut bytes, null_mut()) })?;
        Ok(Block::new(bytes, 1, self.fields()?.into()))
    }

    /// Senses what the data hold, which stay as they are.
    ///
    /// # Safety
    /// `data` is an mjData of the model that the senses are attached to, and nobody writes to it meanwhile.
    pub unsafe fn observe(&mut self, data: *const c_void, block: &mut Block) -> Result<()> {
        let (bytes, count) = memory(Some(block));
        check(sys::mimo_senses_observe(self.handle(), data, bytes, count))
    }
}

impl Drop for Senses {
    fn drop(&mut self) {
        unsafe { sys::mimo_senses_destroy(self.handle()) }
    }
}
