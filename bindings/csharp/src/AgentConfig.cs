using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>One infant: where it is, what it senses, what of it acts. mimo_agent_config of mimo.h, whose comments hold.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct AgentConfig
    {
        /// <summary>The library's defaults: the mitten body at the scene's place, all senses on. MimoScene.DefaultAgent gives
        /// what a scene wants instead.</summary>
        public static AgentConfig Default
        {
            get
            {
                Library.Require();
                AgentConfig config;
                MimoException.Check(Native.mimo_agent_config_init(out config, Structs.Size<AgentConfig>()));
                return config;
            }
        }

        internal uint struct_size;
        /// <summary>Which point of it lies at position: 1 its root body, 2 its soles, 3 its lowest point; 0: the scene's own
        /// place counts instead.</summary>
        public int place;
        internal IntPtr name;
        internal IntPtr body;
        /// <summary>Of the point that place says, metres, world frame.</summary>
        public Vector3d position;
        /// <summary>Of the root body.</summary>
        public Quaterniond orientation;
        /// <summary>MIMO_PROPRIOCEPTION_ bits; 0: none.</summary>
        public uint proprioception;
        /// <summary>1 acceleration, 2 angular velocity, of the head; 0: no sense of balance.</summary>
        public uint vestibular;
        /// <summary>Limit sensors work this near to a limit, radians.</summary>
        public double limit_threshold;
        /// <summary>1 colour, 2 depth, 4 segmentation, of both eyes; 0: no vision.</summary>
        public uint vision;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint vision_width;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint vision_height;
        /// <summary>0 torque, 1 position, 2 muscles, 3 MuJoCo's muscles.</summary>
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
        internal IntPtr face, root, vestibular_at;
    }
}
