//! A simulated world, whoever owns it.
use crate::block::Block;
use crate::error::Result;
use crate::layout::Layout;
use crate::results::Results;
use crate::sys;
use std::fmt;

/// A simulated world. What can be done with it does not depend on who owns it: an [`Env`](crate::Env), or a
/// [`Batch`](crate::Batch).
///
/// A reference to it *is* the library's handle, and it has no size of its own: a world cannot be moved out of its
/// owner, so that a world of a batch never outlives the batch.
#[repr(C)]
pub struct World {
    opaque: [u8; 0],
    // Neither Send nor Sync by itself.
    handle_of_c: std::marker::PhantomData<*mut u8>,
}

// `&self` methods call functions that take the handle as const, `&mut self` methods the others: the header's rule.
unsafe impl Send for World {}
unsafe impl Sync for World {}

impl fmt::Debug for World {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("World").field("handle", &self.handle()).finish()
    }
}

impl World {
    /// # Safety
    /// The handle lives, is not NULL, and nobody else uses it, for as long as the reference does.
    pub(crate) unsafe fn of<'a>(handle: *mut sys::mimo_env) -> &'a mut World {
        &mut *(handle as *mut World)
    }

    /// The library's handle, for functions of [`sys`] that have no method here.
    pub fn handle(&self) -> *mut sys::mimo_env {
        self as *const World as *mut sys::mimo_env
    }

    /// What it observes, acts with and is rewarded for.
    pub fn layout(&self) -> Result<Layout<'_>> {
        unsafe { Layout::of(|layout| sys::mimo_env_layout(self.handle(), layout)) }
    }

    /// Memory for its observations, zero at first.
    pub fn new_block(&self) -> Result<Block> {
        self.layout()?.new_blocks(1)
    }

    /// Memory for the results of its steps.
    pub fn new_results(&self) -> Result<Results> {
        Ok(Results::of(&self.layout()?))
    }
}
