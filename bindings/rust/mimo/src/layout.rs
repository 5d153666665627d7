//! Descriptions of observations, actions and rewards.
use crate::block::Block;
use crate::constants::Receptor;
use crate::error::{c_string, check, text, Result};
use crate::field::Field;
use crate::records::{Action, LayoutInfo, Term};
use crate::rows::row;
use crate::structs::described;
use crate::sys;
use std::ptr::null;

/// Describes the observations, actions and rewards of a [`World`](crate::World), of each world of a
/// [`Batch`](crate::Batch), or of [`Senses`](crate::Senses). It never changes.
#[derive(Clone, Copy, Debug)]
pub struct Layout<'a> {
    // Belongs to its owner.
    handle: &'a sys::mimo_layout,
    info: LayoutInfo,
}

/// A receptor of the skin.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReceptorInfo {
    /// Id of the body that it sits on.
    pub body: i32,
    /// Id of the geom whose surface it lies on.
    pub geom: i32,
    /// In the frame of the body, m.
    pub position: [f64; 3],
    /// Rows: outward normal, two tangents; in the frame of the body.
    pub frame: [f64; 9],
}

impl<'a> Layout<'a> {
    /// # Safety
    /// `ask` returns the layout of an owner that lives as long as `'a`.
    pub(crate) unsafe fn of(
        ask: impl FnOnce(*mut *const sys::mimo_layout) -> sys::mimo_status,
    ) -> Result<Layout<'a>> {
        let mut handle = null();
        check(ask(&mut handle))?;
        let info = described(|info| sys::mimo_layout_describe(handle, info))?;
        Ok(Layout { handle: &*handle, info: LayoutInfo::of(&info) })
    }

    /// The sizes of one world.
    pub fn info(&self) -> LayoutInfo {
        self.info
    }

    /// Size of an observation block in bytes, a multiple of 64.
    pub fn block_bytes(&self) -> usize {
        self.info.block_bytes
    }

    /// Number of agents, and so of rewards, flags and outcomes.
    pub fn agent_count(&self) -> usize {
        self.info.agents
    }

    /// Number of actions of all agents together.
    pub fn action_count(&self) -> usize {
        self.info.actions
    }

    /// Number of reward terms of all agents together.
    pub fn term_count(&self) -> usize {
        self.info.terms
    }

    /// The fields of an observation, in the order of the block.
    pub fn fields(&self) -> Result<Vec<Field>> {
        (0..self.info.fields).map(|index| self.field(index)).collect()
    }

    /// The index-th field.
    pub fn field(&self, index: usize) -> Result<Field> {
        let raw = described(|raw| unsafe { sys::mimo_layout_field(self.handle, index, raw) })?;
        Ok(unsafe { Field::of(&raw) })
    }

    /// Index of a field by its name.
    pub fn find(&self, name: &str) -> Result<usize> {
        let name = c_string(name)?;
        let mut index = 0;
        check(unsafe { sys::mimo_layout_find(self.handle, name.as_ptr(), &mut index) })?;
        Ok(index)
    }

    /// The joint, sensor or actuator of each element of a field, "robot:left_elbow"; "" in pictures and
    /// touch.
    pub fn labels(&self, field: usize) -> Result<Vec<String>> {
        let elements = self.field(field)?.shape.iter().product::<usize>();
        (0..elements).map(|element| self.label(field, element)).collect()
    }

    fn label(&self, field: usize, element: usize) -> Result<String> {
        let mut label = null();
        check(unsafe { sys::mimo_layout_label(self.handle, field, element, &mut label) })?;
        Ok(text(label))
    }

    /// The delay of each element of a field in seconds; 0 for none. A reset to another age changes the
    /// delays, and with them the times of fields. For a batch both belong to world 0 as it was made.
    pub fn delays(&self, field: usize) -> Result<Vec<f64>> {
        let mut seconds = vec![0.0; self.field(field)?.shape.iter().product()];
        check(unsafe { sys::mimo_layout_delays(self.handle, field, seconds.as_mut_ptr(), seconds.len()) })?;
        Ok(seconds)
    }

    /// The directions of a picture's pixels, foveated or not: unit vectors from the eye or camera to the
    /// middle of each pixel, row by row, in the camera's frame (x right, y up, z backwards).
    pub fn directions(&self, field: usize) -> Result<Vec<[f32; 3]>> {
        let mut vectors = vec![[0.0; 3]; self.field(field)?.shape.iter().take(2).product()];
        let count = 3 * vectors.len();
        check(unsafe {
            sys::mimo_layout_directions(self.handle, field, vectors.as_mut_ptr().cast(), count)
        })?;
        Ok(vectors)
    }

    /// The receptors of a field, in the order of its first axis.
    pub fn receptors(&self, field: usize) -> Result<Vec<ReceptorInfo>> {
        let bodies = self.receptor_values(field, Receptor::BODY)?;
        let geoms = self.receptor_values(field, Receptor::GEOM)?;
        let positions = self.receptor_values(field, Receptor::POSITION)?;
        let frames = self.receptor_values(field, Receptor::FRAME)?;
        let receptor = |i: usize| ReceptorInfo {
            body: bodies[i] as i32,
            geom: geoms[i] as i32,
            position: row(&positions, i),
            frame: row(&frames, i),
        };
        Ok((0..bodies.len()).map(receptor).collect())
    }

    /// A quantity of all receptors of a field, one after the other.
    pub fn receptor_values(&self, field: usize, quantity: Receptor) -> Result<Vec<f64>> {
        let (handle, quantity, mut count) = (self.handle, quantity.raw(), 0);
        check(unsafe { sys::mimo_layout_receptor_width(handle, field, quantity, &mut count) })?;
        let mut values = vec![0.0; count];
        check(unsafe { sys::mimo_layout_receptors(handle, field, quantity, values.as_mut_ptr(), count) })?;
        Ok(values)
    }

    /// The actions of all agents, in their order.
    pub fn actions(&self) -> Result<Vec<Action>> {
        (0..self.info.actions).map(|index| self.action(index)).collect()
    }

    fn action(&self, index: usize) -> Result<Action> {
        Ok(Action::of(&described(|raw| unsafe { sys::mimo_layout_action(self.handle, index, raw) })?))
    }

    /// Names the terms of [`Results`](crate::Results), in their order.
    pub fn terms(&self) -> Result<Vec<Term>> {
        (0..self.info.terms).map(|index| self.term(index)).collect()
    }

    fn term(&self, index: usize) -> Result<Term> {
        Ok(Term::of(&described(|raw| unsafe { sys::mimo_layout_term(self.handle, index, raw) })?))
    }

    /// Memory for the observations of several worlds.
    pub(crate) fn new_blocks(&self, worlds: usize) -> Result<Block> {
        Ok(Block::new(self.block_bytes(), worlds, self.fields()?.into()))
    }
}
