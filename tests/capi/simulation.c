/* Simulations that fail: the host gets a status and a message, nothing is printed or written, and it can go on. */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>

#include "support/capi.h"
#include "support/folder.h"

struct log {
  int warnings;
  char text[512];
  mimo_log_record last;
};

static void listen(void* user, const mimo_log_record* record) {
  struct log* log = user;
  CHECK(record->struct_size == sizeof *record && record->level == MIMO_LOG_WARNING && record->in_world == 1);
  ++log->warnings;
  log->last = *record;
  log->text[sizeof log->text - 1] = '\0';
  strncpy(log->text, record->text, sizeof log->text - 1);
}

static void states(mimo_env* env, double* values, size_t count) {
  int32_t ids[50];
  int32_t i;
  for (i = 0; i < 50; ++i) ids[i] = i;
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, ids, 50, values, count));
}

/* What a failed world answers: whatever would simulate, sense, draw, look, write values, save or clone is refused; what
 * reads, and the settings of the world that outlive a reset, go on. docs/guide/errors.md has the same table. */
static void check_failed(mimo_env* env) {
#define REFUSED(call) CHECK_FAILS(MIMO_E_SIMULATION, "failed before", call)
  const int32_t ball = 1, elbow = 25;
  const double velocity[6] = {0, 0, 0, 0, 0, 0}, point[3] = {1, 0, 0.5};
  static uint8_t block[1 << 20], before[1 << 20];
  double values[7], errors[2], pixels[3];
  uint8_t rgb[3 * 4 * 4];
  size_t bytes = 0, count = 0;
  const char* name = NULL;
  mimo_env* twin = NULL;
  mimo_picture_config picture;
  mimo_gaze gaze;
  mimo_timing timing;
  CHECK_OK(mimo_picture_config_init(&picture, sizeof picture));
  picture.width = picture.height = 4;
  memset(&gaze, 0, sizeof gaze);
  gaze.struct_size = sizeof gaze;
  memset(&timing, 0, sizeof timing);
  timing.struct_size = sizeof timing;
  bytes = sizes_of(env).block_bytes;
  memset(block, 0x5a, sizeof block);
  memcpy(before, block, sizeof block);

  REFUSED(mimo_env_step(env, NULL, 0, block, bytes, NULL));
  REFUSED(mimo_env_physics_step(env, 1));
  REFUSED(mimo_env_observe(env, block, bytes));
  REFUSED(mimo_env_update(env));
  REFUSED(mimo_env_render(env, &picture, PICTURE(.rgb = rgb, .rgb_bytes = sizeof rgb)));
  REFUSED(mimo_env_set(env, MIMO_JOINT_VELOCITY, &ball, 1, velocity, 6));
  REFUSED(mimo_env_look_at(env, 0, point, MIMO_LOOK_EYES, errors));
  REFUSED(mimo_env_look_angles(env, 0, point, MIMO_LOOK_EYES, NULL, NULL, 0, &count, errors));
  CHECK_OK(mimo_env_state_size(env, &bytes));
  REFUSED(mimo_env_state_save(env, block, bytes));
  REFUSED(mimo_env_clone(env, &twin));
  CHECK(twin == NULL && memcmp(block, before, sizeof block) == 0); /* refused means nothing written */

  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, &ball, 1, values, 7));
  CHECK_OK(mimo_env_time(env, values));
  CHECK_OK(mimo_env_count(env, MIMO_CONTACT, &count));
  CHECK_OK(mimo_env_name(env, MIMO_JOINT, elbow, &name));
  CHECK_OK(mimo_env_gaze(env, 0, &gaze));
  REFUSED(mimo_env_project(env, &picture, point, 1, pixels));
  CHECK(field_of(env, "touch/force").receptors == 5685);
  CHECK_OK(mimo_env_timing(env, &timing));
  CHECK_OK(mimo_env_random(env, values, 1));
  CHECK_OK(mimo_env_get(env, MIMO_WORLD_GRAVITY, NULL, 0, values, 3));
  CHECK_OK(mimo_env_set(env, MIMO_WORLD_GRAVITY, NULL, 0, values, 3));
  REFUSED(mimo_env_get(env, MIMO_BODY_POSE | MIMO_NOW, &ball, 1, values, 7));
#undef REFUSED
}

/* A velocity beyond all bounds; another world goes on to the bit, and a reset repairs this one. */
static void check_a_world_that_diverges(void) {
  mimo_env *failing = blind_env("benchmark", NULL), *other = blind_env("benchmark", NULL),
           *fresh = blind_env("benchmark", NULL);
  const int32_t ball = 1;
  const double absurd[6] = {1e300, 0, 0, 0, 0, 0};
  double one[68], two[68], seconds = -1;
  size_t i;
  for (i = 0; i < 40; ++i) {
    CHECK_OK(mimo_env_step(other, NULL, 0, NULL, 0, NULL));
    CHECK_OK(mimo_env_step(fresh, NULL, 0, NULL, 0, NULL));
    if (i == 20) {
      CHECK_OK(mimo_env_set(failing, MIMO_JOINT_VELOCITY, &ball, 1, absurd, 6));
      CHECK_FAILS(MIMO_E_SIMULATION,
                  "the simulation failed at 0.0000 s: ", mimo_env_step(failing, NULL, 0, NULL, 0, NULL));
    }
  }
  states(other, one, 68);
  states(fresh, two, 68);
  CHECK(memcmp(one, two, sizeof one) == 0);

  check_failed(failing);

  CHECK_OK(mimo_env_reset(failing, NULL, NULL, 0));
  CHECK_OK(mimo_env_reset(fresh, NULL, NULL, 0));
  for (i = 0; i < 40; ++i) {
    CHECK_OK(mimo_env_step(failing, NULL, 0, NULL, 0, NULL));
    CHECK_OK(mimo_env_step(fresh, NULL, 0, NULL, 0, NULL));
  }
  CHECK_OK(mimo_env_time(failing, &seconds));
  CHECK_NEAR(0.4, seconds, 1e-12);
  states(failing, one, 68);
  states(fresh, two, 68);
  CHECK(memcmp(one, two, sizeof one) == 0);
  mimo_env_destroy(failing);
  mimo_env_destroy(other);
  mimo_env_destroy(fresh);
}

static int on_mujoco_4(void) { return strncmp(mimo_mujoco_version(), "4.", 2) == 0; }

/* An infant in the floor with room for two contacts: the log hears of it, the world lives. */
static void check_a_warning_in_the_log(void) {
  mimo_scene_config room;
  mimo_env_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  struct log log;
  memset(&log, 0, sizeof log);
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  /* A box that lies on the floor with four corners. */
  room.xml =
      "<mujoco><size nconmax='2'/><worldbody><geom type='plane' size='0 0 1'/><body pos='0 0 .099'><freejoint/>"
      "<geom type='box' size='.1 .1 .1'/></body></worldbody></mujoco>";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.log = listen;
  config.log_user = &log;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  CHECK(log.warnings == 1 && strstr(log.text, "nconmax") != NULL);
  CHECK(log.last.code == MIMO_WARNING_CONTACTS_DROPPED && log.last.world == 0 && log.last.time == 0);
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  CHECK(log.warnings == 1);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK(log.warnings == 2);
  mimo_env_destroy(env);
  /* Without a log there is silence. */
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void check_models_that_physics_refuses(void) {
  static const char* const documents[] = {
      "<mujoco><worldbody><body><freejoint/></body></worldbody></mujoco>",
      "<mujoco><asset><mesh file='no/such.stl' name='m'/></asset></mujoco>",
      "<mujoco><asset><texture file='no/such.png' name='t' type='2d'/></asset></mujoco>",
      "<mujoco><size nstack='10'/><worldbody><body><freejoint/><geom size='1'/></body></worldbody></mujoco>"};
  const size_t count = sizeof documents / sizeof documents[0] - (on_mujoco_4() ? 1 : 0); /* which heeds no nstack */
  size_t i;
  for (i = 0; i < count; ++i) {
    mimo_scene_config room;
    mimo_scene* scene = NULL;
    mimo_env* env = NULL;
    CHECK_OK(mimo_scene_config_init(&room, sizeof room));
    room.xml = documents[i];
    CHECK_OK(mimo_scene_create(&room, &scene));
    CHECK_FAILS(MIMO_E_MODEL, "", mimo_env_create(scene, NULL, &env));
    CHECK(env == NULL && strchr(mimo_last_error(), '\n') == NULL);
    mimo_scene_destroy(scene);
  }
}

int main(void) {
  char folder[] = "/tmp/mimo_capi_XXXXXX", text[4096] = "";
  FILE* out = tmpfile();
  const int saved_out = dup(1), saved_err = dup(2);
  DIR* listing;
  struct dirent* entry;
  size_t length;
  CHECK(enter_folder(folder));
  dup2(fileno(out), 1);
  dup2(fileno(out), 2);
  check_a_world_that_diverges();
  if (!on_mujoco_4()) check_a_warning_in_the_log(); /* where contacts are not limited by their number */
  check_models_that_physics_refuses();
  fflush(NULL);
  dup2(saved_out, 1);
  dup2(saved_err, 2);

  rewind(out);
  length = fread(text, 1, sizeof text - 1, out);
  text[length] = '\0';
  fclose(out);
  fputs(text, stderr);
  CHECK(length == 0);
  listing = opendir(".");
  while ((entry = readdir(listing)) != NULL) {
    if (entry->d_name[0] != '.') fprintf(stderr, "file %s\n", entry->d_name);
    CHECK(entry->d_name[0] == '.');
  }
  closedir(listing);
  CHECK(chdir("/") == 0 && rmdir(folder) == 0);
  return failures();
}
