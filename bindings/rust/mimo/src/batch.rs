//! Many worlds.
use crate::block::{memory, Block};
use crate::configs::{BatchConfig, EnvConfig};
use crate::constants::Movement;
use crate::error::{check, text, told, Error, Result};
use crate::layout::Layout;
use crate::log::Log;
use crate::reset::BatchReset;
use crate::results::BatchResults;
use crate::scene::Scene;
use crate::sys;
use crate::task::Shared;
use crate::world::World;
use std::ptr::{null, null_mut, NonNull};

/// Many worlds of one scene, stepped by a pool of threads. World i does exactly what a single world does
/// after a reset with the i-th seed, with the i-th actions.
#[derive(Debug)]
pub struct Batch {
    handle: NonNull<sys::mimo_batch>,
    worlds: usize,
    threads: usize,
    // Both outlive the handle, which points to them.
    _log: Option<Log>,
    _task: Option<Shared>,
}

// `&self` methods call functions whose handle is const, `&mut self` methods call the others: the header's
// rule.
unsafe impl Send for Batch {}
unsafe impl Sync for Batch {}

impl Batch {
    /// Compiles a scene once and makes worlds of it.
    pub fn new(scene: &Scene, env: &EnvConfig, batch: &BatchConfig) -> Result<Batch> {
        let mut handle = null_mut();
        env.with_raw(|env| {
            batch.with_raw(|batch| {
                check(unsafe { sys::mimo_batch_create(scene.handle(), env, batch, &mut handle) })
            })
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

    /// One world. All functions of a single world work on it.
    pub fn world(&mut self, world: usize) -> Result<&mut World> {
        let mut env = null_mut();
        check(unsafe { sys::mimo_batch_world(self.handle(), world, &mut env) })?;
        // It borrows the batch, so nothing else can use the batch meanwhile.
        Ok(unsafe { World::of(env) })
    }

    /// Describes the observations, actions and rewards of each of its worlds.
    pub fn layout(&self) -> Result<Layout<'_>> {
        unsafe { Layout::of(|layout| sys::mimo_batch_layout(self.handle(), layout)) }
    }

    /// Memory for the observations of all worlds.
    pub fn new_blocks(&self) -> Result<Block> {
        self.layout()?.new_blocks(self.worlds)
    }

    /// Memory for the results of a step. Final blocks are written only if you set them.
    pub fn new_results(&self) -> Result<BatchResults> {
        Ok(BatchResults::of(&self.layout()?, self.worlds))
    }

    /// Starts episodes. Without blocks the senses are skipped.
    pub fn reset(&mut self, how: BatchReset, blocks: Option<&mut Block>) -> Result<()> {
        let (bytes, count) = memory(blocks);
        how.with_raw(|how| check(unsafe { sys::mimo_batch_reset(self.handle(), how, bytes, count) }))?
    }

    /// Makes one step in all worlds. `actions` is worlds x actions; if it is empty, the controls do not
    /// change. If a world fails, the error is that of the first world that failed; all other worlds have made
    /// their step.
    pub fn step(
        &mut self,
        actions: &[f32],
        blocks: Option<&mut Block>,
        results: &mut BatchResults,
    ) -> Result<()> {
        let (bytes, count) = memory(blocks);
        let values = if actions.is_empty() { null() } else { actions.as_ptr() };
        let raw = results.raw()?;
        check(unsafe { sys::mimo_batch_step(self.handle(), values, actions.len(), bytes, count, &raw) })
    }

    /// The same as [`step`](Self::step), on the batch's threads, while this thread runs `work`.
    pub fn step_while<R>(
        &mut self,
        actions: &[f32],
        blocks: Option<&mut Block>,
        results: &mut BatchResults,
        work: impl FnOnce() -> R,
    ) -> Result<R> {
        /// Receives the step in any case: until then the arrays belong to the batch.
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
        let raw = results.raw()?;
        check(unsafe { sys::mimo_batch_send(self.handle(), values, actions.len(), bytes, count, &raw) })?;
        let sent = Sent(self, false);
        let done = work();
        sent.receive()?;
        Ok(done)
    }

    /// Observes the current states, without changing trajectories.
    pub fn observe(&mut self, blocks: &mut Block) -> Result<()> {
        let (bytes, count) = memory(Some(blocks));
        check(unsafe { sys::mimo_batch_observe(self.handle(), null(), 0, bytes, count) })
    }

    /// Fills in what the motors of all infants do by themselves: actions for the next step, one world after the other.
    /// `which` are kinds of movements.
    pub fn spontaneous(&self, which: Movement, actions: &mut [f32]) -> Result<()> {
        let (place, count) = (actions.as_mut_ptr(), actions.len());
        check(unsafe { sys::mimo_batch_spontaneous(self.handle(), which.raw(), place, count) })
    }

    /// The error of one world in the last call; None if there was none.
    pub fn world_error(&self, world: usize) -> Result<Option<Error>> {
        let (mut status, mut message) = (0, null());
        check(unsafe { sys::mimo_batch_world_error(self.handle(), world, &mut status, &mut message) })?;
        Ok(told(status, || text(message)))
    }
}

impl Drop for Batch {
    fn drop(&mut self) {
        unsafe { sys::mimo_batch_destroy(self.handle()) }
    }
}
