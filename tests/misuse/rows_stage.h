/* Stages of plain arrays. What their arrays may not hold is capi/stage_refused.c's. See table.h. */

ROW(mimo_stage_air_init, ANYTIME, mimo_stage_air_init(a->air, sizeof *a->air + a->more_bytes),
    INIT(air, mimo_stage_air, "air"))
ROW(mimo_stage_view_init, ANYTIME, mimo_stage_view_init(a->stage_view, sizeof *a->stage_view + a->more_bytes),
    INIT(stage_view, mimo_stage_view, "view"))
ROW(mimo_stage_create, ANYTIME, mimo_stage_create(a->stage_config, a->made_stage), NO_NULL(stage_config, "config"),
    CONFIG(stage_config, mimo_stage_config, "config"), NO_NULL(made_stage, "stage"),
    BAD_FIELD(stage_config, mimo_stage_config, threads, 257, "threads"), CONFIG(shapes, mimo_stage_shapes, "geoms"),
    CONFIG(air, mimo_stage_air, "air"), BAD_REAL(air, mimo_stage_air, near_plane, 0, "air: near_plane"),
    UNREAL(air, mimo_stage_air, near_plane, "air: near_plane"),
    UNREAL(air, mimo_stage_air, far_plane, "air: far_plane"), UNREAL(air, mimo_stage_air, fog_start, "air: fog_start"),
    UNREAL(air, mimo_stage_air, haze, "air: haze"), BAD_FIELD(air, mimo_stage_air, headlight, 2, "air: headlight"))
ROW(mimo_stage_destroy, ON_STAGE | DESTROYS, check_destroy_stage(a), NONE)
ROW(mimo_stage_update, ON_STAGE, mimo_stage_update(a->stage, a->stage_config), NO_NULL(stage_config, "config"),
    CONFIG(stage_config, mimo_stage_config, "config"), CONFIG(shapes, mimo_stage_shapes, "geoms"),
    BAD_FIELD(stage_config, mimo_stage_config, threads, 1, "threads"))
ROW(mimo_stage_draw, ON_STAGE, draw_stage(a), NO_NULL(stage_poses, "poses[0] is NULL"),
    NO_NULL(stage_view, "views[0] is NULL"), CONFIG(stage_poses, mimo_stage_poses, "poses"),
    CONFIG(stage_view, mimo_stage_view, "views"), BAD_SIZE(stage_pose_count, 0, "pose_count"),
    BAD_SIZE(stage_pose_count, -1, "poses"), BAD_FIELD(stage_view, mimo_stage_view, width, 0, "width"),
    BAD_FIELD(stage_view, mimo_stage_view, width, INT32_MIN, "width"),
    BAD_FIELD(stage_view, mimo_stage_view, height, 16385, "height"),
    BAD_FIELD(stage_view, mimo_stage_view, pose, 1, "pose"),
    BAD_FIELD(stage_view, mimo_stage_view, samples, 3, "samples"),
    UNKNOWN_FIELD(stage_view, mimo_stage_view, render, 0x20, "render"),
    UNKNOWN_FIELD(stage_view, mimo_stage_view, geom_groups, 0x40, "geom_groups"),
    UNREAL(stage_view, mimo_stage_view, fovy, "fovy"), BAD_REAL(stage_view, mimo_stage_view, fovy, 180, "fovy"),
    BAD_REAL(stage_view, mimo_stage_view, focal_x, -1, "focal_x"),
    UNREAL(stage_view, mimo_stage_view, ortho_height, "ortho_height"),
    BAD_REAL(stage_view, mimo_stage_view, ortho_height, -1, "ortho_height"),
    UNREAL(stage_view, mimo_stage_view, focal_y, "focal_"), SHORT_FIELD(stage_view, mimo_stage_view, rgb_bytes, "rgb"),
    SHORT_FIELD(stage_view, mimo_stage_view, depth_count, "depth"),
    SHORT_FIELD(stage_view, mimo_stage_view, segmentation_count, "segmentation"),
    BAD_FIELD(stage_poses, mimo_stage_poses, reserved, 1, "reserved"))
