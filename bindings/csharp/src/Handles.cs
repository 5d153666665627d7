using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace Mimo
{
    /// <summary>Owns a mimo_scene, and a share of its log and its task.</summary>
    internal sealed class SceneHandle : SafeHandle
    {
        internal Logging Log;
        internal Tasking Task;

        internal SceneHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_scene_destroy(handle);
            Log?.Release();
            Task?.Release();
            return true;
        }
    }

    /// <summary>A mimo_env, and a share of what its log callback and its task need. Arrays that its steps write to stay in
    /// place as long as there is this.</summary>
    internal sealed class EnvHandle : SafeHandle
    {
        internal Logging Log;
        internal Tasking Task;
        internal readonly PinnedParts Kept = new PinnedParts();
        private readonly bool isLent;

        // Of a world that belongs to a batch: alive as long as the handle is in use.
        internal BatchHandle Owner { get; }

        internal EnvHandle() : base(IntPtr.Zero, true) { }

        internal EnvHandle(IntPtr lent, BatchHandle owner) : this(lent)
        {
            Owner = owner;
            Log = owner.Log;
            Task = owner.Task;
        }

        /// <summary>Of a world that a task is asked about: whoever asks keeps it alive.</summary>
        internal EnvHandle(IntPtr lent) : base(IntPtr.Zero, true)
        {
            isLent = true;
            SetHandle(lent);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            if (!isLent) Destroy();
            Kept.Dispose();
            return true;
        }

        private void Destroy()
        {
            Native.mimo_env_destroy(handle);
            Log?.Release();
            Task?.Release(handle);
        }
    }

    /// <summary>Owns a mimo_batch and a share of what its log callback and its task need, and holds the arrays in place that its threads
    /// use between two calls.</summary>
    internal sealed class BatchHandle : SafeHandle, Ending.IEnds
    {
        private volatile bool isGone;
        internal Logging Log;
        internal Tasking Task;
        internal readonly PinnedParts Kept = new PinnedParts();
        private Pinned sent;

        internal BatchHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_batch_destroy(handle); // waits for what was sent
            Kept.Dispose();
            sent?.Dispose();
            Log?.Release();
            Task?.Release();
            isGone = true;
            return true;
        }

        public bool IsGone => isGone;

        /// <summary>The actions of a step that was sent stay until the next is: the one before was received by then.</summary>
        internal void KeepSent(Pinned actions)
        {
            sent?.Dispose();
            sent = actions;
        }
    }

    /// <summary>Owns a mimo_senses, and a share of its log.</summary>
    internal sealed class SensesHandle : SafeHandle
    {
        internal Logging Log;

        internal SensesHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_senses_destroy(handle);
            Log?.Release();
            return true;
        }
    }

    /// <summary>Owns a mimo_recorder.</summary>
    internal sealed class RecorderHandle : SafeHandle, Ending.IEnds
    {
        private volatile bool isGone;

        internal RecorderHandle() : base(IntPtr.Zero, true) { }

        // Alive as long as this is: it would be closed by its world otherwise, on the thread of the collector.
        internal EnvHandle World;

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            // Within a step of another thread the library would leave it open.
            for (var wait = 0; Native.mimo_recorder_close(handle) == (int)Status.Busy && wait < 1000; ++wait) Thread.Sleep(1);
            isGone = true;
            return true;
        }

        public bool IsGone => isGone;
    }

    /// <summary>Owns a mimo_recording.</summary>
    internal sealed class RecordingHandle : SafeHandle
    {
        internal RecordingHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle()
        {
            Native.mimo_recording_destroy(handle);
            return true;
        }
    }

    /// <summary>The mimo_layout of a world, a batch or senses, which are alive as long as it is in use.</summary>
    internal sealed class LayoutHandle : SafeHandle
    {
        internal SafeHandle Owner { get; }

        internal LayoutHandle(IntPtr lent, SafeHandle owner) : base(IntPtr.Zero, false)
        {
            Owner = owner;
            SetHandle(lent);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        protected override bool ReleaseHandle() { return true; }
    }
}
