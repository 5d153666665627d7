using System;
using System.Runtime.InteropServices;

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
        /// <summary>What sounds, and what reaches ears.</summary>
        public double Hearing;
    }

    /// <summary>What is to be known of one agent of a world.</summary>
    public sealed class AgentInfo
    {
        /// <summary>"" for a sole one; else the prefix of its fields and model names.</summary>
        public string Name { get; internal set; }
        /// <summary>Where its actions start among Layout.Actions.</summary>
        public int ActionOffset { get; internal set; }
        /// <summary>How many they are.</summary>
        public int ActionCount { get; internal set; }
        /// <summary>Of its whole body, kg.</summary>
        public double Mass { get; internal set; }
        /// <summary>From its lowest to its highest point in the initial pose, m.</summary>
        public double Height { get; internal set; }
    }

    /// <summary>How a world goes on: its task, its agents, its time steps, and where the time goes.</summary>
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
            var raw = new AgentInfoStruct { struct_size = (uint)Structs.Size<AgentInfoStruct>() };
            MimoException.Check(Native.mimo_env_agent(Handle, Given.Index(agent, "agent"), ref raw));
            return new AgentInfo
            {
                Name = Utf8.Of(raw.name), ActionOffset = (int)raw.action_offset, ActionCount = (int)raw.action_count,
                Mass = raw.mass, Height = raw.height
            };
        }

        /// <summary>Physics steps in a step.</summary>
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

        /// <summary>Bare physics: so many physics steps with the controls as they are, without senses or task.</summary>
        public void StepPhysics(int count = 1)
        {
            MimoException.Check(Native.mimo_env_physics_step(Handle, Given.Index(count, "count")));
        }

        /// <summary>One step of a movement that is known: FrameSkip x positions of all joints, at the end of each physics step.
        /// The senses answer; gives FrameSkip x the forces that it takes, one for each degree of freedom, N or Nm.</summary>
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
                    struct_size = (uint)Structs.Size<MovementStruct>(),
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

        /// <summary>Lets a body play samples, Pa at 1 m, from the next physics step on, after what it plays already; without
        /// any it ends. The rate is Field.SampleRate of the ears.</summary>
        public void Play(string body, float[] samples, double rate)
        {
            MimoException.Check(Native.mimo_env_play(Handle, Utf8.Bytes(body), samples, Given.LengthOf(samples, "samples"), rate));
        }

        /// <summary>Where the time of steps went since the last ResetTiming; all zero without EnvOptions.Timing.</summary>
        public Timing Timing
        {
            get
            {
                var raw = new TimingStruct { struct_size = (uint)Structs.Size<TimingStruct>() };
                MimoException.Check(Native.mimo_env_timing(Handle, ref raw));
                return new Timing
                {
                    Steps = (long)raw.steps, Total = raw.total, Physics = raw.physics, Touch = raw.touch, Vision = raw.vision,
                    Proprioception = raw.proprioception, Vestibular = raw.vestibular, Hearing = raw.hearing
                };
            }
        }

        /// <summary>Starts counting anew.</summary>
        public void ResetTiming() { MimoException.Check(Native.mimo_env_timing_reset(Handle)); }
    }
}
