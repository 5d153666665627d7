/* Faces, gaze, further cameras and layouts of pictures. Unit tests check what they compute; these test the calls. */
#include "support/capi.h"

enum { SIZE = 25, PIXELS = SIZE * SIZE };

/* The face that an agent shows, by its name. */
static const char* face_of(mimo_env* env, int32_t agent) {
  double face = -2;
  const char* name = "";
  CHECK_OK(mimo_env_get(env, MIMO_AGENT_FACE, &agent, 1, &face, 1));
  CHECK_OK(mimo_env_name(env, MIMO_FACE, (int32_t)face, &name));
  return name;
}

static void check_faces(mimo_env* env) {
  const int32_t nobody = 1;
  double face = find(env, MIMO_FACE, "surprise"), wrong = 7;
  const char* name = NULL;
  int32_t id = 0;
  size_t count = 0, i;
  while (mimo_face_name(count) != NULL) ++count;
  CHECK(count == 7);
  CHECK_OK(mimo_env_count(env, MIMO_FACE, &count));
  CHECK(count == 7);
  for (i = 0; i < count; ++i) {
    CHECK_OK(mimo_env_name(env, MIMO_FACE, (int32_t)i, &name));
    CHECK_TEXT(mimo_face_name(i), name);
  }
  CHECK_TEXT("sadness", face_of(env, 0));
  CHECK_OK(mimo_env_set(env, MIMO_AGENT_FACE, NULL, 0, &face, 1));
  CHECK_TEXT("surprise", face_of(env, 0));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no face named \"bored\"; there are: ", mimo_env_find(env, MIMO_FACE, "bored", &id));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "face is 7, expected 0 to 6",
              mimo_env_set(env, MIMO_AGENT_FACE, NULL, 0, &wrong, 1));
  wrong = 0.5;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "face is 0.5", mimo_env_set(env, MIMO_AGENT_FACE, NULL, 0, &wrong, 1));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "ids[0] is 1", mimo_env_set(env, MIMO_AGENT_FACE, &nobody, 1, &face, 1));
  CHECK_TEXT("surprise", face_of(env, 0));
}

static void check_batch_faces(const mimo_scene* scene) {
  const uint8_t mask[3] = {1, 0, 1};
  const char* expected[3] = {"fear", "sadness", "fear"};
  mimo_batch_config config;
  mimo_batch* batch = NULL;
  mimo_env* env = NULL;
  double faces[3];
  size_t i;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 3;
  CHECK_OK(mimo_batch_create(scene, NULL, &config, &batch));
  CHECK_OK(mimo_batch_world(batch, 0, &env));
  for (i = 0; i < 3; ++i) faces[i] = find(env, MIMO_FACE, "fear");
  CHECK_OK(mimo_batch_set(batch, MIMO_AGENT_FACE, NULL, 0, mask, 3, faces, 3));
  faces[1] = 9;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "face is 9", mimo_batch_set(batch, MIMO_AGENT_FACE, NULL, 0, NULL, 0, faces, 3));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "worlds is 2, expected 3",
              mimo_batch_set(batch, MIMO_AGENT_FACE, NULL, 0, mask, 2, faces, 3));
  for (i = 0; i < 3; ++i) {
    CHECK_OK(mimo_batch_world(batch, i, &env));
    CHECK_TEXT(expected[i], face_of(env, 0));
  }
  mimo_batch_destroy(batch);
}

static void check_gaze(mimo_env* env) {
  mimo_gaze gaze;
  int32_t joints[8];
  double angles[8], there[8], errors[2], point[3];
  const double nowhere[3] = {0, (double)NAN, 0};
  size_t count = 0, i;
  memset(&gaze, 0, sizeof gaze);
  CHECK_FAILS(MIMO_E_STRUCT_SIZE, "gaze: struct_size is 0", mimo_env_gaze(env, 0, &gaze));
  gaze.struct_size = sizeof gaze;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "agent is 9", mimo_env_gaze(env, 9, &gaze));
  CHECK_OK(mimo_env_gaze(env, 0, &gaze));
  CHECK(gaze.meets == 0);
  CHECK_NEAR(0.049, gaze.left_position[1] - gaze.right_position[1], 1e-9);
  for (i = 0; i < 3; ++i) point[i] = 0.5 * (gaze.left_position[i] + gaze.right_position[i]);
  point[0] += 0.3;
  point[1] += 0.1;
  CHECK_OK(mimo_env_look_angles(env, 0, point, MIMO_LOOK_HEAD, joints, angles, 8, &count, errors));
  CHECK(count == 8 && joints[0] == find(env, MIMO_JOINT, "robot:head_swivel"));
  CHECK(joints[2] == find(env, MIMO_JOINT, "robot:left_eye_horizontal"));
  CHECK_NEAR(0, errors[0] + errors[1], 1e-9);
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, joints, count, there, count));
  CHECK_NEAR(0, there[0], 1e-12); /* nothing has moved yet */
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "capacity is 5",
              mimo_env_look_angles(env, 0, point, MIMO_LOOK_EYES, joints, angles, 5, NULL, NULL));
  CHECK_OK(mimo_env_look_angles(env, 0, point, MIMO_LOOK_EYES, NULL, NULL, 0, &count, NULL));
  CHECK(count == 6);
  CHECK_OK(mimo_env_look_at(env, 0, point, MIMO_LOOK_HEAD, errors));
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, joints, 8, there, 8));
  for (i = 0; i < 8; ++i) CHECK_NEAR(angles[i], there[i], 1e-12);
  CHECK_OK(mimo_env_gaze(env, 0, &gaze));
  CHECK(gaze.meets == 1 && gaze.vergence > 0);
  for (i = 0; i < 3; ++i) CHECK_NEAR(point[i], gaze.point[i], 1e-6);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "point is NULL", mimo_env_look_at(env, 0, NULL, MIMO_LOOK_EYES, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "point[1] is nan", mimo_env_look_at(env, 0, nowhere, MIMO_LOOK_EYES, NULL));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "how is 2", mimo_env_look_at(env, 0, point, 2, NULL));
}

/* A camera on the wall, one on the left hand, and an eye at another size; then a blue room seen by the first. */
static void add_cameras(mimo_scene* scene) {
  mimo_camera_config camera;
  CHECK_OK(mimo_camera_config_init(&camera, sizeof camera));
  CHECK(camera.outputs == MIMO_VISION_RGB && camera.width == 256 && camera.height == 256 && camera.placed == 0);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "name is empty", mimo_scene_add_camera(scene, &camera));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "config is NULL", mimo_scene_add_camera(scene, NULL));
  camera.name = "wall";
  camera.placed = 1;
  camera.width = camera.height = SIZE;
  camera.outputs = 0;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "outputs is 0", mimo_scene_add_camera(scene, &camera));
  camera.outputs = MIMO_VISION_RGB | MIMO_VISION_DEPTH | MIMO_VISION_SEGMENTATION;
  camera.height = 0;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "height is 0", mimo_scene_add_camera(scene, &camera));
  camera.height = SIZE;
  camera.body = "nobody";
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no body named \"nobody\"", mimo_scene_add_camera(scene, &camera));
  camera.body = NULL;
  camera.look_at[0] = camera.position[0];
  camera.look_at[2] = camera.position[2];
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "looks at its own position", mimo_scene_add_camera(scene, &camera));
  camera.look_at[0] = 0.01; /* the middle of the head's sphere: 0.4 + 0.076 + 0.091 + 0.135 + 0.0735 above the floor */
  camera.look_at[2] = 0.7755;
  camera.position[2] = 0.7755;
  CHECK_OK(mimo_scene_add_camera(scene, &camera));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "observed already", mimo_scene_add_camera(scene, &camera));
  camera.name = "palm";
  camera.body = "left_hand";
  camera.outputs = MIMO_VISION_RGB;
  camera.look_at[2] = 1;
  CHECK_OK(mimo_scene_add_camera(scene, &camera));
  CHECK_OK(mimo_camera_config_init(&camera, sizeof camera));
  camera.name = "eye_right";
  camera.width = 8;
  camera.height = 4;
  CHECK_OK(mimo_scene_add_camera(scene, &camera));
}

static void check_cameras(mimo_env* env) {
  const mimo_field color = field_of(env, "vision/wall"), depth = field_of(env, "vision/wall_depth"),
                   ids = field_of(env, "vision/wall_segmentation"), eye = field_of(env, "vision/eye_right");
  static uint8_t rgb[4 * PIXELS + 1], plain[3 * PIXELS];
  static float far[PIXELS];
  mimo_picture_config picture;
  uint8_t* block;
  size_t bytes = 0, i, middle = SIZE / 2 * SIZE + SIZE / 2;
  bytes = sizes_of(env).block_bytes;
  CHECK(color.shape[0] == SIZE && color.shape[1] == SIZE && color.shape[2] == 3);
  CHECK(eye.shape[0] == 4 && eye.shape[1] == 8);
  CHECK_TEXT("camera", color.frame);
  field_of(env, "vision/palm");
  block = malloc(bytes);
  CHECK_OK(mimo_env_reset(env, NULL, block, bytes));
  CHECK(((const int32_t*)(block + ids.offset))[middle] == find(env, MIMO_GEOM, "head"));
  /* From 1.5 m to the skin of the head, which has a radius of 73.5 mm and its centre at x = 10 mm. */
  CHECK_NEAR(1.5 - 0.0835, ((const float*)(block + depth.offset))[middle], 2e-3);

  /* The same picture in other layouts. */
  CHECK_OK(mimo_picture_config_init(&picture, sizeof picture));
  picture.camera = "wall";
  picture.width = picture.height = SIZE;
  CHECK_OK(mimo_env_render(env, &picture, PICTURE(.rgb = plain, .rgb_bytes = sizeof plain)));
  CHECK(memcmp(plain, block + color.offset, sizeof plain) == 0);
  picture.format = 4;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "format is 0x4",
              mimo_env_render(env, &picture, PICTURE(.rgb = rgb, .rgb_bytes = 4 * PIXELS)));
  picture.format = MIMO_PICTURE_RGBA | MIMO_PICTURE_BOTTOM_UP;
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "rgb has a length of",
              mimo_env_render(env, &picture, PICTURE(.rgb = rgb, .rgb_bytes = 4 * PIXELS - 1)));
  rgb[4 * PIXELS] = 0xab;
  CHECK_OK(mimo_env_render(env, &picture,
                           PICTURE(.rgb = rgb, .rgb_bytes = 4 * PIXELS, .depth = far, .depth_count = PIXELS)));
  CHECK(rgb[4 * PIXELS] == 0xab);
  for (i = 0; i < PIXELS; ++i) {
    const size_t upright = (SIZE - 1 - i / SIZE) * SIZE + i % SIZE;
    if (memcmp(rgb + 4 * i, plain + 3 * upright, 3) != 0 || rgb[4 * i + 3] != 255) break;
    if (far[i] != ((const float*)(block + depth.offset))[upright]) break;
  }
  CHECK(i == PIXELS);
  free(block);
}

static void check_quality(const mimo_scene* scene) {
  mimo_env_config config;
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  CHECK(config.render == (MIMO_RENDER_SHADOWS | MIMO_RENDER_REFLECTIONS | MIMO_RENDER_SKY | MIMO_RENDER_HAZE));
  CHECK(config.samples == 0 && config.render_threads == 1);
  config.render = 0x20;
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "render is 0x20", mimo_env_create(scene, &config, &env));
  config.render = 0;
  config.samples = 3;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "samples is 3", mimo_env_create(scene, &config, &env));
  config.samples = 4;
  config.render_threads = 0;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "render_threads is 0", mimo_env_create(scene, &config, &env));
  config.render_threads = 3;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  mimo_env_destroy(env);
}

int main(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_env_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "free";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  CHECK(agent.face == NULL);
  agent.vision = 0;
  agent.touch = 0;
  agent.face = "sadness";
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  check_batch_faces(scene);
  add_cameras(scene);
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.renderer = "none";
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "camera \"wall\" is observed; choose a renderer",
              mimo_env_create(scene, &config, &env));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  if (env == NULL) return failures();
  check_cameras(env);
  check_faces(env);
  check_gaze(env);
  check_quality(scene);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return failures();
}
