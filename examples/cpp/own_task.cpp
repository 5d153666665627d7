// A task of one's own: MIMo is rewarded for holding its head high and for sparing its motors, and the episode ends when
// the head is down. The library asks the task within each step; how high the head is, is a field of the observation.
#include <cstdio>
#include <mimo/mimo.hpp>
#include <random>

namespace {

class HoldYourHeadHigh : public mimo::Task {
 public:
  std::vector<std::string> terms() const override { return {"height", "effort"}; }
  std::vector<mimo::TaskField> fields() const override { return {mimo::TaskField("head_height", {}, "m", "world")}; }

  void evaluate(mimo::Env& env, const mimo_task_moment& moment, mimo_task_verdict& verdict) override {
    const double height = env.get_values(MIMO_BODY_POSITION, {env.find(MIMO_BODY, "head")})[2];
    moment.fields[0] = static_cast<float>(height);
    verdict.terms[0] = height - kDown;
    for (std::size_t i = 0; i < moment.action_count; ++i) {
      verdict.terms[1] -= 0.001 * moment.action[i] * moment.action[i];
    }
    if (height < kDown) verdict.outcome = MIMO_OUTCOME_FAILURE;
  }

 private:
  static constexpr double kDown = 0.2;  // m
};

mimo::Env make_world(mimo::Task& task) {
  mimo_scene_config config = mimo::scene_config();
  config.name = "free";
  mimo::Scene scene(config);
  mimo_agent_config agent = mimo::agent_config();
  agent.vision = 0;
  scene.add_agent(agent);
  scene.set_task(task);
  return mimo::Env(scene);
}

}  // namespace

int main() try {
  HoldYourHeadHigh task;  // outlives its worlds
  mimo::Env env = make_world(task);
  mimo::Block block = env.make_block();
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<float> action(env.layout().info().actions);
  mimo::Results results = env.make_results();
  double sum = 0;
  int steps = 0;
  env.reset(1, block);
  for (bool ended = false; !ended && steps < 500; ++steps) {
    for (float& value : action) value = uniform(random);
    env.step(action, block, results);
    sum += results.reward[0];
    ended = results.terminated[0] != 0;
  }
  const float height = block.view<float>(env.layout().field("head_height"))[0];
  std::printf("after %d steps the head is at %.2f m; return %.2f\n", steps, height, sum);
  const auto terms = env.layout().terms();
  for (std::size_t i = 0; i < terms.size(); ++i)
    std::printf("  %s: %.3f in the last step\n", terms[i].name, results.terms[i]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
