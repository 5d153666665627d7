// A task of one's own: MIMo is rewarded for holding its head high, and the episode ends when the head is down.
// Reward and end are computed here, by named access; the library simulates.
#include <cstdio>
#include <mimo/mimo.hpp>
#include <random>

namespace {

class HoldYourHeadHigh {
 public:
  HoldYourHeadHigh() : env_(world()), block_(env_.make_block()), head_{env_.find(MIMO_BODY, "head")} {}

  void reset(std::uint64_t seed) { env_.reset(seed, block_); }

  // Reward, and whether the episode has ended.
  std::pair<double, bool> step(const std::vector<float>& action) {
    env_.step(action, block_);
    const double height = env_.get_values(MIMO_BODY_POSITION, head_)[2];
    return {height - 0.2, height < 0.2};
  }

  std::size_t action_size() const { return env_.action_size(); }

 private:
  static mimo::Env world() {
    mimo_scene_config scene_config = mimo::scene_config();
    scene_config.name = "free";
    mimo_agent_config agent = mimo::agent_config();
    agent.vision = 0;
    mimo::Scene scene(scene_config);
    scene.add_agent(agent);
    return mimo::Env(scene);
  }

  mimo::Env env_;
  mimo::Block block_;
  std::vector<std::int32_t> head_;
};

}  // namespace

int main() try {
  HoldYourHeadHigh task;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  task.reset(1);
  double sum = 0;
  int steps = 0;
  for (bool ended = false; !ended && steps < 500; ++steps) {
    std::vector<float> action(task.action_size());
    for (float& value : action) value = uniform(random);
    const auto result = task.step(action);
    sum += result.first;
    ended = result.second;
  }
  std::printf("the head was down after %d steps; return %.2f\n", steps, sum);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
