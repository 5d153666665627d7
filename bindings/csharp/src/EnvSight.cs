using System;

namespace Mimo
{
    /// <summary>Joints that make an infant look at a point.</summary>
    public struct LookAngles
    {
        /// <summary>Joint ids: pan, tilt and torsion of the left eye, then of the right eye. With Look.Head swivel and
        /// tilt of the head come first.</summary>
        public int[] Joints;
        /// <summary>The joints' angles, rad, within their ranges.</summary>
        public double[] Angles;
        /// <summary>Angles by which the left and the right eye miss the point because of their range, rad.</summary>
        public double[] Errors;
    }

    /// <summary>Gaze of infants, and pictures.</summary>
    public sealed partial class Env
    {
        /// <summary>Fills in what the motors of an infant do by themselves: actions for the next step, as many as it has.</summary>
        public void Spontaneous(float[] actions, Movement which = Movement.All, int agent = 0)
        {
            MimoException.Check(Native.mimo_env_spontaneous(Handle, Given.Index(agent, "agent"), (uint)which, actions,
                Given.LengthOf(actions, "actions")));
        }

        /// <summary>An infant's gaze, from the poses of its eye cameras as Get reads them.</summary>
        public Gaze Gaze(int agent = 0)
        {
            var raw = GazeStruct.New();
            MimoException.Check(Native.mimo_env_gaze(Handle, Given.Index(agent, "agent"), ref raw));
            return new Gaze(raw);
        }

        /// <summary>The joint angles with which an infant looks at a point (world frame, m). Nothing moves.</summary>
        public LookAngles LookAngles(Vector3d point, Look how = Look.Eyes, int agent = 0)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_look_angles(Handle, Given.Index(agent, "agent"), ref point, (int)how, null, null, UIntPtr.Zero,
                out count, null));
            var look = new LookAngles { Joints = new int[(int)count], Angles = new double[(int)count], Errors = new double[2] };
            MimoException.Check(Native.mimo_env_look_angles(Handle, Given.Index(agent, "agent"), ref point, (int)how, look.Joints,
                look.Angles, count, out count, look.Errors));
            return look;
        }

        /// <summary>Turns an infant's eyes to a point (world frame, m) at once. Springs and motors move the joints on
        /// in the next step. Returns the angles by which the left and the right eye miss the point, rad.</summary>
        public double[] LookAt(Vector3d point, Look how = Look.Eyes, int agent = 0)
        {
            var errors = new double[2];
            MimoException.Check(Native.mimo_env_look_at(Handle, Given.Index(agent, "agent"), ref point, (int)how, errors));
            return errors;
        }

        /// <summary>Draws the current state into the arrays that are not null.</summary>
        /// <param name="config">What to draw.</param>
        /// <param name="rgba">Height x width x 4 bytes, opaque.</param>
        /// <param name="depth">Height x width, metres along the camera's axis.</param>
        /// <param name="segmentation">Height x width ids of geoms, -1 is background.</param>
        public void Draw(PictureConfig config, byte[] rgba, float[] depth = null, int[] segmentation = null)
        {
            using (Pinned color = new Pinned(rgba), distance = new Pinned(depth), geoms = new Pinned(segmentation))
            {
                var picture = new PictureStruct
                {
                    struct_size = PictureStruct.Bytes, rgb = color.Pointer, rgb_bytes = color.Length,
                    depth = distance.Pointer, depth_count = distance.Length, segmentation = geoms.Pointer,
                    segmentation_count = geoms.Length
                };
                Given.Some(config, "config", "a PictureConfig").Use(raw => Native.mimo_env_render(Handle, ref raw, ref picture));
            }
        }

        /// <summary>The positions of world points (m) in the picture that Draw draws of this state: pixels from the
        /// left edge, pixels from the top edge, and depth along the camera's axis, m. A depth of 0 or less is behind
        /// the camera, and its pixels have no meaning.</summary>
        public Vector3d[] Project(PictureConfig config, params Vector3d[] points)
        {
            var pixels = new Vector3d[Given.Some(points, "points", "an array").Length];
            Given.Some(config, "config", "a PictureConfig").Use(raw => Native.mimo_env_project(Handle, ref raw, points, Given.LengthOf(points, "points"), pixels));
            return pixels;
        }
    }
}
