/* Simulations in trouble, seen by a host: a status, a message, nothing printed, no file, and on it goes. */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <unistd.h>

#include "support/capi.h"

struct log {
  int warnings;
  char last[512];
};

static void listen(void* user, int32_t level, const char* message) {
  struct log* log = user;
  CHECK(level == MIMO_LOG_WARNING);
  ++log->warnings;
  log->last[sizeof log->last - 1] = '\0';
  strncpy(log->last, message, sizeof log->last - 1);
}

static void states(mimo_env* env, double* values, size_t count) {
  int32_t ids[50];
  int32_t i;
  for (i = 0; i < 50; ++i) ids[i] = i;
  CHECK_OK(mimo_env_get(env, MIMO_JOINT_POSITION, ids, 50, values, count));
}

/* A velocity beyond all bounds; another world goes on to the bit, and a reset repairs this one. */
static void check_divergence(void) {
  mimo_env *failing = blind_env("benchmark", NULL), *other = blind_env("benchmark", NULL),
           *fresh = blind_env("benchmark", NULL);
  const int32_t ball = 1;
  const double absurd[6] = {1e300, 0, 0, 0, 0, 0};
  double one[68], two[68], seconds = -1;
  uint8_t block[8192];
  size_t count = 0, i;
  for (i = 0; i < 40; ++i) {
    CHECK_OK(mimo_env_step(other, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
    CHECK_OK(mimo_env_step(fresh, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
    if (i == 20) {
      CHECK_OK(mimo_env_set(failing, MIMO_JOINT_VELOCITY, &ball, 1, absurd, 6));
      CHECK_FAILS(MIMO_E_SIMULATION,
                  "the simulation failed at 0.0000 s: ", mimo_env_step(failing, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
    }
  }
  states(other, one, 68);
  states(fresh, two, 68);
  CHECK(memcmp(one, two, sizeof one) == 0);

  CHECK_FAILS(MIMO_E_SIMULATION, "reset", mimo_env_step(failing, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
  CHECK_FAILS(MIMO_E_SIMULATION, "reset", mimo_env_observe(failing, block, sizeof block));
  CHECK_FAILS(MIMO_E_SIMULATION, "reset", mimo_env_physics_step(failing, 1));
  CHECK_FAILS(MIMO_E_SIMULATION, "reset", mimo_env_update(failing));
  CHECK_FAILS(MIMO_E_SIMULATION, "reset", mimo_env_set(failing, MIMO_JOINT_VELOCITY, &ball, 1, absurd, 6));
  CHECK_OK(mimo_env_contacts(failing, NULL, NULL, 0, &count)); /* reading is harmless */

  CHECK_OK(mimo_env_reset(failing, NULL, NULL, 0));
  CHECK_OK(mimo_env_reset(fresh, NULL, NULL, 0));
  for (i = 0; i < 40; ++i) {
    CHECK_OK(mimo_env_step(failing, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
    CHECK_OK(mimo_env_step(fresh, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
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

/* An infant in the floor with room for two contacts: the log hears of it, the world lives. */
static void check_warnings(void) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_env_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  struct log log = {0, ""};
  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.xml = "<mujoco><size nconmax='2'/><worldbody><geom type='plane' size='0 0 1'/></worldbody></mujoco>";
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_config_init(&config, sizeof config));
  config.log = listen;
  config.log_user = &log;
  CHECK_OK(mimo_env_create(scene, &config, &env));
  CHECK(log.warnings == 1 && strstr(log.last, "nconmax") != NULL);
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
  CHECK(log.warnings == 1);
  CHECK_OK(mimo_env_reset(env, NULL, NULL, 0));
  CHECK(log.warnings == 2);
  mimo_env_destroy(env);
  /* Without a log there is silence. */
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_env_step(env, NULL, 0, NULL, 0, NULL, NULL, NULL, 0));
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void check_bad_models(void) {
  static const char* const documents[] = {
      "<mujoco><worldbody><body><freejoint/></body></worldbody></mujoco>",
      "<mujoco><asset><mesh file='no/such.stl' name='m'/></asset></mujoco>",
      "<mujoco><asset><texture file='no/such.png' name='t' type='2d'/></asset></mujoco>",
      "<mujoco><size nstack='10'/><worldbody><body><freejoint/><geom size='1'/></body></worldbody></mujoco>"};
  size_t i;
  for (i = 0; i < sizeof documents / sizeof documents[0]; ++i) {
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
  CHECK(mkdtemp(folder) != NULL && chdir(folder) == 0);
  dup2(fileno(out), 1);
  dup2(fileno(out), 2);
  check_divergence();
  check_warnings();
  check_bad_models();
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
