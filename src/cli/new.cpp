// mimo new: a folder to start a sense or a task of one's own from, which builds and passes its test as it is.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "programs/files.h"
#include "programs/program.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

// In the files @name@ stands for the name, and @Class@ for the class.
using Files = std::vector<std::pair<std::string, std::string>>;

const char* const kSense =
    R"(// The sense "@name@": how high the head is, and for how many physics steps the episode has gone on.
// docs/guide/write-a-sense.md explains each part.
#include <mimo/mimo.hpp>

namespace {

// What it remembers: plain numbers, zero at the start of an episode, part of the world's state.
struct Memory {
  double steps;
};

class @Class@ : public mimo::Sense {
 public:
  static std::vector<mimo_parameter> parameters() {
    return {mimo::sense_parameter("gain", "factor of the height, 1", 1, 0, 10)};
  }

  // Looks up ids and declares fields, once for each agent of a world.
  explicit @Class@(mimo::SenseOpening &opening) : head_(opening.world.find(MIMO_BODY, opening.own("head"))) {
    opening.add(mimo::SenseField("height", {}, "m", "world"));
    opening.add(mimo::SenseField("steps"));
    opening.memory_bytes = sizeof(Memory);
  }

  // After each physics step.
  void advance(const mimo::SenseMoment &now) const override { now.memory<Memory>().steps += 1; }

  // For an observation. It changes nothing but the fields.
  void write(const mimo::SenseMoment &now) const override {
    double position[3];
    mimo::check(mimo_env_get(now.world.get(), MIMO_BODY_POSITION, &head_, 1, position, 3));
    now.field(0)[0] = static_cast<float>(now.told.parameters[0] * position[2]);
    now.field(1)[0] = static_cast<float>(now.memory<Memory>().steps);
  }

 private:
  std::int32_t head_;
};

}  // namespace

MIMO_SENSE(mimo::sense<@Class@>("@name@"))
)";

const char* const kSenseTest =
    R"(// What "@name@" senses, compared with what the world says. Its argument is the shared library with the sense.
#include <mimo/mimo.hpp>

#include <cmath>
#include <cstdio>

static int failures = 0;

static void check(bool good, const char *what) {
  if (good) return;
  ++failures;
  std::printf("failed: %s\n", what);
}

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  mimo_scene_config room = mimo::scene_config();
  room.name = "free";
  mimo::Scene scene(room);
  mimo_agent_config infant = mimo::agent_config();
  infant.vision = 0;
  scene.add_agents(&infant);
  scene.load_sense(argv[1]);
  mimo::Env world(scene);
  mimo::Block block = world.make_block();
  const mimo::View<const float> height = block.view<float>(world.layout().field("@name@/height"));
  const mimo::View<const float> steps = block.view<float>(world.layout().field("@name@/steps"));
  world.reset(1, block);
  check(steps[0] == 0, "an episode starts with no step");
  for (int i = 1; i <= 3; ++i) {
    world.step({}, block);
    const double head = world.get_values(MIMO_BODY_POSITION, {world.find(MIMO_BODY, "head")})[2];
    check(std::fabs(height[0] - head) < 1e-6, "the head is as high as the world says");
    check(steps[0] == static_cast<float>(i * static_cast<int>(world.frame_skip())), "each physics step counts");
  }
  return failures;
}
)";

const char* const kSenseBuild = R"(cmake_minimum_required(VERSION 3.16)
project(@name@ LANGUAGES C CXX)
find_package(mimo 1.0 REQUIRED)

# The sense: a shared library, which mimo::Scene::load_sense and Scene.load_sense in Python load.
add_library(@name@ MODULE @name@.cpp)
set_target_properties(@name@ PROPERTIES PREFIX "" CXX_STANDARD 11)
target_link_libraries(@name@ PRIVATE mimo::mimo)

enable_testing()
add_executable(@name@_test test.cpp)
set_target_properties(@name@_test PROPERTIES CXX_STANDARD 11)
target_link_libraries(@name@_test PRIVATE mimo::mimo)
add_test(NAME @name@ COMMAND @name@_test $<TARGET_FILE:@name@>)
set_tests_properties(@name@ PROPERTIES ENVIRONMENT MIMO_CHECK_PLUGINS=1)
)";

const char* const kTask = R"(// The task "@name@": holding the head up. docs/tasks.md has the built-in ones.
#ifndef @name@_H
#define @name@_H

#include <mimo/mimo.hpp>

class @Class@ : public mimo::Task {
 public:
  // Numbers that each world and agent keeps, zero at the start of an episode, part of the world's state.
  struct Memory {
    double goal;
  };
  std::size_t memory_bytes() const override { return sizeof(Memory); }
  // What the infant is told beside its senses.
  std::vector<mimo::TaskField> fields() const override { return {mimo::TaskField("goal", {}, "m", "world")}; }

  // An episode starts: here the world may be changed, and random numbers drawn.
  void reset(mimo::Env &world, const mimo_task_moment &moment) override {
    const double goal = 0.1 + 0.1 * world.random(1)[0];
    static_cast<Memory *>(moment.memory)->goal = goal;
    moment.fields[0] = static_cast<float>(goal);
  }

  // A step is over: its reward, and whether the episode ends.
  void evaluate(mimo::Env &world, const mimo_task_moment &moment, mimo_task_verdict &verdict) override {
    const double head = world.get_values(MIMO_BODY_POSITION, {world.find(MIMO_BODY, "head")})[2];
    const double missing = static_cast<const Memory *>(moment.memory)->goal - head;
    verdict.reward = missing > 0 ? -missing : 0;
    if (missing <= 0) verdict.outcome = MIMO_OUTCOME_SUCCESS;
  }
};

#endif
)";

const char* const kTaskTest = R"(// What "@name@" rewards, compared with what the world says.
#include "@name@.h"

#include <cmath>
#include <cstdio>

static int failures = 0;

static void check(bool good, const char *what) {
  if (good) return;
  ++failures;
  std::printf("failed: %s\n", what);
}

int main() {
  mimo_scene_config room = mimo::scene_config();
  room.name = "free";
  mimo::Scene scene(room);
  mimo_agent_config infant = mimo::agent_config();
  infant.vision = 0;
  scene.add_agents(&infant);
  @Class@ task;
  scene.set_task(task);
  mimo::Env world(scene);
  mimo::Block block = world.make_block();
  const mimo::View<const float> goal = block.view<float>(world.layout().field("goal"));
  for (int episode = 0; episode < 3; ++episode) {
    world.reset(static_cast<std::uint64_t>(episode), block);
    check(goal[0] >= 0.1f && goal[0] <= 0.2f, "a goal was drawn");
    const mimo::Result result = world.step({}, block)[0];
    const double missing = goal[0] - world.get_values(MIMO_BODY_POSITION, {world.find(MIMO_BODY, "head")})[2];
    check(std::fabs(result.reward + (missing > 0 ? missing : 0)) < 1e-6, "the reward is what is missing");
    check((result.outcome == MIMO_OUTCOME_SUCCESS) == (missing <= 0), "success is a head that is held up");
  }
  return failures;
}
)";

const char* const kTaskBuild = R"(cmake_minimum_required(VERSION 3.16)
project(@name@ LANGUAGES C CXX)
find_package(mimo 1.0 REQUIRED)

enable_testing()
add_executable(@name@_test test.cpp @name@.h)
set_target_properties(@name@_test PROPERTIES CXX_STANDARD 11)
target_link_libraries(@name@_test PRIVATE mimo::mimo)
add_test(NAME @name@ COMMAND @name@_test)
)";

bool is_plain(const std::string& name) {
  const auto small = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto fits = [small](char c) { return small(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name.size() <= 63 && small(name[0]) && std::all_of(name.begin(), name.end(), fits);
}

// "warm_nose" is WarmNose.
std::string class_of(const std::string& name) {
  std::string made;
  bool first = true;
  for (const char c : name) {
    if (c != '_') made += first && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    first = c == '_';
  }
  return made;
}

std::string filled_in(std::string text, const std::string& name) {
  const std::pair<std::string, std::string> words[] = {{"@name@", name}, {"@Class@", class_of(name)}};
  for (const auto& [word, value] : words) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += value.size()) {
      text.replace(at, word.size(), value);
    }
  }
  return text;
}

// All of it, or nothing.
void write_folder(const std::string& name, const Files& files) {
  if (!is_plain(name)) {
    throw Failure("NAME is \"" + name + "\", expected lower-case letters, digits and _, with a letter first");
  }
  std::error_code error;
  if (fs::exists(fs::symlink_status(name, error))) throw Failure(name + " exists already and is not overwritten");
  if (!fs::create_directory(name, error)) throw Failure(name + " cannot be made: " + error.message());
  try {
    for (const auto& [file, text] : files) write_file(name + "/" + filled_in(file, name), filled_in(text, name));
  } catch (...) {
    fs::remove_all(name, error);
    throw;
  }
  std::cout << "wrote " << name << "/: " << filled_in(files[0].first, name) << ", test.cpp, CMakeLists.txt\n"
            << "  cmake -S " << name << " -B " << name << "/build && cmake --build " << name
            << "/build && ctest --test-dir " << name << "/build\n";
}

void add_kind(CLI::App& command, const char* kind, const char* about, Files files) {
  CLI::App& sub = *command.add_subcommand(kind, about);
  const auto name = std::make_shared<std::string>();
  sub.add_option("NAME", *name, "of the " + std::string(kind) + " and its folder: lower-case letters, digits and _")
      ->required();
  sub.callback([name, files = std::move(files)] { write_folder(*name, files); });
}

}  // namespace

void add_new(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("new", "Write a folder with a sense or a task of your own, and its test");
  command.require_subcommand(1);
  add_kind(command, "sense", "A sense: a shared library that worlds load",
           {{"@name@.cpp", kSense}, {"test.cpp", kSenseTest}, {"CMakeLists.txt", kSenseBuild}});
  add_kind(command, "task", "A task: a class of a C++ program",
           {{"@name@.h", kTask}, {"test.cpp", kTaskTest}, {"CMakeLists.txt", kTaskBuild}});
  command.footer(
      "Example:\n"
      "  mimo new sense warm_nose         writes warm_nose/, which builds and passes its test");
}

}  // namespace cli
