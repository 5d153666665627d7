//! Pictures of what plain arrays describe, without a simulation.
use crate::constants::{Render, Status};
use crate::error::{check, Error, Result};
use crate::log::{self, Log, LogRecord};
use crate::stage_parts::*;
use crate::structs::{defaults, sized};
use crate::sys;
use std::ptr::{null_mut, NonNull};

/// From where a picture is taken, and how. What the members mean is in mimo/experimental/stage.h.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct StageView {
    /// Which of the poses it shows.
    pub pose: u32,
    /// Pixels, 1 to 16384.
    pub width: u32,
    /// Pixels, 1 to 16384.
    pub height: u32,
    /// What the picture shows.
    pub render: Render,
    /// Rays per pixel of colours: 0, 1, 4, 16 or 64.
    pub samples: u32,
    /// Bit n: geoms of group n are shown.
    pub geom_groups: u32,
    /// Bit n: sites of group n are shown.
    pub site_groups: u32,
    /// Bit n: surfaces of group n are shown.
    pub surface_groups: u32,
    /// Bit n: tendons of group n are shown.
    pub tendon_groups: u32,
    /// Where the camera is, m.
    pub position: [f64; 3],
    /// From the camera's frame (x right, y up, z backward) to the world's, row by row.
    pub rotation: [f64; 9],
    /// Vertical field of view, degrees.
    pub fovy: f64,
    /// Focal lengths along x and y, pixels; zeros: `fovy` counts.
    pub focal: [f64; 2],
    /// With focal lengths: the principal point, pixels from the left and the upper edge.
    pub center: [f64; 2],
    /// Height of an orthographic camera's picture, m; 0: a perspective camera.
    pub ortho_height: f64,
}

impl StageView {
    /// With the library's defaults.
    pub fn new(width: u32, height: u32, position: [f64; 3], rotation: [f64; 9]) -> Result<StageView> {
        let raw: sys::mimo_stage_view = defaults(sys::mimo_stage_view_init)?;
        Ok(StageView {
            pose: raw.pose,
            width,
            height,
            render: Render::from_raw(raw.render),
            samples: raw.samples,
            geom_groups: raw.geom_groups,
            site_groups: raw.site_groups,
            surface_groups: raw.surface_groups,
            tendon_groups: raw.tendon_groups,
            position,
            rotation,
            fovy: raw.fovy,
            focal: [raw.focal_x, raw.focal_y],
            center: [raw.center_x, raw.center_y],
            ortho_height: raw.ortho_height,
        })
    }

    fn raw(&self, picture: &mut StagePicture) -> sys::mimo_stage_view {
        let mut raw: sys::mimo_stage_view = sized();
        raw.pose = self.pose;
        raw.width = self.width;
        raw.height = self.height;
        raw.render = self.render.raw();
        raw.samples = self.samples;
        raw.geom_groups = self.geom_groups;
        raw.site_groups = self.site_groups;
        raw.surface_groups = self.surface_groups;
        raw.tendon_groups = self.tendon_groups;
        raw.position = self.position.as_ptr();
        raw.rotation = self.rotation.as_ptr();
        raw.fovy = self.fovy;
        raw.focal_x = self.focal[0];
        raw.focal_y = self.focal[1];
        raw.center_x = self.center[0];
        raw.center_y = self.center[1];
        raw.ortho_height = self.ortho_height;
        raw.rgb_bytes = picture.rgb.len();
        raw.depth_count = picture.depth.len();
        raw.segmentation_count = picture.segmentation.len();
        if raw.rgb_bytes > 0 {
            raw.rgb = picture.rgb.as_mut_ptr();
        }
        if raw.depth_count > 0 {
            raw.depth = picture.depth.as_mut_ptr();
        }
        if raw.segmentation_count > 0 {
            raw.segmentation = picture.segmentation.as_mut_ptr();
        }
        raw
    }
}

/// The pixels of a picture, top row first. Empty vectors are not drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StagePicture {
    /// Red, green, blue.
    pub rgb: Vec<u8>,
    /// Metres along the camera's axis.
    pub depth: Vec<f32>,
    /// Id and type of each pixel's object, -1 and -1 where nothing is.
    pub segmentation: Vec<i32>,
}

impl StagePicture {
    /// Room for all of them.
    pub fn new(width: u32, height: u32) -> StagePicture {
        let pixels = width as usize * height as usize;
        StagePicture { rgb: vec![0; 3 * pixels], depth: vec![0.0; pixels], segmentation: vec![0; 2 * pixels] }
    }
}

/// Things that plain arrays describe, drawn on the CPU without a simulation.
#[derive(Debug)]
pub struct Stage {
    handle: NonNull<sys::mimo_stage>,
    // Outlives the handle, which points to it.
    _log: Option<Log>,
}

// `&mut self` methods call functions that need exclusive use: the header's rule.
unsafe impl Send for Stage {}
unsafe impl Sync for Stage {}

impl Stage {
    /// Copies all arrays; pictures are drawn on so many threads.
    pub fn new(parts: &StageParts, threads: u32) -> Result<Stage> {
        Stage::make(parts, threads, None)
    }

    /// The same; the closure receives a warning for each thing that is not drawn, once.
    pub fn with_log(
        parts: &StageParts,
        threads: u32,
        log: impl Fn(&LogRecord) + Send + Sync + 'static,
    ) -> Result<Stage> {
        Stage::make(parts, threads, Some(Log::new(log)))
    }

    fn make(parts: &StageParts, threads: u32, kept: Option<Log>) -> Result<Stage> {
        let mut handle = null_mut();
        parts.with_raw(|raw| {
            raw.threads = threads;
            (raw.log, raw.log_user) = log::raw(&kept);
            check(unsafe { sys::mimo_stage_create(raw, &mut handle) })
        })?;
        Ok(Stage { handle: NonNull::new(handle).expect("a handle"), _log: kept })
    }

    /// Replaces the parts that are given.
    pub fn update(&mut self, change: &StageParts) -> Result<()> {
        change.with_raw(|raw| check(unsafe { sys::mimo_stage_update(self.handle.as_ptr(), raw) }))
    }

    /// One picture.
    pub fn draw(&mut self, poses: &StagePoses, view: &StageView) -> Result<StagePicture> {
        let mut pictures = [StagePicture::new(view.width, view.height)];
        self.draw_into(&[*poses], &[*view], &mut pictures)?;
        let [picture] = pictures;
        Ok(picture)
    }

    /// Many pictures, of many poses: each view says by number which of them it shows.
    pub fn draw_into(
        &mut self,
        poses: &[StagePoses],
        views: &[StageView],
        pictures: &mut [StagePicture],
    ) -> Result<()> {
        if pictures.len() != views.len() {
            let text =
                format!("pictures has {} elements, expected {}, as views has", pictures.len(), views.len());
            return Err(Error::new(Status::INVALID_ARGUMENT, text));
        }
        let structs = poses.iter().map(|one| one.raw()).collect::<Result<Vec<_>>>()?;
        let cameras: Vec<_> = views.iter().zip(pictures).map(|(view, picture)| view.raw(picture)).collect();
        let places: Vec<*const sys::mimo_stage_poses> = structs.iter().map(|one| one as *const _).collect();
        let seen: Vec<*const sys::mimo_stage_view> = cameras.iter().map(|one| one as *const _).collect();
        check(unsafe {
            sys::mimo_stage_draw(
                self.handle.as_ptr(),
                places.as_ptr(),
                places.len(),
                seen.as_ptr(),
                seen.len(),
            )
        })
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        unsafe { sys::mimo_stage_destroy(self.handle.as_ptr()) }
    }
}
