//! Pictures for people.
use crate::error::{c_string, check, Result};
use crate::structs::{defaults, pointer, sized};
use crate::sys;
use crate::world::World;
use std::ffi::CString;

/// What to draw for people: by default a free camera that sees the infant from the front, in colour.
#[derive(Clone, Debug)]
pub struct PictureConfig {
    raw: sys::mimo_picture_config,
    camera: Option<CString>,
    outputs: u32,
}

// The pointer inside is set for the length of a call only.
unsafe impl Send for PictureConfig {}
unsafe impl Sync for PictureConfig {}

/// Pictures of one camera. What is empty is not drawn.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Picture {
    /// Height x width x 3 bytes, or 4.
    pub rgb: Vec<u8>,
    /// Height x width, metres along the camera's axis.
    pub depth: Vec<f32>,
    /// Height x width ids of geoms; -1 is background.
    pub segmentation: Vec<i32>,
}

impl PictureConfig {
    /// Width and height in pixels, 1 to 4096.
    pub fn new(width: u32, height: u32) -> Result<PictureConfig> {
        let mut raw = defaults(sys::mimo_picture_config_init)?;
        raw.width = width;
        raw.height = height;
        Ok(PictureConfig { raw, camera: None, outputs: sys::MIMO_VISION_RGB })
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

    /// The middle is shown L / ln(1 + L) times as large and the rim small; 0: as drawn.
    pub fn foveation(&mut self, strength: f64) -> &mut Self {
        self.raw.foveation = strength;
        self
    }

    /// `MIMO_PICTURE_` bits: four bytes a pixel, bottom row first. Otherwise RGB, row 0 is the top.
    pub fn format(&mut self, bits: u32) -> &mut Self {
        self.raw.format = bits;
        self
    }

    /// `MIMO_VISION_` bits: what is drawn; colour unless set.
    pub fn outputs(&mut self, bits: u32) -> &mut Self {
        self.outputs = bits;
        self
    }

    /// Memory for what is drawn.
    pub fn new_picture(&self) -> Picture {
        let pixels = self.raw.width as usize * self.raw.height as usize;
        let channels = if self.raw.format & sys::MIMO_PICTURE_RGBA != 0 { 4 } else { 3 };
        let wanted = |bit, count| if self.outputs & bit != 0 { count } else { 0 };
        Picture {
            rgb: vec![0; wanted(sys::MIMO_VISION_RGB, pixels * channels)],
            depth: vec![0.0; wanted(sys::MIMO_VISION_DEPTH, pixels)],
            segmentation: vec![0; wanted(sys::MIMO_VISION_SEGMENTATION, pixels)],
        }
    }

    fn raw(&self) -> sys::mimo_picture_config {
        sys::mimo_picture_config { camera: pointer(&self.camera), ..self.raw }
    }
}

impl Picture {
    fn raw(&mut self) -> sys::mimo_picture {
        sys::mimo_picture {
            rgb: start(&mut self.rgb),
            rgb_bytes: self.rgb.len(),
            depth: start(&mut self.depth),
            depth_count: self.depth.len(),
            segmentation: start(&mut self.segmentation),
            segmentation_count: self.segmentation.len(),
            ..sized()
        }
    }
}

/// NULL for what is empty.
fn start<T>(values: &mut [T]) -> *mut T {
    if values.is_empty() {
        return std::ptr::null_mut();
    }
    values.as_mut_ptr()
}

impl World {
    /// Draws the current state.
    pub fn render(&mut self, config: &PictureConfig) -> Result<Picture> {
        let mut picture = config.new_picture();
        self.render_into(config, &mut picture)?;
        Ok(picture)
    }

    /// The same into memory that is there, of [`PictureConfig::new_picture`].
    pub fn render_into(&mut self, config: &PictureConfig, picture: &mut Picture) -> Result<()> {
        check(unsafe { sys::mimo_env_render(self.handle(), &config.raw(), &picture.raw()) })
    }

    /// Where points of the world (m) lie in the picture that [`render`](Self::render) draws of this state: pixels to the
    /// right of its left edge, pixels below its upper edge, and depth along the camera's axis, m. What has no depth above
    /// 0 is behind the camera, and its pixels mean nothing.
    pub fn project(&self, config: &PictureConfig, points: &[[f64; 3]]) -> Result<Vec<[f64; 3]>> {
        let mut pixels = vec![[0.0; 3]; points.len()];
        check(unsafe {
            let (from, to) = (points.as_ptr().cast(), pixels.as_mut_ptr().cast());
            sys::mimo_env_project(self.handle(), &config.raw(), from, points.len(), to)
        })?;
        Ok(pixels)
    }
}
