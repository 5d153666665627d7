using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Threading;

namespace Mimo
{
    /// <summary>Cleans up at the end of the process, or of a domain that an engine unloads to reload scripts. Library
    /// threads that have run a task belong to the runtime, which would wait for them for ever; therefore batches are
    /// destroyed first. Recordings are closed. Other threads that are inside the library at that time never return to
    /// the program, because its worlds are gone.</summary>
    internal static class Ending
    {
        private static readonly TimeSpan patience = TimeSpan.FromSeconds(10);

        // Tracks resurrection: objects that wait for their finalizers count, too.
        private static readonly List<WeakReference<IEnds>> living = new List<WeakReference<IEnds>>();

        private static volatile Thread ender; // null until the end begins
        private static int callbacks;         // running now
        [ThreadStatic] private static int within; // of them on this thread

        static Ending()
        {
            AppDomain.CurrentDomain.ProcessExit += (sender, arguments) => End();
            AppDomain.CurrentDomain.DomainUnload += (sender, arguments) => End();
        }

        /// <summary>An object that must be disposed at the end, because finalizers may not run.</summary>
        internal interface IEnds : IDisposable
        {
            /// <summary>True once the library has released the object, which happens when the last call on it
            /// returns.</summary>
            bool IsGone { get; }
        }

        internal static void Watch(IEnds one)
        {
            lock (living)
            {
                IEnds there;
                living.RemoveAll(other => !other.TryGetTarget(out there) || there.IsGone);
                living.Add(new WeakReference<IEnds>(one, true));
            }
        }

        /// <summary>Passes a handle to a call, unless the call starts after the end has begun.</summary>
        internal static T Pass<T>(T handle) where T : SafeHandle
        {
            Hold();
            return handle;
        }

        /// <summary>Blocks a thread until its process or domain is gone. Does not block the thread that runs the end,
        /// because the program's further handlers run there, nor a thread in a callback, because End waits for
        /// callbacks.</summary>
        internal static void Hold()
        {
            if (ender != null && ender != Thread.CurrentThread && within == 0) Thread.Sleep(Timeout.Infinite);
        }

        /// <summary>Call it before a callback of the program runs; Leave goes with it. Returns false if the end has
        /// begun and the callback must not run.</summary>
        internal static bool Enter()
        {
            ++within;
            Interlocked.Increment(ref callbacks);
            return ender == null || within > 1;
        }

        internal static void Leave()
        {
            Interlocked.Decrement(ref callbacks);
            --within;
        }

        private static void End()
        {
            ender = Thread.CurrentThread;
            WeakReference<IEnds>[] all;
            lock (living) all = living.ToArray();
            var until = DateTime.UtcNow + patience;
            // The newest first: recorders before their worlds.
            for (var i = all.Length - 1; i >= 0; --i)
            {
                IEnds one;
                if (all[i].TryGetTarget(out one)) End(one, until);
            }
            while (Volatile.Read(ref callbacks) > within && DateTime.UtcNow < until) Thread.Sleep(1);
        }

        private static void End(IEnds one, DateTime until)
        {
            for (one.Dispose(); !one.IsGone && DateTime.UtcNow < until; one.Dispose()) Thread.Sleep(1);
        }
    }
}
