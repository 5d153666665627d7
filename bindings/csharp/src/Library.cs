using System;

namespace Mimo
{
    /// <summary>The native library that was loaded.</summary>
    public static class Library
    {
        private static bool isGood;

        /// <summary>Its version, such as "1.2.3".</summary>
        public static string Version => Text(Native.mimo_version);

        /// <summary>Version of the MuJoCo that it uses, such as "2.2.2".</summary>
        public static string MuJoCoVersion => Text(Native.mimo_mujoco_version);

        /// <summary>Version of its interface, 1002 for 1.2.</summary>
        public static uint ApiVersion
        {
            get
            {
                Require();
                return Native.mimo_api_version();
            }
        }

        /// <summary>Whether it knows a name of the C interface: a function ("mimo_env_step"), a constant
        /// ("MIMO_BODY_MASS"), a struct ("mimo_field") or a member of one ("mimo_field.period").</summary>
        public static bool Supports(string name)
        {
            Require();
            return Native.mimo_supports(Utf8.Bytes(name)) != 0;
        }

        private static string Text(Func<IntPtr> text)
        {
            Require();
            return Utf8.Of(text());
        }

        /// <summary>Checks that the library can be used. Everything that can be called first calls it: otherwise a
        /// missing library would give an exception of the runtime, and a library of another ABI would have undefined
        /// behaviour.</summary>
        internal static void Require()
        {
            if (isGood) return;
            var found = AbiFound();
            if (found != Constants.AbiVersion)
                throw Unusable("libmimo " + Utf8.Of(Native.mimo_version()) + " has ABI version " + found +
                    ", expected " + Constants.AbiVersion + ": use sources and a library of the same release");
            isGood = true;
        }

        private static uint AbiFound()
        {
            try
            {
                return Native.mimo_abi_version();
            }
            catch (DllNotFoundException)
            {
                throw Unusable("libmimo was not found, or the MuJoCo library that came with it: put both libraries beside the program, " +
                    "in Unity into Assets/Plugins/x86_64, or on Linux add their folders to LD_LIBRARY_PATH");
            }
        }

        /// <summary>The error of a call of a function that the loaded library does not have.</summary>
        internal static MimoException Lacks(string function)
        {
            if (!isGood || function == "mimo_version") return Unusable("the library that was found as libmimo has no " + function + ": it is another library");
            return Unusable("libmimo " + Utf8.Of(Native.mimo_version()) + " has no " + function + ", which these sources know: use a newer library");
        }

        private static MimoException Unusable(string message) { return new MimoException(Status.Unsupported, "MIMO_E_UNSUPPORTED", message); }
    }
}
