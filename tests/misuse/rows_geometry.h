/* Geometry for engines. See table.h. */

#define AXES UNKNOWNS(axes, MIMO_AXES_GLTF + 1, "axes")
#define FIELD_AXES(m, t)                                                                                  \
  UNKNOWN_FIELD(m, t, axes, MIMO_AXES_GLTF + 1, #m ": axes"), UNKNOWN_FIELD(m, t, axes, -1, #m ": axes"), \
      UNKNOWN_FIELD(m, t, axes, INT32_MIN, #m ": axes")
#define SEGMENTS(n) BAD_FIELD(mesh, mimo_mesh, segments, n, "mesh: segments")
/* A capacity that is too small, or as large as no memory. */
#define ROOM(f)                                                                                                        \
  {FAULT_FIELD_SIZE, #f " is 1", MEMBER(mesh), FIELD(mimo_mesh, f), 1, 0, NULL, MIMO_E_BUFFER_TOO_SMALL, "mesh: " #f}, \
  {                                                                                                                    \
    FAULT_FIELD_SIZE, #f " is huge", MEMBER(mesh), FIELD(mimo_mesh, f), -1, 0, NULL, E_ARG, "mesh: " #f                \
  }
#define NO_ARRAY(m, t, f) \
  { FAULT_FIELD_NULL, #f " is NULL", MEMBER(m), FIELD(t, f), 0, 0, NULL, MIMO_OK, NULL }

ROW(mimo_convert_points, ANYTIME, mimo_convert_points(a->axes, a->poses, 2), AXES, NO_NULL(poses, "points"))
ROW(mimo_convert_directions, ANYTIME, mimo_convert_directions(a->axes, a->poses, a->point_count), AXES,
    NO_NULL(poses, "directions"), BAD_SIZE(point_count, -1, "directions"),
    BAD_SIZE(point_count, SIZE_MAX / 3 + 1, "directions"), SIZE_IS(point_count, 0, MIMO_OK, NULL))
ROW(mimo_convert_poses, ANYTIME, mimo_convert_poses(a->axes, a->poses, a->point_count), AXES, NO_NULL(poses, "poses"),
    BAD_SIZE(point_count, -1, "poses"), BAD_SIZE(point_count, SIZE_MAX / 7 + 1, "poses"),
    SIZE_IS(point_count, 0, MIMO_OK, NULL))
ROW(mimo_env_poses, ON_ENV | SIMULATES, mimo_env_poses(a->env, a->kind, a->axes, a->poses, a->pose_count), AXES,
    UNKNOWN(kind, 0, "kind"), UNKNOWNS(kind, MIMO_WARNING + 1, "kind"), BAD_I32(kind, MIMO_JOINT, "kind"),
    NO_NULL(poses, "poses"),
    {FAULT_LESS, "pose_count is one too small", MEMBER(pose_count), 0, 1, 0, NULL, MIMO_E_BUFFER_TOO_SMALL,
     "value_count"},
    {FAULT_LESS, "pose_count is one too large", MEMBER(pose_count), 0, -1, 0, NULL, E_ARG, "value_count"},
    SIZE_IS(pose_count, 0, MIMO_E_BUFFER_TOO_SMALL, "value_count"), BAD_SIZE(pose_count, -1, "poses"))
ROW(mimo_mesh_init, ANYTIME, mimo_mesh_init(a->mesh, sizeof *a->mesh + a->more_bytes), INIT(mesh, mimo_mesh, "mesh"))
ROW(mimo_env_mesh, ON_ENV, mimo_env_mesh(a->env, a->geom, a->mesh), BAD_IDS(geom, "geom"), NO_NULL(mesh, "mesh"),
    CONFIG(mesh, mimo_mesh, "mesh"), FIELD_AXES(mesh, mimo_mesh), SEGMENTS(0), SEGMENTS(3), SEGMENTS(6), SEGMENTS(260),
    SEGMENTS(-4), UNKNOWN_FIELD(mesh, mimo_mesh, reserved, 1, "mesh: reserved"),
    BAD_REAL(mesh, mimo_mesh, plane, 0, "mesh: plane"), BAD_REAL(mesh, mimo_mesh, plane, -1, "mesh: plane"),
    UNREAL(mesh, mimo_mesh, plane, "mesh: plane"), ROOM(vertex_capacity), ROOM(index_capacity),
    NO_ARRAY(mesh, mimo_mesh, positions), NO_ARRAY(mesh, mimo_mesh, normals), NO_ARRAY(mesh, mimo_mesh, texcoords),
    NO_ARRAY(mesh, mimo_mesh, indices))
ROW(mimo_env_appearance, ON_ENV, mimo_env_appearance(a->env, a->geom, a->appearance), BAD_IDS(geom, "geom"),
    DESCRIPTION(appearance, mimo_appearance, "appearance"))
ROW(mimo_env_texture_count, ON_ENV, mimo_env_texture_count(a->env, a->count), NO_NULL(count, "count"))
ROW(mimo_env_texture, ON_ENV, mimo_env_texture(a->env, a->geom, a->texture), BAD_IDS(geom, "texture_id"),
    NO_NULL(texture, "texture"), CONFIG(texture, mimo_texture, "texture"),
    {FAULT_FIELD_NULL, "pixels is NULL, with a length", MEMBER(texture), FIELD(mimo_texture, pixels), 0, 0, NULL, E_ARG,
     "texture: pixels"},
    DO(no_pixels, MIMO_OK, NULL), SHORT_FIELD(texture, mimo_texture, pixel_bytes, "texture: pixels"))
ROW(mimo_env_light, ON_ENV | SIMULATES, mimo_env_light(a->env, a->geom, a->light), BAD_I32(geom, -2, "id"),
    BAD_I32(geom, INT32_MIN, "id"), BAD_I32(geom, INT32_MAX, "id"), NO_NULL(light, "light"),
    CONFIG(light, mimo_light, "light"), FIELD_AXES(light, mimo_light))
