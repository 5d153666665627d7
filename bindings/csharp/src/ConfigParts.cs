using System;

// The parts of configs that are not generated.
namespace Mimo
{
    public sealed partial class SceneConfig
    {
        /// <summary>Makes a scene of a document. At most one of the three is not null.</summary>
        internal SceneHandle Make(string name, string file, string xml)
        {
            using (var parts = new PinnedParts())
            {
                var config = Raw(parts);
                config.name = parts.Text(name);
                config.file = parts.Text(file);
                config.xml = parts.Text(xml);
                var log = Logging.Tell(Log, out config.log, out config.log_user);
                SceneHandle made;
                var status = Native.mimo_scene_create(ref config, out made);
                made.Log = log;
                Logging.CheckTold(status, log);
                return made;
            }
        }
    }

    public sealed partial class EnvConfig
    {
        /// <summary>Calls a function with the struct. The function takes over the log, also when it fails.</summary>
        internal T Use<T>(Func<EnvConfigStruct, Logging, T> make)
        {
            using (var parts = new PinnedParts())
            {
                var config = Raw(parts);
                var log = Logging.Tell(Log, out config.log, out config.log_user);
                return make(config, log);
            }
        }
    }

    public sealed partial class SensesConfig
    {
        /// <summary>Attaches senses to a model of that version of MuJoCo.</summary>
        internal SensesHandle Attach(MimoScene scene, IntPtr model, int mujocoVersion)
        {
            using (var parts = new PinnedParts())
            {
                var config = Raw(parts);
                config.mujoco_version = mujocoVersion;
                var log = Logging.Tell(Log, out config.log, out config.log_user);
                SensesHandle made;
                var status = Native.mimo_senses_attach(Given.Some(scene, "scene", "a MimoScene").Handle, model, ref config, out made);
                made.Log = log;
                Logging.CheckTold(status, log);
                return made;
            }
        }
    }

    public sealed partial class PictureConfig
    {
        /// <summary>True: row 0 is the bottom one, as in textures of Unity and OpenGL; false (default): it is the top
        /// one.</summary>
        public bool BottomUp { get; set; }

        /// <summary>Calls a function with the struct, and checks the status that it returns.</summary>
        internal void Use(Func<PictureConfigStruct, int> call)
        {
            using (var parts = new PinnedParts())
            {
                var config = Raw(parts);
                config.format = (uint)(PictureFormat.Rgba | (BottomUp ? PictureFormat.BottomUp : PictureFormat.None));
                MimoException.Check(call(config));
            }
        }
    }

    public sealed partial class Growth
    {
        /// <summary>The median infant of an age, months from 0 to 24.</summary>
        public static Growth OfAge(double months) { return new Growth { Age = months }; }
    }

    public sealed partial class Maturity
    {
        /// <summary>Eyes and nerves of an age, months from 0 to 24. ContrastThreshold and Flicker, which are options, stay
        /// off.</summary>
        public static Maturity OfAge(double months)
        {
            Library.Require();
            MaturityStruct raw;
            MimoException.Check(Native.mimo_maturity_at(months, out raw, (UIntPtr)MaturityStruct.Bytes));
            return new Maturity(raw);
        }
    }
}
