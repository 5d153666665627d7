using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>A room, objects and infants. Worlds that were made of it live on without it.</summary>
    public sealed class Scene : IDisposable
    {
        internal readonly SceneHandle Handle;

        private Scene(string name, string file, string xml)
        {
            using (PinnedText n = new PinnedText(name), f = new PinnedText(file), x = new PinnedText(xml))
            {
                SceneConfigStruct config;
                MimoException.Check(Native.mimo_scene_config_init(out config, Structs.Size<SceneConfigStruct>()));
                config.name = n.Pointer;
                config.file = f.Pointer;
                config.xml = x.Pointer;
                MimoException.Check(Native.mimo_scene_create(ref config, out Handle));
            }
        }

        /// <summary>An empty world.</summary>
        public static Scene Empty() { return new Scene(null, null, null); }

        /// <summary>A built-in scene: "reach", "benchmark", ...</summary>
        public static Scene Builtin(string name) { return new Scene(name, null, null); }

        /// <summary>An MJCF file.</summary>
        public static Scene FromFile(string path) { return new Scene(null, path, null); }

        /// <summary>MJCF text.</summary>
        public static Scene FromXml(string xml) { return new Scene(null, null, xml); }

        /// <summary>What the scene gives its infant by itself.</summary>
        public AgentConfig DefaultAgent()
        {
            AgentConfig config;
            MimoException.Check(Native.mimo_scene_default_agent(Handle, out config, Structs.Size<AgentConfig>()));
            return config;
        }

        /// <summary>Adds an infant and gives its number. Its name is null for a sole agent; else the prefix of its fields
        /// and model names, "anna/...".</summary>
        public int AddAgent(AgentConfig config, string name = null)
        {
            using (var text = new PinnedText(name))
            {
                if (name != null) config.name = text.Pointer;
                int agent;
                MimoException.Check(Native.mimo_scene_add_agent(Handle, ref config, out agent));
                return agent;
            }
        }

        /// <summary>Adds a ball that moves freely: radius in metres, mass in kilograms.</summary>
        public void AddBall(string name, double radius, double mass, Vector3 position)
        {
            using (var text = new PinnedText(name))
            {
                ObjectConfigStruct config;
                MimoException.Check(Native.mimo_object_config_init(out config, Structs.Size<ObjectConfigStruct>()));
                config.name = text.Pointer;
                config.size.X = radius;
                config.mass = mass;
                config.position = position;
                MimoException.Check(Native.mimo_scene_add_object(Handle, ref config));
            }
        }

        /// <summary>Sets a parameter of a task, "reach/success_reward", for worlds made from now on.</summary>
        public void SetParameter(string name, double value)
        {
            MimoException.Check(Native.mimo_scene_set_parameter(Handle, Text.Bytes(name), value));
        }

        /// <summary>Frees the scene.</summary>
        public void Dispose() { Handle.Dispose(); }
    }

    internal static class Structs
    {
        internal static UIntPtr Size<T>() { return (UIntPtr)Marshal.SizeOf(typeof(T)); }
    }
}
