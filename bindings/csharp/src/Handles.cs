using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Owns a mimo_scene, and a share of its task.</summary>
    internal sealed class SceneHandle : SafeHandle
    {
        internal Tasking Task;

        internal SceneHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_scene_destroy(handle);
            Task?.Release();
            return true;
        }
    }

    /// <summary>A mimo_env, and a share of what its log callback and its task need.</summary>
    internal sealed class EnvHandle : SafeHandle
    {
        internal Logging Log;
        internal Tasking Task;

        // Of a world that belongs to a batch: alive as long as the handle is in use.
        internal BatchHandle Owner { get; }

        internal EnvHandle() : base(IntPtr.Zero, true) { }

        internal EnvHandle(IntPtr borrowed, BatchHandle owner) : base(IntPtr.Zero, false)
        {
            Owner = owner;
            Log = owner.Log;
            Task = owner.Task;
            SetHandle(borrowed);
        }

        /// <summary>Of a world that a task is asked about: whoever asks keeps it alive.</summary>
        internal EnvHandle(IntPtr borrowed) : base(IntPtr.Zero, false) { SetHandle(borrowed); }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_env_destroy(handle);
            Log?.Release();
            Task?.Release(handle);
            return true;
        }
    }

    /// <summary>Owns a mimo_batch and a share of what its log callback and its task need, and holds the arrays in place that its threads
    /// use between two calls.</summary>
    internal sealed class BatchHandle : SafeHandle
    {
        internal Logging Log;
        internal Tasking Task;

        private readonly List<Pinned> kept = new List<Pinned>();
        private Pinned sent;

        internal BatchHandle() : base(IntPtr.Zero, true) { }

        /// <summary>Has an array stay in place as long as there is the batch, and gives that place.</summary>
        internal IntPtr Keep(Array array)
        {
            var pinned = new Pinned(array);
            kept.Add(pinned);
            return pinned.Pointer;
        }

        /// <summary>The actions of a step that was sent stay until the next is: the one before was received by then.</summary>
        internal void KeepSent(Pinned actions)
        {
            sent?.Dispose();
            sent = actions;
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_batch_destroy(handle); // waits for what was sent
            foreach (var pinned in kept) pinned.Dispose();
            sent?.Dispose();
            Log?.Release();
            Task?.Release();
            return true;
        }
    }
}
