//! Named access, for rewards and experiments of one's own: ids are looked up once, then many are read and written at a time.
use crate::error::{c_string, check, text, Result};
use crate::sys;
use crate::world::World;
use std::ptr::{null, null_mut};

impl World {
    /// How many of a kind (`MIMO_BODY` ...) there are; their ids are 0 to one less.
    pub fn count(&self, kind: u32) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_count(self.handle(), kind as i32, &mut count) })?;
        Ok(count)
    }

    /// The id of something (`MIMO_BODY` ...) by its name in the model.
    pub fn find(&self, kind: u32, name: &str) -> Result<i32> {
        let name = c_string(name)?;
        let mut id = 0;
        check(unsafe { sys::mimo_env_find(self.handle(), kind as i32, name.as_ptr(), &mut id) })?;
        Ok(id)
    }

    /// The name of something; "" where the model gives none.
    pub fn name(&self, kind: u32, id: i32) -> Result<String> {
        let mut name = null();
        check(unsafe { sys::mimo_env_name(self.handle(), kind as i32, id, &mut name) })?;
        Ok(text(name))
    }

    /// How many values a quantity (`MIMO_BODY_POSITION` ...) has for these ids together.
    pub fn width(&self, quantity: u32, ids: &[i32]) -> Result<usize> {
        let mut count = 0;
        check(unsafe {
            sys::mimo_env_width(self.handle(), quantity as i32, ids.as_ptr(), ids.len(), &mut count)
        })?;
        Ok(count)
    }

    /// Reads a quantity of many at once into `values`, which is as long as [`width`](Self::width) says.
    pub fn get_into(&self, quantity: u32, ids: &[i32], values: &mut [f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_get(
                self.handle(),
                quantity as i32,
                ids.as_ptr(),
                ids.len(),
                values.as_mut_ptr(),
                values.len(),
            )
        })
    }

    /// Reads a quantity of many at once.
    pub fn get(&self, quantity: u32, ids: &[i32]) -> Result<Vec<f64>> {
        let mut values = vec![0.0; self.width(quantity, ids)?];
        self.get_into(quantity, ids, &mut values)?;
        Ok(values)
    }

    /// Writes a quantity of many at once.
    pub fn set(&mut self, quantity: u32, ids: &[i32], values: &[f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_set(
                self.handle(),
                quantity as i32,
                ids.as_ptr(),
                ids.len(),
                values.as_ptr(),
                values.len(),
            )
        })
    }

    /// Reads a quantity of all that there are of its kind.
    pub fn get_all(&self, quantity: u32) -> Result<Vec<f64>> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_width(self.handle(), quantity as i32, null(), 0, &mut count) })?;
        let mut values = vec![0.0; count];
        check(unsafe {
            sys::mimo_env_get(self.handle(), quantity as i32, null(), 0, values.as_mut_ptr(), count)
        })?;
        Ok(values)
    }

    /// Writes a quantity of all that there are of its kind.
    pub fn set_all(&mut self, quantity: u32, values: &[f64]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_set(self.handle(), quantity as i32, null(), 0, values.as_ptr(), values.len())
        })
    }

    /// The same as [`get_into`](Self::get_into) in single precision, for engines.
    pub fn get_f32_into(&self, quantity: u32, ids: &[i32], values: &mut [f32]) -> Result<()> {
        check(unsafe {
            sys::mimo_env_get_float(
                self.handle(),
                quantity as i32,
                ids.as_ptr(),
                ids.len(),
                values.as_mut_ptr(),
                values.len(),
            )
        })
    }

    /// Recomputes poses from the current joint positions. The trajectory stays as it was.
    pub fn update(&mut self) -> Result<()> {
        check(unsafe { sys::mimo_env_update(self.handle()) })
    }

    /// The body that a joint, geom, site or camera belongs to, or the parent of a body.
    pub fn body_of(&self, kind: u32, id: i32) -> Result<i32> {
        let mut body = 0;
        check(unsafe { sys::mimo_env_body_of(self.handle(), kind as i32, id, &mut body) })?;
        Ok(body)
    }

    /// Numbers from 0 to 1 from the world's own random stream, which is part of its state.
    pub fn random(&mut self, values: &mut [f64]) -> Result<()> {
        let values = if values.is_empty() { (null_mut(), 0) } else { (values.as_mut_ptr(), values.len()) };
        check(unsafe { sys::mimo_env_random(self.handle(), values.0, values.1) })
    }
}
