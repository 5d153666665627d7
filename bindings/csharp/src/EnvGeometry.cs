using System;

namespace Mimo
{
    /// <summary>A geom as triangles, in the geom's own frame.</summary>
    public sealed class MimoMesh
    {
        /// <summary>Three for each vertex.</summary>
        public float[] Positions { get; internal set; }
        /// <summary>Three for each vertex; unit vectors.</summary>
        public float[] Normals { get; internal set; }
        /// <summary>Two for each vertex; (0, 0) is the start of the texture's first row.</summary>
        public float[] Texcoords { get; internal set; }
        /// <summary>Three for each triangle, in the winding order of the engine's outsides.</summary>
        public int[] Indices { get; internal set; }
    }

    /// <summary>A texture as pixels.</summary>
    public sealed class MimoTexture
    {
        /// <summary>Arrangement of the pixels.</summary>
        public TextureType Type { get; internal set; }
        /// <summary>Width in pixels.</summary>
        public int Width { get; internal set; }
        /// <summary>Height in pixels; for a cube of all six pictures together.</summary>
        public int Height { get; internal set; }
        /// <summary>Four bytes per pixel (red, green, blue, 255), row after row.</summary>
        public byte[] Pixels { get; internal set; }
    }

    /// <summary>Shapes, textures, lights and poses, for engines that draw the world themselves.</summary>
    public sealed partial class Env
    {
        /// <summary>The light that every camera carries.</summary>
        public const int Headlight = Constants.Headlight;

        /// <summary>A geom as triangles.</summary>
        /// <param name="geom">Its id.</param>
        /// <param name="axes">The engine's frame.</param>
        /// <param name="segments">Pieces of a circle, a multiple of 4, 4 to 256.</param>
        /// <param name="plane">Half the size of planes without an end, m.</param>
        public MimoMesh Mesh(int geom, Axes axes = Axes.Mimo, int segments = 24, double plane = 20)
        {
            var raw = MeshStruct.New();
            raw.axes = (int)axes;
            raw.segments = Given.Count(segments, "segments");
            raw.plane = plane;
            MimoException.Check(Native.mimo_env_mesh(Handle, geom, ref raw));
            int vertices = (int)raw.vertex_count, corners = (int)raw.index_count;
            var mesh = new MimoMesh
            {
                Positions = new float[3 * vertices], Normals = new float[3 * vertices],
                Texcoords = new float[2 * vertices], Indices = new int[corners]
            };
            using (Pinned positions = new Pinned(mesh.Positions), normals = new Pinned(mesh.Normals),
                texcoords = new Pinned(mesh.Texcoords), indices = new Pinned(mesh.Indices))
            {
                raw.positions = positions.Pointer;
                raw.normals = normals.Pointer;
                raw.texcoords = texcoords.Pointer;
                raw.indices = indices.Pointer;
                raw.vertex_capacity = raw.vertex_count;
                raw.index_capacity = raw.index_count;
                MimoException.Check(Native.mimo_env_mesh(Handle, geom, ref raw));
            }
            return mesh;
        }

        /// <summary>A geom's current appearance.</summary>
        public Appearance Appearance(int geom)
        {
            var raw = AppearanceStruct.New();
            MimoException.Check(Native.mimo_env_appearance(Handle, geom, ref raw));
            return new Appearance(raw);
        }

        /// <summary>Number of textures. Ids are 0 to TextureCount - 1.</summary>
        public int TextureCount
        {
            get
            {
                UIntPtr count;
                MimoException.Check(Native.mimo_env_texture_count(Handle, out count));
                return (int)count;
            }
        }

        /// <summary>A texture as pixels.</summary>
        public MimoTexture Texture(int id)
        {
            var raw = TextureStruct.New();
            MimoException.Check(Native.mimo_env_texture(Handle, id, ref raw));
            var texture = new MimoTexture
            {
                Type = (TextureType)raw.type, Width = (int)raw.width, Height = (int)raw.height,
                Pixels = new byte[4 * raw.width * raw.height]
            };
            using (var pixels = new Pinned(texture.Pixels))
            {
                raw.pixels = pixels.Pointer;
                raw.pixel_bytes = pixels.Length;
                MimoException.Check(Native.mimo_env_texture(Handle, id, ref raw));
            }
            return texture;
        }

        /// <summary>A light by its id, or Headlight.</summary>
        public MimoLight Light(int id, Axes axes = Axes.Mimo)
        {
            var raw = LightStruct.New();
            raw.axes = (int)axes;
            MimoException.Check(Native.mimo_env_light(Handle, id, ref raw));
            return new MimoLight(raw);
        }

        /// <summary>The current poses of all bodies, geoms, sites or cameras: seven numbers each, position and
        /// quaternion in the order of the frame. Allocates nothing.</summary>
        public void Poses(Kind kind, Axes axes, float[] poses)
        {
            MimoException.Check(Native.mimo_env_poses(Handle, (int)kind, (int)axes, poses, Given.LengthOf(poses, "poses")));
        }
    }
}
