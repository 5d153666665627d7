using System;
using System.Runtime.InteropServices;

namespace Mimo
{
    // The structs of mimo.h under their names there; a test compares them with tests/abi/layout.json.

    [StructLayout(LayoutKind.Sequential)]
    internal struct SceneConfigStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr name, file, xml, model_dir, log, log_user;
        internal ulong max_file_bytes, max_pixels, max_vertices, max_elements, max_keyframes, max_iterations, max_world_bytes;
        internal uint confined, limits_reserved;
        internal ulong max_compile_ms;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ObjectConfigStruct
    {
        internal uint struct_size;
        internal int shape;
        internal IntPtr name;
        internal Vector3d size, position;
        internal Quaterniond orientation;
        internal double mass;
        internal Rgba rgba;
        internal uint @fixed, reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct EnvConfigStruct
    {
        internal uint struct_size, frame_skip;
        internal int jacobian;
        internal uint disable;
        internal IntPtr renderer;
        internal uint max_steps, timing;
        internal IntPtr log, log_user, task;
        internal uint render, samples, render_threads, step_contacts;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct LogRecordStruct
    {
        internal uint struct_size;
        internal int level, code;
        internal uint in_world;
        internal IntPtr text;
        internal UIntPtr world;
        internal double time;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct LayoutInfoStruct
    {
        internal uint struct_size, reserved;
        internal UIntPtr block_bytes, fields, actions, agents, terms;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct FieldStruct
    {
        internal uint struct_size;
        internal int dtype;
        internal IntPtr name, unit, frame;
        internal UIntPtr offset, bytes;
        internal IntPtr shape;
        internal UIntPtr ndim;
        internal double low, high, start, end, period;
        internal UIntPtr receptors;
        internal double sample_rate;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ActionStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr name, unit;
        internal UIntPtr agent;
        internal double low, high;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct TermStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr name;
        internal UIntPtr agent;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct AgentInfoStruct
    {
        internal uint struct_size, action_offset, action_count, reserved;
        internal IntPtr name;
        internal double mass, height;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MovementStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr positions;
        internal UIntPtr position_count;
        internal IntPtr forces;
        internal UIntPtr force_count;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ResetConfigStruct
    {
        internal uint struct_size, seeded;
        internal ulong seed;
        internal IntPtr growth;
        internal UIntPtr growth_count;

        internal static ResetConfigStruct Of(ulong? seed)
        {
            return new ResetConfigStruct
            {
                struct_size = (uint)Structs.Size<ResetConfigStruct>(), seeded = seed.HasValue ? 1u : 0u,
                seed = seed.GetValueOrDefault()
            };
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct EnvResultsStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr reward, terminated, truncated, outcome;
        internal UIntPtr agent_count;
        internal IntPtr terms;
        internal UIntPtr term_count;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct FieldConfigStruct
    {
        internal uint struct_size;
        internal int quantity;
        internal IntPtr name, elements;
        internal UIntPtr element_count;
        internal IntPtr relative_to;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct CameraConfigStruct
    {
        internal uint struct_size, outputs;
        internal IntPtr name;
        internal uint width, height;
        internal double fovy;
        internal uint placed, reserved;
        internal IntPtr body;
        internal Vector3d position, look_at;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ModelConfigStruct
    {
        internal uint struct_size, @fixed;
        internal IntPtr name, file, xml;
        internal Vector3d position;
        internal Quaterniond orientation;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct LimitsStruct
    {
        internal uint struct_size, reserved;
        internal double delay, gain, noise, blur, signal_noise;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct LoadReportStruct
    {
        internal uint struct_size, reserved;
        internal UIntPtr fresh, ignored;
        internal IntPtr fresh_names, ignored_names;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct RecorderConfigStruct
    {
        internal uint struct_size, compression;
        internal IntPtr keep;
        internal double state_seconds, flush_seconds;
        internal IntPtr configuration;
        internal ulong seed;
        internal IntPtr hdf5;
        internal uint replace, reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct RecordingInfoStruct
    {
        internal uint struct_size, format_version, same_build, reserved;
        internal UIntPtr steps, states, actions, agents, bodies;
        internal double step_seconds;
        internal IntPtr build, this_build, configuration, seed;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ReplayReportStruct
    {
        internal uint struct_size, identical;
        internal UIntPtr next, steps, first_difference;
        internal double largest_difference;
        internal IntPtr differs_most_in;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct SensesConfigStruct
    {
        internal uint struct_size;
        internal int mujoco_version;
        internal UIntPtr model_size, data_size;
        internal double step;
        internal IntPtr renderer, log, log_user;
        internal uint render, samples, render_threads, reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct GazeStruct
    {
        internal uint struct_size, meets;
        internal Vector3d left_position, left_direction, right_position, right_direction;
        internal double vergence;
        internal Vector3d point;
        internal double miss;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct PictureConfigStruct
    {
        internal uint struct_size, width, height, format;
        internal IntPtr camera;
        internal Vector3d look_at;
        internal double distance, azimuth, elevation, fovy, foveation;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct PictureStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr rgb;
        internal UIntPtr rgb_bytes;
        internal IntPtr depth;
        internal UIntPtr depth_count;
        internal IntPtr segmentation;
        internal UIntPtr segmentation_count;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct TimingStruct
    {
        internal uint struct_size, reserved;
        internal ulong steps;
        internal double total, physics, touch, vision, proprioception, vestibular, hearing;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct BatchConfigStruct
    {
        internal uint struct_size, worlds, threads;
        internal int autoreset;
        internal uint restart_failed, reserved;
        internal IntPtr cohort;
        internal UIntPtr cohort_count;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct BatchResetConfigStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr seeds, mask;
        internal UIntPtr worlds;
        internal IntPtr growth;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct BatchResultsStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr reward, terminated, truncated, outcome;
        internal UIntPtr agent_count;
        internal IntPtr terms;
        internal UIntPtr term_count;
        internal IntPtr status, was_reset, final_written;
        internal UIntPtr worlds;
        internal IntPtr final_blocks;
        internal UIntPtr final_bytes;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ParameterStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr name, description;
        internal double standard, low, high;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct TaskMomentStruct
    {
        internal uint struct_size, reserved;
        internal UIntPtr world, agent;
        internal ulong step;
        internal IntPtr memory, fields, action;
        internal UIntPtr action_count;
        internal IntPtr block;
        internal UIntPtr block_bytes;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct TaskVerdictStruct
    {
        internal uint struct_size;
        internal int outcome;
        internal double reward;
        internal IntPtr terms;
        internal uint goes_on, truncated;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct TaskFieldStruct
    {
        internal uint struct_size, ndim;
        internal IntPtr name, unit, frame, shape;
        internal double low, high;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct TaskStruct
    {
        internal uint struct_size, reserved;
        internal IntPtr user;
        internal UIntPtr memory_bytes;
        internal IntPtr reset, evaluate, terms;
        internal UIntPtr term_count;
        internal IntPtr fields;
        internal UIntPtr field_count;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct Floats3
    {
        internal float x, y, z;
        internal Vector3d Wide => new Vector3d(x, y, z);
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct Floats4
    {
        internal float r, g, b, a;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct MeshStruct
    {
        internal uint struct_size;
        internal int axes;
        internal uint segments, reserved;
        internal double plane;
        internal IntPtr positions, normals, texcoords, indices;
        internal UIntPtr vertex_capacity, index_capacity, vertex_count, index_count;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct AppearanceStruct
    {
        internal uint struct_size, visible;
        internal int group, texture;
        internal Floats4 color;
        internal float emission, specular, shininess, reflectance;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct TextureStruct
    {
        internal uint struct_size;
        internal int type;
        internal uint width, height;
        internal IntPtr pixels;
        internal UIntPtr pixel_bytes;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct LightStruct
    {
        internal uint struct_size;
        internal int axes;
        internal uint active, directional, casts_shadow;
        internal float cutoff, exponent;
        internal Floats3 position, direction, ambient, diffuse, specular, attenuation;
        internal uint reserved;
    }

    internal static class Structs
    {
        internal static UIntPtr Size<T>() { return (UIntPtr)Marshal.SizeOf(typeof(T)); }
    }
}
