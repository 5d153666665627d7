using System;
using System.Collections.Generic;

namespace Mimo
{
    /// <summary>The built-in scenes.</summary>
    public static class Scenes
    {
        /// <summary>Their names, for MimoScene.Builtin: "reach", "benchmark", ...</summary>
        public static IReadOnlyList<string> Names => Listed.Of(Native.mimo_scene_name);
    }

    /// <summary>The rooms.</summary>
    public static class Rooms
    {
        /// <summary>Their names, for MimoScene.SetRoom: "playroom", ...</summary>
        public static IReadOnlyList<string> Names => Listed.Of(Native.mimo_room_name);
    }

    /// <summary>The faces of the built-in bodies.</summary>
    public static class Faces
    {
        /// <summary>Their names: "neutral", "enjoyment", ...</summary>
        public static IReadOnlyList<string> Names => Listed.Of(Native.mimo_face_name);
    }

    /// <summary>What things may be made of.</summary>
    public static class Materials
    {
        /// <summary>Their names, for MimoScene.SetMaterial: "copper", "hardwood", ...</summary>
        public static IReadOnlyList<string> Names => Listed.Of(Native.mimo_material_name);
    }

    /// <summary>The tasks of the library.</summary>
    public static class Tasks
    {
        /// <summary>Their names, for EnvOptions.Task: "none", "reach", ...</summary>
        public static IReadOnlyList<string> Names => Listed.Of(Native.mimo_task_name);

        /// <summary>The numbers by which they can be changed, with MimoScene.SetParameter.</summary>
        public static IReadOnlyList<Parameter> Parameters
        {
            get
            {
                Library.Require();
                UIntPtr count;
                MimoException.Check(Native.mimo_parameter_count(out count));
                var all = new Parameter[(int)count];
                for (var i = 0; i < all.Length; ++i) all[i] = Parameter.Of(i);
                return all;
            }
        }
    }

    /// <summary>A number by which a task can be changed.</summary>
    public sealed class Parameter
    {
        /// <summary>"reach/success_reward".</summary>
        public string Name { get; private set; }
        /// <summary>One line, with unit.</summary>
        public string Description { get; private set; }
        /// <summary>Value unless set.</summary>
        public double Standard { get; private set; }
        /// <summary>Smallest allowed value.</summary>
        public double Low { get; private set; }
        /// <summary>Largest allowed value.</summary>
        public double High { get; private set; }

        internal static Parameter Of(int index)
        {
            var raw = new ParameterStruct { struct_size = (uint)Structs.Size<ParameterStruct>() };
            MimoException.Check(Native.mimo_parameter_describe((UIntPtr)index, ref raw));
            return new Parameter
            {
                Name = Utf8.Of(raw.name), Description = Utf8.Of(raw.description),
                Standard = raw.standard, Low = raw.low, High = raw.high
            };
        }
    }

    internal static class Listed
    {
        /// <summary>Names by their number, up to the first that there is not.</summary>
        internal static IReadOnlyList<string> Of(Func<UIntPtr, IntPtr> byIndex)
        {
            Library.Require();
            var names = new List<string>();
            for (var name = byIndex(UIntPtr.Zero); name != IntPtr.Zero; name = byIndex((UIntPtr)names.Count)) names.Add(Utf8.Of(name));
            return names;
        }
    }
}
