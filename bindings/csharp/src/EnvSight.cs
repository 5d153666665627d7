using System;

namespace Mimo
{
    /// <summary>What turns to look at a point; values are those of mimo.h.</summary>
    public enum Look
    {
        /// <summary>The eyes alone; they reach 45 degrees to the sides, 33 up and 47 down.</summary>
        Eyes = 0,
        /// <summary>The head first, so that the eyes have to turn little.</summary>
        Head = 1
    }

    /// <summary>Where both eyes look; metres and directions in the world frame.</summary>
    public struct Gaze
    {
        /// <summary>Of the left eye's camera.</summary>
        public Vector3d LeftPosition;
        /// <summary>Its line of sight, unit vector.</summary>
        public Vector3d LeftDirection;
        /// <summary>Of the right eye's camera.</summary>
        public Vector3d RightPosition;
        /// <summary>Its line of sight.</summary>
        public Vector3d RightDirection;
        /// <summary>Angle between the lines of sight, rad; negative where they lead apart.</summary>
        public double Vergence;
        /// <summary>Where they come closest to each other; null where they lead apart.</summary>
        public Vector3d? Point;
        /// <summary>How far they pass each other there, m.</summary>
        public double Miss;
    }

    /// <summary>Joints that make an infant look at a point.</summary>
    public struct LookAngles
    {
        /// <summary>Ids: pan, tilt and torsion of the left eye, then of the right one; before them swivel and tilt of the head
        /// with Look.Head.</summary>
        public int[] Joints;
        /// <summary>Their angles, rad, within the joints' ranges.</summary>
        public double[] Angles;
        /// <summary>By how much the left and the right eye miss the point because of their range, rad.</summary>
        public double[] Errors;
    }

    /// <summary>Looking, and being looked at.</summary>
    public sealed partial class Env
    {
        private const int MostLookJoints = 8; // MIMO_LOOK_JOINTS

        /// <summary>Where an infant looks, by the poses of its eyes' cameras as they are.</summary>
        public Gaze Gaze(int agent = 0)
        {
            var raw = new GazeStruct { struct_size = (uint)Structs.Size<GazeStruct>() };
            MimoException.Check(Native.mimo_env_gaze(handle, (UIntPtr)agent, ref raw));
            return new Gaze
            {
                LeftPosition = raw.left_position, LeftDirection = raw.left_direction,
                RightPosition = raw.right_position, RightDirection = raw.right_direction,
                Vergence = raw.vergence, Point = raw.meets != 0 ? raw.point : (Vector3d?)null, Miss = raw.miss
            };
        }

        /// <summary>Angles of the joints that make an infant look at a point (world, m); nothing moves.</summary>
        public LookAngles LookAngles(Vector3d point, Look how = Look.Eyes, int agent = 0)
        {
            UIntPtr count;
            var look = new LookAngles { Joints = new int[MostLookJoints], Angles = new double[MostLookJoints], Errors = new double[2] };
            MimoException.Check(Native.mimo_env_look_angles(handle, (UIntPtr)agent, ref point, (int)how, look.Joints,
                look.Angles, (UIntPtr)MostLookJoints, out count, look.Errors));
            Array.Resize(ref look.Joints, (int)count);
            Array.Resize(ref look.Angles, (int)count);
            return look;
        }

        /// <summary>Makes an infant look at a point (world, m) at once; springs and motors go on moving its joints in the next
        /// step. Gives the angles by which the left and the right eye miss it, rad.</summary>
        public double[] LookAt(Vector3d point, Look how = Look.Eyes, int agent = 0)
        {
            var errors = new double[2];
            MimoException.Check(Native.mimo_env_look_at(handle, (UIntPtr)agent, ref point, (int)how, errors));
            return errors;
        }

        /// <summary>Draws the current state into rgba: height x width x 4 bytes, opaque.</summary>
        public void Draw(PictureOptions options, byte[] rgba)
        {
            options.Use(config => Native.mimo_env_render(handle, ref config, rgba, (UIntPtr)rgba.Length, null, UIntPtr.Zero, null,
                UIntPtr.Zero));
        }

        /// <summary>Where points of the world (m) lie in the picture that Draw draws of this state: pixels to the right of its
        /// left edge, pixels below its upper edge, and depth along the camera's axis, m. What has no depth above 0 is behind
        /// the camera, and its pixels mean nothing.</summary>
        public Vector3d[] Project(PictureOptions options, params Vector3d[] points)
        {
            var pixels = new Vector3d[points.Length];
            options.Use(config => Native.mimo_env_project(handle, ref config, points, (UIntPtr)points.Length, pixels));
            return pixels;
        }
    }
}
