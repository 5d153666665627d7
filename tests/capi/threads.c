/* Different handles on different threads; each thread has its own last error. Const functions share a handle. */
#include <pthread.h>

#include "support/capi.h"

#define THREADS 16
#define STEPS 30
#define VALUES 68

struct job {
  const mimo_env* shared;
  double state[VALUES];
  int number, wrong;
};

static void simulate(struct job* job) {
  mimo_scene_config room;
  mimo_agent_config agent;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  int32_t ids[50], id = 0, i;
  char name[16];
  job->wrong += mimo_scene_config_init(&room, sizeof room) != MIMO_OK;
  room.name = "benchmark";
  job->wrong += mimo_scene_create(&room, &scene) != MIMO_OK;
  job->wrong += mimo_agent_config_init(&agent, sizeof agent) != MIMO_OK;
  agent.vision = 0;
  job->wrong += mimo_scene_add_agent(scene, &agent, NULL) != MIMO_OK;
  job->wrong += mimo_env_create(scene, NULL, &env) != MIMO_OK;
  mimo_scene_destroy(scene);
  sprintf(name, "nobody%d", job->number);
  for (i = 0; i < STEPS; ++i) {
    job->wrong += mimo_env_step(env, NULL, 0, NULL, 0, NULL) != MIMO_OK;
    job->wrong += mimo_env_find(job->shared, MIMO_SENSOR, name, &id) != MIMO_E_NOT_FOUND;
    job->wrong += strstr(mimo_last_error(), name) == NULL;
    job->wrong += mimo_env_find(job->shared, MIMO_BODY, "head", &id) != MIMO_OK;
  }
  for (i = 0; i < 50; ++i) ids[i] = i;
  job->wrong += mimo_env_get(env, MIMO_JOINT_POSITION, ids, 50, job->state, VALUES) != MIMO_OK;
  mimo_env_destroy(env);
}

static void* run(void* argument) {
  simulate(argument);
  return NULL;
}

int main(void) {
  static struct job jobs[THREADS + 1];
  pthread_t threads[THREADS];
  mimo_env* shared = blind_env("free", NULL);
  int i;
  for (i = 0; i <= THREADS; ++i) {
    jobs[i].shared = shared;
    jobs[i].number = i;
  }
  for (i = 0; i < THREADS; ++i) CHECK(pthread_create(&threads[i], NULL, run, &jobs[i]) == 0);
  for (i = 0; i < THREADS; ++i) pthread_join(threads[i], NULL);
  CHECK_TEXT("", mimo_last_error()); /* the others' errors are theirs */
  simulate(&jobs[THREADS]);
  for (i = 0; i <= THREADS; ++i) {
    CHECK(jobs[i].wrong == 0);
    CHECK(memcmp(jobs[i].state, jobs[THREADS].state, sizeof jobs[i].state) == 0);
  }
  mimo_env_destroy(shared);
  return failures();
}
