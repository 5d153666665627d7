//! Things that a scene has beside infants.
use crate::error::{c_string, Result};
use crate::structs::{defaults, pointer};
use crate::sys;
use std::ffi::CString;

/// A rigid object of one primitive shape: a red sphere of 4 cm radius and 0.1 kg that moves freely, unless changed.
#[derive(Clone, Debug)]
pub struct Object {
    raw: sys::mimo_object_config,
    name: CString,
}

// The pointer inside is set for the length of a call only.
unsafe impl Send for Object {}
unsafe impl Sync for Object {}

impl Object {
    /// An object with the name of its body and geom, unique in the scene.
    pub fn new(name: &str) -> Result<Object> {
        Ok(Object { raw: defaults(sys::mimo_object_config_init)?, name: c_string(name)? })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_object_config) -> R) -> R {
        use_it(&sys::mimo_object_config { name: self.name.as_ptr(), ..self.raw })
    }

    /// A `MIMO_SHAPE_` constant and sizes in metres as it says.
    pub fn shape(&mut self, shape: u32, size: [f64; 3]) -> &mut Self {
        self.raw.shape = shape as i32;
        self.raw.size = size;
        self
    }

    /// Metres, world frame.
    pub fn position(&mut self, position: [f64; 3]) -> &mut Self {
        self.raw.position = position;
        self
    }

    /// w x y z.
    pub fn orientation(&mut self, orientation: [f64; 4]) -> &mut Self {
        self.raw.orientation = orientation;
        self
    }

    /// Kilograms; 0: a density of 1000 kg/m^3.
    pub fn mass(&mut self, mass: f64) -> &mut Self {
        self.raw.mass = mass;
        self
    }

    /// Colour, 0 to 1.
    pub fn rgba(&mut self, rgba: [f64; 4]) -> &mut Self {
        self.raw.rgba = rgba;
        self
    }

    /// Whether it is part of the world instead of moving freely.
    pub fn fixed(&mut self, fixed: bool) -> &mut Self {
        self.raw.fixed = fixed.into();
        self
    }
}

/// An MJCF document with one body, as an object: a toy with parts, a piece of furniture, a robot.
#[derive(Clone, Debug)]
pub struct Model {
    raw: sys::mimo_model_config,
    name: CString,
    file: Option<CString>,
    xml: Option<CString>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for Model {}
unsafe impl Sync for Model {}

impl Model {
    /// A file; all names in it get `name` and '/' before them.
    pub fn file(name: &str, path: &str) -> Result<Model> {
        Ok(Model { file: Some(c_string(path)?), ..Model::named(name)? })
    }

    /// A text; relative paths in it start from the working directory.
    pub fn xml(name: &str, text: &str) -> Result<Model> {
        Ok(Model { xml: Some(c_string(text)?), ..Model::named(name)? })
    }

    fn named(name: &str) -> Result<Model> {
        Ok(Model {
            raw: defaults(sys::mimo_model_config_init)?,
            name: c_string(name)?,
            file: None,
            xml: None,
        })
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_model_config) -> R) -> R {
        let (name, file, xml) = (self.name.as_ptr(), pointer(&self.file), pointer(&self.xml));
        use_it(&sys::mimo_model_config { name, file, xml, ..self.raw })
    }

    /// Where its body is: metres, and w x y z; world frame.
    pub fn place(&mut self, position: [f64; 3], orientation: [f64; 4]) -> &mut Self {
        self.raw.position = position;
        self.raw.orientation = orientation;
        self
    }

    /// Whether it gets no free joint.
    pub fn fixed(&mut self, fixed: bool) -> &mut Self {
        self.raw.fixed = fixed.into();
        self
    }
}
