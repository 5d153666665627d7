using System;
using System.Linq;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>One field of an observation block. What a step gives of it belongs to the time from Start to End.</summary>
    public sealed class Field
    {
        private readonly LayoutHandle layout;
        private readonly UIntPtr index;

        /// <summary>Path, "proprioception/position".</summary>
        public string Name { get; }

        /// <summary>"rad"; "" for none.</summary>
        public string Unit { get; }

        /// <summary>Frame of reference, "joint"; "" for none.</summary>
        public string Frame { get; }

        /// <summary>Type of the elements.</summary>
        public FieldType Type { get; }

        /// <summary>Dimensions, C order.</summary>
        public int[] Shape { get; }

        /// <summary>Bytes from the start of the block.</summary>
        public int Offset { get; }

        /// <summary>Length in bytes.</summary>
        public int Bytes { get; }

        /// <summary>Smallest possible value; -infinity where there is none.</summary>
        public double Low { get; }

        /// <summary>Largest possible value; infinity where there is none.</summary>
        public double High { get; }

        /// <summary>Seconds after the step's end, not above 0.</summary>
        public double Start { get; private set; }

        /// <summary>Seconds after the step's end, from Start to 0.</summary>
        public double End { get; private set; }

        /// <summary>Seconds from one new value to the next.</summary>
        public double Period { get; }

        /// <summary>On how many receptors it reports, in the order of its first dimension; 0: it is not of skin.</summary>
        public int ReceptorCount { get; }

        /// <summary>Of sound, samples a second, the oldest first; 0: it is no sound.</summary>
        public double SampleRate { get; }

        internal Field(LayoutHandle layout, UIntPtr index)
        {
            this.layout = layout;
            this.index = index;
            var raw = Raw();
            Name = Utf8.Of(raw.name);
            Unit = Utf8.Of(raw.unit);
            Frame = Utf8.Of(raw.frame);
            Type = (FieldType)raw.dtype;
            Shape = ShapeOf(raw);
            Offset = (int)raw.offset;
            Bytes = (int)raw.bytes;
            Low = raw.low;
            High = raw.high;
            Start = raw.start;
            End = raw.end;
            Period = raw.period;
            ReceptorCount = (int)raw.receptors;
            SampleRate = raw.sample_rate;
        }

        private FieldStruct Raw()
        {
            var raw = FieldStruct.New();
            MimoException.Check(Native.mimo_layout_field(layout, index, ref raw));
            return raw;
        }

        /// <summary>Reads anew when it is true: infants of other ages are late by other times.</summary>
        internal void Renew()
        {
            var raw = Raw();
            Start = raw.start;
            End = raw.end;
        }

        private static int[] ShapeOf(FieldStruct raw)
        {
            var sizes = new long[(int)raw.ndim];
            Marshal.Copy(raw.shape, sizes, 0, sizes.Length);
            return sizes.Select(size => (int)size).ToArray();
        }

        /// <summary>The joint, sensor or actuator that one element belongs to, by its position in the flattened field; "" in
        /// pictures and touch.</summary>
        public string Label(int element)
        {
            IntPtr label;
            MimoException.Check(Native.mimo_layout_label(layout, index, Given.Index(element, "element"), out label));
            return Utf8.Of(label);
        }

        /// <summary>How late each element of the flattened field comes, seconds, 0 for what is sensed at once; in a batch as
        /// world 0 was made.</summary>
        public double[] Delays()
        {
            var seconds = new double[Shape.Aggregate(1, (count, size) => count * size)];
            MimoException.Check(Native.mimo_layout_delays(layout, index, seconds, (UIntPtr)(uint)seconds.Length));
            return seconds;
        }

        /// <summary>Where the pixels of a picture lie, foveated or not: unit vectors from the eye or camera to the middle of
        /// each, height x width x 3, in its frame: x right, y up, z backwards.</summary>
        public float[] Directions()
        {
            var directions = new float[Shape.Length < 2 ? 0 : Shape[0] * Shape[1] * 3];
            MimoException.Check(Native.mimo_layout_directions(layout, index, directions, (UIntPtr)(uint)directions.Length));
            return directions;
        }

        /// <summary>Where the receptors are: a quantity of all of them, one after the other.</summary>
        public double[] Receptors(Receptor quantity)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_layout_receptor_width(layout, index, (int)quantity, out count));
            var values = new double[(int)count];
            MimoException.Check(Native.mimo_layout_receptors(layout, index, (int)quantity, values, count));
            return values;
        }

        /// <summary>Copies its elements out of a world's block that starts at a place of an array.</summary>
        internal void CopyTo<T>(T[] into, byte[] blocks, int start) where T : struct
        {
            var count = Bytes / ElementSize;
            if (into == null || Marshal.SizeOf(typeof(T)) != ElementSize || into.Length < count)
                throw Given.Misfit(into, nameof(into), "but " + Name + " has " + count + " elements of type " + Type);
            Buffer.BlockCopy(blocks, start + Offset, into, 0, Bytes);
        }

        private int ElementSize => Type == FieldType.U8 ? 1 : Type == FieldType.F64 ? 8 : 4;
    }
}
