using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>Marks a static method that native code calls; Unity's IL2CPP looks for an attribute of this name.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        internal MonoPInvokeCallbackAttribute(Type type) { }
    }

    /// <summary>The way of a message from the library to a user's delegate.</summary>
    internal static class Logging
    {
        // In a static field, so that the collector never takes what the library may still call.
        private static readonly Native.LogFunction forward = Forward;

        /// <summary>The handle keeps the user's delegate alive; to be freed after the world is destroyed.</summary>
        internal static GCHandle Attach(ref EnvConfigStruct config, Action<int, string> log)
        {
            if (log == null) return new GCHandle();
            var kept = GCHandle.Alloc(log);
            config.log = Marshal.GetFunctionPointerForDelegate(forward);
            config.log_user = GCHandle.ToIntPtr(kept);
            return kept;
        }

        [MonoPInvokeCallback(typeof(Native.LogFunction))]
        private static void Forward(IntPtr user, int level, IntPtr message)
        {
            try
            {
                ((Action<int, string>)GCHandle.FromIntPtr(user).Target)(level, Text.Of(message));
            }
            catch (Exception)
            {
                // An exception must not unwind through the library's frames.
            }
        }
    }
}
