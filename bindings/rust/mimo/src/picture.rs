//! Pictures for people.
use crate::config::{defaults, pointer};
use crate::error::{c_string, check, Result};
use crate::sys;
use crate::world::World;
use std::ffi::CString;
use std::ptr::null_mut;

/// What to draw for people: by default a free camera that sees the infant from the front.
#[derive(Clone, Debug)]
pub struct Picture {
    raw: sys::mimo_picture_config,
    camera: Option<CString>,
}

// The pointer inside is set for the length of a call only.
unsafe impl Send for Picture {}
unsafe impl Sync for Picture {}

impl Picture {
    /// Width and height in pixels, 1 to 4096.
    pub fn new(width: u32, height: u32) -> Result<Picture> {
        let mut raw = defaults(sys::mimo_picture_config_init)?;
        raw.width = width;
        raw.height = height;
        Ok(Picture { raw, camera: None })
    }

    /// From a camera of the model.
    pub fn camera(&mut self, name: &str) -> Result<&mut Self> {
        self.camera = Some(c_string(name)?);
        Ok(self)
    }

    /// From a free camera: the point in the middle (m), the distance from it (m), azimuth and elevation (degrees; 0
    /// looks along x, 90 along y; negative looks down).
    pub fn free(&mut self, look_at: [f64; 3], distance: f64, azimuth: f64, elevation: f64) -> &mut Self {
        self.camera = None;
        self.raw.look_at = look_at;
        self.raw.distance = distance;
        self.raw.azimuth = azimuth;
        self.raw.elevation = elevation;
        self
    }

    /// Vertical field of view, degrees; 0: the camera's own.
    pub fn fovy(&mut self, degrees: f64) -> &mut Self {
        self.raw.fovy = degrees;
        self
    }

    /// `MIMO_PICTURE_` bits: four bytes a pixel, bottom row first. Otherwise RGB, row 0 is the top.
    pub fn format(&mut self, bits: u32) -> &mut Self {
        self.raw.format = bits;
        self
    }

    fn colors(&self) -> usize {
        let channels = if self.raw.format & sys::MIMO_PICTURE_RGBA != 0 { 4 } else { 3 };
        self.raw.width as usize * self.raw.height as usize * channels
    }

    fn raw(&self) -> sys::mimo_picture_config {
        sys::mimo_picture_config { camera: pointer(&self.camera), ..self.raw }
    }
}

impl World {
    /// Draws the current state: height x width x 3 bytes, or 4.
    pub fn render(&mut self, picture: &Picture) -> Result<Vec<u8>> {
        let mut colors = vec![0; picture.colors()];
        check(unsafe {
            let (to, bytes) = (colors.as_mut_ptr(), colors.len());
            sys::mimo_env_render(self.handle(), &picture.raw(), to, bytes, null_mut(), 0, null_mut(), 0)
        })?;
        Ok(colors)
    }

    /// Where points of the world (m) lie in the picture that [`render`](Self::render) draws of this state: pixels to the
    /// right of its left edge, pixels below its upper edge, and depth along the camera's axis, m. What has no depth above
    /// 0 is behind the camera, and its pixels mean nothing.
    pub fn project(&self, picture: &Picture, points: &[[f64; 3]]) -> Result<Vec<[f64; 3]>> {
        let mut pixels = vec![[0.0; 3]; points.len()];
        check(unsafe {
            let (from, to) = (points.as_ptr() as *const f64, pixels.as_mut_ptr() as *mut f64);
            sys::mimo_env_project(self.handle(), &picture.raw(), from, points.len(), to)
        })?;
        Ok(pixels)
    }
}
