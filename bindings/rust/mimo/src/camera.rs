//! Cameras whose pictures are fields of observations.
use crate::error::{c_string, Result};
use crate::structs::{defaults, pointer};
use crate::sys;
use std::ffi::CString;

/// A camera whose pictures are fields of the observation: "vision/NAME", "vision/NAME_depth",
/// "vision/NAME_segmentation".
#[derive(Clone, Debug)]
pub struct Camera {
    raw: sys::mimo_camera_config,
    name: CString,
    body: Option<CString>,
}

// The pointers inside are set for the length of a call only.
unsafe impl Send for Camera {}
unsafe impl Sync for Camera {}

impl Camera {
    /// A camera that is there already: one of the scene's MJCF, or of an infant, "anna/eye_left".
    pub fn of_scene(name: &str) -> Result<Camera> {
        Ok(Camera { raw: defaults(sys::mimo_camera_config_init)?, name: c_string(name)?, body: None })
    }

    /// A new one that stands still in the world: where it is, and the point in the middle of its picture, m.
    pub fn new(name: &str, position: [f64; 3], look_at: [f64; 3]) -> Result<Camera> {
        let mut camera = Camera::of_scene(name)?;
        camera.raw.placed = 1;
        camera.raw.position = position;
        camera.raw.look_at = look_at;
        Ok(camera)
    }

    pub(crate) fn with_raw<R>(&self, use_it: impl FnOnce(&sys::mimo_camera_config) -> R) -> R {
        let (name, body) = (self.name.as_ptr(), pointer(&self.body));
        use_it(&sys::mimo_camera_config { name, body, ..self.raw })
    }

    /// The body that carries a new camera; its places are then in the frame of that body.
    pub fn body(&mut self, name: &str) -> Result<&mut Self> {
        self.body = Some(c_string(name)?);
        Ok(self)
    }

    /// `MIMO_VISION_` bits; colour unless set.
    pub fn outputs(&mut self, bits: u32) -> &mut Self {
        self.raw.outputs = bits;
        self
    }

    /// Pixels, 1 to 4096; 256 x 256 unless set.
    pub fn size(&mut self, width: u32, height: u32) -> &mut Self {
        self.raw.width = width;
        self.raw.height = height;
        self
    }

    /// Vertical field of view in degrees, 1 to 170.
    pub fn fovy(&mut self, degrees: f64) -> &mut Self {
        self.raw.fovy = degrees;
        self
    }
}
