using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>One infant: where it is, what it senses, what of it acts. mimo_agent_config of mimo.h, whose comments hold.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct AgentConfig
    {
        /// <summary>The library's defaults: the mitten body at the scene's place, which feels its joints, balance and
        /// touch, and sees in colour. MimoScene.DefaultAgent gives what a scene wants instead.</summary>
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
        /// <summary>Which point of it lies at position.</summary>
        public Place place;
        internal IntPtr name;
        internal IntPtr body;
        /// <summary>Of the point that place says, metres, world frame.</summary>
        public Vector3d position;
        /// <summary>Of the root body.</summary>
        public Quaterniond orientation;
        /// <summary>What it senses of its body; by default, as the original, all but JointTorque and Effort.</summary>
        public Proprioception proprioception;
        /// <summary>What its sense of balance feels.</summary>
        public Vestibular vestibular;
        /// <summary>Limit sensors work this near to a limit, radians.</summary>
        public double limit_threshold;
        /// <summary>What both eyes give.</summary>
        public Vision vision;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint vision_width;
        /// <summary>Pixels, 1 to 4096.</summary>
        public uint vision_height;
        /// <summary>What its actions are.</summary>
        public Actuation actuation;
        /// <summary>Vertical field of view, degrees; 0: the camera's own.</summary>
        public double vision_fovy;
        /// <summary>Of colour: the middle is shown L / ln(1 + L) times as large, the rim small; 0: as drawn.</summary>
        public double vision_foveation;
        /// <summary>Parts that have motors; 0: the scene's own choice.</summary>
        public Act acts;
        /// <summary>1: all actions go from -1 to 1.</summary>
        public uint normalize_actions;
        /// <summary>What its skin feels.</summary>
        public TouchOutputs touch;
        /// <summary>Which sensors feel how much of a touch.</summary>
        public TouchResponse touch_response;
        /// <summary>The frame of touch forces.</summary>
        public TouchFrame touch_frame;
        /// <summary>Its reflexes of newborns, which add to its commands; none by default.</summary>
        public Reflexes reflexes;
        /// <summary>Divides the usual distances between touch sensors.</summary>
        public double touch_scale;
        /// <summary>Slip below counts as none, m/s.</summary>
        public double touch_slip_threshold;
        internal IntPtr face, root, vestibular_at, growth;
        /// <summary>What it hears; nothing by default.</summary>
        public Hearing hearing;
        /// <summary>1: an infant's voice, four more actions after those of motors.</summary>
        public uint voice;
    }
}
