// mimo record: random or learned movements, kept in a file that can be played again.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/chosen_actions.h"
#include "cli/commands.h"
#include "cli/episode.h"
#include "cli/recorded_world.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

struct RecordOptions {
  WorldOptions world;
  RecorderOptions recorder;
  ActionOptions actions;
  double seconds = 10;
};

void record(const RecordOptions& options) {
  require_writable(options.recorder.out);
  mimo::Env env = open_world(options.world, make_env_config());
  mimo::Block block = env.make_block();
  mimo::Results results = env.make_results();
  const double dt = env.timestep() * env.frame_skip();
  const auto steps = steps_in(options.seconds, dt);
  ChosenActions actions(env, options.actions, options.world.seed);
  Episode episode;
  env.reset(options.world.seed, block);
  const Interrupt interrupt;
  mimo::Recorder recorder = open_recorder(env, options.recorder, options.world.seed);
  std::size_t done = 0;
  {
    Progress progress(steps);
    while (done < steps && !(actions.learned() && episode.over()) && !Interrupt::requested()) {
      env.step(actions.next(block), block, results);
      episode.add(results, env.time());
      progress.show(++done);
    }
  }
  recorder.close();
  std::cout << text("%g s in %zu steps: %s\n", dt * static_cast<double>(done), done, options.recorder.out.c_str());
  std::cout.flush();
  if (Interrupt::requested()) Interrupt::pass_on();
}

}  // namespace

void add_record(CLI::App& program) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command =
      program.add_subcommand("record", "Move at random or as learned, and keep the run in a file to play again");
  add_recorded_options(*command, options->world);
  add_seed_option(*command, options->world);
  add_seconds_option(*command, options->seconds);
  add_action_options(*command, options->actions);
  add_recorder_options(*command, options->recorder)->required();
  command->footer(
      "Writes an HDF5 file, which MATLAB, Python, R and Julia read: actions, joints, rewards and the chosen fields of\n"
      "each step, a state every now and then, and the world itself. A run that is killed leaves all that was flushed. "
      "Ctrl-C ends "
      "early.\n"
      "Examples:\n"
      "  mimo record --seconds 60 --seed 7 --out run.h5\n"
      "  mimo record --scene reach --keep all --out run.h5\n"
      "  mimo record --policy reach.json --out run.h5");
  command->callback([options, command] {
    follow_policy(*command, options->actions, options->world);
    record(*options);
  });
}

}  // namespace cli
