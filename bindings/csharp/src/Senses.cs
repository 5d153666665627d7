using System;

namespace Mimo
{
    /// <summary>Senses that look at a host's own MuJoCo model, and never change it. Pointers are those of MuJoCo's structs,
    /// as its plug-in for Unity has them; the model outlives the senses.</summary>
    public sealed class Senses : IDisposable
    {
        private readonly SensesHandle owned;
        private SensesHandle Handle => Ending.Pass(owned);

        /// <summary>The last observation.</summary>
        public byte[] Block { get; }

        /// <summary>What it consists of.</summary>
        public Layout Layout { get; }

        /// <summary>Attaches senses to an mjModel of a host whose mj_version() is given. The scene describes the agents
        /// (with the body "scene"), their skin, the limits of their senses and the cameras.</summary>
        public Senses(MimoScene scene, IntPtr model, int mujocoVersion, SensesConfig config = null)
        {
            owned = (config ?? new SensesConfig()).Attach(scene, model, mujocoVersion);
            Layout = new Layout(Handle, (out IntPtr layout) => Native.mimo_senses_layout(Handle, out layout));
            Block = new byte[Layout.BlockBytes];
        }

        /// <summary>Copies a field of the last observation into an array of its element type: byte, int, float or double.</summary>
        public void Read<T>(Field field, T[] into) where T : struct { Given.Some(field, "field", "one of Layout.Fields").CopyTo(into, Block, 0); }

        /// <summary>Starts an episode: nothing was sensed before what the mjData hold. Noise follows from the seed; without
        /// one it goes on from the last episode's.</summary>
        public void Reset(IntPtr data, ulong? seed = null)
        {
            var config = ResetConfigStruct.Of(seed);
            MimoException.Check(Native.mimo_senses_reset(Handle, data, ref config));
        }

        /// <summary>One step later, once after each step of the host: senses with a delay take in what the mjData hold.</summary>
        public void Advance(IntPtr data) { MimoException.Check(Native.mimo_senses_advance(Handle, data)); }

        /// <summary>Dynamic and static drive of the spindles of both muscles of each motor, Hz, 4 numbers a motor, until
        /// an episode starts. Null: all motors that have spindles.</summary>
        public void DriveSpindles(int[] actuators, double[] rates)
        {
            var count = Given.LengthOrNone(actuators);
            MimoException.Check(
                Native.mimo_senses_drive_spindles(Handle, actuators, count, rates, Given.LengthOf(rates, "rates")));
        }

        /// <summary>Lets a body play samples, Pa at 1 m, from the next Advance on: see Env.Play.</summary>
        public void Play(string body, float[] samples, double rate)
        {
            MimoException.Check(Native.mimo_senses_play(Handle, Utf8.Bytes(body), samples, Given.LengthOf(samples, "samples"), rate));
        }

        /// <summary>Senses what the mjData hold, which stay as they are, as does what the senses remember.</summary>
        public void Observe(IntPtr data)
        {
            MimoException.Check(Native.mimo_senses_observe(Handle, data, Block, (UIntPtr)Block.Length));
        }

        /// <summary>What the senses remember, as bytes.</summary>
        public byte[] Save()
        {
            UIntPtr bytes;
            MimoException.Check(Native.mimo_senses_state_size(Handle, out bytes));
            var state = new byte[(int)bytes];
            MimoException.Check(Native.mimo_senses_state_save(Handle, state, bytes));
            return state;
        }

        /// <summary>Goes on from what other senses of such a model remembered; what the state lacks starts fresh.</summary>
        public LoadReport Load(byte[] state)
        {
            return LoadReport.Of((ref LoadReportStruct report) =>
                Native.mimo_senses_state_load(Handle, state, Given.LengthOf(state, "state"), ref report));
        }

        /// <summary>Detaches the senses.</summary>
        public void Dispose() { owned.Dispose(); }
    }
}
