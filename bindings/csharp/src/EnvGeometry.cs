using System;

namespace Mimo
{
    /// <summary>Frames of engines; values are those of mimo.h.</summary>
    public enum Axes
    {
        /// <summary>The library's: x forward, y left, z up; quaternions w x y z, x y z w in all others.</summary>
        Mimo = 0,
        /// <summary>Left-handed: x right, y up, z forward.</summary>
        Unity = 1,
        /// <summary>Left-handed: x forward, y right, z up; cm.</summary>
        Unreal = 2,
        /// <summary>Right-handed: x right, y up, z backward.</summary>
        Godot = 3,
        /// <summary>Right-handed: x left, y up, z forward.</summary>
        Gltf = 4
    }

    /// <summary>How a texture's pixels are to be understood; values are those of mimo.h.</summary>
    public enum TextureType
    {
        /// <summary>One picture, repeated beyond its edges.</summary>
        Flat = 0,
        /// <summary>Six square pictures, one above the other; texture coordinates already lie in them.</summary>
        Cube = 1,
        /// <summary>A cube around everything.</summary>
        Sky = 2
    }

    /// <summary>A geom as triangles, in the geom's own frame.</summary>
    public sealed class GeomMesh
    {
        /// <summary>Three for each vertex.</summary>
        public float[] Positions { get; internal set; }
        /// <summary>Three for each vertex; unit vectors.</summary>
        public float[] Normals { get; internal set; }
        /// <summary>Two for each vertex; (0, 0) is where the texture's first row begins.</summary>
        public float[] Texcoords { get; internal set; }
        /// <summary>Three for each triangle, in the order that the engine takes for an outside.</summary>
        public int[] Indices { get; internal set; }
    }

    /// <summary>How a geom looks.</summary>
    public struct GeomAppearance
    {
        /// <summary>Whether MuJoCo would draw it.</summary>
        public bool Visible;
        /// <summary>MuJoCo's number of its group.</summary>
        public int Group;
        /// <summary>Id of its texture, -1 for none.</summary>
        public int Texture;
        /// <summary>Red, green, blue, opacity; times the texture's.</summary>
        public Rgba Color;
        /// <summary>How much of its colour it shines by itself, 0 to 1.</summary>
        public float Emission;
        /// <summary>Strength of highlights, 0 to 1.</summary>
        public float Specular;
        /// <summary>Their sharpness, 0 to 1: Phong's exponent is 128 times this.</summary>
        public float Shininess;
        /// <summary>Share of what it mirrors, 0 to 1.</summary>
        public float Reflectance;
    }

    /// <summary>A texture as pixels.</summary>
    public sealed class GeomTexture
    {
        /// <summary>Flat, cube or sky.</summary>
        public TextureType Type { get; internal set; }
        /// <summary>Pixels.</summary>
        public int Width { get; internal set; }
        /// <summary>Pixels, of a cube's six pictures together.</summary>
        public int Height { get; internal set; }
        /// <summary>Red, green, blue, 255 of each, row after row.</summary>
        public byte[] Pixels { get; internal set; }
    }

    /// <summary>A light of now.</summary>
    public struct WorldLight
    {
        /// <summary>Whether it shines.</summary>
        public bool Active;
        /// <summary>Whether its light is parallel.</summary>
        public bool Directional;
        /// <summary>Whether it casts shadows.</summary>
        public bool CastsShadow;
        /// <summary>Half angle of its cone, degrees; 180: to all sides.</summary>
        public float Cutoff;
        /// <summary>How much it is stronger in the middle of the cone.</summary>
        public float Exponent;
        /// <summary>Where it is.</summary>
        public Vector3d Position;
        /// <summary>Where it shines, unit vector.</summary>
        public Vector3d Direction;
        /// <summary>Red, green, blue that reach everything.</summary>
        public Vector3d Ambient;
        /// <summary>Red, green, blue of what is turned to it.</summary>
        public Vector3d Diffuse;
        /// <summary>Red, green, blue of highlights.</summary>
        public Vector3d Specular;
        /// <summary>At a distance of d metres it has 1 / (X + Y d + Z d^2) of its strength.</summary>
        public Vector3d Attenuation;
    }

    /// <summary>Places and directions in an engine's frame.</summary>
    public static class Frames
    {
        /// <summary>Converts points in place, three numbers each: of touch sensors, for example.</summary>
        public static void ConvertPoints(Axes axes, float[] points)
        {
            MimoException.Check(Native.mimo_convert_points((int)axes, points, Triples(points, "points")));
        }

        private static UIntPtr Triples(float[] numbers, string name)
        {
            if (Given.Some(numbers, name, "an array").Length % 3 != 0)
                throw Given.Misfit(numbers, name, "expected three numbers for each");
            return (UIntPtr)(numbers.Length / 3);
        }

        /// <summary>Converts directions in place; their lengths stay.</summary>
        public static void ConvertDirections(Axes axes, float[] directions)
        {
            MimoException.Check(Native.mimo_convert_directions((int)axes, directions, Triples(directions, "directions")));
        }
    }

    /// <summary>What engines draw themselves.</summary>
    public sealed partial class Env
    {
        /// <summary>The light that every camera carries.</summary>
        public const int Headlight = -1;

        /// <summary>A geom as triangles.</summary>
        /// <param name="geom">Its id.</param>
        /// <param name="axes">The engine's frame.</param>
        /// <param name="segments">Pieces of a circle, a multiple of 4, 4 to 256.</param>
        /// <param name="plane">Half the size of planes without an end, m.</param>
        public GeomMesh Mesh(int geom, Axes axes = Axes.Mimo, int segments = 24, double plane = 20)
        {
            MeshStruct raw;
            MimoException.Check(Native.mimo_mesh_init(out raw, Structs.Size<MeshStruct>()));
            raw.axes = (int)axes;
            raw.segments = Given.Count(segments, "segments");
            raw.plane = plane;
            MimoException.Check(Native.mimo_env_mesh(Handle, geom, ref raw));
            int vertices = (int)raw.vertex_count, corners = (int)raw.index_count;
            var mesh = new GeomMesh
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

        /// <summary>How a geom looks now.</summary>
        public GeomAppearance Appearance(int geom)
        {
            var raw = new AppearanceStruct { struct_size = (uint)Structs.Size<AppearanceStruct>() };
            MimoException.Check(Native.mimo_env_appearance(Handle, geom, ref raw));
            return new GeomAppearance
            {
                Visible = raw.visible != 0, Group = raw.group, Texture = raw.texture,
                Color = new Rgba(raw.color.r, raw.color.g, raw.color.b, raw.color.a), Emission = raw.emission,
                Specular = raw.specular, Shininess = raw.shininess, Reflectance = raw.reflectance
            };
        }

        /// <summary>How many textures there are; ids are 0 to that - 1.</summary>
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
        public GeomTexture Texture(int id)
        {
            var raw = new TextureStruct { struct_size = (uint)Structs.Size<TextureStruct>() };
            MimoException.Check(Native.mimo_env_texture(Handle, id, ref raw));
            var texture = new GeomTexture
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
        public WorldLight Light(int id, Axes axes = Axes.Mimo)
        {
            var raw = new LightStruct { struct_size = (uint)Structs.Size<LightStruct>(), axes = (int)axes };
            MimoException.Check(Native.mimo_env_light(Handle, id, ref raw));
            return new WorldLight
            {
                Active = raw.active != 0, Directional = raw.directional != 0, CastsShadow = raw.casts_shadow != 0,
                Cutoff = raw.cutoff, Exponent = raw.exponent, Position = raw.position.Wide, Direction = raw.direction.Wide,
                Ambient = raw.ambient.Wide, Diffuse = raw.diffuse.Wide, Specular = raw.specular.Wide,
                Attenuation = raw.attenuation.Wide
            };
        }

        /// <summary>Where all bodies, geoms, sites or cameras are now: seven numbers each, place and quaternion in the order of
        /// the frame. Allocates nothing.</summary>
        public void Poses(Kind kind, Axes axes, float[] poses)
        {
            MimoException.Check(Native.mimo_env_poses(Handle, (int)kind, (int)axes, poses, Given.LengthOf(poses, "poses")));
        }
    }
}
