#include "follow.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "facts.h"
#include "failure.h"
#include "files.h"
#include "motion.h"
#include "progress.h"
#include "statistics.h"
#include "text.h"

namespace cli {
namespace {

const std::vector<std::string> kFreeForces = {":fx", ":fy", ":fz", ":tx", ":ty", ":tz"};

// A column for each degree of freedom, called after its joint.
std::vector<std::string> force_names(const mimo::Env& env) {
  std::vector<std::string> names;
  for (const std::int32_t joint : env.ids(MIMO_JOINT)) {
    const std::size_t width = env.width(MIMO_JOINT_VELOCITY, {joint});
    for (std::size_t i = 0; i < width; ++i) {
      names.push_back(joint_label(env, joint) + (width == 1 ? "" : kFreeForces[i + (width == 3 ? 3 : 0)]));
    }
  }
  return names;
}

class Follow {
 public:
  explicit Follow(const FollowOptions& options)
      : options_(options),
        env_(open_world(options.world, make_env_config())),
        block_(env_.make_block()),
        motion_(options.motion, options.degrees, env_),
        names_(force_names(env_)) {
    for (const mimo_field& field : env_.layout().fields()) statistics_.emplace_back(field);
  }

  void play();
  void write_forces() const;
  void report() const;

 private:
  std::vector<double> largest_forces() const;

  const FollowOptions& options_;
  mimo::Env env_;
  mimo::Block block_;
  Motion motion_;
  std::vector<std::string> names_;
  std::vector<FieldStatistics> statistics_;
  std::vector<double> forces_;  // of all degrees of freedom, physics step after physics step
  std::size_t steps_ = 0;
};

void Follow::play() {
  const double tick = env_.timestep();
  const std::size_t skip = env_.frame_skip();
  // A whole number of steps; a file of one row is a pose that is held for one.
  const double whole = std::floor(motion_.seconds() / (tick * static_cast<double>(skip)) + 1e-9);
  const auto steps = static_cast<std::size_t>(std::max(1.0, whole));
  env_.reset(options_.world.seed, block_);
  env_.set_values(MIMO_JOINT_POSITION, env_.ids(MIMO_JOINT), motion_.positions(0));
  env_.set_values(MIMO_JOINT_VELOCITY, env_.ids(MIMO_JOINT), motion_.velocities(env_, 0));
  Progress progress(steps);
  for (; steps_ < steps; ++steps_) {
    std::vector<double> positions;
    for (std::size_t i = 1; i <= skip; ++i) {
      const std::vector<double> next = motion_.positions(tick * static_cast<double>(steps_ * skip + i));
      positions.insert(positions.end(), next.begin(), next.end());
    }
    const std::vector<double> forces = env_.follow(positions, block_);
    forces_.insert(forces_.end(), forces.begin(), forces.end());
    for (FieldStatistics& field : statistics_) field.add(block_);
    progress.show(steps_ + 1);
  }
}

void Follow::write_forces() const {
  std::ofstream file(options_.forces);
  file << "time";
  for (const std::string& name : names_) file << "," << name;
  for (std::size_t row = 0; row * names_.size() < forces_.size(); ++row) {
    file << text("\n%.9g", env_.timestep() * static_cast<double>(row));
    for (std::size_t i = 0; i < names_.size(); ++i) file << text(",%.9g", forces_[row * names_.size() + i]);
  }
  file << "\n";
  file.close();
  if (!file) throw Failure("cannot write " + options_.forces + ": " + std::strerror(errno));
}

std::vector<double> Follow::largest_forces() const {
  std::vector<double> largest(names_.size(), 0);
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    double& most = largest[i % names_.size()];
    most = std::max(most, std::abs(forces_[i]));
  }
  return largest;
}

void Follow::report() const {
  const std::vector<std::string> beyond = motion_.beyond_limits(env_);
  const std::vector<double> largest = largest_forces();
  const double seconds = env_.timestep() * static_cast<double>(steps_ * env_.frame_skip());
  if (options_.json) {
    nlohmann::ordered_json forces = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < names_.size(); ++i) forces[names_[i]] = largest[i];
    nlohmann::ordered_json senses = nlohmann::ordered_json::object();
    for (const FieldStatistics& field : statistics_) {
      senses[field.field().name] = {{"min", field.min()}, {"mean", field.mean()}, {"max", field.max()}};
    }
    const nlohmann::ordered_json json = {{"seconds", seconds}, {"steps", steps_},          {"rows", motion_.rows()},
                                         {"senses", senses},   {"largest_forces", forces}, {"beyond_limits", beyond}};
    std::cout << json.dump(2) << "\n";
    return;
  }
  std::cout << text("%g s in %zu steps, from %zu rows of %s\n\nsenses over all steps\n", seconds, steps_,
                    motion_.rows(), options_.motion.c_str());
  Table senses(2);
  senses.add({"field", "unit", "min", "mean", "max"});
  for (const FieldStatistics& field : statistics_) {
    senses.add({field.field().name, or_dash(field.field().unit), text("%.4g", field.min()), text("%.4g", field.mean()),
                text("%.4g", field.max())});
  }
  senses.print(std::cout);
  const auto most = std::max_element(largest.begin(), largest.end()) - largest.begin();
  std::cout << text("\nlargest force or torque: %.4g at %s\n", largest[static_cast<std::size_t>(most)],
                    names_[static_cast<std::size_t>(most)].c_str());
  for (const std::string& joint : beyond) std::cout << "beyond its limits: " << joint << "\n";
}

}  // namespace

CLI::Option* add_follow_options(CLI::App& command, FollowOptions& options) {
  const auto before = command.get_options().size();
  add_seed_option(command, options.world);
  command
      .add_option("--forces", options.forces, "Also write the forces and torques that it takes, one row a physics step")
      ->type_name("FILE.csv");
  command.add_flag("--degrees", options.degrees, "Angles of the table are degrees");
  const auto added = command.get_options();
  CLI::Option* motion =
      command
          .add_option("--motion", options.motion,
                      "Instead of a recording: a table of joint positions that a scene's infant follows")
          ->type_name("FILE.csv");
  for (std::size_t i = before; i < added.size(); ++i)
    command.get_option("--" + added[i]->get_single_name())->needs(motion);
  return motion;
}

void follow(const FollowOptions& options) {
  if (!options.forces.empty()) require_writable(options.forces);
  Follow run(options);
  run.play();
  if (!options.forces.empty()) run.write_forces();
  run.report();
  std::cout.flush();
}

}  // namespace cli
