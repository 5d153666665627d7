/* The worlds whose states are kept: each kind of section, task, actuation, age and owner is in one of them. */
#ifndef MIMO_TESTS_STATES_WORLDS_H
#define MIMO_TESTS_STATES_WORLDS_H

#include <stddef.h>
#include <stdint.h>

#include "support/mujoco.h"

/* Whoever has a state: one of these handles. The senses' host has the model and the data. */
typedef struct owner {
  mimo_env* env;
  mimo_batch* batch;
  mimo_senses* senses;
  mjModel* model;
  mjData* data;
} owner;

/* The sizes of mjModel that docs/state-format.md names, in its order: nq, nv, nu, na, nbody, ngeom, neq, ntendon,
 * nlight, nmocap, nuserdata. Filled by make_owner where wants_sizes is set, since compiling the model again takes its
 * time. */
enum { SIZES = 11 };
extern int wants_sizes, model_sizes[SIZES];

extern const char* const kept_names[]; /* ends with NULL */

/* The owner of that name, at the start of its episode. */
owner make_owner(const char* name);
void free_owner(owner* it);

/* Steps with actions that follow from how many steps are left. */
void go_on(owner* it, int steps);
size_t state_size(const owner* it);
void save_state(owner* it, uint8_t* state, size_t bytes);
mimo_status load_state(owner* it, const uint8_t* state, size_t bytes, mimo_load_report* report);

/* Of each world: where all joints are, the time, and the sum of the numbers that are sensed. Returns how many. */
size_t look(owner* it, double* numbers, size_t room);

/* An infant that has all bits which the library takes. */
mimo_env* everything(void);
/* The world of a built-in task, and of one whose memory and fields are its own. */
mimo_env* world_of_task(const char* task);
/* A world whose infant is moved that way; NULL where the library does not know it. */
mimo_env* world_of_actuation(int32_t actuation);

#endif
