#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/recorded_world.h"
#include "motion/markers.h"
#include "motion/motion.h"
#include "motion/movement.h"
#include "motion/retarget.h"
#include "motion/size.h"
#include "programs/csv.h"
#include "programs/files.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"

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

// A slip of the unit of time would be followed for years.
void require_short(const Movement& movement) {
  constexpr double kDay = 24 * 60 * 60;
  const double seconds = movement.times.back() - movement.times.front();
  if (seconds <= kDay) return;
  throw Failure(movement.source + text(": the movement takes %.6g s, expected at most a day (%.0f s)", seconds, kDay));
}

// Points of somebody whose age nobody gave tell that, too.
struct Sized {
  FollowOptions options;
  std::optional<Markers> points;
  std::optional<FoundAge> age;
};

Sized sized(const FollowOptions& options) {
  Sized it{options, {}, {}};
  const RetargetOptions& skeleton = options.skeleton;
  if (!has_points(options.motion)) {
    if (!skeleton.camera.empty()) throw Failure("--camera: " + options.motion + " has no points in pixels");
    if (skeleton.rate > 0) throw Failure("--rate: " + options.motion + " has times itself");
    if (skeleton.robust) throw Failure("--robust has no effect on joints and poses of bodies");
    if (!options.errors.empty()) throw Failure("--errors: " + options.motion + " has no points");
    return it;
  }
  if (options.degrees) throw Failure("--degrees has no effect on points");
  it.points = read_points(options.motion, skeleton);
  if (!is_age_open(options.world)) return it;
  it.age = fit_age(*it.points, skeleton, options.world);
  it.options.world.age.age = it.age->months;
  return it;
}

Movement read(const Sized& sized, mimo::Env& env) {
  const FollowOptions& options = sized.options;
  const auto from_file = [&] {
    if (has_ending(options.motion, ".bvh")) return read_skeleton(options.motion, options.skeleton, env);
    if (!sized.points) return read_movement(options.motion, options.degrees, env);
    Movement movement = point_movement(*sized.points, options.skeleton, env);
    if (sized.age) movement.notes.insert(movement.notes.begin(), sized.age->note);
    return movement;
  };
  Movement movement = from_file();
  require_short(movement);
  return movement;
}

// As the table of a movement calls them.
std::vector<std::string> position_names(const mimo::Env& env) {
  std::vector<std::string> names;
  for (const Joint& joint : joints_of(env)) {
    for (std::size_t i = 0; i < joint.width; ++i) {
      names.push_back(joint_label(env, joint.id) +
                      (joint.width == 1 ? "" : std::string(":") + kPoseParts[i + 7 - joint.width]));
    }
  }
  return names;
}

std::string name_of(const PoseError& error, const mimo::Env& env) {
  return error.point.empty() ? env.name(MIMO_BODY, error.body) : error.point;
}

// Of all points in all rows; m or pixels.
double root_mean_square(const std::vector<PoseError>& errors) {
  double squares = 0, count = 0;
  for (const PoseError& error : errors) {
    for (const double distance : error.distances) {
      if (std::isnan(distance)) continue;
      squares += distance * distance;
      count += 1;
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

nlohmann::ordered_json to_json(const std::vector<PoseError>& errors, bool in_pixels, const mimo::Env& env) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const PoseError& error : errors) {
    nlohmann::ordered_json& it = json[name_of(error, env)];
    if (in_pixels) {
      it = {{"pixels_largest", error.distance_largest}, {"pixels_mean", error.distance_mean}};
    } else {
      it = {{"angle_largest", error.angle_largest},
            {"angle_mean", error.angle_mean},
            {"distance_largest", error.distance_largest},
            {"distance_mean", error.distance_mean}};
    }
  }
  return json;
}

void print(const std::vector<PoseError>& errors, bool in_pixels, const mimo::Env& env) {
  std::cout << "\nfrom where bodies were told to be, at most and on average\n";
  Table table(1);
  table.add({"body", "angle", "mean", "distance", "mean"});
  const auto distance = [&](double it) { return in_pixels ? text("%.3g px", it) : text("%.3g mm", 1000 * it); };
  for (const PoseError& error : errors) {
    table.add({name_of(error, env), text("%.3g deg", error.angle_largest / kDegree),
               text("%.3g deg", error.angle_mean / kDegree), distance(error.distance_largest),
               distance(error.distance_mean)});
  }
  table.print(std::cout);
}

class Follow {
 public:
  explicit Follow(const Sized& sized)
      : options_(sized.options),
        age_(sized.age),
        env_(open_world(options_.world, make_env_config())),
        block_(env_.make_block()),
        movement_(read(sized, env_)),
        errors_(fit_poses(movement_, env_)),
        motion_(movement_, env_, options_.cutoff),
        names_(force_names(env_)) {
    for (const mimo_field& field : env_.layout().fields()) statistics_.emplace_back(field);
  }

  void play(const RecorderOptions& recording);
  void write_forces() const;
  void write_joints() const;
  void write_errors() const;
  void report() const;

 private:
  std::vector<double> largest_forces() const;

  const FollowOptions& options_;
  std::optional<FoundAge> age_;
  mimo::Env env_;
  mimo::Block block_;
  Movement movement_;
  std::vector<PoseError> errors_;
  Motion motion_;
  std::vector<std::string> names_;
  std::vector<FieldStatistics> statistics_;
  std::vector<double> forces_;  // of all degrees of freedom, physics step after physics step
  std::size_t steps_ = 0;
};

void Follow::play(const RecorderOptions& recording) {
  const double tick = env_.timestep();
  const std::size_t skip = env_.frame_skip();
  // A whole number of steps; a file of one row is a pose that is held for one.
  const double whole = std::floor(motion_.seconds() / (tick * static_cast<double>(skip)) + 1e-9);
  const auto steps = static_cast<std::size_t>(std::max(1.0, whole));
  env_.reset(options_.world.seed, block_);
  env_.set_values(MIMO_JOINT_POSITION, env_.ids(MIMO_JOINT), motion_.positions(0));
  env_.set_values(MIMO_JOINT_VELOCITY, env_.ids(MIMO_JOINT), motion_.velocities(env_, 0));
  std::optional<mimo::Recorder> recorder;
  if (!recording.out.empty()) recorder.emplace(open_recorder(env_, recording, options_.world.seed));
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
  if (recorder) recorder->close();
}

void Follow::write_forces() const {
  NumberTable table{names_, {}};
  table.names.insert(table.names.begin(), "time");
  for (auto row = forces_.begin(); row != forces_.end(); row += static_cast<std::ptrdiff_t>(names_.size())) {
    table.rows.push_back({env_.timestep() * static_cast<double>(table.rows.size())});
    table.rows.back().insert(table.rows.back().end(), row, row + static_cast<std::ptrdiff_t>(names_.size()));
  }
  write_numbers(options_.forces, table, 9);
}

// A row for each of the file, to the last digit.
void Follow::write_joints() const {
  NumberTable table{position_names(env_), {}};
  table.names.insert(table.names.begin(), "time");
  for (const double time : movement_.times) {
    table.rows.push_back(motion_.positions(time - movement_.times.front()));
    table.rows.back().insert(table.rows.back().begin(), time);
  }
  write_numbers(options_.joints, table, 17);
}

// A row for each of the file; empty where a point was not seen.
void Follow::write_errors() const {
  std::string table = "time";
  for (const PoseError& error : errors_) table += ',' + name_of(error, env_);
  for (std::size_t row = 0; row < movement_.times.size(); ++row) {
    table += text("\n%.17g", movement_.times[row]);
    for (const PoseError& error : errors_) {
      table += std::isnan(error.distances[row]) ? "," : text(",%.9g", error.distances[row]);
    }
  }
  write_file(options_.errors, table + '\n');
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
    nlohmann::ordered_json json = {{"seconds", seconds},
                                   {"steps", steps_},
                                   {"rows", motion_.rows()},
                                   {"senses", senses},
                                   {"largest_forces", forces},
                                   {"beyond_limits", beyond},
                                   {"pose_errors", to_json(errors_, movement_.camera.has_value(), env_)},
                                   {"notes", movement_.notes}};
    if (movement_.of_points) {
      json["points_rms"] = root_mean_square(errors_);
      json["fitted_age"] = age_ ? nlohmann::ordered_json(age_->months) : nlohmann::ordered_json();
    }
    std::cout << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
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
  const bool in_pixels = movement_.camera.has_value();
  if (!errors_.empty()) print(errors_, in_pixels, env_);
  if (movement_.of_points) {
    const double rms = root_mean_square(errors_);
    std::cout << (in_pixels ? text("all points: %.3g px rms\n", rms) : text("all points: %.3g mm rms\n", 1000 * rms));
  }
  const auto most = std::max_element(largest.begin(), largest.end()) - largest.begin();
  std::cout << text("\nlargest force or torque: %.4g at %s\n", largest[static_cast<std::size_t>(most)],
                    names_[static_cast<std::size_t>(most)].c_str());
  for (const std::string& joint : beyond) std::cout << "beyond its limits: " << joint << "\n";
  for (const std::string& note : movement_.notes) std::cout << one_line(note) << "\n";
}

}  // namespace

CLI::Option* add_follow_options(CLI::App& command, FollowOptions& options) {
  const auto before = command.get_options().size();
  add_seed_option(command, options.world);
  command
      .add_option("--forces", options.forces, "Also write the forces and torques that it takes, one row a physics step")
      ->type_name("FILE.csv");
  command
      .add_option("--joints", options.joints, "Also write the positions of all joints, one row a row of the movement")
      ->type_name("FILE.csv");
  command
      .add_option(
          "--errors", options.errors,
          "Also write how far each point is from where it was seen, m or pixels, one row a row\nof the movement")
      ->type_name("FILE.csv");
  command
      .add_option("--camera", options.skeleton.camera,
                  "Of points in pixels: JSON with matrix, or fovy, width, height or fx, fy, cx, cy,\nand position, "
                  "look_at. Default: of MINI-RGBD, a metre above the infant")
      ->type_name("FILE.json");
  command.add_option("--rate", options.skeleton.rate, "Frames a second, of DeepLabCut, OpenPose and MINI-RGBD")
      ->type_name("HZ")
      ->check(number(1e-3, 1e6));
  command.add_flag("--robust", options.skeleton.robust, "Give less weight to points that are far off");
  command
      .add_option("--cutoff", options.cutoff,
                  "Filter the movement: remove what is faster; 6 is usual. Default: no filter")
      ->type_name("HZ")
      ->check(number(1e-3, 1e6));
  command.add_flag("--degrees", options.degrees, "Angles of the table are degrees");
  command
      .add_option("--map", options.skeleton.map,
                  "BVH: lines of joint,body; markers: of marker,point. Default: by usual names")
      ->type_name("FILE.csv");
  command
      .add_option("--scale", options.skeleton.scale,
                  "BVH: metres of its unit; markers: what lengths are multiplied with.\nDefault: so that legs or limbs "
                  "are as long as the infant's")
      ->type_name("M")
      ->check(number(1e-9, 1e9));
  command
      .add_option(
          "--up", options.skeleton.up,
          "Which axis of the file points up. Default: the one a BVH file's skeleton stands\nalong; z of markers")
      ->type_name("y|z")
      ->check(CLI::IsMember({"y", "z"}));
  command
      .add_option("--rest-frame", options.skeleton.rest_frame,
                  "BVH: the frame, from 0, in which the skeleton stands upright. Default: as its offsets have it")
      ->type_name("N")
      ->check(CLI::Range(0, 100000000));
  const auto added = command.get_options();
  CLI::Option* motion =
      command
          .add_option("--motion", options.motion,
                      "Instead of a recording: joint positions, poses of bodies, a skeleton, markers or key points,\n"
                      "which a scene's infant follows. A folder of OpenPose or MINI-RGBD, or a file")
          ->type_name("FILE.csv|bvh|c3d|trc|tsv");
  for (std::size_t i = before; i < added.size(); ++i)
    command.get_option("--" + added[i]->get_single_name())->needs(motion);
  return motion;
}

void follow(const FollowOptions& options, const RecorderOptions& recorder) {
  for (const std::string& file : {options.forces, options.joints, options.errors, recorder.out}) {
    if (!file.empty()) require_writable(file);
  }
  const Sized given = sized(options);
  Follow run(given);
  run.play(recorder);
  if (!options.forces.empty()) run.write_forces();
  if (!options.joints.empty()) run.write_joints();
  if (!options.errors.empty()) run.write_errors();
  run.report();
  std::cout.flush();
}

}  // namespace cli
