//! Access by name, for your own rewards and experiments: look an id up once, then read and write many values
//! at a time.
use crate::constants::{Kind, Quantity};
use crate::error::{c_string, check, text, Result};
use crate::sys;
use crate::world::World;
use std::ptr::{null, null_mut};

impl World {
    /// The number of elements of a kind; their ids are 0 to one less.
    pub fn count(&self, kind: Kind) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_count(self.handle(), kind.raw(), &mut count) })?;
        Ok(count)
    }

    /// The id of an element by its name in the model.
    pub fn find(&self, kind: Kind, name: &str) -> Result<i32> {
        let name = c_string(name)?;
        let mut id = 0;
        check(unsafe { sys::mimo_env_find(self.handle(), kind.raw(), name.as_ptr(), &mut id) })?;
        Ok(id)
    }

    /// The name of an element; "" if the model gives none.
    pub fn name(&self, kind: Kind, id: i32) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_name(self.handle(), kind.raw(), id, &mut name) })?;
        Ok(text(name))
    }

    /// The number of values that a quantity has for these ids together.
    pub fn width(&self, quantity: Quantity, ids: &[i32]) -> Result<usize> {
        let mut count = 0;
        check(unsafe {
            sys::mimo_env_width(self.handle(), quantity.raw(), ids.as_ptr(), ids.len(), &mut count)
        })?;
        Ok(count)
    }

    /// Reads a quantity of several elements into `values`, whose length is [`width`](Self::width).
    pub fn get_into(&self, quantity: Quantity, ids: &[i32], values: &mut [f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_get(
                self.handle(),
                quantity.raw(),
                ids.as_ptr(),
                ids.len(),
                values.as_mut_ptr(),
                values.len(),
            )
        })
    }

    /// Reads a quantity of several elements.
    pub fn get(&self, quantity: Quantity, ids: &[i32]) -> Result<Vec<f64>> {
        let mut values = vec![0.0; self.width(quantity, ids)?];
        self.get_into(quantity, ids, &mut values)?;
        Ok(values)
    }

    /// Writes a quantity of several elements.
    pub fn set(&mut self, quantity: Quantity, ids: &[i32], values: &[f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_set(
                self.handle(),
                quantity.raw(),
                ids.as_ptr(),
                ids.len(),
                values.as_ptr(),
                values.len(),
            )
        })
    }

    /// Reads a quantity of all elements of its kind.
    pub fn get_all(&self, quantity: Quantity) -> Result<Vec<f64>> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_width(self.handle(), quantity.raw(), null(), 0, &mut count) })?;
        let mut values = vec![0.0; count];
        check(unsafe {
            sys::mimo_env_get(self.handle(), quantity.raw(), null(), 0, values.as_mut_ptr(), count)
        })?;
        Ok(values)
    }

    /// Writes a quantity of all elements of its kind.
    pub fn set_all(&mut self, quantity: Quantity, values: &[f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_set(self.handle(), quantity.raw(), null(), 0, values.as_ptr(), values.len())
        })
    }

    /// The same as [`get_into`](Self::get_into) in single precision, for engines.
    pub fn get_f32_into(&self, quantity: Quantity, ids: &[i32], values: &mut [f32]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_get_float(
                self.handle(),
                quantity.raw(),
                ids.as_ptr(),
                ids.len(),
                values.as_mut_ptr(),
                values.len(),
            )
        })
    }

    /// Recomputes poses from the current joint positions. The trajectory does not change.
    pub fn update(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_env_update(self.handle()) })
    }

    /// The body that a joint, geom, site or camera belongs to, or the parent of a body.
    pub fn body_of(&self, kind: Kind, id: i32) -> Result<i32> {
        let mut body = 0;
        check(unsafe { sys::mimo_env_body_of(self.handle(), kind.raw(), id, &mut body) })?;
        Ok(body)
    }

    /// Numbers from 0 to 1 from the world's own random stream, which is part of its state.
    pub fn random(&mut self, values: &mut [f64]) -> Result<()> {
        let values = if values.is_empty() { (null_mut(), 0) } else { (values.as_mut_ptr(), values.len()) };
        check(unsafe { sys::mimo_env_random(self.handle(), values.0, values.1) })
    }
}

impl Quantity {
    /// The present value of a quantity that otherwise belongs to the start of the last physics step: see
    /// [`sys::MIMO_NOW`].
    pub const fn now(self) -> Quantity {
        Quantity::from_raw(self.raw() | sys::MIMO_NOW as i32)
    }
}
