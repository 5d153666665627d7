using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Three numbers: a place in metres, or what else is said where it is used.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Vector3
    {
        /// <summary>Component.</summary>
        public double X;
        /// <summary>Component.</summary>
        public double Y;
        /// <summary>Component.</summary>
        public double Z;

        /// <summary>Makes one of its components.</summary>
        public Vector3(double x, double y, double z) { X = x; Y = y; Z = z; }
    }

    /// <summary>A rotation. In memory in the library's order: w x y z.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Quaternion
    {
        /// <summary>Component.</summary>
        public double W;
        /// <summary>Component.</summary>
        public double X;
        /// <summary>Component.</summary>
        public double Y;
        /// <summary>Component.</summary>
        public double Z;

        /// <summary>Makes one of its components, w first.</summary>
        public Quaternion(double w, double x, double y, double z) { W = w; X = x; Y = y; Z = z; }
    }

    /// <summary>One infant: where it is, what it senses, what of it acts. mimo_agent_config of mimo.h, whose comments hold.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct AgentConfig
    {
        internal uint struct_size;
        /// <summary>1: position and orientation count; 0: the scene's own place.</summary>
        public uint place_given;
        internal IntPtr name;
        internal IntPtr body;
        /// <summary>Of the root body, metres, world frame.</summary>
        public Vector3 position;
        /// <summary>Of the root body.</summary>
        public Quaternion orientation;
        /// <summary>MIMO_PROPRIOCEPTION_ bits; 0: none.</summary>
        public uint proprioception;
        /// <summary>1: accelerometer and gyroscope in the head; 0: none.</summary>
        public uint vestibular;
        /// <summary>Limit sensors work this near to a limit, radians.</summary>
        public double limit_threshold;
        /// <summary>1 colour, 2 depth, 4 segmentation, of both eyes; 0: no vision.</summary>
        public uint vision;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint vision_width;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint vision_height;
        /// <summary>0 torque, 1 position.</summary>
        public uint actuation;
        /// <summary>Vertical field of view, degrees; 0: the camera's own.</summary>
        public double vision_fovy;
        /// <summary>MIMO_ACT_ bits: parts that have motors; 0: the scene's own choice.</summary>
        public uint acts;
        /// <summary>1: all actions go from -1 to 1.</summary>
        public uint normalize_actions;
        /// <summary>MIMO_TOUCH_ bits; 0: no touch.</summary>
        public uint touch;
        /// <summary>1 nearest, 2 linear, 3 gaussian.</summary>
        public int touch_response;
        /// <summary>1 body, 2 world, 3 skin.</summary>
        public int touch_frame;
        internal uint touch_reserved;
        /// <summary>Divides the usual distances between touch sensors.</summary>
        public double touch_scale;
        /// <summary>Slip below counts as none, m/s.</summary>
        public double touch_slip_threshold;
        internal IntPtr face;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneConfigStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr name, file, xml, model_dir, log, log_user;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ObjectConfigStruct
    {
        internal uint struct_size;
        internal int shape;
        internal IntPtr name;
        internal Vector3 size, position;
        internal Quaternion orientation;
        internal double mass;
        internal Quaternion rgba;
        internal uint @fixed, reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct EnvConfigStruct
    {
        internal uint struct_size, frame_skip;
        internal int jacobian;
        internal uint disable;
        internal IntPtr renderer;
        internal uint max_steps, timing;
        internal IntPtr log, log_user, task;
        internal uint render, samples, render_threads, reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct Shape
    {
        internal UIntPtr A, B, C, D;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct FieldStruct
    {
        internal uint struct_size;
        internal int dtype;
        internal IntPtr name, unit, frame;
        internal UIntPtr offset, bytes;
        internal Shape shape;
        internal uint ndim;
        internal int time;
        internal double low, high;
    }
}
