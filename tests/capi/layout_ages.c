/* One thread reads a layout while another resets the world between two ages: each answer belongs to one age wholly. */
#include <pthread.h>

#include "support/capi.h"

enum { RESETS = 200, MOST_FIELDS = 32 };

/* All that a layout tells and that another age changes. */
typedef struct told {
  mimo_field fields[MOST_FIELDS];
  double *delays[MOST_FIELDS], *receptors[MOST_FIELDS];
} told;

typedef struct asking {
  const mimo_layout* layout;
  const told *young, *old;
  size_t fields, answers, wrong;
  pthread_mutex_t mutex; /* of done */
  int done;
} asking;

static size_t numbers_of(const mimo_field* field) {
  size_t count = 1, i;
  for (i = 0; i < field->ndim; ++i) count *= field->shape[i];
  return count;
}

static size_t places_bytes(const mimo_field* field) { return 3 * field->receptors * sizeof(double); }

static size_t delays_bytes(const mimo_field* field) { return numbers_of(field) * sizeof(double); }

static mimo_status ask_delays(const mimo_layout* layout, size_t i, const mimo_field* field, double* delays) {
  return mimo_layout_delays(layout, i, delays, numbers_of(field));
}

static mimo_status ask_places(const mimo_layout* layout, size_t i, const mimo_field* field, double* places) {
  return mimo_layout_receptors(layout, i, MIMO_RECEPTOR_POSITION, places, 3 * field->receptors);
}

static told tell(const mimo_layout* layout, size_t fields) {
  told all;
  size_t i;
  memset(&all, 0, sizeof all);
  for (i = 0; i < fields; ++i) {
    mimo_field* field = &all.fields[i];
    field->struct_size = sizeof *field;
    CHECK_OK(mimo_layout_field(layout, i, field));
    all.delays[i] = malloc(delays_bytes(field) + 1);
    all.receptors[i] = malloc(places_bytes(field) + 1);
    CHECK_OK(ask_delays(layout, i, field, all.delays[i]));
    CHECK_OK(ask_places(layout, i, field, all.receptors[i]));
  }
  return all;
}

static void forget(told* all, size_t fields) {
  size_t i;
  for (i = 0; i < fields; ++i) {
    free(all->delays[i]);
    free(all->receptors[i]);
  }
}

static int is_one_of(const void* answer, const void* young, const void* old, size_t bytes) {
  return memcmp(answer, young, bytes) == 0 || memcmp(answer, old, bytes) == 0;
}

static void ask_field(asking* it, size_t i) {
  const mimo_field *young = &it->young->fields[i], *old = &it->old->fields[i];
  double *delays = malloc(delays_bytes(young) + 1), *places = malloc(places_bytes(young) + 1);
  mimo_field field;
  memset(&field, 0, sizeof field);
  field.struct_size = sizeof field;
  it->wrong += mimo_layout_field(it->layout, i, &field) != MIMO_OK || !is_one_of(&field, young, old, sizeof field);
  it->wrong += ask_delays(it->layout, i, young, delays) != MIMO_OK ||
               !is_one_of(delays, it->young->delays[i], it->old->delays[i], delays_bytes(young));
  it->wrong += ask_places(it->layout, i, young, places) != MIMO_OK ||
               !is_one_of(places, it->young->receptors[i], it->old->receptors[i], places_bytes(young));
  ++it->answers;
  free(delays);
  free(places);
}

static int is_done(asking* it) {
  int done;
  pthread_mutex_lock(&it->mutex);
  done = it->done;
  pthread_mutex_unlock(&it->mutex);
  return done;
}

static void* ask(void* argument) {
  asking* it = argument;
  size_t i;
  while (!is_done(it)) {
    for (i = 0; i < it->fields; ++i) ask_field(it, i);
  }
  return NULL;
}

/* Its nerves are as long as its body is old. */
static mimo_growth aged(double months) {
  mimo_growth growth;
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.age = months;
  growth.maturity = MIMO_MATURITY_BODY | MIMO_MATURITY_DELAYS;
  return growth;
}

static mimo_env* make_env(void) {
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  const mimo_growth toddler = aged(18);
  mimo_agent_config agent;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = "free"), &scene));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.growth = &toddler;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static void become(mimo_env* env, double months) {
  const mimo_growth growth = aged(months);
  const mimo_growth* all[1] = {&growth};
  CHECK_OK(mimo_env_reset(env, SIZED(mimo_reset_config, .growth = all, .growth_count = 1), NULL, 0));
}

int main(void) {
  mimo_env* env = make_env();
  asking it;
  told young, old;
  pthread_t asker;
  size_t i, touch = 0;
  memset(&it, 0, sizeof it);
  it.layout = layout_of(env);
  it.fields = sizes_of(env).fields;
  CHECK(it.fields > 0 && it.fields <= MOST_FIELDS);
  if (it.fields > MOST_FIELDS) return failures();
  become(env, 3);
  young = tell(it.layout, it.fields);
  become(env, 18);
  old = tell(it.layout, it.fields);
  it.young = &young;
  it.old = &old;
  CHECK_OK(mimo_layout_find(it.layout, "touch/force", &touch));
  CHECK(memcmp(young.receptors[touch], old.receptors[touch], places_bytes(&young.fields[touch])) != 0);
  CHECK(young.fields[touch].start != old.fields[touch].start); /* nerves of other lengths */

  CHECK(pthread_mutex_init(&it.mutex, NULL) == 0);
  CHECK(pthread_create(&asker, NULL, ask, &it) == 0);
  for (i = 0; i < RESETS; ++i) become(env, i % 2 == 0 ? 3 : 18);
  pthread_mutex_lock(&it.mutex);
  it.done = 1;
  pthread_mutex_unlock(&it.mutex);
  pthread_join(asker, NULL);
  CHECK(it.wrong == 0 && it.answers > 0);
  pthread_mutex_destroy(&it.mutex);
  forget(&young, it.fields);
  forget(&old, it.fields);
  mimo_env_destroy(env);
  return failures();
}
