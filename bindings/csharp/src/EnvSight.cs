using System;

namespace Mimo
{
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
        /// <summary>Where an infant looks, by the poses of its eyes' cameras as they are.</summary>
        public Gaze Gaze(int agent = 0)
        {
            var raw = GazeStruct.New();
            MimoException.Check(Native.mimo_env_gaze(Handle, Given.Index(agent, "agent"), ref raw));
            return new Gaze(raw);
        }

        /// <summary>Angles of the joints that make an infant look at a point (world, m); nothing moves.</summary>
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

        /// <summary>Makes an infant look at a point (world, m) at once; springs and motors go on moving its joints in the next
        /// step. Gives the angles by which the left and the right eye miss it, rad.</summary>
        public double[] LookAt(Vector3d point, Look how = Look.Eyes, int agent = 0)
        {
            var errors = new double[2];
            MimoException.Check(Native.mimo_env_look_at(Handle, Given.Index(agent, "agent"), ref point, (int)how, errors));
            return errors;
        }

        /// <summary>Draws the current state. What is null is not drawn.</summary>
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

        /// <summary>Where points of the world (m) lie in the picture that Draw draws of this state: pixels to the right of its
        /// left edge, pixels below its upper edge, and depth along the camera's axis, m. What has no depth above 0 is behind
        /// the camera, and its pixels mean nothing.</summary>
        public Vector3d[] Project(PictureConfig config, params Vector3d[] points)
        {
            var pixels = new Vector3d[Given.Some(points, "points", "an array").Length];
            Given.Some(config, "config", "a PictureConfig").Use(raw => Native.mimo_env_project(Handle, ref raw, points, Given.LengthOf(points, "points"), pixels));
            return pixels;
        }
    }
}
