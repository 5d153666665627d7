/* Shapes, materials, textures, lights and poses for engines. Unit tests check where triangles lie; these test
 * the calls.
 */
#include "support/capi.h"

/* A room whose numbers are known: what MuJoCo's own format says of it. */
static const char room_text[] =
    "<mujoco><visual><headlight ambient='.1 .2 .3' diffuse='.4 .5 .6' specular='.7 .8 .9'/></visual>"
    "<asset><texture name='squares' type='2d' builtin='checker' width='8' height='4' rgb1='1 0 0' rgb2='0 0 1'/>"
    "<texture name='dice' type='cube' builtin='flat' width='8' height='48' rgb1='0 1 0'/>"
    "<material name='tiles' texture='squares' specular='.2' shininess='.3' reflectance='.4' emission='.5'/></asset>"
    "<worldbody><light pos='1 2 3' dir='0 3 -4' diffuse='.1 .2 .3' cutoff='30' exponent='5' castshadow='false'"
    " attenuation='1 .5 .25'/><light pos='0 0 9' directional='true' active='false'/>"
    "<geom name='floor' type='plane' size='0 2 1' material='tiles'/>"
    "<body name='ball' pos='1 2 3' quat='.5 .5 .5 .5'><freejoint/><geom name='ball' size='.25' rgba='.1 .2 .3 "
    ".4'/></body>"
    "<geom name='box' type='box' size='.1 .2 .3' group='4'/></worldbody></mujoco>";

typedef struct triangles {
  float *positions, *normals, *texcoords;
  uint32_t* indices;
  size_t vertices, corners;
} triangles;

static triangles read_mesh(const mimo_env* env, int32_t geom, int32_t axes) {
  triangles made = {NULL, NULL, NULL, NULL, 0, 0};
  mimo_mesh mesh;
  CHECK_OK(mimo_mesh_init(&mesh, sizeof mesh));
  mesh.axes = axes;
  CHECK_OK(mimo_env_mesh(env, geom, &mesh));
  made.vertices = mesh.vertex_count;
  made.corners = mesh.index_count;
  made.positions = malloc((3 * made.vertices + 1) * sizeof(float));
  made.normals = malloc((3 * made.vertices + 1) * sizeof(float));
  made.texcoords = malloc((2 * made.vertices + 1) * sizeof(float));
  made.indices = malloc((made.corners + 1) * sizeof(uint32_t));
  mesh.positions = made.positions;
  mesh.normals = made.normals;
  mesh.texcoords = made.texcoords;
  mesh.indices = made.indices;
  mesh.vertex_capacity = made.vertices;
  mesh.index_capacity = made.corners;
  CHECK_OK(mimo_env_mesh(env, geom, &mesh));
  CHECK(mesh.vertex_count == made.vertices && mesh.index_count == made.corners);
  return made;
}

static void release(triangles* mesh) {
  free(mesh->positions);
  free(mesh->normals);
  free(mesh->texcoords);
  free(mesh->indices);
}

static double length(const float* v) { return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]); }

/* How far a triangle's corners, taken counter-clockwise, face where its vertices' normals do: more than 0 is right. */
static double facing(const triangles* mesh, size_t first) {
  const float* p[3];
  double a[3], b[3], sum = 0;
  size_t i, k;
  for (k = 0; k < 3; ++k) p[k] = mesh->positions + 3 * mesh->indices[first + k];
  for (i = 0; i < 3; ++i) {
    a[i] = p[1][i] - p[0][i];
    b[i] = p[2][i] - p[0][i];
  }
  for (i = 0; i < 3; ++i) {
    const double across = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    for (k = 0; k < 3; ++k) sum += across * mesh->normals[3 * mesh->indices[first + k] + i];
  }
  return sum;
}

/* The scene "benchmark" with a body of this name. */
static mimo_env* world_with(const char* body) {
  mimo_agent_config agent;
  mimo_scene_config room;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "benchmark";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = body;
  agent.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

/* Every geom of a world has triangles whose parts fit together. */
static void check_meshes(const char* body) {
  mimo_env* env = world_with(body);
  size_t geoms = 0, geom, i, wrong = 0, inside_out = 0;
  CHECK_OK(mimo_env_count(env, MIMO_GEOM, &geoms));
  CHECK(geoms > 30);
  for (geom = 0; geom < geoms; ++geom) {
    triangles mesh = read_mesh(env, (int32_t)geom, MIMO_AXES_MIMO);
    CHECK(mesh.vertices >= 4 && mesh.corners >= 6 && mesh.corners % 3 == 0);
    for (i = 0; i < mesh.corners; ++i) wrong += mesh.indices[i] >= mesh.vertices;
    for (i = 0; i < mesh.vertices; ++i) wrong += !(fabs(length(mesh.normals + 3 * i) - 1) < 1e-5);
    for (i = 0; i + 2 < mesh.corners && wrong == 0; i += 3) inside_out += !(facing(&mesh, i) > 0);
    release(&mesh);
  }
  CHECK(wrong == 0);
  CHECK(inside_out == 0);
  mimo_env_destroy(env);
}

/* Poses are those of named access, in single precision. */
static void check_poses(void) {
  static const int32_t kinds[] = {MIMO_BODY, MIMO_GEOM, MIMO_SITE, MIMO_CAMERA};
  static const int32_t quantities[] = {MIMO_BODY_POSE, MIMO_GEOM_POSE, MIMO_SITE_POSE, MIMO_CAMERA_POSE};
  mimo_env* env = blind_env("benchmark", NULL);
  size_t k, i, count = 0, apart;
  CHECK_OK(mimo_env_reset(env, SEED(3), NULL, 0));
  CHECK_OK(mimo_env_physics_step(env, 50));
  for (k = 0; k < 4; ++k) {
    float* poses;
    double* values;
    CHECK_OK(mimo_env_count(env, kinds[k], &count));
    CHECK(count > 0);
    poses = malloc(7 * count * sizeof *poses);
    values = malloc(7 * count * sizeof *values);
    CHECK_OK(mimo_env_get(env, quantities[k] | MIMO_NOW, NULL, 0, values, 7 * count));
    CHECK_OK(mimo_env_poses(env, kinds[k], MIMO_AXES_MIMO, poses, 7 * count));
    for (i = 0, apart = 0; i < 7 * count; ++i) apart += poses[i] != (float)values[i];
    CHECK(apart == 0);
    /* Unity's x is to the right, so our -y; its y is our z; its z our x. */
    CHECK_OK(mimo_env_poses(env, kinds[k], MIMO_AXES_UNITY, poses, 7 * count));
    for (i = 0; i < count; ++i) {
      CHECK_NEAR(-values[7 * i + 1], poses[7 * i], 1e-6);
      CHECK_NEAR(values[7 * i + 2], poses[7 * i + 1], 1e-6);
      CHECK_NEAR(values[7 * i], poses[7 * i + 2], 1e-6);
      CHECK_NEAR(values[7 * i + 3], poses[7 * i + 6], 1e-6); /* w, which a change of frame leaves as it is */
    }
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "value_count is", mimo_env_poses(env, kinds[k], 0, poses, 7 * count + 1));
    CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "value_count is", mimo_env_poses(env, kinds[k], 0, poses, 7 * count - 1));
    free(values);
    free(poses);
  }
  {
    float pose[7];
    CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "kind is 2 (joint), expected body, geom, site or camera",
                mimo_env_poses(env, MIMO_JOINT, 0, pose, 7));
    CHECK_FAILS(MIMO_E_UNSUPPORTED, "axes is 5", mimo_env_poses(env, MIMO_BODY, 5, pose, 7));
  }
  mimo_env_destroy(env);
}

static mimo_appearance material_of(const mimo_env* env, const char* geom) {
  mimo_appearance material;
  memset(&material, 0, sizeof material);
  material.struct_size = sizeof material;
  CHECK_OK(mimo_env_appearance(env, find(env, MIMO_GEOM, geom), &material));
  return material;
}

/* The pixels of a texture, with its size; freed by the caller. */
static uint8_t* read_texture(const mimo_env* env, int32_t id, mimo_texture* texture) {
  memset(texture, 0, sizeof *texture);
  texture->struct_size = sizeof *texture;
  CHECK_OK(mimo_env_texture(env, id, texture));
  texture->pixel_bytes = (size_t)4 * texture->width * texture->height;
  texture->pixels = malloc(texture->pixel_bytes);
  CHECK_OK(mimo_env_texture(env, id, texture));
  return texture->pixels;
}

static void check_textures_of_faces(void) {
  mimo_env* env = blind_env("benchmark", NULL);
  const mimo_appearance before = material_of(env, "head");
  const double joy = find(env, MIMO_FACE, "enjoyment");
  mimo_texture texture;
  uint8_t *calm, *happy;
  mimo_appearance after;
  calm = read_texture(env, before.texture, &texture);
  CHECK(texture.type == MIMO_TEXTURE_CUBE && texture.height == 6 * texture.width);
  CHECK_OK(mimo_env_set(env, MIMO_AGENT_FACE, NULL, 0, &joy, 1));
  after = material_of(env, "head");
  CHECK(after.texture >= 0 && after.texture != before.texture);
  happy = read_texture(env, after.texture, &texture);
  CHECK(memcmp(calm, happy, texture.pixel_bytes) != 0);
  free(calm);
  free(happy);
  mimo_env_destroy(env);
}

static mimo_env* known_room(void) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.xml = room_text;
  CHECK_OK(mimo_scene_create(&config, &scene));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static void check_looks(mimo_env* env) {
  const int32_t ball = find(env, MIMO_GEOM, "ball");
  const double large[3] = {0.5, 0, 0}, red[4] = {1, 0, 0, 0.5}, gone[4] = {1, 0, 0, 0};
  mimo_appearance material = material_of(env, "ball");
  triangles mesh;
  size_t i;
  CHECK(material.visible == 1 && material.group == 0 && material.texture == -1);
  CHECK_NEAR(0.1, material.color[0], 1e-7);
  CHECK_NEAR(0.4, material.color[3], 1e-7);
  CHECK_OK(mimo_env_set(env, MIMO_GEOM_COLOR, &ball, 1, red, 4));
  CHECK_OK(mimo_env_set(env, MIMO_GEOM_SIZE, &ball, 1, large, 3));
  material = material_of(env, "ball");
  CHECK(material.color[0] == 1.0F && material.color[1] == 0.0F && material.color[3] == 0.5F);
  mesh = read_mesh(env, ball, MIMO_AXES_UNREAL);
  for (i = 0; i < mesh.vertices; ++i) CHECK_NEAR(50, length(mesh.positions + 3 * i), 1e-4); /* cm */
  release(&mesh);
  CHECK_OK(mimo_env_set(env, MIMO_GEOM_COLOR, &ball, 1, gone, 4));
  CHECK(material_of(env, "ball").visible == 0);
  material = material_of(env, "box");
  CHECK(material.visible == 0 && material.group == 4); /* MuJoCo draws groups 0 to 2 */
  material = material_of(env, "floor");
  CHECK(material.texture >= 0);
  CHECK_NEAR(0.2, material.specular, 1e-7);
  CHECK_NEAR(0.3, material.shininess, 1e-7);
  CHECK_NEAR(0.4, material.reflectance, 1e-7);
  CHECK_NEAR(0.5, material.emission, 1e-7);
}

static void check_textures(mimo_env* env) {
  mimo_texture texture;
  size_t count = 0, i, odd = 0;
  uint8_t* pixels;
  CHECK_OK(mimo_env_texture_count(env, &count));
  CHECK(count == 2);
  pixels = read_texture(env, material_of(env, "floor").texture, &texture);
  CHECK(texture.type == MIMO_TEXTURE_FLAT && texture.width == 8 && texture.height == 4);
  for (i = 0; i < 32; ++i) odd += pixels[4 * i + 1] != 0 || pixels[4 * i + 3] != 255;
  CHECK(odd == 0);
  CHECK(pixels[0] + pixels[2] == 255); /* red or blue */
  texture.pixel_bytes -= 1;
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "texture: pixels", mimo_env_texture(env, 0, &texture));
  free(pixels);
  pixels = read_texture(env, 1, &texture);
  CHECK(texture.type == MIMO_TEXTURE_CUBE && texture.width == 8 && texture.height == 48);
  CHECK(pixels[0] == 0 && pixels[1] == 255 && pixels[2] == 0 && pixels[3] == 255);
  free(pixels);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "texture_id is 2, expected an id from 0 to 1",
              mimo_env_texture(env, 2, &texture));
}

static mimo_light light_of(const mimo_env* env, int32_t id, int32_t axes) {
  mimo_light light;
  memset(&light, 0, sizeof light);
  light.struct_size = sizeof light;
  light.axes = axes;
  CHECK_OK(mimo_env_light(env, id, &light));
  return light;
}

static void check_lights(mimo_env* env) {
  mimo_light light = light_of(env, MIMO_HEADLIGHT, MIMO_AXES_UNITY);
  CHECK(light.active == 1 && light.axes == MIMO_AXES_UNITY && light.attenuation[0] == 1.0F);
  CHECK_NEAR(0.3, light.ambient[2], 1e-7);
  CHECK_NEAR(0.4, light.diffuse[0], 1e-7);
  CHECK_NEAR(0.8, light.specular[1], 1e-7);
  light = light_of(env, 0, MIMO_AXES_MIMO);
  CHECK(light.active == 1 && light.directional == 0 && light.casts_shadow == 0);
  CHECK(light.cutoff == 30.0F && light.exponent == 5.0F && light.attenuation[2] == 0.25F);
  CHECK_NEAR(2, light.position[1], 1e-6);
  CHECK_NEAR(0.6, light.direction[1], 1e-6);
  CHECK_NEAR(-0.8, light.direction[2], 1e-6);
  light = light_of(env, 0, MIMO_AXES_UNREAL);
  CHECK_NEAR(-200, light.position[1], 1e-4); /* cm to the right */
  CHECK_NEAR(-0.6, light.direction[1], 1e-6);
  light = light_of(env, 1, MIMO_AXES_MIMO);
  CHECK(light.active == 0 && light.directional == 1);
  light.struct_size = sizeof light;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "id is 2, expected an id from 0 to 1", mimo_env_light(env, 2, &light));
  light.axes = -1;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "light: axes is -1", mimo_env_light(env, 0, &light));
}

/* The floor, endless to one side: what sizes mean, in which order corners come, and what is refused. */
static void check_details(mimo_env* env) {
  const int32_t floor = find(env, MIMO_GEOM, "floor"), ball = find(env, MIMO_GEOM, "ball");
  static const int32_t axes[] = {MIMO_AXES_MIMO, MIMO_AXES_UNITY, MIMO_AXES_UNREAL, MIMO_AXES_GODOT, MIMO_AXES_GLTF};
  /* Which way the corners turn as numbers: mirrored frames turn them round, Unity and Godot ask for the other order. */
  static const int turns[] = {1, 1, -1, -1, 1};
  float few[3] = {7, 7, 7};
  size_t coarse, i;
  mimo_mesh mesh;
  for (i = 0; i < 5; ++i) {
    triangles plane = read_mesh(env, floor, axes[i]);
    CHECK(turns[i] * facing(&plane, 0) > 0);
    release(&plane);
  }
  CHECK_OK(mimo_mesh_init(&mesh, sizeof mesh));
  CHECK(mesh.segments == 24 && mesh.plane == 20 && mesh.positions == NULL);
  mesh.segments = 8;
  CHECK_OK(mimo_env_mesh(env, ball, &mesh));
  coarse = mesh.index_count;
  mesh.segments = 32;
  CHECK_OK(mimo_env_mesh(env, ball, &mesh));
  CHECK(mesh.index_count > 10 * coarse);
  mesh.positions = few;
  mesh.vertex_capacity = 1;
  mesh.vertex_count = 0;
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "mesh: vertex_capacity is 1, but ", mimo_env_mesh(env, ball, &mesh));
  CHECK(mesh.vertex_count == 0 && few[0] == 7.0F);
  mesh.positions = NULL;
  mesh.segments = 6;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "segments is 6, expected a multiple of 4", mimo_env_mesh(env, ball, &mesh));
  mesh.segments = 24;
  mesh.plane = (double)NAN;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "plane is nan", mimo_env_mesh(env, ball, &mesh));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "geom is 3, expected an id from 0 to 2", mimo_env_mesh(env, 3, &mesh));
}

/* The poses of two bodies that access reads are, converted, those among all bodies: in each frame, which keeps or turns
 * round hands. A quarter turn to the left about our z is one about Unity's y, whose axis looks the same way but whose
 * frame is mirrored: x y z w is 0, -sin 45, 0, cos 45. */
static void check_single_poses(void) {
  float turned[7] = {1, 2, 3, 0.70710678F, 0, 0, 0.70710678F}, two[14], *all;
  mimo_env* env = blind_env("benchmark", NULL);
  int32_t bodies[2], axes;
  size_t count = 0, i;
  CHECK_OK(mimo_convert_poses(MIMO_AXES_UNITY, turned, 1));
  CHECK(turned[0] == -2.0F && turned[1] == 3.0F && turned[2] == 1.0F && turned[3] == 0.0F && turned[5] == 0.0F);
  CHECK_NEAR(-0.70710678, turned[4], 1e-7);
  CHECK_NEAR(0.70710678, turned[6], 1e-7);
  bodies[0] = find(env, MIMO_BODY, "right_hand");
  bodies[1] = find(env, MIMO_BODY, "head");
  CHECK_OK(mimo_env_reset(env, SEED(3), NULL, 0));
  CHECK_OK(mimo_env_physics_step(env, 50));
  CHECK_OK(mimo_env_count(env, MIMO_BODY, &count));
  all = malloc(7 * count * sizeof *all);
  for (axes = MIMO_AXES_MIMO; axes <= MIMO_AXES_GLTF; ++axes) {
    CHECK_OK(mimo_env_poses(env, MIMO_BODY, axes, all, 7 * count));
    CHECK_OK(mimo_env_get_float(env, MIMO_BODY_POSE | MIMO_NOW, bodies, 2, two, 14));
    CHECK_OK(mimo_convert_poses(axes, two, 2));
    for (i = 0; i < 2; ++i) CHECK(memcmp(two + 7 * i, all + 7 * bodies[i], 7 * sizeof *all) == 0);
  }
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "axes is 5", mimo_convert_poses(5, two, 2));
  CHECK_OK(mimo_convert_poses(MIMO_AXES_UNITY, NULL, 0));
  free(all);
  mimo_env_destroy(env);
}

static void check_conversions(void) {
  float points[6] = {1, 2, 3, 0, 0, 1}, direction[3] = {1, 2, 3};
  CHECK_OK(mimo_convert_points(MIMO_AXES_UNREAL, points, 2));
  CHECK(points[0] == 100.0F && points[1] == -200.0F && points[2] == 300.0F && points[5] == 100.0F);
  CHECK_OK(mimo_convert_directions(MIMO_AXES_UNITY, direction, 1));
  CHECK(direction[0] == -2.0F && direction[1] == 3.0F && direction[2] == 1.0F);
  CHECK_OK(mimo_convert_points(MIMO_AXES_GODOT, NULL, 0));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "points is NULL", mimo_convert_points(MIMO_AXES_GODOT, NULL, 1));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "axes is 9", mimo_convert_directions(9, direction, 1));
}

int main(void) {
  mimo_env* room = known_room();
  check_meshes("mitten");
  check_meshes("fingers");
  check_poses();
  check_textures_of_faces();
  check_textures(room);
  check_lights(room);
  check_details(room);
  check_looks(room);
  check_single_poses();
  check_conversions();
  mimo_env_destroy(room);
  return failures();
}
