using System;
using System.Runtime.InteropServices;
using System.Threading;
using Mimo.Callbacks;

// Apart from Mimo: Unity has an attribute of this name too, and a script may use both namespaces.
namespace Mimo.Callbacks
{
    /// <summary>Marks a static method that native code calls; Unity's IL2CPP looks for an attribute of this name.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        internal MonoPInvokeCallbackAttribute(Type type) { }
    }
}

namespace Mimo
{
    /// <summary>The way of a message from the library to a user's delegate, which it keeps alive. Worlds and their clones
    /// share it; the last one that is destroyed lets it go.</summary>
    internal sealed class Logging
    {
        // In a static field, so that the collector never takes what the library may still call.
        private static readonly Native.LogFunction forward = Forward;

        private readonly GCHandle kept;
        private int shares = 1;

        private Logging(Action<LogRecord> log) { kept = GCHandle.Alloc(log); }

        /// <summary>Gives what a config needs; null when there is nothing to be told to.</summary>
        internal static Logging Tell(Action<LogRecord> log, out IntPtr function, out IntPtr user)
        {
            function = user = IntPtr.Zero;
            if (log == null) return null;
            var logging = new Logging(log);
            function = Marshal.GetFunctionPointerForDelegate(forward);
            user = GCHandle.ToIntPtr(logging.kept);
            return logging;
        }

        /// <summary>Checks the status of making something that was given a log; what is not made lets it go.</summary>
        internal static void CheckTold(int status, Logging log)
        {
            if (status != 0) log?.Release();
            MimoException.Check(status);
        }

        internal Logging Share()
        {
            Interlocked.Increment(ref shares);
            return this;
        }

        internal void Release()
        {
            if (Interlocked.Decrement(ref shares) == 0) kept.Free();
        }

        [MonoPInvokeCallback(typeof(Native.LogFunction))]
        private static void Forward(IntPtr user, ref LogRecordStruct record)
        {
            try
            {
                if (Ending.Enter()) ((Action<LogRecord>)GCHandle.FromIntPtr(user).Target)(LogRecord.Of(ref record));
            }
            catch (Exception)
            {
                // An exception must not unwind through the library's frames.
            }
            finally
            {
                Ending.Leave();
            }
        }
    }
}
