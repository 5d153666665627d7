using System;

namespace Mimo
{
    /// <summary>Senses attached to a host's own MuJoCo model, which they never change. Pointers refer to MuJoCo's
    /// structs, as in MuJoCo's Unity plug-in. The model must outlive the senses.</summary>
    public sealed class Senses : IDisposable
    {
        private readonly SensesHandle owned;
        private SensesHandle Handle => Ending.Pass(owned);

        /// <summary>The last observation.</summary>
        public byte[] Block { get; }

        /// <summary>The fields of the observation.</summary>
        public Layout Layout { get; }

        /// <summary>Attaches senses to a host's mjModel; mujocoVersion is the host's mj_version(). The scene describes
        /// the agents (with the body "scene"), their skin, the limits of their senses and the cameras.</summary>
        public Senses(MimoScene scene, IntPtr model, int mujocoVersion, SensesConfig config = null)
        {
            owned = (config ?? new SensesConfig()).Attach(scene, model, mujocoVersion);
            Layout = new Layout(Handle, (out IntPtr layout) => Native.mimo_senses_layout(Handle, out layout));
            Block = new byte[Layout.BlockBytes];
        }

        /// <summary>Copies a field of the last observation into an array of its element type: byte, int, float or
        /// double.</summary>
        public void Read<T>(Field field, T[] into) where T : struct { Given.Some(field, "field", "one of Layout.Fields").CopyTo(into, Block, 0); }

        /// <summary>Starts an episode with the state in the mjData. The seed determines the noise; without a seed the
        /// noise continues from the last episode.</summary>
        public void Reset(IntPtr data, ulong? seed = null)
        {
            var config = ResetConfigStruct.Of(seed);
            MimoException.Check(Native.mimo_senses_reset(Handle, data, ref config));
        }

        /// <summary>Moves the senses' memory one step on. Call it once after each step of the host: delayed senses read
        /// the mjData here.</summary>
        public void Advance(IntPtr data) { MimoException.Check(Native.mimo_senses_advance(Handle, data)); }

        /// <summary>Sets the dynamic and static drive of the spindles of both muscles of motors, Hz, 4 numbers per
        /// motor, until the next episode. actuators = null: all motors with spindles.</summary>
        public void DriveSpindles(int[] actuators, double[] rates)
        {
            var count = Given.LengthOrNone(actuators);
            MimoException.Check(
                Native.mimo_senses_drive_spindles(Handle, actuators, count, rates, Given.LengthOf(rates, "rates")));
        }

        /// <summary>Plays samples (Pa at 1 m) from a body, from the next Advance on: see Env.Play.</summary>
        public void Play(string body, float[] samples, double rate)
        {
            MimoException.Check(Native.mimo_senses_play(Handle, Utf8.Bytes(body), samples, Given.LengthOf(samples, "samples"), rate));
        }

        /// <summary>Senses the state in the mjData. Neither the mjData nor the senses' memory changes.</summary>
        public void Observe(IntPtr data)
        {
            MimoException.Check(Native.mimo_senses_observe(Handle, data, Block, (UIntPtr)Block.Length));
        }

        /// <summary>The senses' memory as bytes.</summary>
        public byte[] Save()
        {
            UIntPtr bytes;
            MimoException.Check(Native.mimo_senses_state_size(Handle, out bytes));
            var state = new byte[(int)bytes];
            MimoException.Check(Native.mimo_senses_state_save(Handle, state, bytes));
            return state;
        }

        /// <summary>Loads the memory of other senses of such a model. Parts that the state lacks start fresh.</summary>
        public LoadReport Load(byte[] state)
        {
            return LoadReport.Of((ref LoadReportStruct report) =>
                Native.mimo_senses_state_load(Handle, state, Given.LengthOf(state, "state"), ref report));
        }

        /// <summary>Detaches the senses.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
