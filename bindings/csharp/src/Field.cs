using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Type of a field's elements; values are those of mimo.h.</summary>
    public enum FieldType
    {
        /// <summary>byte</summary>
        U8 = 1,
        /// <summary>int</summary>
        I32 = 2,
        /// <summary>float</summary>
        F32 = 3,
        /// <summary>double</summary>
        F64 = 4
    }

    /// <summary>One field of an observation block.</summary>
    public sealed class Field
    {
        /// <summary>Path, "proprioception/position".</summary>
        public string Name { get; internal set; }

        /// <summary>"rad"; "" for none.</summary>
        public string Unit { get; internal set; }

        /// <summary>Type of the elements.</summary>
        public FieldType Type { get; internal set; }

        /// <summary>Dimensions, C order.</summary>
        public int[] Shape { get; internal set; }

        /// <summary>Bytes from the start of the block.</summary>
        public int Offset { get; internal set; }

        /// <summary>Length in bytes.</summary>
        public int Bytes { get; internal set; }

        /// <summary>Copies its elements out of a world's block that starts at a place of an array.</summary>
        internal void CopyTo<T>(T[] into, byte[] blocks, int start) where T : struct
        {
            if (Marshal.SizeOf(typeof(T)) != ElementSize || Buffer.ByteLength(into) < Bytes)
                throw new ArgumentException(Name + " has " + Bytes + " bytes of type " + Type, nameof(into));
            Buffer.BlockCopy(blocks, start + Offset, into, 0, Bytes);
        }

        private int ElementSize => Type == FieldType.U8 ? 1 : Type == FieldType.F64 ? 8 : 4;

        internal static Field Of(FieldStruct field)
        {
            var all = new[] { (int)field.shape.A, (int)field.shape.B, (int)field.shape.C, (int)field.shape.D };
            var shape = new int[field.ndim];
            Array.Copy(all, shape, shape.Length);
            return new Field
            {
                Name = Utf8.Of(field.name), Unit = Utf8.Of(field.unit), Type = (FieldType)field.dtype,
                Shape = shape, Offset = (int)field.offset, Bytes = (int)field.bytes
            };
        }
    }
}
