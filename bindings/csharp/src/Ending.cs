using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Threading;

namespace Mimo
{
    /// <summary>The end of the process, or of a domain that an engine unloads to reload scripts. The library's threads that have
    /// run a task belong to the runtime, which would wait for them for ever: so batches go before. Recordings are closed. Other
    /// threads that are in the library meanwhile do not come back to the program, which would find its worlds gone.</summary>
    internal static class Ending
    {
        private static readonly TimeSpan patience = TimeSpan.FromSeconds(10);

        // Also of what awaits its finalizer: at the end that may not run.
        private static readonly List<WeakReference<IEnds>> living = new List<WeakReference<IEnds>>();

        private static volatile Thread ender; // null: nothing ends
        private static int callbacks;         // that run now
        [ThreadStatic] private static int within; // of these, on this thread

        static Ending()
        {
            AppDomain.CurrentDomain.ProcessExit += (sender, arguments) => End();
            AppDomain.CurrentDomain.DomainUnload += (sender, arguments) => End();
        }

        /// <summary>What cannot be left to the collector at the end.</summary>
        internal interface IEnds : IDisposable
        {
            /// <summary>Once the library has let it go, which it does as the last call on it returns.</summary>
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

        /// <summary>Gives a handle to a call: not to one that begins after the end has.</summary>
        internal static T Pass<T>(T handle) where T : SafeHandle
        {
            Hold();
            return handle;
        }

        /// <summary>Keeps a thread until its process or domain is gone. Not the one that ends it, which runs further handlers of
        /// the program's, nor one in a callback, for whose end is waited.</summary>
        internal static void Hold()
        {
            if (ender != null && ender != Thread.CurrentThread && within == 0) Thread.Sleep(Timeout.Infinite);
        }

        /// <summary>A function of the program's is to run within a call; false: it is too late for that. Goes with Leave.</summary>
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
            // The latest first: a recorder goes before its world.
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
