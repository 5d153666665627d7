/* Structs that calls are given, in the place of an argument: RESULTS(.reward = &reward, .agent_count = 1). C99 only. */
#ifndef MIMO_TESTS_SUPPORT_CALLS_H
#define MIMO_TESTS_SUPPORT_CALLS_H

#include "mimo/experimental.h"

#define SIZED(type, ...) (&(const type){.struct_size = sizeof(type), __VA_ARGS__})

#define SEED(number) SIZED(mimo_reset_config, .seeded = 1, .seed = (number))
#define SEEDS(...) SIZED(mimo_batch_reset_config, __VA_ARGS__)
#define RESULTS(...) SIZED(mimo_env_results, __VA_ARGS__)
#define PICTURE(...) SIZED(mimo_picture, __VA_ARGS__)

#endif
