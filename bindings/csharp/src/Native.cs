using System;
using System.Runtime.InteropServices;
using Size = System.UIntPtr;

namespace Mimo
{
    /// <summary>Functions of mimo.h. Arrays are pinned for the length of a call, not copied.</summary>
    internal static class Native
    {
        // libmimo.so on Linux; .NET and Mono complete the name.
        private const string Library = "mimo";

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void LogFunction(IntPtr user, int level, IntPtr message);

        [DllImport(Library)] internal static extern uint mimo_abi_version();
        [DllImport(Library)] internal static extern IntPtr mimo_version();
        [DllImport(Library)] internal static extern IntPtr mimo_status_name(int status);
        [DllImport(Library)] internal static extern IntPtr mimo_last_error();

        [DllImport(Library)] internal static extern int mimo_scene_config_init(out SceneConfigStruct config, Size size);
        [DllImport(Library)] internal static extern int mimo_agent_config_init(out AgentConfig config, Size size);
        [DllImport(Library)] internal static extern int mimo_object_config_init(out ObjectConfigStruct config, Size size);
        [DllImport(Library)] internal static extern int mimo_env_config_init(out EnvConfigStruct config, Size size);

        [DllImport(Library)] internal static extern int mimo_scene_create(ref SceneConfigStruct config, out SceneHandle scene);
        [DllImport(Library)] internal static extern void mimo_scene_destroy(IntPtr scene);
        [DllImport(Library)] internal static extern int mimo_scene_default_agent(SceneHandle scene, out AgentConfig config, Size size);
        [DllImport(Library)] internal static extern int mimo_scene_add_agent(SceneHandle scene, ref AgentConfig config, out int agent);
        [DllImport(Library)] internal static extern int mimo_scene_add_object(SceneHandle scene, ref ObjectConfigStruct config);
        [DllImport(Library)] internal static extern int mimo_scene_set_parameter(SceneHandle scene, byte[] name, double value);

        [DllImport(Library)] internal static extern int mimo_env_create(SceneHandle scene, ref EnvConfigStruct config, out EnvHandle env);
        [DllImport(Library)] internal static extern int mimo_env_make(byte[] scene, out EnvHandle env);
        [DllImport(Library)] internal static extern void mimo_env_destroy(IntPtr env);
        [DllImport(Library)] internal static extern int mimo_env_agent_count(EnvHandle env, out Size count);
        [DllImport(Library)] internal static extern int mimo_env_observation_size(EnvHandle env, out Size bytes, out Size fields);
        [DllImport(Library)] internal static extern int mimo_env_observation_field(EnvHandle env, Size index, ref FieldStruct field);
        [DllImport(Library)] internal static extern int mimo_env_action_size(EnvHandle env, out Size count);
        [DllImport(Library)] internal static extern int mimo_env_action_bounds(EnvHandle env, float[] low, float[] high, Size count);
        [DllImport(Library)] internal static extern int mimo_env_action_name(EnvHandle env, Size index, out IntPtr name);
        [DllImport(Library)] internal static extern int mimo_env_reset(EnvHandle env, ulong[] seed, byte[] block, Size bytes);
        [DllImport(Library)] internal static extern int mimo_env_step(EnvHandle env, float[] action, Size actions, byte[] block, Size bytes, double[] reward, byte[] terminated, byte[] truncated, Size agents);
        [DllImport(Library)] internal static extern int mimo_env_observe(EnvHandle env, byte[] block, Size bytes);
        [DllImport(Library)] internal static extern int mimo_env_time(EnvHandle env, out double seconds);
        [DllImport(Library)] internal static extern int mimo_env_count(EnvHandle env, int kind, out Size count);
        [DllImport(Library)] internal static extern int mimo_env_find(EnvHandle env, int kind, byte[] name, out int id);
        [DllImport(Library)] internal static extern int mimo_env_name(EnvHandle env, int kind, int id, out IntPtr name);
        [DllImport(Library)] internal static extern int mimo_env_width(EnvHandle env, int quantity, int[] ids, Size idCount, out Size count);
        [DllImport(Library)] internal static extern int mimo_env_get(EnvHandle env, int quantity, int[] ids, Size idCount, double[] values, Size count);
        [DllImport(Library)] internal static extern int mimo_env_set(EnvHandle env, int quantity, int[] ids, Size idCount, double[] values, Size count);
    }
}
