using System;

namespace Mimo
{
    /// <summary>How a scene starts: where its models come from, and how much its document may ask for, 0 for the default. What
    /// asks for more is refused.</summary>
    public sealed class SceneOptions
    {
        /// <summary>Receives messages about the scene's making, on the calling thread. Exceptions in it are dropped.</summary>
        public Action<LogRecord> Log;
        /// <summary>Folder to take built-in models from instead of those inside the library; null: none.</summary>
        public string ModelFolder;
        /// <summary>Bytes of each file that is read.</summary>
        public ulong MaxFileBytes;
        /// <summary>Pixels of a texture or height field.</summary>
        public ulong MaxPixels;
        /// <summary>Vertices of a mesh or skin, and its faces.</summary>
        public ulong MaxVertices;
        /// <summary>Elements of the document, and those that composites become.</summary>
        public ulong MaxElements;
        /// <summary>Keyframes of the document.</summary>
        public ulong MaxKeyframes;
        /// <summary>Iterations of each solver in a physics step.</summary>
        public ulong MaxIterations;
        /// <summary>What the buffers of one world and its model may need, as estimated.</summary>
        public ulong MaxWorldBytes;
        /// <summary>Milliseconds that MuJoCo's compiler may work at the document, as estimated; nobody else in the process can make a world meanwhile.</summary>
        public ulong MaxCompileMilliseconds;
        /// <summary>Whether includes and assets must lie in the folder of the document that names them, or below.</summary>
        public bool Confined;

        /// <summary>Makes a scene of a document, of which at most one is not null.</summary>
        internal SceneHandle Make(string name, string file, string xml)
        {
            using (PinnedText n = new PinnedText(name), f = new PinnedText(file), x = new PinnedText(xml), models = new PinnedText(ModelFolder))
            {
                SceneConfigStruct config;
                MimoException.Check(Native.mimo_scene_config_init(out config, Structs.Size<SceneConfigStruct>()));
                config.name = n.Pointer;
                config.file = f.Pointer;
                config.xml = x.Pointer;
                config.model_dir = models.Pointer;
                Limit(ref config);
                var log = Logging.Tell(Log, out config.log, out config.log_user);
                SceneHandle made;
                var status = Native.mimo_scene_create(ref config, out made);
                made.Log = log;
                Logging.CheckTold(status, log);
                return made;
            }
        }

        private void Limit(ref SceneConfigStruct config)
        {
            config.max_file_bytes = MaxFileBytes;
            config.max_pixels = MaxPixels;
            config.max_vertices = MaxVertices;
            config.max_elements = MaxElements;
            config.max_keyframes = MaxKeyframes;
            config.max_iterations = MaxIterations;
            config.max_world_bytes = MaxWorldBytes;
            config.max_compile_ms = MaxCompileMilliseconds;
            config.confined = Confined ? 1u : 0u;
        }
    }

    /// <summary>Shapes of objects, and what their size is; values are those of mimo.h.</summary>
    public enum Shape
    {
        /// <summary>X: radius.</summary>
        Sphere = 1,
        /// <summary>X: radius, Y: half length of the cylindrical part, along z.</summary>
        Capsule = 2,
        /// <summary>Three radii.</summary>
        Ellipsoid = 3,
        /// <summary>X: radius, Y: half length, along z.</summary>
        Cylinder = 4,
        /// <summary>Three half lengths.</summary>
        Box = 5
    }

    /// <summary>A rigid object: a red ball of 4 cm radius and 0.1 kg that moves freely, unless changed.</summary>
    public sealed class ObjectOptions
    {
        /// <summary>Of its body and its geom; needed, unique.</summary>
        public string Name;
        /// <summary>Shape.</summary>
        public Shape Shape = Shape.Sphere;
        /// <summary>Metres, by shape.</summary>
        public Vector3d Size = new Vector3d(0.04, 0, 0);
        /// <summary>Metres, world frame.</summary>
        public Vector3d Position;
        /// <summary>World frame.</summary>
        public Quaterniond Orientation = new Quaterniond(1, 0, 0, 0);
        /// <summary>Kilograms; 0: a density of 1000 kg/m^3.</summary>
        public double Mass = 0.1;
        /// <summary>Colour; null: red.</summary>
        public Rgba? Color;
        /// <summary>Part of the world instead of moving freely.</summary>
        public bool Fixed;
    }

    /// <summary>A camera whose pictures are fields of the observation: "vision/NAME", "vision/NAME_depth",
    /// "vision/NAME_segmentation".</summary>
    public sealed class CameraOptions
    {
        /// <summary>A camera of the scene or of an infant, "anna/eye_left"; with LookAt the name of a new one.</summary>
        public string Name;
        /// <summary>What it gives.</summary>
        public Vision Outputs = Vision.Rgb;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint Width = 256;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint Height = 256;
        /// <summary>Vertical, degrees, 1 to 170; 0: the camera's own, 45 for a new one.</summary>
        public double FieldOfView;
        /// <summary>A new camera: the body that carries it; null: it stands still in the world.</summary>
        public string Body;
        /// <summary>A new camera: where it is, metres, in the frame of the body.</summary>
        public Vector3d Position;
        /// <summary>A new camera: the point in the middle of its picture, in the frame of the body. Null: it is there
        /// already.</summary>
        public Vector3d? LookAt;
    }
}
