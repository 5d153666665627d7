using System;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.RegularExpressions;

namespace Mimo
{
    /// <summary>A call was refused or failed. The message is one line that names the argument, its value and what was
    /// expected.</summary>
    public sealed class MimoException : Exception
    {
        /// <summary>The reason.</summary>
        public Status Status { get; }

        /// <summary>The reason's name in C, such as "MIMO_E_NOT_FOUND".</summary>
        public string StatusName { get; }

        internal MimoException(int status)
            : this((Status)status, Utf8.Of(Native.mimo_status_name(status)), Named(Utf8.Of(Native.mimo_last_error()))) { }

        internal MimoException(Status status, string name, string message) : base(message)
        {
            Status = status;
            StatusName = name;
        }

        private static readonly Regex named = new Regex(@"\bmimo_(?:(\w+_config)|(scene|env|batch|senses|recorder|recording)_(\w+))");

        /// <summary>A message of the library in which C functions and configs have their C# names, such as
        /// "MimoScene.AddAgents".</summary>
        internal static string Named(string message)
        {
            return named.Replace(message, found => found.Groups[1].Success ? Pascal(found.Groups[1].Value)
                : (found.Groups[2].Value == "scene" ? "MimoScene" : Pascal(found.Groups[2].Value)) + "." + Pascal(found.Groups[3].Value))
                .Replace("MIMO_NOW", "Quantity.Now");
        }

        private static string Pascal(string name) { return string.Concat(name.Split('_').Select(Capital)); }

        private static string Capital(string word) { return word.Substring(0, 1).ToUpperInvariant() + word.Substring(1); }

        /// <summary>Throws if a call failed. Call it at once and on the same thread, because the message is the
        /// thread's last one.</summary>
        internal static void Check(int status)
        {
            Ending.Hold();
            if (status != 0) throw new MimoException(status);
        }
    }

    /// <summary>UTF-8 strings, which .NET Standard 2.0 does not marshal.</summary>
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

        internal static string OrNull(IntPtr text) { return text == IntPtr.Zero ? null : Of(text); }

        /// <summary>Zero-terminated bytes; null stays null.</summary>
        internal static byte[] Bytes(string text)
        {
            return text == null ? null : Encoding.UTF8.GetBytes(text + "\0");
        }
    }
}
