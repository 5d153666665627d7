//! Shapes, materials, textures, lights and poses, for programs that draw the world themselves.
use crate::constants::{Axes, Kind, TextureType};
use crate::error::{check, Result};
use crate::records::{Appearance, Light};
use crate::structs::{defaults, described, sized};
use crate::sys;
use crate::world::World;

/// The resolution of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// Segments of a circle, a multiple of 4, 4 to 256.
    pub segments: u32,
    /// Half the size that infinite planes get, m.
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
    /// Positions of the vertices.
    pub positions: Vec<[f32; 3]>,
    /// Unit vectors.
    pub normals: Vec<[f32; 3]>,
    /// (0, 0) is the start of the texture's first row.
    pub texcoords: Vec<[f32; 2]>,
    /// Vertex indices, in the order of the engine's front faces.
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
    /// Pixels; of a cube the sum of its six pictures.
    pub height: u32,
    /// Red, green, blue and 255 of each pixel, row after row.
    pub pixels: Vec<u8>,
}

/// Position and rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Pose {
    /// Metres; centimetres with [`Axes::UNREAL`](crate::Axes::UNREAL).
    pub position: [f32; 3],
    /// w x y z with [`Axes::MIMO`](crate::Axes::MIMO), otherwise x y z w.
    pub rotation: [f32; 4],
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

    /// The current appearance of a geom.
    pub fn appearance(&self, geom: i32) -> Result<Appearance> {
        Ok(Appearance::of(&described(|raw| unsafe { sys::mimo_env_appearance(self.handle(), geom, raw) })?))
    }

    /// The number of textures; their ids are 0 to one less.
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

    /// A light by its id; None: the headlight of every camera.
    pub fn light(&self, id: Option<i32>, axes: Axes) -> Result<Light> {
        let mut raw = sys::mimo_light { axes: axes.raw(), ..sized() };
        check(unsafe { sys::mimo_env_light(self.handle(), id.unwrap_or(sys::MIMO_HEADLIGHT), &mut raw) })?;
        Ok(Light::of(&raw))
    }

    /// The current poses of all bodies, geoms, sites or cameras.
    pub fn poses(&self, kind: Kind, axes: Axes) -> Result<Vec<Pose>> {
        let mut poses = vec![Pose::default(); self.count(kind)?];
        self.poses_into(kind, axes, &mut poses)?;
        Ok(poses)
    }

    /// The same into existing memory.
    pub fn poses_into(&self, kind: Kind, axes: Axes, poses: &mut [Pose]) -> Result<()> {
        let (to, count) = (poses.as_mut_ptr().cast(), 7 * poses.len());
        check(unsafe { sys::mimo_env_poses(self.handle(), kind.raw(), axes.raw(), to, count) })
    }
}
