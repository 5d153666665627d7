using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace Mimo
{
    /// <summary>A handle of the library.</summary>
    internal abstract class LibraryHandle : SafeHandle
    {
        protected LibraryHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid => handle == IntPtr.Zero;
    }

    /// <summary>Owns a mimo_scene and a share of its log and its task.</summary>
    internal sealed class SceneHandle : LibraryHandle
    {
        internal Logging Log;
        internal Tasking Task;

        protected override bool ReleaseHandle()
        {
            Native.mimo_scene_destroy(handle);
            Log?.Release();
            Task?.Release();
            return true;
        }
    }

    /// <summary>Owns or borrows a mimo_env and a share of its log and its task. Keeps the arrays pinned that its steps
    /// write to.</summary>
    internal sealed class EnvHandle : LibraryHandle
    {
        internal Logging Log;
        internal Tasking Task;
        internal readonly PinnedParts Kept = new PinnedParts();
        private readonly bool isLent;

        // The batch of a borrowed world; this reference keeps it alive.
        internal BatchHandle Owner { get; }

        internal EnvHandle() { }

        internal EnvHandle(IntPtr lent, BatchHandle owner) : this(lent)
        {
            Owner = owner;
            Log = owner.Log;
            Task = owner.Task;
        }

        /// <summary>A world that a task is called with. The caller keeps it alive.</summary>
        internal EnvHandle(IntPtr lent)
        {
            isLent = true;
            SetHandle(lent);
        }

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

    /// <summary>Owns a mimo_batch and a share of its log and its task. Keeps the arrays pinned that its threads use
    /// between two calls.</summary>
    internal sealed class BatchHandle : LibraryHandle, Ending.IEnds
    {
        private volatile bool isGone;
        internal Logging Log;
        internal Tasking Task;
        internal readonly PinnedParts Kept = new PinnedParts();
        private Pinned sent;

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

        /// <summary>Keeps the actions of a sent step pinned until the next one is sent; by then the step was
        /// received.</summary>
        internal void KeepSent(Pinned actions)
        {
            sent?.Dispose();
            sent = actions;
        }
    }

    /// <summary>Owns a mimo_senses and a share of its log.</summary>
    internal sealed class SensesHandle : LibraryHandle
    {
        internal Logging Log;

        protected override bool ReleaseHandle()
        {
            Native.mimo_senses_destroy(handle);
            Log?.Release();
            return true;
        }
    }

    /// <summary>Owns a mimo_stage and a share of its log.</summary>
    internal sealed class StageHandle : LibraryHandle
    {
        internal Logging Log;

        protected override bool ReleaseHandle()
        {
            Native.mimo_stage_destroy(handle);
            Log?.Release();
            return true;
        }
    }

    /// <summary>Owns a mimo_recorder.</summary>
    internal sealed class RecorderHandle : LibraryHandle, Ending.IEnds
    {
        private volatile bool isGone;

        // Keeps the world alive, which would otherwise close the recorder on the collector's thread.
        internal EnvHandle World;

        protected override bool ReleaseHandle()
        {
            // While another thread steps the world, the library refuses to close the recorder.
            for (var wait = 0; Native.mimo_recorder_close(handle) == (int)Status.Busy && wait < 1000; ++wait) Thread.Sleep(1);
            isGone = true;
            return true;
        }

        public bool IsGone => isGone;
    }

    /// <summary>Owns a mimo_recording.</summary>
    internal sealed class RecordingHandle : LibraryHandle
    {
        protected override bool ReleaseHandle()
        {
            Native.mimo_recording_close(handle);
            return true;
        }
    }

    /// <summary>Borrows the mimo_layout of a world, a batch or senses, and keeps its owner alive.</summary>
    internal sealed class LayoutHandle : LibraryHandle
    {
        internal SafeHandle Owner { get; }

        internal LayoutHandle(IntPtr lent, SafeHandle owner)
        {
            Owner = owner;
            SetHandle(lent);
        }

        protected override bool ReleaseHandle() { return true; }
    }
}
