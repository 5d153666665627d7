// mimo-bench: how fast the world steps, and what the same physics costs without it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/measurements.h"
#include "bench/timed_worlds.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"
#include "programs/world.h"

namespace cli {
namespace {

using Json = nlohmann::ordered_json;

struct BenchOptions {
  WorldOptions world;
  std::size_t steps = 1000;
  int worlds = 1, threads = 1;
  bool json = false;
  bool paper = false, brief = false;
  bool serve = false;
  std::string csv;
};

// The three worlds side by side. They take turns every few steps, so that a busy machine slows all alike.
class Bench {
 public:
  explicit Bench(const BenchOptions& options)
      : options_(options),
        full_(options.world, options.steps),
        raw_(options.world, MIMO_JACOBIAN_MODEL, options.steps),
        reference_(options.world.seed, options.steps),
        actions_(full_.env(), options.world.seed) {}

  void run();
  Json result() const;

 private:
  static constexpr std::size_t kTurn = 50;

  const BenchOptions& options_;
  SensingWorld full_;
  PhysicsWorld raw_;
  ReferenceStep reference_;
  RandomActions actions_;
};

void Bench::run() {
  const Actions first = draw(actions_, 1);
  full_.warm_up(first);
  raw_.warm_up(first);
  reference_.warm_up();

  Progress progress(options_.steps);
  for (std::size_t done = 0; done < options_.steps;) {
    const std::size_t turn = std::min(kTurn, options_.steps - done);
    const Actions actions = draw(actions_, turn);
    raw_.go_to(full_.env());
    full_.run(actions);
    raw_.run(actions);
    reference_.run(turn);
    progress.show(done += turn);
  }
}

Json split_of(const mimo::Env& env, double step_ms) {
  Json split = Json::object();
  for (const auto& [part, ms] : split_ms(env.timing(), step_ms)) split[part] = ms;
  return split;
}

// In microseconds; null where there was nothing to measure.
Json microseconds(const StepTimes& samples, double (StepTimes::*average)() const) {
  return samples.seconds().empty() ? Json() : Json((samples.*average)() * 1e6);
}

std::size_t pixels(const mimo::Env& env) {
  std::size_t count = 0;
  for (const mimo_field& field : env.layout().fields()) {
    if (std::string(field.name).find("vision/") != std::string::npos) count += field.shape[0] * field.shape[1];
  }
  return count;
}

Json Bench::result() const {
  const StepTimes &full = full_.times(), &raw = raw_.times(), &reference = reference_.times();
  const double steps = static_cast<double>(options_.steps);
  const double frame_skip = full_.env().frame_skip();
  const double simulated = steps * frame_skip * full_.env().timestep();
  const double step_ms = full.mean() * 1e3;
  const double allocations = static_cast<double>(AllocationCounter::counted()) / steps;
  return {{"steps", options_.steps},
          {"wall_s", full.sum()},
          {"realtime_factor", simulated / full.sum()},
          {"ms_per_step", step_ms},
          {"split_ms", split_of(full_.env(), step_ms)},
          {"agents", full_.env().layout().info().agents},
          {"degrees_of_freedom", full_.env().width(MIMO_JOINT_VELOCITY, full_.env().ids(MIMO_JOINT))},
          {"frame_skip", full_.env().frame_skip()},
          {"pixels", pixels(full_.env())},
          {"touch_sensors", touch_sensors(full_.env())},
          {"mean_contacts", static_cast<double>(full_.contacts()) / steps},
          {"raw_physics_us", raw.mean() * 1e6},
          {"reference_us", microseconds(reference, &StepTimes::mean)},
          {"step_vs_raw", full.mean() / (frame_skip * raw.mean())},
          {"allocations_per_step", AllocationCounter::countable() ? Json(allocations) : Json()},
          {"median",
           {{"ms_per_step", full.median() * 1e3},
            {"raw_physics_us", raw.median() * 1e6},
            {"reference_us", microseconds(reference, &StepTimes::median)},
            {"step_vs_raw", full.median() / (frame_skip * raw.median())}}}};
}

void print_for_people(const Json& result) {
  Table table(1);
  for (const auto& [key, value] : result.items()) {
    if (value.is_structured()) continue;
    table.add({key, value.is_number_float() ? text("%.4g", value.get<double>()) : value.dump()});
  }
  for (const char* group : {"split_ms", "median"}) {
    if (!result.contains(group)) continue;
    for (const auto& [key, value] : result[group].items()) {
      table.add({std::string(group) + " " + key, value.is_null() ? "null" : text("%.4g", value.get<double>())});
    }
  }
  table.print(std::cout);
}

Json run_one(const BenchOptions& options) {
  Bench bench(options);
  bench.run();
  return bench.result();
}

// The single world gives what is asked of one; what many give stands in place of its times.
Json run_many(const BenchOptions& options) {
  if (options.threads > options.worlds) throw Failure("--threads is more than --worlds: a world needs only one");
  BenchOptions single = options;
  single.steps = std::min<std::size_t>(options.steps, 500);
  Json result = run_one(single);
  result.erase("median");
  const auto counted = AllocationCounter::counted();
  ThreadScaling scaling(options.world, options.steps, options.worlds, options.threads);
  scaling.run();
  result["steps"] = options.steps;
  result.update(scaling.result());
  const double all = static_cast<double>(options.steps) * options.worlds;
  if (AllocationCounter::countable()) {
    result["allocations_per_step"] = static_cast<double>(AllocationCounter::counted() - counted) / all;
  }
  return result;
}

void describe(CLI::App& program) {
  auto options = std::make_shared<BenchOptions>();
  add_scene_options(program, options->world);
  options->world.actuation = "torque";
  add_actuation_option(program, options->world);
  add_vision_options(program, options->world);
  add_touch_option(program, options->world);
  add_senses_option(program, options->world);
  add_own_senses_option(program, options->world);
  add_parameter_option(program, options->world);
  program.add_option("--steps", options->steps, "Steps to measure, of two physics steps (10 ms) each")
      ->type_name("N")
      ->check(CLI::Range(1, 100000000).description(""))
      ->capture_default_str();
  program.add_option("--worlds", options->worlds, "Worlds at a time, as one batch; steps are those of each world")
      ->type_name("W")
      ->check(CLI::Range(1, 100000).description(""))
      ->capture_default_str();
  program.add_option("--threads", options->threads, "Threads that step them, at most one a world")
      ->type_name("T")
      ->check(CLI::Range(1, 4096).description(""))
      ->capture_default_str();
  add_seed_option(program, options->world);
  program.add_flag("--json", options->json, "Print one JSON object");
  program.add_flag("--serve-reference", options->serve)->group("");  // how the program calls itself
  CLI::Option* paper =
      program.add_flag("--paper", options->paper,
                       "The paper's Fig. 3: seven sizes of eyes and densities of touch, 60 episodes of a minute each");
  program.add_flag("--short", options->brief, "With --paper: one episode each")->needs(paper);
  program.add_option("--csv", options->csv, "With --paper: its table goes to this file as well")
      ->type_name("FILE")
      ->needs(paper);
  program.footer(
      "raw_physics_us is one mj_step of a twin of the world that follows the same trajectory; reference_us is one of\n"
      "the benchmark scene solved as the original does (dense Jacobian), on Debian's build of MuJoCo: null without "
      "it.\n"
      "All are measured in turns.\n"
      "step_vs_raw is a step's time over that of its bare physics steps.\n"
      "With several worlds ms_per_step is the time of one world's step on its thread; with several threads scaling is\n"
      "throughput over that of one thread, and raw_scaling the same for threads that do nothing but physics.\n"
      "Examples:\n"
      "  mimo-bench\n"
      "  mimo-bench --vision off --steps 5000 --json\n"
      "  mimo-bench --scene reach --worlds 64 --threads 2\n"
      "  mimo-bench --paper --short --csv paper.csv");
  program.callback([options] {
    if (options->serve) return serve_reference(options->world.seed);
    if (!options->csv.empty()) require_writable(options->csv);
    if (options->paper) return run_paper({options->world, options->brief, options->csv});
    const Json result = options->worlds > 1 || options->threads > 1 ? run_many(*options) : run_one(*options);
    if (options->json) {
      std::cout << result.dump(2) << '\n';
    } else {
      print_for_people(result);
    }
  });
}

}  // namespace
}  // namespace cli

int main(int argc, char** argv) {
  CLI::App program("Measures how fast the world steps", "mimo-bench");
  return cli::run_program(
      program, [&] { cli::describe(program); }, [] {}, argc, argv);
}
