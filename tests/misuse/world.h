/* What the table's calls work on, and all memory that a refused call must leave alone. */
#ifndef MIMO_TESTS_MISUSE_WORLD_H
#define MIMO_TESTS_MISUSE_WORLD_H

#include "misuse/table.h"

enum { WORLDS_IN_BATCH = 2, AGENTS = 1, PICTURE_SIZE = 8, VALUES_PER_WORLD = 7 };

/* Makes all handles and buffers; exits when that fails. */
void make_everything(void);
void destroy_everything(void);
int world_failures(void);

/* Arguments with which every call succeeds. What rows use is made anew where calls change it for good. */
args good_args(int uses);

/* Memory of calls, filled with a pattern by good_args. */
void remember_memory(void);
int memory_changed(void);

/* Handles made by a call are destroyed; 1 if there was one. */
int destroy_made(args* a);

/* A destroyed handle of each kind, and something that is none. */
mimo_scene* retired_scene(void);
mimo_env* retired_env(void);
mimo_batch* retired_batch(void);
mimo_senses* retired_senses(void);
mimo_recorder* retired_recorder(void);
mimo_recording* retired_recording(void);
mimo_stage* retired_stage(void);
mimo_layout* retired_layout(void);
void* no_handle(void);

/* Makes the environment and the batch fail by divergence; makes them good again. */
void break_worlds(void);
void mend_worlds(void);

/* The state of a world of another scene. */
const void* foreign_state(void);

#endif
