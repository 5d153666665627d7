using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>An array that stays in place while the library has a pointer to it; null is a null pointer.</summary>
    internal class Pinned : IDisposable
    {
        private GCHandle handle;

        internal Pinned(Array array)
        {
            if (array != null) handle = GCHandle.Alloc(array, GCHandleType.Pinned);
        }

        internal IntPtr Pointer => handle.IsAllocated ? handle.AddrOfPinnedObject() : IntPtr.Zero;

        public void Dispose()
        {
            if (handle.IsAllocated) handle.Free();
        }
    }

    /// <summary>A string that stays in place, for a struct; null is a null pointer.</summary>
    internal sealed class PinnedText : Pinned
    {
        internal PinnedText(string text) : base(Utf8.Bytes(text)) { }
    }
}
