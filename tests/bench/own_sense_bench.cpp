// What a user's own sense costs that does nothing, as C functions and as a class in C++, and what worlds pay that have
// none: a pendulum, so that nothing else takes long, stepped in turns with it, without it, and by MuJoCo alone.
//
//   bench_own_sense [TURNS]
#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mimo/mimo.hpp>
#include <vector>

#include "bench/measured.h"

namespace {

using mimo::test::median;
using Clock = std::chrono::steady_clock;

constexpr char kFile[] = "bench_own_sense.xml";
constexpr char kPendulum[] = R"(<mujoco><worldbody><body name="pendulum"><joint type="hinge" axis="0 1 0"/>
<geom type="capsule" size="0.02" fromto="0 0 0 0 0 -0.5"/></body></worldbody></mujoco>)";
constexpr int kSteps = 200;    // of a turn
constexpr int kFrameSkip = 2;  // physics steps of a step, as usual

void check(mimo_status status) {
  if (status == MIMO_OK) return;
  std::fprintf(stderr, "%s\n", mimo_last_error());
  std::exit(1);
}

mimo_status open(void*, const mimo_env* env, const mimo_sense_moment*, mimo_sense_needs*) {
  mimo_sense_field field;
  check(mimo_sense_field_init(&field, sizeof field));
  return mimo_sense_add_field(env, &field);
}

mimo_status do_nothing(void*, const mimo_env*, const mimo_sense_moment*) { return MIMO_OK; }

mimo_sense in_c() {
  mimo_sense sense;
  check(mimo_sense_init(&sense, sizeof sense));
  sense.interface_version = MIMO_SENSE_INTERFACE;
  sense.name = "empty";
  sense.open = open;
  sense.advance = sense.write = do_nothing;
  return sense;
}

class Empty : public mimo::Sense {
 public:
  explicit Empty(mimo::SenseOpening& opening) { opening.add(mimo::SenseField()); }
  void write(const mimo::SenseMoment&) const override {}
};

mimo_env* make(const mimo_sense* sense) {
  mimo_scene_config config;
  check(mimo_scene_config_init(&config, sizeof config));
  config.file = kFile;
  mimo_scene* scene = nullptr;
  check(mimo_scene_create(&config, &scene));
  mimo_agent_config agent;
  check(mimo_agent_config_init(&agent, sizeof agent));
  agent.body = "scene";
  agent.root = "pendulum";
  agent.vision = agent.touch = agent.vestibular = 0;
  check(mimo_scene_add_agent(scene, &agent, nullptr));
  if (sense != nullptr) check(mimo_scene_add_sense(scene, 0, sense));
  mimo_env_config usual;
  check(mimo_env_config_init(&usual, sizeof usual));
  usual.frame_skip = kFrameSkip;
  mimo_env* env = nullptr;
  check(mimo_env_create(scene, &usual, &env));
  mimo_scene_destroy(scene);
  return env;
}

template <typename Step>
double microseconds_a_step(Step&& step) {
  const auto start = Clock::now();
  for (int i = 0; i < kSteps; ++i) step();
  return std::chrono::duration<double>(Clock::now() - start).count() / kSteps * 1e6;
}

}  // namespace

int main(int argc, char** argv) {
  const int turns = argc > 1 ? std::atoi(argv[1]) : 500;
  std::FILE* const file = std::fopen(kFile, "w");
  if (file == nullptr || std::fputs(kPendulum, file) < 0 || std::fclose(file) != 0) return 1;
  char error[200] = "";
  mjModel* const model = mj_loadXML(kFile, nullptr, error, sizeof error);
  const mimo_sense c = in_c(), cpp = mimo::sense<Empty>("empty");
  mimo_env *const usual = make(nullptr), *const having = make(&c), *const having_cpp = make(&cpp);
  std::remove(kFile);
  if (model == nullptr) return 1;
  mjData* const data = mj_makeData(model);
  std::vector<unsigned char> block(4096);
  for (mimo_env* env : {usual, having, having_cpp}) check(mimo_env_reset(env, nullptr, block.data(), block.size()));

  const auto step = [&](mimo_env* env) {
    return microseconds_a_step([&] { check(mimo_env_step(env, nullptr, 0, block.data(), block.size(), nullptr)); });
  };
  std::vector<double> bare, without, more, more_cpp, factors, shares;
  for (int turn = 0; turn < turns; ++turn) {
    bare.push_back(microseconds_a_step([&] {
      for (int i = 0; i < kFrameSkip; ++i) mj_step(model, data);
    }));
    without.push_back(step(usual));
    more.push_back(step(having) - without.back());
    more_cpp.push_back(step(having_cpp) - without.back());
    factors.push_back(without.back() / bare.back());
    shares.push_back(more.back() / bare.back());
  }
  std::printf("bare physics takes %.3f us a step, without a sense %.4f times as long (median of %.3f us)\n",
              median(bare), median(factors), median(without));
  std::printf("an empty sense takes %.3f us more, %.4f of that physics; a class in C++ takes %.3f us more\n",
              median(more), median(shares), median(more_cpp));
  mj_deleteData(data);
  mj_deleteModel(model);
  for (mimo_env* env : {usual, having, having_cpp}) mimo_env_destroy(env);
}
