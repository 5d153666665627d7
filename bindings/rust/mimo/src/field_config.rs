//! What is observed on request.
use crate::error::{c_string, Result};
use crate::structs::{defaults, pointer};
use crate::sys;
use std::ffi::CString;
use std::ptr::null;

/// A further field of the observation, of `f32`: a quantity of parts of the scene, where [`World::get`](crate::World::get)
/// is asked for it otherwise. Its shape is elements x values of each; elements alone where they have one value each; and
/// one axis of all values where they differ in that. Of the world it is its values.
#[derive(Clone, Debug)]
pub struct FieldConfig {
    raw: sys::mimo_field_config,
    name: CString,
    elements: Vec<CString>,
    relative_to: Option<CString>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for FieldConfig {}
unsafe impl Sync for FieldConfig {}

impl FieldConfig {
    /// A field by a name of its own, "toys/position": a quantity (`MIMO_BODY_POSITION`, or `MIMO_BODY_POSITION |
    /// MIMO_NOW`, ...) of elements by their names in the model; of agents "" for a sole one, of the world none.
    pub fn new(name: &str, quantity: u32, elements: &[&str]) -> Result<FieldConfig> {
        let mut raw = defaults(sys::mimo_field_config_init)?;
        raw.quantity = quantity as i32;
        let elements = elements.iter().map(|element| c_string(element)).collect::<Result<_>>()?;
        Ok(FieldConfig { raw, name: c_string(name)?, elements, relative_to: None })
    }

    /// The body in whose frame positions, orientations, poses and velocities are, moving along with it; otherwise they
    /// are in the world's.
    pub fn relative_to(&mut self, body: &str) -> Result<&mut Self> {
        self.relative_to = Some(c_string(body)?);
        Ok(self)
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_field_config) -> R) -> R {
        let elements: Vec<_> = self.elements.iter().map(|element| element.as_ptr()).collect();
        use_it(&sys::mimo_field_config {
            name: self.name.as_ptr(),
            elements: if elements.is_empty() { null() } else { elements.as_ptr() },
            element_count: elements.len(),
            relative_to: pointer(&self.relative_to),
            ..self.raw
        })
    }
}
