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

    /// <summary>The materials of things.</summary>
    public static class Materials
    {
        /// <summary>Their names, for MimoScene.SetMaterial: "copper", "hardwood", ...</summary>
        public static IReadOnlyList<string> Names => Listed.Of(Native.mimo_material_name);
    }

    /// <summary>The tasks of the library.</summary>
    public static class Tasks
    {
        /// <summary>Their names, for EnvConfig.Task: "none", "reach", ...</summary>
        public static IReadOnlyList<string> Names => Listed.Of(Native.mimo_task_name);

        /// <summary>The parameters of all tasks, for MimoScene.SetParameter.</summary>
        public static IReadOnlyList<Parameter> Parameters
        {
            get
            {
                Library.Require();
                UIntPtr count;
                MimoException.Check(Native.mimo_parameter_count(out count));
                var all = new Parameter[(int)count];
                for (var i = 0; i < all.Length; ++i)
                {
                    var raw = ParameterStruct.New();
                    MimoException.Check(Native.mimo_parameter_describe((UIntPtr)i, ref raw));
                    all[i] = new Parameter(raw);
                }
                return all;
            }
        }
    }

    internal static class Listed
    {
        /// <summary>The names with index 0, 1, ..., up to the first missing one.</summary>
        internal static IReadOnlyList<string> Of(Func<UIntPtr, IntPtr> byIndex)
        {
            Library.Require();
            var names = new List<string>();
            for (var name = byIndex(UIntPtr.Zero); name != IntPtr.Zero; name = byIndex((UIntPtr)names.Count)) names.Add(Utf8.Of(name));
            return names;
        }
    }
}
