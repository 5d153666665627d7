//! Pictures for people.
use crate::configs::PictureConfig;
use crate::constants::{PictureFormat, Vision};
use crate::error::{check, Result};
use crate::structs::sized;
use crate::sys;
use crate::world::World;

/// Pictures of one camera. Empty vectors are not drawn.
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
    /// Uses a free camera: the point in the middle of the picture (m), the distance from it (m), azimuth and
    /// elevation (degrees; azimuth 0 looks along x, 90 along y; a negative elevation looks down).
    pub fn free(&mut self, look_at: [f64; 3], distance: f64, azimuth: f64, elevation: f64) -> &mut Self {
        self.camera = None;
        self.raw.look_at = look_at;
        self.raw.distance = distance;
        self.raw.azimuth = azimuth;
        self.raw.elevation = elevation;
        self
    }

    /// Memory for pictures of these kinds.
    pub fn new_picture(&self, outputs: Vision) -> Picture {
        let pixels = self.raw.width as usize * self.raw.height as usize;
        let channels =
            if PictureFormat::from_raw(self.raw.format).contains(PictureFormat::RGBA) { 4 } else { 3 };
        let wanted = |output, count| if outputs.contains(output) { count } else { 0 };
        Picture {
            rgb: vec![0; wanted(Vision::RGB, pixels * channels)],
            depth: vec![0.0; wanted(Vision::DEPTH, pixels)],
            segmentation: vec![0; wanted(Vision::SEGMENTATION, pixels)],
        }
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

/// NULL for an empty vector.
fn start<T>(values: &mut [T]) -> *mut T {
    if values.is_empty() {
        return std::ptr::null_mut();
    }
    values.as_mut_ptr()
}

impl World {
    /// Draws the current state: `Vision::RGB | Vision::DEPTH` gives colour and depth.
    pub fn render(&mut self, config: &PictureConfig, outputs: Vision) -> Result<Picture> {
        let mut picture = config.new_picture(outputs);
        self.render_into(config, &mut picture)?;
        Ok(picture)
    }

    /// The same into existing memory, made by [`PictureConfig::new_picture`].
    pub fn render_into(&mut self, config: &PictureConfig, picture: &mut Picture) -> Result<()> {
        config
            .with_raw(|config| check(unsafe { sys::mimo_env_render(self.handle(), config, &picture.raw()) }))
    }

    /// The positions of points of the world (m) in the picture that [`render`](Self::render) draws of this
    /// state: pixels from the left edge, pixels from the upper edge, and depth along the camera's axis, m. A
    /// point whose depth is not above 0 is behind the camera, and its pixels have no meaning.
    pub fn project(&self, config: &PictureConfig, points: &[[f64; 3]]) -> Result<Vec<[f64; 3]>> {
        let mut pixels = vec![[0.0; 3]; points.len()];
        let (from, to) = (points.as_ptr().cast(), pixels.as_mut_ptr().cast());
        config.with_raw(|config| {
            check(unsafe { sys::mimo_env_project(self.handle(), config, from, points.len(), to) })
        })?;
        Ok(pixels)
    }
}
