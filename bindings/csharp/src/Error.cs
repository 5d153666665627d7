using System;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.RegularExpressions;

namespace Mimo
{
    /// <summary>Why a call failed; values are those of mimo.h. A newer library may have further ones.</summary>
    public enum Status
    {
        /// <summary>An argument is null, out of range or not finite.</summary>
        InvalidArgument = -1,
        /// <summary>What is used was destroyed already.</summary>
        BadHandle = -2,
        /// <summary>An array is shorter than needed.</summary>
        BufferTooSmall = -3,
        /// <summary>The library is older than these sources, and lacks what was asked for.</summary>
        StructSize = -4,
        /// <summary>No body, joint, scene, file... of that name.</summary>
        NotFound = -5,
        /// <summary>A model does not compile, or asks for too much.</summary>
        Model = -6,
        /// <summary>The simulation failed or diverged; a reset makes the world usable again.</summary>
        Simulation = -7,
        /// <summary>The renderer failed.</summary>
        Render = -8,
        /// <summary>Not possible here, or not known to this version: the message says which.</summary>
        Unsupported = -9,
        /// <summary>An allocation failed.</summary>
        OutOfMemory = -10,
        /// <summary>It was made in the parent process, before fork.</summary>
        Forked = -11,
        /// <summary>A defect in libmimo; please report the message.</summary>
        Internal = -12,
        /// <summary>A file cannot be written, or is not what it should be.</summary>
        File = -13,
        /// <summary>A MimoTask threw, or said what cannot be meant.</summary>
        Task = -14,
        /// <summary>Not now, and nothing was changed: another thread is using it, or another call has to come first.</summary>
        Busy = -15
    }

    /// <summary>What the library complained about: one line that names the argument, its value and what was expected.</summary>
    public sealed class MimoException : Exception
    {
        /// <summary>Why the call failed.</summary>
        public Status Status { get; }

        /// <summary>"MIMO_E_NOT_FOUND".</summary>
        public string StatusName { get; }

        internal MimoException(int status)
            : this((Status)status, Utf8.Of(Native.mimo_status_name(status)), Named(Utf8.Of(Native.mimo_last_error()))) { }

        internal MimoException(Status status, string name, string message) : base(message)
        {
            Status = status;
            StatusName = name;
        }

        private static readonly Regex function = new Regex(@"\bmimo_(scene|env|batch)_(?!config)(\w+)");

        /// <summary>A message of the library's, with functions of C as they are called here: "MimoScene.AddAgents".</summary>
        internal static string Named(string message)
        {
            return function.Replace(message, found =>
                (found.Groups[1].Value == "scene" ? "MimoScene" : Capital(found.Groups[1].Value)) + "." +
                string.Concat(found.Groups[2].Value.Split('_').Select(Capital)));
        }

        private static string Capital(string word) { return word.Substring(0, 1).ToUpperInvariant() + word.Substring(1); }

        /// <summary>To be called on the thread of the call, at once: the message is the thread's last.</summary>
        internal static void Check(int status)
        {
            Ending.Hold();
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
