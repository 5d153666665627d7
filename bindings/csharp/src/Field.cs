using System;
using System.Linq;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>One field of an observation block. Its values belong to the time from Start to End.</summary>
    public sealed class Field
    {
        private readonly LayoutHandle layout;
        private readonly UIntPtr index;
        internal UIntPtr Index => index;

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

        /// <summary>Number of receptors, in the order of the first dimension; 0 if the field is not on the
        /// skin.</summary>
        public int ReceptorCount { get; }

        /// <summary>For sound: samples per second, the oldest first; 0 for other fields.</summary>
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

        /// <summary>Updates Start and End: the delays of infants depend on their age.</summary>
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

        /// <summary>The joint, sensor or actuator of one element of the flattened field; "" for pictures and
        /// touch.</summary>
        public string Label(int element)
        {
            IntPtr label;
            MimoException.Check(Native.mimo_layout_label(layout, index, Given.Index(element, "element"), out label));
            return Utf8.Of(label);
        }

        /// <summary>Delay of each element of the flattened field, seconds; 0 for no delay. In a batch these are the
        /// delays of world 0 when it was made.</summary>
        public double[] Delays()
        {
            var seconds = new double[Shape.Aggregate(1, (count, size) => count * size)];
            MimoException.Check(Native.mimo_layout_delays(layout, index, seconds, (UIntPtr)(uint)seconds.Length));
            return seconds;
        }

        /// <summary>The directions of a picture's pixels, foveated or not: height x width x 3, unit vectors from the
        /// eye or camera through the middle of each pixel, in its frame (x right, y up, z backwards).</summary>
        public float[] Directions()
        {
            var directions = new float[Shape.Length < 2 ? 0 : Shape[0] * Shape[1] * 3];
            MimoException.Check(Native.mimo_layout_directions(layout, index, directions, (UIntPtr)(uint)directions.Length));
            return directions;
        }

        /// <summary>A quantity of all receptors of the field, one receptor after the other.</summary>
        public double[] Receptors(Receptor quantity)
        {
            UIntPtr count;
            MimoException.Check(Native.mimo_layout_receptor_width(layout, index, (int)quantity, out count));
            var values = new double[(int)count];
            MimoException.Check(Native.mimo_layout_receptors(layout, index, (int)quantity, values, count));
            return values;
        }

        /// <summary>Copies the field out of the block that begins at an index of an array of blocks.</summary>
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
