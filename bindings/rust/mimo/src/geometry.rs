//! Shapes, materials, textures, lights and poses, for programs that draw the world themselves.
use crate::constants::{Axes, Kind, TextureType};
use crate::error::{check, Result};
use crate::records::{Appearance, Light};
use crate::structs::{defaults, described, sized};
use crate::sys;
use crate::world::World;

/// How fine a mesh is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// Pieces of a circle, a multiple of 4, 4 to 256.
    pub segments: u32,
    /// Half the size of planes without an end, m.
    pub plane: f64,
}

impl Default for Detail {
    fn default() -> Detail {
        Detail { segments: 24, plane: 20.0 }
    }
}

/// A geom as triangles, in the geom's own frame.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Mesh {
    /// Of the vertices.
    pub positions: Vec<[f32; 3]>,
    /// Unit vectors.
    pub normals: Vec<[f32; 3]>,
    /// (0, 0) is where the texture's first row begins.
    pub texcoords: Vec<[f32; 2]>,
    /// Numbers of vertices, in the order that the engine takes for an outside.
    pub triangles: Vec<[u32; 3]>,
}

/// A texture as pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Texture {
    /// How its pixels are arranged.
    pub kind: TextureType,
    /// Pixels.
    pub width: u32,
    /// Pixels, of a cube's six pictures together.
    pub height: u32,
    /// Red, green, blue, 255 of each, row after row.
    pub pixels: Vec<u8>,
}

/// Where something is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Pose {
    /// Metres, centimetres for Unreal.
    pub position: [f32; 3],
    /// In the order of the frame: w x y z of ours, x y z w of the others.
    pub rotation: [f32; 4],
}

/// Places of ours in another frame: of touch sensors, for example.
pub fn convert_points(axes: Axes, points: &mut [[f32; 3]]) -> Result<()> {
    check(unsafe { sys::mimo_convert_points(axes.raw(), points.as_mut_ptr().cast(), points.len()) })
}

/// Directions likewise; their lengths stay.
pub fn convert_directions(axes: Axes, directions: &mut [[f32; 3]]) -> Result<()> {
    check(unsafe {
        sys::mimo_convert_directions(axes.raw(), directions.as_mut_ptr().cast(), directions.len())
    })
}

impl World {
    /// A geom as triangles.
    pub fn mesh(&self, geom: i32, axes: Axes, detail: Detail) -> Result<Mesh> {
        let mut raw = defaults(sys::mimo_mesh_init)?;
        raw.axes = axes.raw();
        raw.segments = detail.segments;
        raw.plane = detail.plane;
        check(unsafe { sys::mimo_env_mesh(self.handle(), geom, &mut raw) })?;
        let count = raw.vertex_count;
        let mut mesh = Mesh {
            positions: vec![[0.0; 3]; count],
            normals: vec![[0.0; 3]; count],
            texcoords: vec![[0.0; 2]; count],
            triangles: vec![[0; 3]; raw.index_count / 3],
        };
        raw.positions = mesh.positions.as_mut_ptr().cast();
        raw.normals = mesh.normals.as_mut_ptr().cast();
        raw.texcoords = mesh.texcoords.as_mut_ptr().cast();
        raw.indices = mesh.triangles.as_mut_ptr().cast();
        raw.vertex_capacity = count;
        raw.index_capacity = raw.index_count;
        check(unsafe { sys::mimo_env_mesh(self.handle(), geom, &mut raw) })?;
        Ok(mesh)
    }

    /// How a geom looks now.
    pub fn appearance(&self, geom: i32) -> Result<Appearance> {
        Ok(Appearance::of(&described(|raw| unsafe { sys::mimo_env_appearance(self.handle(), geom, raw) })?))
    }

    /// How many textures there are; ids are 0 to that - 1.
    pub fn texture_count(&self) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::mimo_env_texture_count(self.handle(), &mut count) })?;
        Ok(count)
    }

    /// A texture as pixels.
    pub fn texture(&self, id: i32) -> Result<Texture> {
        let mut raw: sys::mimo_texture =
            described(|raw| unsafe { sys::mimo_env_texture(self.handle(), id, raw) })?;
        let mut pixels = vec![0; 4 * raw.width as usize * raw.height as usize];
        raw.pixels = pixels.as_mut_ptr();
        raw.pixel_bytes = pixels.len();
        check(unsafe { sys::mimo_env_texture(self.handle(), id, &mut raw) })?;
        Ok(Texture { kind: TextureType::from_raw(raw.type_), width: raw.width, height: raw.height, pixels })
    }

    /// A light by its id; None: the one that every camera carries.
    pub fn light(&self, id: Option<i32>, axes: Axes) -> Result<Light> {
        let mut raw = sys::mimo_light { axes: axes.raw(), ..sized() };
        check(unsafe { sys::mimo_env_light(self.handle(), id.unwrap_or(sys::MIMO_HEADLIGHT), &mut raw) })?;
        Ok(Light::of(&raw))
    }

    /// Where all bodies, geoms, sites or cameras are now.
    pub fn poses(&self, kind: Kind, axes: Axes) -> Result<Vec<Pose>> {
        let mut poses = vec![Pose::default(); self.count(kind)?];
        self.poses_into(kind, axes, &mut poses)?;
        Ok(poses)
    }

    /// The same into memory that is there.
    pub fn poses_into(&self, kind: Kind, axes: Axes, poses: &mut [Pose]) -> Result<()> {
        let (to, count) = (poses.as_mut_ptr().cast(), 7 * poses.len());
        check(unsafe { sys::mimo_env_poses(self.handle(), kind.raw(), axes.raw(), to, count) })
    }
}
