//! Many worlds.
use crate::block::Block;
use crate::config::{defaults, EnvConfig};
use crate::error::{check, text, Error, Kind, Result};
use crate::log::Log;
use crate::scene::Scene;
use crate::state::LoadReport;
use crate::sys;
use crate::task::Shared;
use crate::world::{memory, World};
use std::os::raw::c_void;
use std::ptr::{null, null_mut, NonNull};

/// How many worlds, and what happens when one's episode ends.
#[derive(Clone, Copy, Debug)]
pub struct BatchConfig {
    raw: sys::mimo_batch_config,
}

impl BatchConfig {
    /// That many worlds, all cores, no automatic reset.
    pub fn new(worlds: u32) -> Result<BatchConfig> {
        let mut raw = defaults(sys::mimo_batch_config_init)?;
        raw.worlds = worlds;
        Ok(BatchConfig { raw })
    }

    /// 0: as many as the machine has cores.
    pub fn threads(&mut self, threads: u32) -> &mut Self {
        self.raw.threads = threads;
        self
    }

    /// A `MIMO_AUTORESET_` constant.
    pub fn autoreset(&mut self, mode: u32) -> &mut Self {
        self.raw.autoreset = mode as i32;
        self
    }

    /// Whether a world whose simulation fails starts a new episode.
    pub fn restart_failed(&mut self, on: bool) -> &mut Self {
        self.raw.restart_failed = on.into();
        self
    }
}

/// What a step of a batch gave, beside the observations. Made by [`Batch::new_results`], overwritten by each step.
#[derive(Clone, Debug)]
pub struct BatchResults {
    /// Rewards, worlds x agents.
    pub reward: Vec<f64>,
    /// 1 where an episode has ended by success or failure, worlds x agents.
    pub terminated: Vec<u8>,
    /// 1 where an episode has reached its step limit, worlds x agents.
    pub truncated: Vec<u8>,
    /// 1 for worlds that this step started anew: their observation is the first of an episode.
    pub was_reset: Vec<u8>,
    /// 1 for worlds whose final block was written.
    pub final_written: Vec<u8>,
    /// With `MIMO_AUTORESET_SAME_STEP`: last observations of the episodes that ended. None: not wanted.
    pub final_blocks: Option<Block>,
}

impl BatchResults {
    fn with_raw<R>(&mut self, use_it: impl FnOnce(&sys::mimo_batch_results) -> R) -> Result<R> {
        let (agents, worlds) = (self.reward.len(), self.was_reset.len());
        // C knows one length for each group of arrays.
        let same = [self.terminated.len(), self.truncated.len()] == [agents; 2]
            && self.final_written.len() == worlds;
        if !same {
            return Err(Error::new(Kind::InvalidArgument, "arrays of the results differ in length"));
        }
        let (final_blocks, final_bytes) = memory(self.final_blocks.as_mut());
        Ok(use_it(&sys::mimo_batch_results {
            struct_size: std::mem::size_of::<sys::mimo_batch_results>() as u32,
            reserved: 0,
            reward: self.reward.as_mut_ptr(),
            terminated: self.terminated.as_mut_ptr(),
            truncated: self.truncated.as_mut_ptr(),
            agents,
            status: null_mut(),
            was_reset: self.was_reset.as_mut_ptr(),
            final_written: self.final_written.as_mut_ptr(),
            worlds,
            final_blocks,
            final_bytes,
        }))
    }
}

/// Many worlds of one scene, stepped by a pool of threads. World i does exactly what a single one does that is
/// reset with the i-th seed and given the i-th actions.
#[derive(Debug)]
pub struct Batch {
    handle: NonNull<sys::mimo_batch>,
    worlds: usize,
    threads: usize,
    // Both outlive the handle, which points to them.
    _log: Option<Log>,
    _task: Option<Shared>,
}

// `&self` methods call functions that take the handle as const, `&mut self` methods the others: the header's rule.
unsafe impl Send for Batch {}
unsafe impl Sync for Batch {}

impl Batch {
    /// Compiles a scene once and makes worlds of it.
    pub fn new(scene: &Scene, env: &EnvConfig, batch: &BatchConfig) -> Result<Batch> {
        let mut handle = null_mut();
        env.with_raw(|env| {
            check(unsafe { sys::mimo_batch_create(scene.handle(), env, &batch.raw, &mut handle) })
        })?;
        let handle = NonNull::new(handle).expect("a handle");
        let mut made =
            Batch { handle, worlds: 0, threads: 0, _log: env.log.clone(), _task: scene.task.clone() };
        check(unsafe { sys::mimo_batch_size(made.handle(), &mut made.worlds, &mut made.threads) })?;
        Ok(made)
    }

    /// The library's handle, for functions of [`sys`] that have no method here.
    pub fn handle(&self) -> *mut sys::mimo_batch {
        self.handle.as_ptr()
    }

    /// Number of worlds.
    pub fn worlds(&self) -> usize {
        self.worlds
    }

    /// Number of threads that step them.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// One world. It takes everything a world of its own does.
    pub fn world(&mut self, world: usize) -> Result<&mut World> {
        let mut env = null_mut();
        check(unsafe { sys::mimo_batch_world(self.handle(), world, &mut env) })?;
        // Borrowed from the batch, which is not used meanwhile.
        Ok(unsafe { World::of(env) })
    }

    /// Memory for the observations of all worlds.
    pub fn new_blocks(&mut self) -> Result<Block> {
        let worlds = self.worlds;
        self.world(0)?.new_blocks(worlds)
    }

    /// Memory for the results of a step; final blocks are not wanted unless set.
    pub fn new_results(&mut self) -> Result<BatchResults> {
        let worlds = self.worlds;
        let agents = worlds * self.world(0)?.agent_count()?;
        Ok(BatchResults {
            reward: vec![0.0; agents],
            terminated: vec![0; agents],
            truncated: vec![0; agents],
            was_reset: vec![0; worlds],
            final_written: vec![0; worlds],
            final_blocks: None,
        })
    }

    /// Starts episodes in all worlds, with one seed for each or with their own random numbers.
    pub fn reset(&mut self, seeds: Option<&[u64]>, blocks: Option<&mut Block>) -> Result<()> {
        let (bytes, count) = memory(blocks);
        let (seeds, worlds) = seeds.map_or((null(), 0), |seeds| (seeds.as_ptr(), seeds.len()));
        check(unsafe { sys::mimo_batch_reset(self.handle(), seeds, null(), worlds, bytes, count) })
    }

    /// Starts episodes in the worlds whose entry of the mask is true; the others, and their blocks, stay as they are.
    pub fn reset_where(&mut self, mask: &[bool], blocks: Option<&mut Block>) -> Result<()> {
        let (bytes, count) = memory(blocks);
        let (mask, worlds) = chosen(Some(mask));
        check(unsafe { sys::mimo_batch_reset(self.handle(), null(), mask, worlds, bytes, count) })
    }

    /// Goes one step on in all worlds; `actions` is worlds x actions, or empty: controls stay as they are.
    /// The error is that of the first world that did not do what was asked; all others have made their step.
    pub fn step(
        &mut self,
        actions: &[f32],
        blocks: Option<&mut Block>,
        results: &mut BatchResults,
    ) -> Result<()> {
        let (bytes, count) = memory(blocks);
        let values = if actions.is_empty() { null() } else { actions.as_ptr() };
        results.with_raw(|raw| {
            check(unsafe { sys::mimo_batch_step(self.handle(), values, actions.len(), bytes, count, raw) })
        })?
    }

    /// A step as [`step`](Self::step) does it, on the batch's threads, while this thread does something else.
    pub fn step_while<R>(
        &mut self,
        actions: &[f32],
        blocks: Option<&mut Block>,
        results: &mut BatchResults,
        work: impl FnOnce() -> R,
    ) -> Result<R> {
        /// Receives what was sent whatever happens: until then the arrays belong to the batch.
        struct Sent<'a>(&'a Batch, bool);
        impl Sent<'_> {
            fn receive(mut self) -> Result<()> {
                self.1 = true;
                check(unsafe { sys::mimo_batch_receive(self.0.handle()) })
            }
        }
        impl Drop for Sent<'_> {
            fn drop(&mut self) {
                if !self.1 {
                    unsafe { sys::mimo_batch_receive(self.0.handle()) };
                }
            }
        }
        let (bytes, count) = memory(blocks);
        let values = if actions.is_empty() { null() } else { actions.as_ptr() };
        results.with_raw(|raw| {
            check(unsafe { sys::mimo_batch_send(self.handle(), values, actions.len(), bytes, count, raw) })
        })??;
        let sent = Sent(self, false);
        let done = work();
        sent.receive()?;
        Ok(done)
    }

    /// The observations of the current states, without changing trajectories.
    pub fn observe(&mut self, blocks: &mut Block) -> Result<()> {
        let (bytes, count) = memory(Some(blocks));
        check(unsafe { sys::mimo_batch_observe(self.handle(), null(), 0, bytes, count) })
    }

    /// Gives an infant another face in the worlds whose entry of the mask is true; None: in all.
    pub fn set_face(&mut self, agent: usize, name: &str, mask: Option<&[bool]>) -> Result<()> {
        let face = self.world(0)?.find(sys::MIMO_FACE, name)? as f64;
        self.set_in(sys::MIMO_AGENT_FACE, &[agent as i32], &vec![face; self.worlds], mask)
    }

    /// The states of all worlds, one after the other; all have the same size.
    pub fn save(&mut self) -> Result<Vec<u8>> {
        let mut bytes = 0;
        check(unsafe { sys::mimo_env_state_size(self.world(0)?.handle(), &mut bytes) })?;
        let mut states = vec![0; bytes * self.worlds];
        check(unsafe {
            let (to, bytes) = (states.as_mut_ptr() as *mut c_void, states.len());
            sys::mimo_batch_state_save(self.handle(), null(), 0, to, bytes)
        })?;
        Ok(states)
    }

    /// Loads one state for each world, or a single one into all: futures of one present. Only into the worlds whose
    /// entry of the mask is true; None: into all. Tells of the world where most started fresh.
    pub fn load(&mut self, states: &[u8], mask: Option<&[bool]>) -> Result<LoadReport> {
        let (mask, worlds) = chosen(mask);
        let from = states.as_ptr() as *const c_void;
        LoadReport::of(|report| unsafe {
            sys::mimo_batch_state_load(self.handle(), mask, worlds, from, states.len(), report)
        })
    }

    /// What became of one world in the last call: its message, "" for none.
    pub fn world_error(&self, world: usize) -> Result<String> {
        let mut message = null();
        check(unsafe { sys::mimo_batch_world_error(self.handle(), world, null_mut(), &mut message) })?;
        Ok(text(message))
    }

    /// Reads a quantity of many ids in all worlds into `values`: worlds x [`World::width`].
    pub fn get_into(&self, quantity: u32, ids: &[i32], values: &mut [f64]) -> Result<()> {
        let (ids, id_count) = (ids.as_ptr(), ids.len());
        check(unsafe {
            let (into, count) = (values.as_mut_ptr(), values.len());
            sys::mimo_batch_get(
                self.handle(),
                quantity as i32,
                ids,
                id_count,
                null(),
                self.worlds,
                into,
                count,
            )
        })
    }

    /// The same in single precision, for engines.
    pub fn get_f32_into(&self, quantity: u32, ids: &[i32], values: &mut [f32]) -> Result<()> {
        let (ids, id_count) = (ids.as_ptr(), ids.len());
        let (into, count) = (values.as_mut_ptr(), values.len());
        check(unsafe {
            sys::mimo_batch_get_float(self.handle(), quantity as i32, ids, id_count, null(), 0, into, count)
        })
    }

    /// Writes a quantity of many ids in all worlds: worlds x [`World::width`].
    pub fn set(&mut self, quantity: u32, ids: &[i32], values: &[f64]) -> Result<()> {
        self.set_in(quantity, ids, values, None)
    }

    /// The same, but only in the worlds whose entry of the mask is true; None: in all.
    pub fn set_in(
        &mut self,
        quantity: u32,
        ids: &[i32],
        values: &[f64],
        mask: Option<&[bool]>,
    ) -> Result<()> {
        let (mask, worlds) = chosen(mask);
        let (ids, id_count) = (ids.as_ptr(), ids.len());
        let (from, count) = (values.as_ptr(), values.len());
        check(unsafe {
            sys::mimo_batch_set(self.handle(), quantity as i32, ids, id_count, mask, worlds, from, count)
        })
    }
}

/// A mask as C has it, and its length. `bool` is a byte of 0 or 1.
fn chosen(mask: Option<&[bool]>) -> (*const u8, usize) {
    mask.map_or((null(), 0), |mask| (mask.as_ptr() as *const u8, mask.len()))
}

impl Drop for Batch {
    fn drop(&mut self) {
        unsafe { sys::mimo_batch_destroy(self.handle()) }
    }
}
