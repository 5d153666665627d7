using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>The world's task, agents, time steps and timing.</summary>
    public sealed partial class Env
    {
        /// <summary>Name of the task.</summary>
        public string Task
        {
            get
            {
                IntPtr name;
                MimoException.Check(Native.mimo_env_task(Handle, out name));
                return Utf8.Of(name);
            }
        }

        /// <summary>Describes an agent.</summary>
        public AgentInfo Agent(int agent = 0)
        {
            var raw = AgentInfoStruct.New();
            MimoException.Check(Native.mimo_env_agent(Handle, Given.Index(agent, "agent"), ref raw));
            return new AgentInfo(raw);
        }

        /// <summary>Physics steps per step.</summary>
        public int FrameSkip
        {
            get
            {
                uint steps;
                MimoException.Check(Native.mimo_env_frame_skip(Handle, out steps));
                return (int)steps;
            }
        }

        /// <summary>Length of one physics step, seconds.</summary>
        public double Timestep
        {
            get
            {
                double seconds;
                MimoException.Check(Native.mimo_env_timestep(Handle, out seconds));
                return seconds;
            }
        }

        /// <summary>Runs count physics steps with the current controls, without senses and task.</summary>
        public void StepPhysics(int count = 1)
        {
            MimoException.Check(Native.mimo_env_physics_step(Handle, Given.Index(count, "count")));
        }

        /// <summary>Makes one step along a given movement. positions has FrameSkip x the positions of all joints, at
        /// the end of each physics step. The observation is updated. Returns FrameSkip x the forces that the movement
        /// takes, one per degree of freedom, N or Nm.</summary>
        public double[] Follow(double[] positions)
        {
            Given.Some(positions, "positions", "an array");
            var forces = new double[FrameSkip * Width(Quantity.JointVelocity, null)];
            var from = GCHandle.Alloc(positions, GCHandleType.Pinned);
            var to = GCHandle.Alloc(forces, GCHandleType.Pinned);
            try
            {
                var movement = new MovementStruct
                {
                    struct_size = MovementStruct.Bytes,
                    positions = from.AddrOfPinnedObject(), position_count = (UIntPtr)positions.Length,
                    forces = to.AddrOfPinnedObject(), force_count = (UIntPtr)forces.Length
                };
                MimoException.Check(Native.mimo_env_follow(Handle, ref movement, Block, (UIntPtr)Block.Length));
            }
            finally
            {
                from.Free();
                to.Free();
            }
            return forces;
        }

        /// <summary>Plays samples (Pa at 1 m) from a body, from the next physics step on and after the sound that it
        /// already plays. An empty array ends the body's sound. The rate must be Field.SampleRate of the
        /// ears.</summary>
        public void Play(string body, float[] samples, double rate)
        {
            MimoException.Check(Native.mimo_env_play(Handle, Utf8.Bytes(body), samples, Given.LengthOf(samples, "samples"), rate));
        }

        /// <summary>The time spent in steps since the last ResetTiming; all 0 without EnvConfig.Timing.</summary>
        public Timing Timing
        {
            get
            {
                var raw = TimingStruct.New();
                MimoException.Check(Native.mimo_env_timing(Handle, ref raw));
                return new Timing(raw);
            }
        }

        /// <summary>Resets Timing to 0.</summary>
        public void ResetTiming() { MimoException.Check(Native.mimo_env_timing_reset(Handle)); }
    }
}
