using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Three numbers: a position in metres unless stated otherwise.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Vector3d
    {
        /// <summary>Component.</summary>
        public double X;
        /// <summary>Component.</summary>
        public double Y;
        /// <summary>Component.</summary>
        public double Z;

        /// <summary>Makes it from its components.</summary>
        public Vector3d(double x, double y, double z) { X = x; Y = y; Z = z; }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct Floats3
    {
        internal float x, y, z;
        internal Vector3d Wide => new Vector3d(x, y, z);
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct Floats4
    {
        internal float r, g, b, a;
        internal Rgba Wide => new Rgba(r, g, b, a);
    }

    internal partial struct ResetConfigStruct
    {
        internal static ResetConfigStruct Of(ulong? seed)
        {
            return new ResetConfigStruct { struct_size = Bytes, seeded = seed.HasValue ? 1u : 0u, seed = seed.GetValueOrDefault() };
        }
    }

    /// <summary>A rotation, in memory in the library's order w x y z.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Quaterniond
    {
        /// <summary>Component.</summary>
        public double W;
        /// <summary>Component.</summary>
        public double X;
        /// <summary>Component.</summary>
        public double Y;
        /// <summary>Component.</summary>
        public double Z;

        /// <summary>Makes it from its components, w first.</summary>
        public Quaterniond(double w, double x, double y, double z) { W = w; X = x; Y = y; Z = z; }
    }

    /// <summary>A colour, components from 0 to 1.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Rgba
    {
        /// <summary>Red.</summary>
        public double R;
        /// <summary>Green.</summary>
        public double G;
        /// <summary>Blue.</summary>
        public double B;
        /// <summary>Opacity.</summary>
        public double A;

        /// <summary>Makes it from its components.</summary>
        public Rgba(double r, double g, double b, double a) { R = r; G = g; B = b; A = a; }
    }
}
