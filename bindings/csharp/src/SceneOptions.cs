using System;

namespace Mimo
{
    /// <summary>How much an MJCF document may ask for, 0 for the default, and whether its files must lie in its own folder.
    /// What asks for more is refused.</summary>
    public struct DocumentLimits
    {
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
        /// <summary>What the buffers of one world may need, as estimated.</summary>
        public ulong MaxWorldBytes;
        /// <summary>Whether includes and assets must lie in the folder of the document that names them, or below.</summary>
        public bool Confined;
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

    /// <summary>What a camera or an eye gives; values are those of mimo.h.</summary>
    [Flags]
    public enum Vision
    {
        /// <summary>Nothing.</summary>
        None = 0,
        /// <summary>Colour, bytes, height x width x 3, row 0 is the top.</summary>
        Rgb = 1,
        /// <summary>Depth along the camera's axis, float, metres.</summary>
        Depth = 2,
        /// <summary>Geom id of each pixel, int; -1 is background.</summary>
        Segmentation = 4
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
