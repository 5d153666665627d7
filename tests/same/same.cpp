// The scenario of tests/capi/same.c, which gives the same hashes in every language.
#include <cstdio>
#include <mimo/mimo.hpp>

namespace {

std::uint64_t hash_of(std::uint64_t hash, const mimo::Block& block) {  // FNV-1a
  for (std::size_t i = 0; i < block.bytes(); ++i) hash = (hash ^ block.data()[i]) * 1099511628211U;
  return hash;
}

// The task "own" of tests/capi/same.c.
class Height : public mimo::Task {
 public:
  std::vector<std::string> terms() const override { return {"height", "effort"}; }
  std::vector<mimo::TaskField> fields() const override {
    return {mimo::TaskField("desired_goal", {}, "m", "world"), mimo::TaskField("achieved_goal", {}, "m", "world")};
  }
  std::size_t memory_bytes() const override { return sizeof(double); }

  void reset(mimo::Env& env, const mimo_task_moment& moment) override {
    double& height = *static_cast<double*>(moment.memory);
    height = 0.2 + 0.2 * env.random(1)[0];
    moment.fields[0] = static_cast<float>(height);
  }
  void evaluate(mimo::Env& env, const mimo_task_moment& moment, mimo_task_verdict& verdict) override {
    const double height = *static_cast<double*>(moment.memory);
    const double hand = env.get_values(MIMO_BODY_POSITION, {env.find(MIMO_BODY, "left_hand")})[2];
    double effort = 0;
    for (std::size_t i = 0; i < moment.action_count; ++i)
      effort += static_cast<double>(moment.action[i]) * moment.action[i];
    verdict.terms[0] = hand - height;
    verdict.terms[1] = -0.01 * effort;
    moment.fields[1] = static_cast<float>(hand);
    verdict.outcome = hand > height ? MIMO_OUTCOME_SUCCESS : MIMO_OUTCOME_NONE;
    verdict.goes_on = 1;
  }
};

mimo::Env make_own(mimo::Task& task) {
  mimo_scene_config room = mimo::scene_config();
  room.name = "benchmark";
  mimo::Scene scene(room);
  mimo_agent_config infant = scene.default_agent();
  infant.vision = 0;
  scene.add_agent(infant);
  scene.set_task(task);
  return mimo::Env(scene);
}

void run(const std::string& scene) {
  Height task;
  mimo::Env env = scene == "own" ? make_own(task) : mimo::make(scene);
  mimo::Block block = env.make_block();
  std::vector<float> actions(env.layout().info().actions);
  env.reset(7, block);
  std::uint64_t hash = hash_of(14695981039346656037U, block);
  double sum = 0;
  for (std::size_t step = 0; step < 100; ++step) {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      actions[i] = static_cast<float>(static_cast<int>((7 * step + 3 * i) % 21) - 10) / 10.0F;
    }
    sum += env.step(actions, block).at(0).reward;
    hash = hash_of(hash, block);
  }
  std::printf("%s %016llx %.6f\n", scene.c_str(), static_cast<unsigned long long>(hash), sum);
}

}  // namespace

int main() {
  for (const char* scene : {"reach", "standup", "selfbody", "benchmark", "own"}) run(scene);
}
