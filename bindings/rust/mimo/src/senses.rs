//! Senses on a simulation of your own.
use crate::block::{memory, Block};
use crate::configs::SensesConfig;
use crate::error::{c_string, check, Result};
use crate::layout::Layout;
use crate::log::Log;
use crate::reset::Reset;
use crate::scene::Scene;
use crate::state::LoadReport;
use crate::sys;
use std::os::raw::c_void;
use std::ptr::{null_mut, NonNull};

/// Senses on your own MuJoCo model, which they never change.
#[derive(Debug)]
pub struct Senses {
    handle: NonNull<sys::mimo_senses>,
    // Outlives the handle, which points to it.
    _log: Option<Log>,
}

// `&self` methods call functions whose handle is const, `&mut self` methods call the others: the header's
// rule.
unsafe impl Send for Senses {}
unsafe impl Sync for Senses {}

impl Senses {
    /// Attaches senses to a model; the scene describes the agents (with the body "scene"), their skin, the limits of
    /// their senses and the cameras.
    ///
    /// # Safety
    /// `model` is an mjModel of the config's version. It outlives the senses and keeps its sizes, and nobody writes to
    /// it while a method runs.
    pub unsafe fn attach(scene: &Scene, model: *const c_void, config: &SensesConfig) -> Result<Senses> {
        let mut handle = null_mut();
        config.with_raw(|raw| check(sys::mimo_senses_attach(scene.handle(), model, raw, &mut handle)))?;
        Ok(Senses { handle: NonNull::new(handle).expect("a handle"), _log: config.log.clone() })
    }

    fn handle(&self) -> *mut sys::mimo_senses {
        self.handle.as_ptr()
    }

    /// Describes the observations. It has no actions and no terms.
    pub fn layout(&self) -> Result<Layout<'_>> {
        unsafe { Layout::of(|layout| sys::mimo_senses_layout(self.handle(), layout)) }
    }

    /// Memory for its observations, zero at first.
    pub fn new_block(&self) -> Result<Block> {
        self.layout()?.new_blocks(1)
    }

    /// Starts an episode: delayed senses forget everything before `data`. Noise follows from the seed;
    /// without a seed it continues from the last episode.
    ///
    /// # Safety
    /// As [`Senses::observe`].
    pub unsafe fn reset(&mut self, data: *const c_void, how: Reset) -> Result<()> {
        how.with_raw(|how| check(sys::mimo_senses_reset(self.handle(), data, how)))
    }

    /// Call it once after each step of your simulation: senses with a delay remember the values of `data`.
    ///
    /// # Safety
    /// As [`Senses::observe`].
    pub unsafe fn advance(&mut self, data: *const c_void) -> Result<()> {
        check(sys::mimo_senses_advance(self.handle(), data))
    }

    /// Sets the dynamic and static drive of the spindles of both muscles of each motor, Hz, four numbers per
    /// motor, until an episode starts. None: all motors that have spindles.
    pub fn drive_spindles(&mut self, actuators: Option<&[i32]>, rates: &[f64]) -> Result<()> {
        let (ids, count) = actuators.map_or((std::ptr::null(), 0), |ids| (ids.as_ptr(), ids.len()));
        check(unsafe {
            sys::mimo_senses_drive_spindles(self.handle(), ids, count, rates.as_ptr(), rates.len())
        })
    }

    /// Makes a body play samples, Pa at 1 m, from the next [`advance`](Self::advance) on: see
    /// [`World::play`](crate::World::play).
    pub fn play(&mut self, body: &str, samples: &[f32], rate: f64) -> Result<()> {
        let body = c_string(body)?;
        check(unsafe {
            sys::mimo_senses_play(self.handle(), body.as_ptr(), samples.as_ptr(), samples.len(), rate)
        })
    }

    /// The memories of the senses, as bytes.
    pub fn save(&self) -> Result<Vec<u8>> {
        let mut bytes = 0;
        check(unsafe { sys::mimo_senses_state_size(self.handle(), &mut bytes) })?;
        let mut state = vec![0; bytes];
        check(unsafe {
            sys::mimo_senses_state_save(self.handle(), state.as_mut_ptr() as *mut c_void, bytes)
        })?;
        Ok(state)
    }

    /// Loads the memories of other senses of such a model. Memories that the state lacks start fresh.
    pub fn load(&mut self, state: &[u8]) -> Result<LoadReport> {
        let from = state.as_ptr() as *const c_void;
        LoadReport::of(|report| unsafe {
            sys::mimo_senses_state_load(self.handle(), from, state.len(), report)
        })
    }

    /// Observes the state in `data`. Delayed values come from memory. Neither changes.
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
