using System;
using System.Runtime.InteropServices;
using System.Threading;
using Mimo.Callbacks;

// In a namespace of its own: Unity has an attribute of this name, too, and a script may use both namespaces.
namespace Mimo.Callbacks
{
    /// <summary>Marks a static method that native code calls; Unity's IL2CPP looks for an attribute of this
    /// name.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        internal MonoPInvokeCallbackAttribute(Type type) { }
    }
}

namespace Mimo
{
    /// <summary>A message of the library.</summary>
    public struct LogRecord
    {
        /// <summary>How much the message matters.</summary>
        public LogLevel Level;
        /// <summary>The warning of physics; null for other messages.</summary>
        public WarningCode? Code;
        /// <summary>The message, one line.</summary>
        public string Text;
        /// <summary>The index in its batch of the world whose physics warns, 0 for a single world; null for messages of
        /// scenes, models and renderers.</summary>
        public int? World;
        /// <summary>Simulated seconds since the world's reset.</summary>
        public double Time;

        internal static LogRecord Of(ref LogRecordStruct raw)
        {
            return new LogRecord
            {
                Level = (LogLevel)raw.level, Code = raw.code != 0 ? (WarningCode)raw.code : (WarningCode?)null, Text = MimoException.Named(Utf8.Of(raw.text)),
                World = raw.in_world != 0 ? (int)raw.world : (int?)null, Time = raw.time
            };
        }
    }

    /// <summary>Passes messages of the library to a user's delegate, which it keeps alive. A world and its clones share
    /// it; the last one that is destroyed releases it.</summary>
    internal sealed class Logging
    {
        // A static field keeps the delegate alive as long as the library may call it.
        private static readonly Native.LogFunction forward = Forward;

        private readonly GCHandle kept;
        private int shares = 1;

        private Logging(Action<LogRecord> log) { kept = GCHandle.Alloc(log); }

        /// <summary>Sets the members of a config. Returns null if there is no delegate.</summary>
        internal static Logging Tell(Action<LogRecord> log, out IntPtr function, out IntPtr user)
        {
            function = user = IntPtr.Zero;
            if (log == null) return null;
            var logging = new Logging(log);
            function = Marshal.GetFunctionPointerForDelegate(forward);
            user = GCHandle.ToIntPtr(logging.kept);
            return logging;
        }

        /// <summary>Checks the status of a call that took a log, and releases the log if the call failed.</summary>
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
