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

    /// <summary>What to draw for people: a camera of the model, or a free one that by default sees the infant from the
    /// front.</summary>
    public sealed class PictureOptions
    {
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint Width = 640;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint Height = 480;
        /// <summary>Row 0 is the lowest, as in textures of Unity and OpenGL; otherwise it is the top.</summary>
        public bool BottomUp;
        /// <summary>A camera of the model; null: the free camera.</summary>
        public string Camera;
        /// <summary>Free camera: the point in the middle, world, m. Null: the default view, also of distance and angles.</summary>
        public Vector3d? LookAt;
        /// <summary>Free camera: from that point, m.</summary>
        public double Distance = 2;
        /// <summary>Free camera: degrees; 0 looks along x, 90 along y.</summary>
        public double Azimuth;
        /// <summary>Free camera: degrees; negative looks down.</summary>
        public double Elevation;
        /// <summary>Vertical field of view, degrees; 0: the camera's own.</summary>
        public double FieldOfView;
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
            const uint fourBytes = 1, bottomUp = 2; // MIMO_PICTURE_RGBA, MIMO_PICTURE_BOTTOM_UP
            using (var camera = new PinnedText(options.Camera))
            {
                PictureConfigStruct config;
                MimoException.Check(Native.mimo_picture_config_init(out config, Structs.Size<PictureConfigStruct>()));
                config.width = options.Width;
                config.height = options.Height;
                config.format = fourBytes | (options.BottomUp ? bottomUp : 0);
                config.camera = camera.Pointer;
                config.fovy = options.FieldOfView;
                if (options.LookAt.HasValue)
                {
                    config.look_at = options.LookAt.Value;
                    config.distance = options.Distance;
                    config.azimuth = options.Azimuth;
                    config.elevation = options.Elevation;
                }
                MimoException.Check(Native.mimo_env_render(handle, ref config, rgba, (UIntPtr)rgba.Length, null, UIntPtr.Zero,
                    null, UIntPtr.Zero));
            }
        }
    }
}
