using System;
using System.Collections.Generic;

namespace Mimo
{
    /// <summary>Where the time of steps went, seconds.</summary>
    public struct Timing
    {
        /// <summary>Steps counted.</summary>
        public long Steps;
        /// <summary>Everything.</summary>
        public double Total;
        /// <summary>MuJoCo's steps.</summary>
        public double Physics;
        /// <summary>Sense of touch.</summary>
        public double Touch;
        /// <summary>Drawing the eyes' pictures.</summary>
        public double Vision;
        /// <summary>Joint senses.</summary>
        public double Proprioception;
        /// <summary>Accelerometer and gyroscope.</summary>
        public double Vestibular;
    }

    /// <summary>How a world goes on: its time steps, what their rewards consist of, and where the time goes.</summary>
    public sealed partial class Env
    {
        /// <summary>Name of the task.</summary>
        public string Task
        {
            get
            {
                IntPtr name;
                MimoException.Check(Native.mimo_env_task(handle, out name));
                return Utf8.Of(name);
            }
        }

        /// <summary>Physics steps in a step.</summary>
        public int FrameSkip
        {
            get
            {
                uint steps;
                MimoException.Check(Native.mimo_env_frame_skip(handle, out steps));
                return (int)steps;
            }
        }

        /// <summary>Length of one physics step, seconds.</summary>
        public double Timestep
        {
            get
            {
                double seconds;
                MimoException.Check(Native.mimo_env_timestep(handle, out seconds));
                return seconds;
            }
        }

        /// <summary>Bare physics: so many physics steps with the controls as they are, without senses or task.</summary>
        public void StepPhysics(int count = 1)
        {
            MimoException.Check(Native.mimo_env_physics_step(handle, (UIntPtr)checked((uint)count)));
        }

        /// <summary>The terms of the last step's reward by name; it is their sum. 0 after a reset.</summary>
        public IReadOnlyDictionary<string, double> RewardTerms(int agent = 0)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_env_reward_term_count(handle, (UIntPtr)agent, out count));
            var values = new double[(int)count];
            MimoException.Check(Native.mimo_env_reward_terms(handle, (UIntPtr)agent, values, count));
            var terms = new Dictionary<string, double>();
            for (var i = 0; i < values.Length; ++i)
            {
                IntPtr name;
                MimoException.Check(Native.mimo_env_reward_term_name(handle, (UIntPtr)agent, (UIntPtr)i, out name));
                terms.Add(Utf8.Of(name), values[i]);
            }
            return terms;
        }

        /// <summary>Where the time of steps went since the last ResetTiming; all zero without EnvOptions.Timing.</summary>
        public Timing Timing
        {
            get
            {
                var raw = new TimingStruct { struct_size = (uint)Structs.Size<TimingStruct>() };
                MimoException.Check(Native.mimo_env_timing(handle, ref raw));
                return new Timing
                {
                    Steps = (long)raw.steps, Total = raw.total, Physics = raw.physics, Touch = raw.touch, Vision = raw.vision,
                    Proprioception = raw.proprioception, Vestibular = raw.vestibular
                };
            }
        }

        /// <summary>Starts counting anew.</summary>
        public void ResetTiming() { MimoException.Check(Native.mimo_env_timing_reset(handle)); }
    }
}
