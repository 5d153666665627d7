using System;

namespace Mimo
{
    /// <summary>A pose in the frame of Unity: left-handed, x right, y up, z forward; quaternion x y z w.</summary>
    public struct LeftHandedPose
    {
        /// <summary>Of the place, metres.</summary>
        public float X;
        /// <summary>Of the place, metres.</summary>
        public float Y;
        /// <summary>Of the place, metres.</summary>
        public float Z;

        /// <summary>Of the rotation.</summary>
        public float Qx;
        /// <summary>Of the rotation.</summary>
        public float Qy;
        /// <summary>Of the rotation.</summary>
        public float Qz;
        /// <summary>Of the rotation.</summary>
        public float Qw;
    }

    /// <summary>
    /// From the library's frame (right-handed, x forward, y left, z up) to a left-handed one with y up. The axes are
    /// right = -y, up = z, forward = x. That mirrors space, so the axis of a rotation, which is no ordinary vector,
    /// goes to minus that.
    /// </summary>
    public static class LeftHanded
    {
        /// <summary>Converts a place.</summary>
        public static Vector3d Position(Vector3d p) { return new Vector3d(-p.Y, p.Z, p.X); }

        /// <summary>Converts a rotation; the result's components are in the new frame, w stays.</summary>
        public static Quaterniond Rotation(Quaterniond q) { return new Quaterniond(q.W, q.Y, -q.Z, -q.X); }
    }

    /// <summary>
    /// To a right-handed frame with y up, that of Godot and OpenGL: right = -y, up = z, backward = -x. Nothing is mirrored: the
    /// axis of a rotation goes where any vector goes.
    /// </summary>
    public static class RightHanded
    {
        /// <summary>Converts a place.</summary>
        public static Vector3d Position(Vector3d p) { return new Vector3d(-p.Y, p.Z, -p.X); }

        /// <summary>Converts a rotation; the result's components are in the new frame, w stays.</summary>
        public static Quaterniond Rotation(Quaterniond q) { return new Quaterniond(q.W, -q.Y, q.Z, -q.X); }
    }

    /// <summary>Reads the poses of many bodies at once, without allocating.</summary>
    public sealed class PoseReader
    {
        private readonly Env env;
        private readonly float[] poses;

        /// <summary>Ids of the bodies, in the order of the poses.</summary>
        public int[] Bodies { get; }

        /// <summary>The poses that Read has read.</summary>
        public LeftHandedPose[] Poses { get; }

        /// <summary>For all bodies of a world, its fixed world body included.</summary>
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
            env.Get(Quantity.BodyPose | Quantity.Now, Bodies, poses);
            for (var i = 0; i < Bodies.Length; ++i)
            {
                var p = LeftHanded.Position(new Vector3d(poses[7 * i], poses[7 * i + 1], poses[7 * i + 2]));
                var q = LeftHanded.Rotation(new Quaterniond(poses[7 * i + 3], poses[7 * i + 4], poses[7 * i + 5],
                    poses[7 * i + 6]));
                Poses[i] = new LeftHandedPose
                {
                    X = (float)p.X, Y = (float)p.Y, Z = (float)p.Z,
                    Qx = (float)q.X, Qy = (float)q.Y, Qz = (float)q.Z, Qw = (float)q.W
                };
            }
        }
    }
}
