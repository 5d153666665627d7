//! A simulated world.
use crate::block::Block;
use crate::error::Result;
use crate::layout::Layout;
use crate::results::Results;
use crate::sys;
use std::fmt;

/// A simulated world, which belongs to an [`Env`](crate::Env) or a [`Batch`](crate::Batch).
///
/// A reference to it *is* the library's handle, and the type has no size: a world cannot be moved out of its
/// owner, so a world of a batch never outlives the batch.
#[repr(C)]
pub struct World {
    opaque: [u8; 0],
    // Not Send or Sync by default.
    handle_of_c: std::marker::PhantomData<*mut u8>,
}

// `&self` methods call functions whose handle is const, `&mut self` methods call the others: the header's
// rule.
unsafe impl Send for World {}
unsafe impl Sync for World {}

impl fmt::Debug for World {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("World").field("handle", &self.handle()).finish()
    }
}

impl World {
    /// # Safety
    /// As long as the reference lives, the handle is valid, not NULL, and used by nobody else.
    pub(crate) unsafe fn of<'a>(handle: *mut sys::mimo_env) -> &'a mut World {
        &mut *(handle as *mut World)
    }

    /// The library's handle, for functions of [`sys`] that have no method here.
    pub fn handle(&self) -> *mut sys::mimo_env {
        self as *const World as *mut sys::mimo_env
    }

    /// Describes its observations, actions and rewards.
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
