// What something costs that can be switched on: two worlds of the benchmark scene (behaviours: of a scene that has one)
// that go the same way, one of which has it, are stepped in turns.
//
//   bench_extras contacts [STEPS]   what touches what within a step is recorded (step_contacts); no senses
//   bench_extras delays [STEPS]     the nerves of a newborn, all senses but the eyes
//   bench_extras eyes [STEPS]       the eyes of a newborn, 256 pixels, in steps of a third world without eyes: what
//                                   pictures take depends on how wide the processor's vectors are
//   bench_extras newborn [STEPS] [PIXELS]   both, in steps of the world without them, which has eyes of so many pixels
//                                           a side, 256 unless told otherwise
//   bench_extras skin [STEPS]       all that nerves of the skin tell
//   bench_extras caresses [STEPS]   C-tactile afferents of the skin alone
//   bench_extras hearing [STEPS]    what sounds, and both ears, with bands
//   bench_extras voice [STEPS]      the same with a voice that speaks, against ears without one
//   bench_extras receptors [STEPS]  all that nerves of skin, labyrinth, muscles and joints tell
//   bench_extras recording [STEPS]  steps are recorded as usual: joints, proprioception, vestibular sense, a state a
//                                   second; thousands of steps, as most of them only wait for the one that writes
//   bench_extras reflexes [STEPS]   all reflexes of a newborn that mittens allow, but at 18 months: they move nothing
//   bench_extras behaviour [STEPS]  what the scene "sit" measures, against the same room without a task
//   bench_extras spontaneous [STEPS]  an infant's spontaneous movements are asked for before each step
#include <mimo/experimental.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

#include "bench/measured.h"

namespace {

using mimo::test::median;
using mimo::test::processor_seconds;

void check(mimo_status status) {
  if (status == MIMO_OK) return;
  std::fprintf(stderr, "%s\n", mimo_last_error());
  std::exit(1);
}

enum class Extra {
  kContacts,
  kDelays,
  kEyes,
  kNewborn,
  kSkin,
  kCaresses,
  kReceptors,
  kReflexes,
  kHearing,
  kVoice,
  kRecording,
  kBehaviour,
  kSpontaneous
};

bool is_maturity(Extra extra) { return extra == Extra::kDelays || extra == Extra::kEyes || extra == Extra::kNewborn; }

bool is_receptors(Extra extra) { return extra == Extra::kSkin || extra == Extra::kReceptors; }

// Eyes or nerves of a newborn; actions arrive at once, so that both worlds go the same way.
void mature(mimo_scene* scene, Extra extra) {
  mimo_maturity newborn, perfect;
  mimo_limits prompt;
  check(mimo_maturity_at(0, &newborn, sizeof newborn));
  check(mimo_maturity_init(&perfect, sizeof perfect));
  check(mimo_limits_init(&prompt, sizeof prompt));
  if (extra != Extra::kDelays) {
    perfect.acuity = newborn.acuity;
    perfect.peak_contrast = newborn.peak_contrast;
    perfect.chroma = newborn.chroma;
  }
  if (extra != Extra::kEyes) {
    perfect.conduction_speed = newborn.conduction_speed;
    perfect.sensory_delay = newborn.sensory_delay;
    perfect.vestibular_delay = newborn.vestibular_delay;
    check(mimo_scene_limit_motor(scene, 0, "", &prompt));
  }
  check(mimo_scene_set_maturity(scene, 0, &perfect));
}

// With eyes of so many pixels a side; 0: without.
mimo_env* make(Extra extra, bool has, std::uint32_t pixels) {
  mimo_scene_config named;
  check(mimo_scene_config_init(&named, sizeof named));
  named.name = extra == Extra::kBehaviour ? "sit" : "benchmark";
  mimo_scene* scene = nullptr;
  check(mimo_scene_create(&named, &scene));
  mimo_agent_config agent;
  check(mimo_scene_default_agent(scene, &agent, sizeof agent));
  if (pixels == 0) agent.vision = 0;
  if (pixels > 0) agent.vision_width = agent.vision_height = pixels;
  if (has && is_receptors(extra)) {
    agent.touch |= MIMO_TOUCH_SA1 | MIMO_TOUCH_RA | MIMO_TOUCH_PC | MIMO_TOUCH_SA2 | MIMO_TOUCH_TEMPERATURE |
                   MIMO_TOUCH_COLD | MIMO_TOUCH_WARM | MIMO_TOUCH_NOCICEPTION_FAST | MIMO_TOUCH_NOCICEPTION_SLOW;
  }
  if (has && extra == Extra::kCaresses) agent.touch |= MIMO_TOUCH_CT;
  if ((has && extra == Extra::kHearing) || extra == Extra::kVoice)
    agent.hearing = MIMO_HEARING_EARS | MIMO_HEARING_BANDS;
  agent.voice = has && extra == Extra::kVoice ? 1 : 0;
  if (has && extra == Extra::kReceptors) {
    agent.vestibular |= MIMO_VESTIBULAR_CANALS | MIMO_VESTIBULAR_OTOLITHS | MIMO_VESTIBULAR_GRAVITY;
    agent.proprioception |= MIMO_PROPRIOCEPTION_SPINDLE_PRIMARY | MIMO_PROPRIOCEPTION_SPINDLE_SECONDARY |
                            MIMO_PROPRIOCEPTION_TENDON_ORGAN | MIMO_PROPRIOCEPTION_JOINT_RECEPTOR;
  }
  // Withdrawal stays; nothing touches the infant but the floor, so that both worlds go the same way.
  if (has && extra == Extra::kReflexes) agent.reflexes = MIMO_REFLEX_ALL;
  check(mimo_scene_add_agent(scene, &agent, nullptr));
  if (has && is_maturity(extra)) mature(scene, extra);
  mimo_env_config config;
  check(mimo_env_config_init(&config, sizeof config));
  config.step_contacts = has && extra == Extra::kContacts ? 1 : 0;
  if (!has && extra == Extra::kBehaviour) config.task = "none";
  if (extra == Extra::kBehaviour) check(mimo_scene_set_parameter(scene, "behaviour/pose_noise", 0));
  mimo_env* env = nullptr;
  check(mimo_env_create(scene, &config, &env));
  mimo_scene_destroy(scene);
  return env;
}

// Each motor has a rhythm of its own.
std::vector<float> wish(std::size_t actions, int step) {
  std::vector<float> action(actions);
  for (std::size_t i = 0; i < actions; ++i) {
    action[i] = static_cast<float>(std::sin(0.05 * step * (1 + 0.1 * static_cast<double>(i)) + static_cast<double>(i)));
  }
  return action;
}

// Of so many steps each: within them every table of a recording is written once or more.
constexpr std::size_t kWritten = 1024;

std::vector<double> shares_of_sums(const std::vector<double>& with, const std::vector<double>& without) {
  std::vector<double> shares;
  for (std::size_t i = 0; i + kWritten <= with.size(); i += kWritten) {
    const auto sum = [i](const std::vector<double>& times) {
      const auto first = times.begin() + static_cast<std::ptrdiff_t>(i);
      return std::accumulate(first, first + kWritten, 0.0);
    };
    shares.push_back(sum(with) / sum(without) - 1);
  }
  return shares;
}

// Without a block nothing is sensed. What the infant would do by itself is asked for and not done, so that both worlds
// go the same way.
double seconds(mimo_env* env, const std::vector<float>& action, std::vector<std::uint8_t>& block,
               bool spontaneous = false) {
  std::vector<float> own(action.size());
  const double start = processor_seconds();
  if (spontaneous) check(mimo_env_spontaneous(env, 0, MIMO_MOVEMENT_ALL, own.data(), own.size()));
  check(
      mimo_env_step(env, action.data(), action.size(), block.empty() ? nullptr : block.data(), block.size(), nullptr));
  return processor_seconds() - start;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "contacts";
  const Extra extra = what == "eyes"          ? Extra::kEyes
                      : what == "delays"      ? Extra::kDelays
                      : what == "newborn"     ? Extra::kNewborn
                      : what == "skin"        ? Extra::kSkin
                      : what == "caresses"    ? Extra::kCaresses
                      : what == "hearing"     ? Extra::kHearing
                      : what == "voice"       ? Extra::kVoice
                      : what == "receptors"   ? Extra::kReceptors
                      : what == "reflexes"    ? Extra::kReflexes
                      : what == "recording"   ? Extra::kRecording
                      : what == "behaviour"   ? Extra::kBehaviour
                      : what == "spontaneous" ? Extra::kSpontaneous
                                              : Extra::kContacts;
  const bool eyes = extra == Extra::kEyes || extra == Extra::kNewborn;
  const int usual_steps = eyes ? 200 : extra == Extra::kRecording ? 9216 : 4000;
  const int steps = argc > 2 ? std::atoi(argv[2]) : usual_steps;
  const std::uint32_t pixels = !eyes ? 0 : argc > 3 ? static_cast<std::uint32_t>(std::atoi(argv[3])) : 256;
  mimo_env *const having = make(extra, true, pixels), *const usual = make(extra, false, pixels);
  mimo_env* const blind = extra == Extra::kEyes ? make(extra, false, 0) : nullptr;
  const mimo_layout* layout = nullptr;
  mimo_layout_info info{};
  info.struct_size = sizeof info;
  check(mimo_env_layout(having, &layout));  // the larger block
  check(mimo_layout_describe(layout, &info));
  std::vector<std::uint8_t> block(extra == Extra::kContacts ? 0 : info.block_bytes);
  for (mimo_env* env : {having, usual, blind}) {
    if (env != nullptr) check(mimo_env_reset(env, nullptr, nullptr, 0));
  }

  const char* const file = "bench_recording.h5";
  mimo_recorder* recorder = nullptr;
  if (extra == Extra::kRecording) check(mimo_recorder_open(having, file, nullptr, &recorder));

  std::vector<double> with, without, shares;
  for (int step = 0; step < steps; ++step) {
    const std::vector<float> action = wish(info.actions, step);
    std::vector<float> mute = action;
    if (extra == Extra::kVoice) mute.resize(action.size() - 4);  // a voice's actions are the last ones
    const bool asks = extra == Extra::kSpontaneous;
    // Who goes second finds warm caches: they take turns at that, too.
    if (step % 2 == 0) with.push_back(seconds(having, action, block, asks));
    without.push_back(seconds(usual, mute, block));
    if (step % 2 != 0) with.push_back(seconds(having, action, block, asks));
    const double unit = blind == nullptr ? without.back() : seconds(blind, mute, block);
    shares.push_back((with.back() - without.back()) / unit);
  }
  if (extra == Extra::kRecording) shares = shares_of_sums(with, without);
  std::printf("a step takes %.1f us, with %s %.1f us: %.4f of a step more (median)\n", median(without) * 1e6,
              what.c_str(), median(with) * 1e6, median(shares));
  check(mimo_recorder_close(recorder));
  if (recorder != nullptr) std::remove(file);
  mimo_env_destroy(having);
  mimo_env_destroy(usual);
  mimo_env_destroy(blind);
}
