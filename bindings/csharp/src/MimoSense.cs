using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>A field of floats that a sense of your own fills. Each agent has its own.</summary>
    public sealed class SenseField
    {
        /// <summary>Name, such as "rate" for "ct/rate"; null: the field has the sense's name.</summary>
        public string Name;
        /// <summary>Dimensions, C order; empty: a single number.</summary>
        public int[] Shape = new int[0];
        /// <summary>Unit, such as "Hz"; null: none.</summary>
        public string Unit;
        /// <summary>Frame of reference, such as "world"; null: none.</summary>
        public string Frame;
        /// <summary>Smallest value.</summary>
        public double Low = double.NegativeInfinity;
        /// <summary>Largest value.</summary>
        public double High = double.PositiveInfinity;
        /// <summary>A name for each number; null: none.</summary>
        public string[] Labels;
        /// <summary>A field of touch whose receptors the first dimension counts, such as "touch/force"; null:
        /// none.</summary>
        public string Skin;
        /// <summary>Which of these receptors; null: all.</summary>
        public int[] Receptors;
        /// <summary>How fast the nerves of a skin field conduct, m/s; 0: as fast as large fibres.</summary>
        public double NerveSpeed;

        /// <summary>Makes a field without unit, frame and bounds.</summary>
        public SenseField(string name = null, params int[] shape)
        {
            Name = name;
            Shape = shape;
        }
    }

    /// <summary>A parameter of a sense of your own.</summary>
    public sealed class SenseParameter
    {
        /// <summary>Name without the sense, such as "rate" for "ct/rate".</summary>
        public string Name;
        /// <summary>One line, with the unit.</summary>
        public string Description;
        /// <summary>Default value.</summary>
        public double Standard;
        /// <summary>Smallest allowed value.</summary>
        public double Low;
        /// <summary>Largest allowed value.</summary>
        public double High;
    }

    /// <summary>The world, the agent and the moment that a sense is called at. Valid until the method
    /// returns.</summary>
    public sealed class SenseMoment
    {
        private readonly EnvHandle world;
        private readonly int[] counts;
        private SenseMomentStruct told;

        /// <summary>The world, to be read: whatever changes it throws.</summary>
        public Env World { get; }

        /// <summary>Index of the world in its batch; 0 for a single world.</summary>
        public int WorldNumber => (int)told.world;

        /// <summary>Index of the agent.</summary>
        public int Agent => (int)told.agent;

        /// <summary>How the agent's fields, and an infant's parts in the model, begin: "anna/".</summary>
        public string Prefix => Utf8.Of(told.prefix);

        /// <summary>Physics steps since the start of the episode.</summary>
        public long Tick => (long)told.tick;

        /// <summary>Seconds of a physics step.</summary>
        public double Timestep => told.timestep;

        /// <summary>Physics steps of an environment step.</summary>
        public int StepTicks => (int)told.step_ticks;

        /// <summary>Values of the sense's parameters, in their order.</summary>
        public double[] Parameters { get; }

        /// <summary>What the sense remembers for this world and agent. It is 0 at the start of an episode and part of
        /// the world's state. What Write changes in it does not last.</summary>
        public double[] Memory { get; }

        /// <summary>In Write: the values of each field, in the order of declaration, all 0.</summary>
        public float[][] Fields { get; }

        internal SenseMoment(EnvHandle handle, Env env, double[] parameters, int memory, int[] sizes, SenseMomentStruct first)
        {
            world = handle;
            World = env;
            Parameters = parameters;
            Memory = new double[memory];
            counts = sizes;
            Fields = Array.ConvertAll(sizes, size => new float[size]);
            told = first;
        }

        /// <summary>Copies a field (World.Layout.Find) as its own sense has it now, without limits and delays.</summary>
        public void Feel(Field field, float[] into)
        {
            if (into == null || Given.Some(field, "field", "one of Layout.Fields").Type != FieldType.F32 || into.Length * 4 < field.Bytes)
                throw Given.Misfit(into, nameof(into), "but " + field.Name + " has " + field.Bytes / 4 + " elements of type " + field.Type);
            Marshal.Copy(Felt(field), into, 0, field.Bytes / 4);
        }

        /// <summary>The same for a colour picture.</summary>
        public void Feel(Field field, byte[] into)
        {
            if (into == null || Given.Some(field, "field", "one of Layout.Fields").Type != FieldType.U8 || into.Length < field.Bytes)
                throw Given.Misfit(into, nameof(into), "but " + field.Name + " has " + field.Bytes + " elements of type " + field.Type);
            Marshal.Copy(Felt(field), into, 0, field.Bytes);
        }

        private IntPtr Felt(Field field)
        {
            using (var place = new Pinned(new IntPtr[1]))
            {
                MimoException.Check(Native.mimo_sense_feel(world, field.Index, place.Pointer));
                return Marshal.ReadIntPtr(place.Pointer);
            }
        }

        /// <summary>A normal number that follows from the world's seed, the tick and this number.</summary>
        public double Noise(long number) { return Native.mimo_sense_noise(told.seed, told.tick, (ulong)number); }

        internal void Begin(ref SenseMomentStruct now)
        {
            told = now;
            if (Memory.Length > 0) Marshal.Copy(now.memory, Memory, 0, Memory.Length);
        }

        internal void Keep()
        {
            if (Memory.Length > 0) Marshal.Copy(Memory, 0, told.memory, Memory.Length);
        }

        internal void Clear()
        {
            foreach (var field in Fields) Array.Clear(field, 0, field.Length);
        }

        internal void Hand()
        {
            for (var i = 0; i < Fields.Length; ++i)
                Marshal.Copy(Fields[i], 0, Marshal.ReadIntPtr(told.fields, i * IntPtr.Size), counts[i]);
        }
    }

    /// <summary>What the function is given that makes a sense for an agent of a world.</summary>
    public sealed class SenseOpening
    {
        private readonly EnvHandle handle;
        private readonly System.Collections.Generic.List<int> counts = new System.Collections.Generic.List<int>();

        /// <summary>The world, to be read.</summary>
        public Env World { get; }

        /// <summary>Index of the agent.</summary>
        public int Agent { get; }

        /// <summary>How the agent's fields, and an infant's parts in the model, begin: "anna/".</summary>
        public string Prefix { get; }

        /// <summary>Seconds of a physics step.</summary>
        public double Timestep { get; }

        /// <summary>Physics steps of an environment step.</summary>
        public int StepTicks { get; }

        /// <summary>Values of the sense's parameters, in their order.</summary>
        public double[] Parameters { get; }

        /// <summary>How many numbers the sense remembers. Set it.</summary>
        public int Memory;

        /// <summary>Whether Advance looks at MuJoCo's sensors, which then are computed in each physics step.</summary>
        public bool Sensors;

        internal int[] Counts => counts.ToArray();

        internal SenseOpening(EnvHandle handle, Env env, double[] parameters, ref SenseMomentStruct told)
        {
            this.handle = handle;
            World = env;
            Parameters = parameters;
            Agent = (int)told.agent;
            Prefix = Utf8.Of(told.prefix);
            Timestep = told.timestep;
            StepTicks = (int)told.step_ticks;
        }

        /// <summary>Declares a field.</summary>
        public void Add(SenseField field)
        {
            Given.Some(Given.Some(field, "field", "a SenseField").Shape, "Shape", "an array");
            using (var words = new PinnedParts())
            {
                SenseFieldStruct raw;
                MimoException.Check(Native.mimo_sense_field_init(out raw, (UIntPtr)SenseFieldStruct.Bytes));
                raw.name = words.Text(field.Name);
                raw.unit = words.Text(field.Unit);
                raw.frame = words.Text(field.Frame);
                raw.shape = words.Keep(Array.ConvertAll(field.Shape, size => Given.Index(size, "size")));
                raw.ndim = (UIntPtr)field.Shape.Length;
                raw.low = field.Low;
                raw.high = field.High;
                raw.labels = field.Labels == null ? IntPtr.Zero : words.Keep(Array.ConvertAll(field.Labels, words.Text));
                raw.label_count = Given.LengthOrNone(field.Labels);
                raw.skin = words.Text(field.Skin);
                raw.receptors = words.Keep(field.Receptors);
                raw.receptor_count = Given.LengthOrNone(field.Receptors);
                raw.nerve_speed = field.NerveSpeed;
                MimoException.Check(Native.mimo_sense_add_field(handle, ref raw));
            }
            var count = 1;
            foreach (var size in field.Shape) count *= size;
            counts.Add(count);
        }
    }

    /// <summary>A sense of your own, of one agent in one world, for MimoScene.AddSense. What changes belongs into
    /// SenseMoment.Memory. The worlds of a batch call it at the same time on different threads. If it throws, the call
    /// that ran it throws a MimoException that quotes the message.</summary>
    public abstract class MimoSense
    {
        /// <summary>An episode starts; the memory is 0.</summary>
        public virtual void Reset(SenseMoment moment) { }

        /// <summary>After each physics step.</summary>
        public virtual void Advance(SenseMoment moment) { }

        /// <summary>Fills moment.Fields. It runs as often as somebody looks.</summary>
        public abstract void Write(SenseMoment moment);
    }
}
