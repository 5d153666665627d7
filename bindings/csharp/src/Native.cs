using System;
using System.Runtime.InteropServices;
using Size = System.UIntPtr;

namespace Mimo
{
    /// <summary>Functions of mimo.h. Arrays are pinned for the length of a call, not copied.</summary>
    internal static class Native
    {
        // libmimo.so on Linux; .NET and Mono complete the name.
        private const string File = "mimo";

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void LogFunction(IntPtr user, ref LogRecordStruct record);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int TaskResetFunction(IntPtr user, IntPtr env, ref TaskMomentStruct moment);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int TaskEvaluateFunction(IntPtr user, IntPtr env, ref TaskMomentStruct moment, ref TaskVerdictStruct verdict);

        [DllImport(File)] internal static extern uint mimo_abi_version();
        [DllImport(File)] internal static extern uint mimo_api_version();
        [DllImport(File)] internal static extern int mimo_supports(byte[] name);
        [DllImport(File)] internal static extern IntPtr mimo_version();
        [DllImport(File)] internal static extern IntPtr mimo_mujoco_version();
        [DllImport(File)] internal static extern IntPtr mimo_status_name(int status);
        [DllImport(File)] internal static extern IntPtr mimo_last_error();
        [DllImport(File)] internal static extern int mimo_fail(int status, byte[] message);

        [DllImport(File)] internal static extern int mimo_scene_config_init(out SceneConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_agent_config_init(out AgentConfig config, Size size);
        [DllImport(File)] internal static extern int mimo_object_config_init(out ObjectConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_env_config_init(out EnvConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_camera_config_init(out CameraConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_picture_config_init(out PictureConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_batch_config_init(out BatchConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_growth_init(out Growth growth, Size size);
        [DllImport(File)] internal static extern int mimo_limits_init(out LimitsStruct limits, Size size);
        [DllImport(File)] internal static extern int mimo_maturity_init(out Maturity maturity, Size size);
        [DllImport(File)] internal static extern int mimo_maturity_at(double age, out Maturity maturity, Size size);
        [DllImport(File)] internal static extern int mimo_field_config_init(out FieldConfigStruct config, Size size);

        [DllImport(File)] internal static extern IntPtr mimo_scene_name(Size index);
        [DllImport(File)] internal static extern IntPtr mimo_room_name(Size index);
        [DllImport(File)] internal static extern IntPtr mimo_task_name(Size index);
        [DllImport(File)] internal static extern int mimo_parameter_count(out Size count);
        [DllImport(File)] internal static extern int mimo_parameter_describe(Size index, ref ParameterStruct parameter);

        [DllImport(File)] internal static extern int mimo_scene_create(ref SceneConfigStruct config, out SceneHandle scene);
        [DllImport(File)] internal static extern void mimo_scene_destroy(IntPtr scene);
        [DllImport(File)] internal static extern int mimo_scene_default_agent(SceneHandle scene, out AgentConfig config, Size size);
        [DllImport(File)] internal static extern int mimo_scene_add_agent(SceneHandle scene, ref AgentConfig config, out Size agent);
        [DllImport(File)] internal static extern int mimo_scene_add_object(SceneHandle scene, ref ObjectConfigStruct config);
        [DllImport(File)] internal static extern int mimo_scene_add_camera(SceneHandle scene, ref CameraConfigStruct config);
        [DllImport(File)] internal static extern int mimo_scene_add_field(SceneHandle scene, ref FieldConfigStruct config);
        [DllImport(File)] internal static extern int mimo_scene_set_touch(SceneHandle scene, Size agent, byte[] body, double spacing);
        [DllImport(File)] internal static extern int mimo_model_config_init(out ModelConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_scene_add_agents(SceneHandle scene, ref AgentConfig config, out Size count);
        [DllImport(File)] internal static extern int mimo_scene_set_room_temperature(SceneHandle scene, double celsius);
        [DllImport(File)] internal static extern int mimo_scene_set_temperature(SceneHandle scene, byte[] body, double celsius);
        [DllImport(File)] internal static extern int mimo_scene_set_material(SceneHandle scene, byte[] body, byte[] material);
        [DllImport(File)] internal static extern int mimo_scene_set_room(SceneHandle scene, byte[] name);
        [DllImport(File)] internal static extern int mimo_scene_add_model(SceneHandle scene, ref ModelConfigStruct config);
        [DllImport(File)] internal static extern int mimo_scene_weld(SceneHandle scene, byte[] body, byte[] other, double[] pose);
        [DllImport(File)] internal static extern int mimo_scene_save(SceneHandle scene, byte[] folder);
        [DllImport(File)] internal static extern int mimo_scene_xml(SceneHandle scene, byte[] text, Size capacity, out Size length);
        [DllImport(File)] internal static extern int mimo_scene_lock(SceneHandle scene, byte[] joint, double value);
        [DllImport(File)] internal static extern int mimo_scene_set_pose(SceneHandle scene, byte[] joint, double value);
        [DllImport(File)] internal static extern int mimo_scene_set_sources(SceneHandle scene, Size count, double seconds);
        [DllImport(File)] internal static extern int mimo_scene_direct_source(SceneHandle scene, byte[] body, double[] place, double[] axis, double directivity);
        [DllImport(File)] internal static extern int mimo_scene_read_joint(SceneHandle scene, Size agent, byte[] joint);
        [DllImport(File)] internal static extern int mimo_scene_limit_sense(SceneHandle scene, Size agent, byte[] path, ref LimitsStruct limits);
        [DllImport(File)] internal static extern int mimo_scene_limit_motor(SceneHandle scene, Size agent, byte[] path, ref LimitsStruct limits);
        [DllImport(File)] internal static extern int mimo_scene_set_maturity(SceneHandle scene, Size agent, ref Maturity maturity);
        [DllImport(File)] internal static extern int mimo_scene_set_maturity(SceneHandle scene, Size agent, IntPtr none);
        [DllImport(File)] internal static extern int mimo_scene_set_sensory_delay(SceneHandle scene, Size agent, byte[] body, double seconds);
        [DllImport(File)] internal static extern int mimo_scene_get_parameter(SceneHandle scene, byte[] name, out double value);
        [DllImport(File)] internal static extern int mimo_env_task(EnvHandle env, out IntPtr name);
        [DllImport(File)] internal static extern int mimo_task_init(out TaskStruct task, Size size);
        [DllImport(File)] internal static extern int mimo_task_field_init(out TaskFieldStruct field, Size size);
        [DllImport(File)] internal static extern int mimo_scene_set_task(SceneHandle scene, ref TaskStruct task);
        [DllImport(File)] internal static extern int mimo_scene_set_task(SceneHandle scene, IntPtr none);
        [DllImport(File)] internal static extern int mimo_scene_set_parameter(SceneHandle scene, byte[] name, double value);

        [DllImport(File)] internal static extern int mimo_layout_describe(LayoutHandle layout, ref LayoutInfoStruct info);
        [DllImport(File)] internal static extern int mimo_layout_field(LayoutHandle layout, Size index, ref FieldStruct field);
        [DllImport(File)] internal static extern int mimo_layout_find(LayoutHandle layout, byte[] name, out Size index);
        [DllImport(File)] internal static extern int mimo_layout_label(LayoutHandle layout, Size field, Size element, out IntPtr label);
        [DllImport(File)] internal static extern int mimo_layout_delays(LayoutHandle layout, Size field, double[] seconds, Size count);
        [DllImport(File)] internal static extern int mimo_layout_directions(LayoutHandle layout, Size field, float[] directions, Size count);
        [DllImport(File)] internal static extern int mimo_layout_receptor_width(LayoutHandle layout, Size field, int quantity, out Size count);
        [DllImport(File)] internal static extern int mimo_layout_receptors(LayoutHandle layout, Size field, int quantity, double[] values, Size count);
        [DllImport(File)] internal static extern int mimo_layout_action(LayoutHandle layout, Size index, ref ActionStruct action);
        [DllImport(File)] internal static extern int mimo_layout_term(LayoutHandle layout, Size index, ref TermStruct term);

        [DllImport(File)] internal static extern int mimo_env_create(SceneHandle scene, ref EnvConfigStruct config, out EnvHandle env);
        [DllImport(File)] internal static extern int mimo_env_make(byte[] scene, out EnvHandle env);
        [DllImport(File)] internal static extern void mimo_env_destroy(IntPtr env);
        [DllImport(File)] internal static extern int mimo_env_layout(EnvHandle env, out IntPtr layout);
        [DllImport(File)] internal static extern int mimo_env_agent(EnvHandle env, Size index, ref AgentInfoStruct info);
        [DllImport(File)] internal static extern int mimo_env_reset(EnvHandle env, ref ResetConfigStruct config, byte[] block, Size bytes);
        [DllImport(File)] internal static extern int mimo_env_step(EnvHandle env, float[] action, Size actions, byte[] block, Size bytes, ref EnvResultsStruct results);
        [DllImport(File)] internal static extern int mimo_env_observe(EnvHandle env, byte[] block, Size bytes);
        [DllImport(File)] internal static extern int mimo_env_time(EnvHandle env, out double seconds);
        [DllImport(File)] internal static extern int mimo_env_frame_skip(EnvHandle env, out uint steps);
        [DllImport(File)] internal static extern int mimo_env_timestep(EnvHandle env, out double seconds);
        [DllImport(File)] internal static extern int mimo_env_physics_step(EnvHandle env, Size count);
        [DllImport(File)] internal static extern int mimo_env_follow(EnvHandle env, ref MovementStruct movement, byte[] block, Size bytes);
        [DllImport(File)] internal static extern int mimo_env_play(EnvHandle env, byte[] body, float[] samples, Size count, double rate);
        [DllImport(File)] internal static extern int mimo_env_timing(EnvHandle env, ref TimingStruct timing);
        [DllImport(File)] internal static extern int mimo_env_timing_reset(EnvHandle env);
        [DllImport(File)] internal static extern int mimo_env_count(EnvHandle env, int kind, out Size count);
        [DllImport(File)] internal static extern int mimo_env_find(EnvHandle env, int kind, byte[] name, out int id);
        [DllImport(File)] internal static extern int mimo_env_name(EnvHandle env, int kind, int id, out IntPtr name);
        [DllImport(File)] internal static extern int mimo_env_body_of(EnvHandle env, int kind, int id, out int body);
        [DllImport(File)] internal static extern int mimo_env_width(EnvHandle env, int quantity, int[] ids, Size idCount, out Size count);
        [DllImport(File)] internal static extern int mimo_env_get(EnvHandle env, int quantity, int[] ids, Size idCount, double[] values, Size count);
        [DllImport(File)] internal static extern int mimo_env_get_float(EnvHandle env, int quantity, int[] ids, Size idCount, float[] values, Size count);
        [DllImport(File)] internal static extern int mimo_env_set(EnvHandle env, int quantity, int[] ids, Size idCount, double[] values, Size count);
        [DllImport(File)] internal static extern int mimo_env_update(EnvHandle env);
        [DllImport(File)] internal static extern int mimo_env_random(EnvHandle env, double[] values, Size count);
        [DllImport(File)] internal static extern int mimo_env_gaze(EnvHandle env, Size agent, ref GazeStruct gaze);
        [DllImport(File)] internal static extern int mimo_env_look_angles(EnvHandle env, Size agent, ref Vector3d point, int how, int[] joints, double[] angles, Size capacity, out Size count, double[] errors);
        [DllImport(File)] internal static extern int mimo_env_look_at(EnvHandle env, Size agent, ref Vector3d point, int how, double[] errors);
        [DllImport(File)] internal static extern int mimo_env_project(EnvHandle env, ref PictureConfigStruct config, Vector3d[] points, Size count, [Out] Vector3d[] pixels);
        [DllImport(File)] internal static extern int mimo_env_render(EnvHandle env, ref PictureConfigStruct config, ref PictureStruct picture);

        [DllImport(File)] internal static extern int mimo_convert_points(int axes, [In, Out] float[] points, Size count);
        [DllImport(File)] internal static extern int mimo_convert_directions(int axes, [In, Out] float[] directions, Size count);
        [DllImport(File)] internal static extern int mimo_env_poses(EnvHandle env, int kind, int axes, float[] poses, Size count);
        [DllImport(File)] internal static extern int mimo_mesh_init(out MeshStruct mesh, Size size);
        [DllImport(File)] internal static extern int mimo_env_mesh(EnvHandle env, int geom, ref MeshStruct mesh);
        [DllImport(File)] internal static extern int mimo_env_appearance(EnvHandle env, int geom, ref AppearanceStruct appearance);
        [DllImport(File)] internal static extern int mimo_env_texture_count(EnvHandle env, out Size count);
        [DllImport(File)] internal static extern int mimo_env_texture(EnvHandle env, int texture, ref TextureStruct raw);
        [DllImport(File)] internal static extern int mimo_env_light(EnvHandle env, int id, ref LightStruct light);

        [DllImport(File)] internal static extern IntPtr mimo_face_name(Size index);
        [DllImport(File)] internal static extern IntPtr mimo_material_name(Size index);
        [DllImport(File)] internal static extern int mimo_env_state_size(EnvHandle env, out Size bytes);
        [DllImport(File)] internal static extern int mimo_env_state_save(EnvHandle env, byte[] state, Size bytes);
        [DllImport(File)] internal static extern int mimo_env_state_load(EnvHandle env, byte[] state, Size bytes, ref LoadReportStruct report);
        [DllImport(File)] internal static extern int mimo_env_clone(EnvHandle env, out EnvHandle clone);

        [DllImport(File)] internal static extern int mimo_recorder_config_init(out RecorderConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_recorder_open(EnvHandle env, byte[] path, ref RecorderConfigStruct config, out RecorderHandle recorder);
        [DllImport(File)] internal static extern int mimo_recorder_flush(RecorderHandle recorder);
        [DllImport(File)] internal static extern int mimo_recorder_close(RecorderHandle recorder);
        [DllImport(File)] internal static extern int mimo_recorder_close(IntPtr recorder);
        [DllImport(File)] internal static extern int mimo_recording_open(byte[] path, byte[] hdf5, out RecordingHandle recording);
        [DllImport(File)] internal static extern void mimo_recording_destroy(IntPtr recording);
        [DllImport(File)] internal static extern int mimo_recording_describe(RecordingHandle recording, ref RecordingInfoStruct info);
        [DllImport(File)] internal static extern int mimo_recording_size(RecordingHandle recording, byte[] dataset, out Size rows, out Size rowBytes);
        [DllImport(File)] internal static extern int mimo_recording_read(RecordingHandle recording, byte[] dataset, Size first, Size rows, IntPtr values, Size bytes);
        [DllImport(File)] internal static extern int mimo_recording_seek(RecordingHandle recording, EnvHandle env, Size step, uint compareFields, out Size at);
        [DllImport(File)] internal static extern int mimo_recording_step(RecordingHandle recording, EnvHandle env, byte[] block, Size bytes, ref EnvResultsStruct results);
        [DllImport(File)] internal static extern int mimo_recording_report(RecordingHandle recording, ref ReplayReportStruct report);

        [DllImport(File)] internal static extern int mimo_batch_create(SceneHandle scene, ref EnvConfigStruct env, ref BatchConfigStruct config, out BatchHandle batch);
        [DllImport(File)] internal static extern void mimo_batch_destroy(IntPtr batch);
        [DllImport(File)] internal static extern int mimo_batch_size(BatchHandle batch, out Size worlds, out Size threads);
        [DllImport(File)] internal static extern int mimo_batch_layout(BatchHandle batch, out IntPtr layout);
        [DllImport(File)] internal static extern int mimo_batch_world(BatchHandle batch, Size world, out IntPtr env);
        [DllImport(File)] internal static extern int mimo_batch_world_error(BatchHandle batch, Size world, out int status, out IntPtr message);
        [DllImport(File)] internal static extern int mimo_batch_reset(BatchHandle batch, ref BatchResetConfigStruct config, byte[] blocks, Size bytes);
        [DllImport(File)] internal static extern int mimo_batch_step(BatchHandle batch, float[] actions, Size count, byte[] blocks, Size bytes, ref BatchResultsStruct results);
        [DllImport(File)] internal static extern int mimo_batch_send(BatchHandle batch, IntPtr actions, Size count, IntPtr blocks, Size bytes, ref BatchResultsStruct results);
        [DllImport(File)] internal static extern int mimo_batch_receive(BatchHandle batch);
        [DllImport(File)] internal static extern int mimo_batch_observe(BatchHandle batch, byte[] mask, Size worlds, byte[] blocks, Size bytes);
        [DllImport(File)] internal static extern int mimo_batch_get(BatchHandle batch, int quantity, int[] ids, Size idCount, byte[] mask, Size worlds, double[] values, Size count);
        [DllImport(File)] internal static extern int mimo_batch_get_float(BatchHandle batch, int quantity, int[] ids, Size idCount, byte[] mask, Size worlds, float[] values, Size count);
        [DllImport(File)] internal static extern int mimo_batch_set(BatchHandle batch, int quantity, int[] ids, Size idCount, byte[] mask, Size worlds, double[] values, Size count);
        [DllImport(File)] internal static extern int mimo_batch_state_size(BatchHandle batch, out Size bytes);
        [DllImport(File)] internal static extern int mimo_batch_state_save(BatchHandle batch, byte[] mask, Size worlds, byte[] states, Size bytes);
        [DllImport(File)] internal static extern int mimo_batch_state_load(BatchHandle batch, byte[] mask, Size worlds, byte[] states, Size bytes, ref LoadReportStruct report);
        [DllImport(File)] internal static extern int mimo_senses_config_init(out SensesConfigStruct config, Size size);
        [DllImport(File)] internal static extern int mimo_senses_attach(SceneHandle scene, IntPtr model, ref SensesConfigStruct config, out SensesHandle senses);
        [DllImport(File)] internal static extern void mimo_senses_destroy(IntPtr senses);
        [DllImport(File)] internal static extern int mimo_senses_layout(SensesHandle senses, out IntPtr layout);
        [DllImport(File)] internal static extern int mimo_senses_reset(SensesHandle senses, IntPtr data, ref ResetConfigStruct config);
        [DllImport(File)] internal static extern int mimo_senses_advance(SensesHandle senses, IntPtr data);
        [DllImport(File)] internal static extern int mimo_senses_drive_spindles(SensesHandle senses, int[] actuators, Size actuatorCount, double[] rates, Size rateCount);
        [DllImport(File)] internal static extern int mimo_senses_play(SensesHandle senses, byte[] body, float[] samples, Size count, double rate);
        [DllImport(File)] internal static extern int mimo_senses_observe(SensesHandle senses, IntPtr data, byte[] block, Size bytes);
        [DllImport(File)] internal static extern int mimo_senses_state_size(SensesHandle senses, out Size bytes);
        [DllImport(File)] internal static extern int mimo_senses_state_save(SensesHandle senses, byte[] state, Size bytes);
        [DllImport(File)] internal static extern int mimo_senses_state_load(SensesHandle senses, byte[] state, Size bytes, ref LoadReportStruct report);
    }
}
