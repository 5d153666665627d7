using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Mimo
{
    /// <summary>What the library complained about: one line that names the argument, its value and what was expected.</summary>
    public sealed class MimoException : Exception
    {
        /// <summary>A MIMO_E_ constant, negative.</summary>
        public int Status { get; }

        /// <summary>"MIMO_E_NOT_FOUND".</summary>
        public string StatusName { get; }

        internal MimoException(int status) : this(status, Utf8.Of(Native.mimo_status_name(status)), Utf8.Of(Native.mimo_last_error())) { }

        internal MimoException(int status, string name, string message) : base(message)
        {
            Status = status;
            StatusName = name;
        }

        /// <summary>To be called on the thread of the call, at once: the message is the thread's last.</summary>
        internal static void Check(int status)
        {
            if (status != 0) throw new MimoException(status);
        }
    }

    /// <summary>UTF-8 strings; netstandard2.0 has no marshalling of its own for them.</summary>
    internal static class Utf8
    {
        internal static string Of(IntPtr text)
        {
            if (text == IntPtr.Zero) return "";
            var length = 0;
            while (Marshal.ReadByte(text, length) != 0) ++length;
            var bytes = new byte[length];
            Marshal.Copy(text, bytes, 0, length);
            return Encoding.UTF8.GetString(bytes);
        }

        /// <summary>Zero-terminated bytes; null stays null.</summary>
        internal static byte[] Bytes(string text)
        {
            return text == null ? null : Encoding.UTF8.GetBytes(text + "\0");
        }
    }
}
