//! Quantities and states of the worlds of a batch.
use crate::batch::Batch;
use crate::constants::{Kind, Quantity};
use crate::error::{check, Result};
use crate::reset::chosen;
use crate::state::LoadReport;
use crate::sys;
use std::os::raw::c_void;
use std::ptr::null;

impl Batch {
    /// Reads a quantity of many ids in all worlds into `values`: worlds x [`World::width`](crate::World::width).
    pub fn get_into(&self, quantity: Quantity, ids: &[i32], values: &mut [f64]) -> Result<()> {
        let (batch, quantity, (ids, id_count)) = (self.handle(), quantity.raw(), (ids.as_ptr(), ids.len()));
        let (to, count) = (values.as_mut_ptr(), values.len());
        check(unsafe { sys::mimo_batch_get(batch, quantity, ids, id_count, null(), 0, to, count) })
    }

    /// The same in single precision, for engines.
    pub fn get_f32_into(&self, quantity: Quantity, ids: &[i32], values: &mut [f32]) -> Result<()> {
        let (batch, quantity, (ids, id_count)) = (self.handle(), quantity.raw(), (ids.as_ptr(), ids.len()));
        let (to, count) = (values.as_mut_ptr(), values.len());
        check(unsafe { sys::mimo_batch_get_float(batch, quantity, ids, id_count, null(), 0, to, count) })
    }

    /// Writes a quantity of many ids in all worlds: worlds x [`World::width`](crate::World::width).
    pub fn set(&mut self, quantity: Quantity, ids: &[i32], values: &[f64]) -> Result<()> {
        self.set_in(quantity, ids, values, None)
    }

    /// The same in the worlds whose entry of the mask is true; None: in all worlds.
    pub fn set_in(
        &mut self,
        quantity: Quantity,
        ids: &[i32],
        values: &[f64],
        mask: Option<&[bool]>,
    ) -> Result<()> {
        let (mask, worlds) = chosen(mask);
        let (ids, id_count) = (ids.as_ptr(), ids.len());
        let (from, count) = (values.as_ptr(), values.len());
        check(unsafe {
            sys::mimo_batch_set(self.handle(), quantity.raw(), ids, id_count, mask, worlds, from, count)
        })
    }

    /// Gives an infant another face in the worlds whose entry of the mask is true; None: in all worlds.
    pub fn set_face(&mut self, agent: usize, name: &str, mask: Option<&[bool]>) -> Result<()> {
        let face = self.world(0)?.find(Kind::FACE, name)? as f64;
        self.set_in(Quantity::AGENT_FACE, &[agent as i32], &vec![face; self.worlds()], mask)
    }

    /// The states of all worlds, one after the other; each takes as many bytes as the longest.
    pub fn save(&mut self) -> Result<Vec<u8>> {
        let mut bytes = 0;
        check(unsafe { sys::mimo_batch_state_size(self.handle(), &mut bytes) })?;
        let mut states = vec![0; bytes * self.worlds()];
        check(unsafe {
            let (to, bytes) = (states.as_mut_ptr() as *mut c_void, states.len());
            sys::mimo_batch_state_save(self.handle(), null(), 0, to, bytes)
        })?;
        Ok(states)
    }

    /// Loads one state for each world, or a single state into all of them, which then continue from the same
    /// present. If one state is refused, no world changes. The mask selects the worlds; None: all. The report is that
    /// of the world where most memories started fresh.
    pub fn load(&mut self, states: &[u8], mask: Option<&[bool]>) -> Result<LoadReport> {
        let (mask, worlds) = chosen(mask);
        let from = states.as_ptr() as *const c_void;
        LoadReport::of(|report| unsafe {
            sys::mimo_batch_state_load(self.handle(), mask, worlds, from, states.len(), report)
        })
    }
}
