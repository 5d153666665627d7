// A C++ host whose tasks throw exceptions: these become errors of that world, in a batch as in a single world.
#include <cmath>
#include <stdexcept>

#include "support/capi.h"

namespace {

enum class Throws { kNothing, kStandard, kForeign };

// World 1 throws. Only the kind that this build of the test asks for: they come through a C interface.
mimo_status judge(void* user, mimo_env*, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  verdict->reward = 1;
  if (moment->world != 1) return MIMO_OK;
  const Throws what = *static_cast<Throws*>(user);
  if (what == Throws::kStandard) throw std::runtime_error("the ball left the table");
  if (what == Throws::kForeign) throw 42;
  return MIMO_OK;
}

mimo_status begin(void* user, mimo_env*, const mimo_task_moment* moment) {
  if (moment->world == 1 && *static_cast<Throws*>(user) == Throws::kForeign) throw 42;
  return MIMO_OK;
}

void expect(mimo_batch* batch, mimo_status status, const char* message) {
  double reward[3] = {7, 7, 7};
  mimo_status each[3] = {};
  mimo_batch_results results{};
  results.struct_size = sizeof results;
  results.reward = reward;
  results.agent_count = results.worlds = 3;
  results.status = each;
  const mimo_status all = mimo_batch_step(batch, nullptr, 0, nullptr, 0, &results);
  check_status(status, message, all, "mimo_batch_step", __LINE__);
  CHECK(each[0] == MIMO_OK && each[1] == status && each[2] == MIMO_OK);
  CHECK(reward[0] == 1 && reward[2] == 1);
}

}  // namespace

int main() {
  Throws throws = Throws::kNothing;
  mimo_scene* scene = blind_scene("free");
  mimo_task task;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.reset = begin;
  task.evaluate = judge;
  task.user = &throws;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  mimo_batch_config config;
  CHECK_OK(mimo_batch_config_init(&config, sizeof config));
  config.worlds = 3;
  config.threads = 2;
  mimo_batch* batch = nullptr;
  CHECK_OK(mimo_batch_create(scene, nullptr, &config, &batch));
  CHECK_OK(mimo_batch_reset(batch, nullptr, nullptr, 0));
  expect(batch, MIMO_OK, "");
  throws = Throws::kStandard;
#ifdef MIMO_OTHER_RUNTIME
  expect(batch, MIMO_E_TASK, "world 1: the task's function evaluate threw an unknown exception");
#else
  expect(batch, MIMO_E_TASK, "world 1: the task's function evaluate threw an exception: the ball left the table");
#endif
  throws = Throws::kForeign;
  expect(batch, MIMO_E_TASK, "world 1: the task's function evaluate threw an unknown exception");
  CHECK_FAILS(MIMO_E_TASK, "world 1: the task's function reset threw an unknown exception",
              mimo_batch_reset(batch, nullptr, nullptr, 0));
  throws = Throws::kNothing;
  CHECK_OK(mimo_batch_reset(batch, nullptr, nullptr, 0));
  expect(batch, MIMO_OK, "");
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
  return failures();
}
