// mimo bench: how many steps of worlds this machine simulates in a second, and how that grows with its cores.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstring>
#include <future>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <thread>

#include "cli/commands.h"
#include "common/cores.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"
#include "programs/world.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

struct BenchOptions {
  WorldOptions world;
  std::size_t worlds = 8;   // a thread
  std::size_t threads = 0;  // 0: as many cores as it may use
  double seconds = 1;       // of each measurement
  bool scale = false, json = false;
};

constexpr std::size_t kTurn = 10;  // steps whose actions are drawn beforehand

// A batch in random play.
class PlayingBatch {
 public:
  PlayingBatch(const WorldOptions& options, std::size_t worlds, std::size_t threads, bool timing = false)
      : batch_(open(options, worlds, threads, timing)),
        worlds_(worlds),
        blocks_(batch_.make_blocks()),
        random_(batch_.env(0), options.seed) {
    std::vector<std::uint64_t> seeds(worlds);
    std::iota(seeds.begin(), seeds.end(), options.seed);
    batch_.reset(seeds, blocks_);
    play([](double) {});  // a world's first steps make what later ones reuse
  }

  // Steps of worlds a second.
  double rate(double seconds) {
    double taken = 0, steps = 0;
    while (taken < seconds) {
      play([&](double step) { taken += step, ++steps; });
    }
    return steps * static_cast<double>(worlds_) / taken;
  }

  // Calls `use` with the seconds of each of some steps.
  template <typename Use>
  void play(Use&& use) {
    for (std::vector<float>& actions : actions_) draw(actions);
    for (const std::vector<float>& actions : actions_) {
      const auto start = Clock::now();
      batch_.step(actions, blocks_);
      use(seconds_since(start));
    }
  }

  // Seconds that a world's steps took so far, of one that is timed.
  double seconds_of(std::size_t world) { return batch_.env(world).timing().total; }

 private:
  static mimo::Batch open(const WorldOptions& options, std::size_t worlds, std::size_t threads, bool timing) {
    auto env = make_env_config();
    set_renderer(options, env);
    env.timing = timing ? 1 : 0;
    auto config = mimo::batch_config();
    config.worlds = static_cast<std::uint32_t>(worlds);
    config.threads = static_cast<std::uint32_t>(threads);
    config.autoreset = MIMO_AUTORESET_SAME_STEP;
    return mimo::Batch(make_scene(options, Senses::kAll), env, config);
  }

  void draw(std::vector<float>& actions) {
    actions.clear();
    for (std::size_t world = 0; world < worlds_; ++world) {
      const std::vector<float> one = random_.draw();
      actions.insert(actions.end(), one.begin(), one.end());
    }
  }

  mimo::Batch batch_;
  std::size_t worlds_;
  mimo::Block blocks_;
  RandomActions random_;
  std::vector<float> actions_[kTurn];
};

// What one thread tells of many: a free thread takes the next world, and a step ends with its last world. What of a
// step lies between worlds is done by each thread for its own. Memory and clock are taken to be as good for all.
class Model {
 public:
  Model(const WorldOptions& options, std::size_t worlds, double seconds) {
    PlayingBatch batch(options, worlds, 1, true);
    std::vector<double> before(worlds);
    for (std::size_t i = 0; i < worlds; ++i) before[i] = batch.seconds_of(i);
    double total = 0, own = 0;
    while (total < seconds) {
      batch.play([&](double step) {
        total += step;
        for (std::size_t i = 0; i < worlds; ++i) {
          const double now = batch.seconds_of(i);
          steps_.push_back(now - before[i]);
          own += steps_.back();
          before[i] = now;
        }
      });
    }
    const double count = static_cast<double>(steps_.size());
    mean_ = own / count;
    between_ = std::max(0.0, total - own) / count;
  }

  // How many times as many steps threads make as one.
  double scaling(std::size_t worlds, std::size_t threads) const {
    constexpr int kSteps = 200;
    std::mt19937_64 random;
    Schedule all{0, 0};
    for (int i = 0; i < kSteps; ++i) {
      const Schedule one = schedule(worlds, threads, random);
      all.work += one.work;
      all.end += one.end;
    }
    return all.work / all.end;
  }

  Json to_json() const { return {{"world_us", mean_ * 1e6}, {"between_us", between_ * 1e6}}; }

 private:
  struct Schedule {
    double work, end;  // seconds of all worlds, and until the last thread is done
  };

  Schedule schedule(std::size_t worlds, std::size_t threads, std::mt19937_64& random) const {
    std::vector<double> busy(threads);
    for (std::size_t i = 0; i < worlds; ++i) {
      *std::min_element(busy.begin(), busy.end()) += steps_[random() % steps_.size()] + between_;
    }
    return {std::accumulate(busy.begin(), busy.end(), 0.0), *std::max_element(busy.begin(), busy.end())};
  }

  std::vector<double> steps_;  // seconds of single worlds' steps
  double mean_ = 0, between_ = 0;
};

// Calls `work` on so many threads, which first meet after each has made what it works with, and adds up what they
// return. Each thread is the first to touch the memory that it works with.
template <typename Make, typename Work>
double sum_of_threads(std::size_t threads, Make make, Work work) {
  std::atomic<std::size_t> missing{threads};
  const auto live = [&]() -> double {
    struct Arrival {  // also of a thread that fails: the others would wait for it
      std::atomic<std::size_t>& missing;
      bool here = false;
      void operator()() {
        if (!here) --missing;
        here = true;
      }
      ~Arrival() { (*this)(); }
    } arrive{missing};
    auto made = make();
    arrive();
    while (missing > 0) std::this_thread::yield();
    return work(*made);
  };
  std::vector<std::future<double>> all;
  for (std::size_t i = 0; i < threads; ++i) {
    try {
      all.push_back(std::async(std::launch::async, live));
    } catch (...) {
      missing -= threads - i;
      throw;
    }
  }
  double sum = 0;
  for (std::future<double>& one : all) sum += one.get();
  return sum;
}

// Steps of worlds a second of threads that have worlds of their own and never wait for each other.
double apart(const BenchOptions& options, const WorldOptions& world, std::size_t threads) {
  return sum_of_threads(
      threads, [&] { return std::make_unique<PlayingBatch>(world, options.worlds, 1); },
      [&](PlayingBatch& batch) { return batch.rate(options.seconds); });
}

// Memory that a thread copies within, larger than its share of a cache.
struct Copying {
  static constexpr std::size_t kBytes = 16 << 20;
  std::vector<char> from = std::vector<char>(kBytes, 1), to = std::vector<char>(kBytes);
};

// Gigabytes a second that threads read and write as they copy memory of their own.
double memory_speed(std::size_t threads) {
  constexpr int kTimes = 12;
  return sum_of_threads(
      threads, [] { return std::make_unique<Copying>(); },
      [](Copying& memory) {
        const auto start = Clock::now();
        for (int i = 0; i < kTimes; ++i) {
          memory.from[0] = static_cast<char>(i);
          std::memcpy(memory.to.data(), memory.from.data(), Copying::kBytes);
          [[maybe_unused]] const volatile char used = memory.to[0];  // else nothing need be copied
        }
        return 2.0 * kTimes * Copying::kBytes / seconds_since(start) / 1e9;
      });
}

// 1, 2, 4, ... and the last.
std::vector<std::size_t> thread_counts(std::size_t most, bool all) {
  std::vector<std::size_t> counts;
  for (std::size_t count = 1; all && count < most; count *= 2) counts.push_back(count);
  counts.push_back(most);
  return counts;
}

// Rows of each number of threads, for worlds without eyes and with eyes.
Json measure(const BenchOptions& options) {
  const std::size_t cores = mimo::usable_cores();
  const auto counts = thread_counts(options.threads == 0 ? cores : options.threads, options.scale);
  const std::vector<std::string> eyes = options.world.vision.empty() ? std::vector<std::string>{"off", "64"}
                                                                     : std::vector<std::string>{options.world.vision};
  Json result = {{"scene", options.world.scene},
                 {"cores", cores},
                 {"worlds_per_thread", options.worlds},
                 {"seconds", options.seconds},
                 {"versions", {{"libmimo", mimo_version()}, {"mujoco", mimo_mujoco_version()}}},
                 {"memory", Json::array()},
                 {"rows", Json::array()}};
  Progress progress((eyes.size() * 2 + 1) * counts.size());
  std::size_t done = 0;
  for (const std::size_t threads : counts) {
    if (options.scale) result["memory"].push_back({{"threads", threads}, {"gb_per_second", memory_speed(threads)}});
    progress.show(++done);
  }
  for (const std::string& vision : eyes) {
    WorldOptions world = options.world;
    world.vision = vision;
    const auto model = options.scale ? std::make_unique<Model>(world, options.worlds, options.seconds) : nullptr;
    double one = 0;
    for (const std::size_t threads : counts) {
      const std::size_t worlds = options.worlds * threads;
      const double rate = PlayingBatch(world, worlds, threads).rate(options.seconds);
      progress.show(++done);
      if (threads == 1) one = rate;
      Json row = {{"vision", vision}, {"threads", threads}, {"worlds", worlds}, {"steps_per_second", rate}};
      if (model != nullptr) {
        row.update(model->to_json());
        row["scaling"] = rate / one;
        row["predicted"] = one * model->scaling(worlds, threads);
        row["apart"] = apart(options, world, threads);
      }
      progress.show(++done);
      result["rows"].push_back(row);
    }
  }
  return result;
}

void print_for_people(const Json& result, bool scale) {
  Table table(1);
  std::vector<std::string> head = {"eyes", "threads", "worlds", "steps a second"};
  if (scale) head.insert(head.end(), {"x one thread", "predicted", "apart"});
  table.add(head);
  for (const Json& row : result["rows"]) {
    std::vector<std::string> cells = {row["vision"], row["threads"].dump(), row["worlds"].dump(),
                                      text("%.0f", row["steps_per_second"].get<double>())};
    if (scale) {
      cells.push_back(text("%.2f", row["scaling"].get<double>()));
      for (const char* key : {"predicted", "apart"}) cells.push_back(text("%.0f", row[key].get<double>()));
    }
    table.add(cells);
  }
  table.print(std::cout);
  if (!scale) return;
  std::cout << '\n';
  Table memory(0);
  memory.add({"threads", "GB of memory read and written a second"});
  for (const Json& row : result["memory"]) {
    memory.add({row["threads"].dump(), text("%.1f", row["gb_per_second"].get<double>())});
  }
  memory.print(std::cout);
}

}  // namespace

void add_bench(CLI::App& program) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = program.add_subcommand("bench", "Measure how many steps a second this machine simulates");
  command->add_flag("--scale", options->scale,
                    "For 1, 2, 4, ... threads, beside what the measurement of one thread\npredicts");
  add_scene_options(*command, options->world);
  add_actuation_option(*command, options->world);
  add_vision_options(*command, options->world, "off, and then 64");
  add_touch_option(*command, options->world);
  command->add_option("--worlds", options->worlds, "Worlds for each thread")
      ->type_name("W")
      ->check(CLI::Range(1, 1024).description(""))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "Most threads. Default: the cores that it may use")
      ->type_name("T")
      ->check(CLI::Range(1, 1024).description(""));
  command->add_option("--seconds", options->seconds, "How long each measurement takes")
      ->type_name("S")
      ->check(number(0.001, 3600))
      ->capture_default_str();
  add_seed_option(*command, options->world);
  command->add_flag("--json", options->json, "Print one JSON object");
  command->footer(
      "A step is that of one world with all its senses, in random play; all worlds are one batch, whose steps end "
      "with\n"
      "their slowest world. predicted: what as many threads would give with the memory and the clock of one. apart:\n"
      "what as many threads give that have worlds of their own and never wait for each other, so what the machine\n"
      "gives. docs/scale.md explains the model. Other programs disturb the measurement.\n"
      "Examples:\n"
      "  mimo bench\n"
      "  mimo bench --scale --json\n"
      "  mimo bench --scene reach --vision off --threads 4");
  command->callback([options] {
    const Json result = measure(*options);
    if (options->json) {
      std::cout << result.dump(2) << '\n';
    } else {
      print_for_people(result, options->scale);
    }
  });
}

}  // namespace cli
