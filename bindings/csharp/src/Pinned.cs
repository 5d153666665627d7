using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>An array that is pinned while the library has a pointer to it; null gives a null pointer.</summary>
    internal class Pinned : IDisposable
    {
        private GCHandle handle;

        /// <summary>Number of elements.</summary>
        internal UIntPtr Length { get; }

        internal Pinned(Array array)
        {
            if (array == null) return;
            Length = (UIntPtr)array.Length;
            handle = GCHandle.Alloc(array, GCHandleType.Pinned);
        }

        internal IntPtr Pointer => handle.IsAllocated ? handle.AddrOfPinnedObject() : IntPtr.Zero;

        public void Dispose()
        {
            if (handle.IsAllocated) handle.Free();
        }
    }

    /// <summary>Pinned growths and an array of pointers to them; null gives a null pointer.</summary>
    internal sealed class PinnedGrowths : IDisposable
    {
        private readonly PinnedParts parts = new PinnedParts();

        internal IntPtr Pointer { get; }
        internal UIntPtr Length { get; }

        internal PinnedGrowths(IList<Growth> growths)
        {
            if (growths == null) return;
            var pointers = new IntPtr[growths.Count];
            for (var i = 0; i < pointers.Length; ++i)
                pointers[i] = growths[i] == null ? IntPtr.Zero : parts.Keep(new[] { growths[i].Raw(parts) });
            Pointer = parts.Keep(pointers);
            Length = (UIntPtr)pointers.Length;
        }

        public void Dispose() { parts.Dispose(); }
    }

    /// <summary>Texts and arrays that are pinned until it is disposed.</summary>
    internal sealed class PinnedParts : IDisposable
    {
        private readonly List<Pinned> parts = new List<Pinned>();

        internal IntPtr Text(string text) { return Keep(Utf8.Bytes(text)); }

        /// <summary>Pins an array, whose elements hold no references.</summary>
        internal IntPtr Keep(Array array)
        {
            var part = new Pinned(array);
            parts.Add(part);
            return part.Pointer;
        }

        public void Dispose()
        {
            foreach (var part in parts) part.Dispose();
        }
    }
}
