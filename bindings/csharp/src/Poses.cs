using System;

namespace Mimo
{
    /// <summary>A pose in Unity's frame: left-handed, x right, y up, z forward; quaternion x y z w.</summary>
    public struct LeftHandedPose
    {
        /// <summary>Position, metres.</summary>
        public float X;
        /// <summary>Position, metres.</summary>
        public float Y;
        /// <summary>Position, metres.</summary>
        public float Z;

        /// <summary>Quaternion.</summary>
        public float Qx;
        /// <summary>Quaternion.</summary>
        public float Qy;
        /// <summary>Quaternion.</summary>
        public float Qz;
        /// <summary>Quaternion.</summary>
        public float Qw;
    }

    /// <summary>Converts from the library's frame (right-handed, x forward, y left, z up) to a left-handed frame with y
    /// up: right = -y, up = z, forward = x. The conversion mirrors space and so reverses the axes of rotations.</summary>
    public static class LeftHanded
    {
        /// <summary>Converts a position.</summary>
        public static Vector3d Position(Vector3d p) { return new Vector3d(-p.Y, p.Z, p.X); }

        /// <summary>Converts a rotation. The components are in the new frame; w does not change.</summary>
        public static Quaterniond Rotation(Quaterniond q) { return new Quaterniond(q.W, q.Y, -q.Z, -q.X); }
    }

    /// <summary>Converts from the library's frame to a right-handed frame with y up, as in Godot and OpenGL: right = -y,
    /// up = z, backward = -x. The axes of rotations are converted like other vectors.</summary>
    public static class RightHanded
    {
        /// <summary>Converts a position.</summary>
        public static Vector3d Position(Vector3d p) { return new Vector3d(-p.Y, p.Z, -p.X); }

        /// <summary>Converts a rotation. The components are in the new frame; w does not change.</summary>
        public static Quaterniond Rotation(Quaterniond q) { return new Quaterniond(q.W, -q.Y, q.Z, -q.X); }
    }

    /// <summary>Reads the poses of all bodies at once, without allocating.</summary>
    public sealed class PoseReader
    {
        private readonly Env env;
        private readonly float[] poses;

        /// <summary>Ids of the bodies, in the order of the poses.</summary>
        public int[] Bodies { get; }

        /// <summary>The poses of the last Read.</summary>
        public LeftHandedPose[] Poses { get; }

        /// <summary>Makes a reader for all bodies of a world, including the fixed world body.</summary>
        public PoseReader(Env env)
        {
            this.env = Given.Some(env, "env", "an Env");
            Bodies = new int[env.Count(Kind.Body)];
            for (var i = 0; i < Bodies.Length; ++i) Bodies[i] = i;
            poses = new float[7 * Bodies.Length];
            Poses = new LeftHandedPose[Bodies.Length];
        }

        /// <summary>Reads and converts the current poses.</summary>
        public void Read()
        {
            env.Poses(Kind.Body, Axes.Unity, poses);
            for (var i = 0; i < Poses.Length; ++i)
            {
                var at = 7 * i;
                Poses[i] = new LeftHandedPose
                {
                    X = poses[at], Y = poses[at + 1], Z = poses[at + 2],
                    Qx = poses[at + 3], Qy = poses[at + 4], Qz = poses[at + 5], Qw = poses[at + 6]
                };
            }
        }
    }
}
