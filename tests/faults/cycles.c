/* Ten thousand worlds made, stepped and destroyed: memory grows by no more than the control blocks of their handles. */
#include <malloc.h>

#include "support/capi.h"

enum { WARM_UP = 100, HANDLES_PER_CYCLE = 2, BYTES_PER_HANDLE = 128 };

static mimo_status cycle(const char* name, const char* xml) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_status status = mimo_scene_config_init(&config, sizeof config);
  config.name = name;
  config.xml = xml;
  if (status == MIMO_OK) status = mimo_scene_create(&config, &scene);
  if (status == MIMO_OK && name != NULL) status = mimo_scene_add_agent(scene, NULL, NULL);
  if (status == MIMO_OK) status = mimo_env_create(scene, NULL, &env);
  if (status == MIMO_OK) status = mimo_env_step(env, NULL, 0, NULL, 0, NULL);
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
  return status;
}

static void check_growth(const char* name, const char* xml, int warm_up, int cycles) {
  size_t before, after;
  double growth;
  int i;
  for (i = 0; i < warm_up; ++i) CHECK_OK(cycle(name, xml));
  before = mallinfo2().uordblks + mallinfo2().hblkhd;
  for (i = 0; i < cycles && failed_checks == 0; ++i) CHECK_OK(cycle(name, xml));
  after = mallinfo2().uordblks + mallinfo2().hblkhd;
  growth = ((double)after - (double)before) / cycles / HANDLES_PER_CYCLE;
  printf("%d cycles of %s: %.1f bytes a handle\n", cycles, name == NULL ? "a small world" : name, growth);
  CHECK(growth <= BYTES_PER_HANDLE);
}

int main(void) {
  const char* small =
      "<mujoco><worldbody><geom type='plane' size='1 1 .1'/><body pos='0 0 1'><freejoint/><geom size='.1'/></body>"
      "</worldbody></mujoco>";
  check_growth(NULL, small, WARM_UP, 10000);
  check_growth("reach", NULL, WARM_UP, 100); /* glibc's chunks find their places in some 80 cycles */
  return failures();
}
