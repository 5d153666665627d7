using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Owns a mimo_scene.</summary>
    internal sealed class SceneHandle : SafeHandle
    {
        internal SceneHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_scene_destroy(handle);
            return true;
        }
    }

    /// <summary>Owns a mimo_env and what its log callback needs.</summary>
    internal sealed class EnvHandle : SafeHandle
    {
        internal GCHandle Log;

        internal EnvHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_env_destroy(handle);
            if (Log.IsAllocated) Log.Free();
            return true;
        }
    }
}
