// Own tasks by mimo.hpp: what they declare is in the layout, and what they throw is in the message.
#include <cmath>

#include "mimo/mimo.hpp"
#include "support/capi.h"

namespace {

enum class Throws { kNothing, kOwn, kLibrary, kForeign };

class Goal : public mimo::Task {
 public:
  std::vector<std::string> terms() const override { return {"near", "lazy"}; }
  std::vector<mimo::TaskField> fields() const override {
    mimo::TaskField goal("goal", {}, "rad", "joint");
    goal.low = 0;
    goal.high = 1;
    return {goal, mimo::TaskField("reached", {2, 3})};
  }
  std::size_t memory_bytes() const override { return sizeof(double); }

  void reset(mimo::Env& env, const mimo_task_moment& moment) override {
    throw_foreign();
    double& goal = *static_cast<double*>(moment.memory);
    CHECK(goal == 0 && moment.fields[0] == 0);
    goal = env.random(1)[0];
    moment.fields[0] = static_cast<float>(goal);
  }
  void evaluate(mimo::Env& env, const mimo_task_moment& moment, mimo_task_verdict& verdict) override {
    CHECK(moment.fields[0] == static_cast<float>(*static_cast<double*>(moment.memory)));
    verdict.terms[0] = static_cast<double>(moment.step);
    verdict.terms[1] = moment.action == nullptr ? 0 : -moment.action[0];
    moment.fields[6] = 5;
    verdict.truncated = moment.step == 3;
    if (throws == Throws::kOwn) throw std::runtime_error("the ball left the table");
    if (throws == Throws::kLibrary) env.find(MIMO_BODY, "unicorn");
    throw_foreign();
  }

  Throws throws = Throws::kNothing;

 private:
  void throw_foreign() const {
    if (throws == Throws::kForeign) throw 7;
  }
};

mimo::Scene scene_with(mimo::Task& task) {
  mimo_scene_config config = mimo::scene_config();
  config.name = "free";
  mimo::Scene scene(config);
  mimo_agent_config agent = mimo::agent_config();
  agent.vision = agent.touch = 0;
  scene.add_agent(agent);
  scene.set_task(task);
  return scene;
}

void check_told(mimo::Env& env) {
  mimo::Block block = env.make_block();
  const mimo_field goal = env.layout().field("goal"), reached = env.layout().field("reached");
  CHECK(goal.low == 0 && goal.high == 1 && goal.ndim == 1 && reached.ndim == 2 && reached.shape[1] == 3);
  CHECK_TEXT("rad", goal.unit);
  CHECK_TEXT("joint", goal.frame);
  env.reset(4, block);
  const float drawn = block.view<float>(goal)[0];
  CHECK(drawn > 0 && drawn < 1);
  std::vector<float> action(env.layout().info().actions);
  action[0] = -7;  // the least is -1
  for (int step = 1; step <= 3; ++step) {
    mimo::Results all = env.make_results();
    env.step(action, block, all);
    const mimo::Result result = {all.reward[0], all.terminated[0] != 0, all.truncated[0] != 0, all.outcome[0]};
    CHECK(result.reward == step + 1 && !result.terminated && result.truncated == (step == 3));
    CHECK(block.view<float>(goal)[0] == drawn && block.view<float>(reached)[5] == 5);
    const std::vector<mimo_term> terms = env.layout().terms();
    CHECK(terms.size() == 2 && std::string(terms[0].name) == "near" && all.terms[0] == step && all.terms[1] == 1);
    CHECK(result.outcome == MIMO_OUTCOME_NONE);
  }
}

// The program itself says so: nothing came through the C interface.
void check_foreign_reset(mimo::Env& env, Goal& task) {
  task.throws = Throws::kForeign;
  CHECK_FAILS(MIMO_E_TASK, "the task's function reset returned -14 (MIMO_E_TASK): threw what is no std::exception",
              mimo_env_reset(env.get(), nullptr, nullptr, 0));
  task.throws = Throws::kNothing;
  CHECK_OK(mimo_env_reset(env.get(), nullptr, nullptr, 0));
}

void check_thrown(mimo::Env& env, Goal& task, Throws throws, mimo_status status, const std::string& message) {
  mimo::Block none;
  task.throws = throws;
  try {
    env.step({}, none);
    const bool thrown = false;
    CHECK(thrown);
  } catch (const mimo::Exception& error) {
    CHECK(error.status() == status);
    CHECK(std::string(error.what()).find(message) != std::string::npos);
  }
  task.throws = Throws::kNothing;
  env.step({}, none);
}

}  // namespace

int main() {
  Goal task;
  mimo::Scene scene = scene_with(task);
  mimo::Env env(scene);
  check_told(env);
  check_thrown(env, task, Throws::kOwn, MIMO_E_TASK, "threw an exception: the ball left the table");
  check_thrown(env, task, Throws::kLibrary, MIMO_E_TASK, "evaluate returned -5 (MIMO_E_NOT_FOUND): ");
  check_thrown(env, task, Throws::kForeign, MIMO_E_TASK,
               "evaluate returned -14 (MIMO_E_TASK): threw what is no std::exception");
  check_foreign_reset(env, task);
  scene.clear_task();
  CHECK(mimo::Env(scene).task() == "none");
  CHECK(!mimo::parameters().empty());
  scene.set_parameter("reach/success_reward", 7);
  CHECK(scene.parameter("reach/success_reward") == 7);
  return failures();
}
