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

        private Logging(Action<int, string> log) { kept = GCHandle.Alloc(log); }

        /// <summary>Null when there is nothing to be told to.</summary>
        internal static Logging Attach(ref EnvConfigStruct config, Action<int, string> log)
        {
            if (log == null) return null;
            var logging = new Logging(log);
            config.log = Marshal.GetFunctionPointerForDelegate(forward);
            config.log_user = GCHandle.ToIntPtr(logging.kept);
            return logging;
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
        private static void Forward(IntPtr user, int level, IntPtr message)
        {
            try
            {
                ((Action<int, string>)GCHandle.FromIntPtr(user).Target)(level, Utf8.Of(message));
            }
            catch (Exception)
            {
                // An exception must not unwind through the library's frames.
            }
        }
    }
}
