#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "motion/movement.h"
#include "motion/retarget.h"
#include "programs/joints.h"
#include "programs/program.h"

namespace cli {
namespace {

constexpr double kPerMetre = 10;  // rad that a metre counts as

Eigen::Quaterniond turn(const Eigen::Vector3d& axis_angle) {
  const double angle = axis_angle.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis_angle / angle));
}

std::size_t rows_seen(const BodyTrack& track) {
  if (track.seen.empty()) return track.positions.size();
  return static_cast<std::size_t>(std::count(track.seen.begin(), track.seen.end(), true));
}

class Fit {
 public:
  Fit(const Movement& movement, mimo::Env& env);
  void run();
  void add_tracks(Movement& movement) const;
  std::vector<PoseError> errors() const { return errors_; }

 private:
  struct Attempt {
    std::vector<double> positions;
    double cost;
  };

  Eigen::Index take_rows(Eigen::Index count);
  void choose_joints();
  void take_known(std::size_t row, std::vector<double>& positions) const;
  Eigen::VectorXd differences(std::size_t row, const std::vector<double>& positions);
  Eigen::MatrixXd jacobian(const std::vector<double>& positions);
  Eigen::VectorXd movements(const std::vector<double>& velocities) const;
  std::vector<double> moved(std::vector<double> positions, const Eigen::VectorXd& by) const;
  Attempt solve(std::size_t row, std::vector<double> start);
  Attempt solve_first();
  Attempt solve_next(std::size_t row);
  std::vector<double> middle_of_ranges(std::vector<double> positions) const;
  double beyond_limits(std::size_t joint, const std::vector<double>& positions) const;  // rad, with its sign
  double beyond_limits(const std::vector<double>& positions) const;                     // of all
  void note(std::size_t row, const std::vector<double>& positions);

  const Movement& movement_;
  mimo::Env& env_;
  std::vector<Joint> joints_;                  // that are looked for
  std::vector<std::array<double, 2>> ranges_;  // of each, or infinite
  std::vector<Eigen::Vector3d> pointers_;      // of each body, where it points now
  std::vector<Eigen::Vector3d> arms_;          // and where its point lies from its origin
  std::vector<bool> seen_;                     // and whether that is known in this row
  Eigen::Index freedom_ = 0, values_ = 0;
  // Rows of differences: of each body's orientation and place, and of the joints' limits; -1 where there are none.
  std::vector<Eigen::Index> turns_at_, places_at_;
  Eigen::Index limits_at_ = -1;
  std::vector<std::int32_t> all_, bodies_;
  std::vector<std::vector<double>> rows_;
  std::vector<PoseError> errors_;
};

Fit::Fit(const Movement& movement, mimo::Env& env) : movement_(movement), env_(env), all_(env.ids(MIMO_JOINT)) {
  for (const BodyTrack& track : movement.bodies) {
    bodies_.push_back(track.body);
    turns_at_.push_back(track.orientations.empty() ? -1 : take_rows(3));
    places_at_.push_back(track.positions.empty() ? -1 : take_rows(3));
    errors_.push_back({track.body, track.point});
  }
  choose_joints();
  pointers_.resize(bodies_.size());
  arms_.resize(bodies_.size());
  seen_.resize(bodies_.size());
  if (movement.of_another) limits_at_ = take_rows(static_cast<Eigen::Index>(joints_.size()));
}

Eigen::Index Fit::take_rows(Eigen::Index count) {
  values_ += count;
  return values_ - count;
}

// Joints on the ways from told bodies to the world, but those whose position is told itself.
void Fit::choose_joints() {
  std::set<std::int32_t> moved;
  for (std::int32_t body : bodies_) {
    for (; body != 0; body = env_.body_of(MIMO_BODY, body)) moved.insert(body);
  }
  for (const Joint& joint : joints_of(env_)) {
    const auto told = movement_.joints.lower_bound(joint.place);
    if (told != movement_.joints.end() && told->first < joint.place + joint.width) continue;
    if (moved.count(env_.body_of(MIMO_JOINT, joint.id)) == 0) continue;
    joints_.push_back(joint);
    freedom_ += static_cast<Eigen::Index>(joint.freedom);
    ranges_.push_back({-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()});
    if (joint.width != 1) continue;
    const std::vector<double> range = env_.get_values(MIMO_JOINT_RANGE, {joint.id});
    ranges_.back() = {range[0], range[1]};
  }
}

void Fit::take_known(std::size_t row, std::vector<double>& positions) const {
  for (const auto& [place, track] : movement_.joints) positions[place] = track.values[row];
}

// From where bodies are to where they are told to be.
Eigen::VectorXd Fit::differences(std::size_t row, const std::vector<double>& positions) {
  env_.set_values(MIMO_JOINT_POSITION, all_, positions);
  const std::vector<double> poses = env_.get_values(MIMO_BODY_POSE | MIMO_NOW, bodies_);
  Eigen::VectorXd all(values_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyTrack& told = movement_.bodies[i];
    const double* pose = &poses[7 * i];
    if (turns_at_[i] >= 0) {
      const Eigen::Quaterniond now(pose[3], pose[4], pose[5], pose[6]);
      const Eigen::Quaterniond& wanted = told.orientations[row];
      pointers_[i] = now * told.pointer;
      const bool whole = told.pointer.isZero();
      all.segment<3>(turns_at_[i]) = rotation_vector(
          whole ? wanted * now.conjugate() : Eigen::Quaterniond::FromTwoVectors(pointers_[i], wanted * told.pointer));
    }
    if (places_at_[i] >= 0) {
      arms_[i] = Eigen::Quaterniond(pose[3], pose[4], pose[5], pose[6]) * told.offset;
      seen_[i] = told.seen.empty() || told.seen[row];
      const Eigen::Vector3d now = Eigen::Vector3d(pose[0], pose[1], pose[2]) + arms_[i];
      all.segment<3>(places_at_[i]) = (seen_[i] ? kPerMetre : 0) * (told.positions[row] - now);
    }
  }
  for (std::size_t i = 0; limits_at_ >= 0 && i < joints_.size(); ++i) {
    all[limits_at_ + static_cast<Eigen::Index>(i)] = -beyond_limits(i, positions);
  }
  return all;
}

// How bodies move where one joint after the other moves at speed 1: exact, and as the model has its joints. The world
// is where `differences` was asked for.
Eigen::MatrixXd Fit::jacobian(const std::vector<double>& positions) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(values_, freedom_);
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    if (limits_at_ >= 0 && beyond_limits(i, positions) != 0) {
      all(limits_at_ + static_cast<Eigen::Index>(i), column) = 1;
    }
    for (std::size_t axis = 0; axis < joint.freedom; ++axis, ++column) {
      std::vector<double> speed(joint.freedom, 0);
      speed[axis] = 1;
      env_.set_values(MIMO_JOINT_VELOCITY, {joint.id}, speed);
      all.col(column) += movements(env_.get_values(MIMO_BODY_VELOCITY | MIMO_NOW, bodies_));
    }
    env_.set_values(MIMO_JOINT_VELOCITY, {joint.id}, std::vector<double>(joint.freedom, 0));
  }
  return all;
}

// Velocities of the bodies as changes of the differences; limits are left at 0.
Eigen::VectorXd Fit::movements(const std::vector<double>& velocities) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(values_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Eigen::Map<const Eigen::Vector3d> linear(&velocities[6 * i]), angular(&velocities[6 * i + 3]);
    if (turns_at_[i] >= 0) {
      all.segment<3>(turns_at_[i]) = angular - pointers_[i].dot(angular) * pointers_[i];
    }
    if (places_at_[i] >= 0 && seen_[i]) {
      all.segment<3>(places_at_[i]) = kPerMetre * (linear + angular.cross(arms_[i]));
    }
  }
  return all;
}

std::vector<double> Fit::moved(std::vector<double> positions, const Eigen::VectorXd& by) const {
  Eigen::Index at = 0;
  for (const Joint& joint : joints_) {
    for (std::size_t i = 0; i < joint.linear(); ++i) {
      positions[joint.place + i] += by[at + static_cast<Eigen::Index>(i)];
    }
    at += static_cast<Eigen::Index>(joint.freedom);
    if (!joint.turns()) continue;
    double* q = &positions[joint.quaternion()];
    const Eigen::Quaterniond next =
        (Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * turn(by.segment<3>(at - 3))).normalized();
    q[0] = next.w();
    q[1] = next.x();
    q[2] = next.y();
    q[3] = next.z();
  }
  return positions;
}

// Levenberg and Marquardt's way: joints that the poses say nothing about stay where they are.
Fit::Attempt Fit::solve(std::size_t row, std::vector<double> start) {
  constexpr double kLeast = 1e-12, kMost = 1e8;
  take_known(row, start);
  Attempt best{std::move(start), 0};
  Eigen::VectorXd difference = differences(row, best.positions);
  best.cost = difference.squaredNorm();
  double damping = 1e-3;
  for (int round = 0; round < 100 && best.cost > 1e-28 && damping < kMost; ++round) {
    const Eigen::MatrixXd slopes = jacobian(best.positions);
    const Eigen::MatrixXd square = slopes.transpose() * slopes;
    const Eigen::VectorXd downhill = slopes.transpose() * difference;
    bool better = false;
    double step_length = 0;
    while (!better && damping < kMost) {
      Eigen::MatrixXd damped = square;
      damped.diagonal() += damping * (square.diagonal().array() + 1e-6).matrix();
      const Eigen::VectorXd step = damped.ldlt().solve(downhill);
      std::vector<double> tried = moved(best.positions, step);
      const Eigen::VectorXd left = differences(row, tried);
      better = left.squaredNorm() < best.cost;
      if (!better) {
        damping *= 10;
        continue;
      }
      best = {std::move(tried), left.squaredNorm()};
      difference = left;
      step_length = step.norm();
      damping = std::max(kLeast, damping / 10);
    }
    if (step_length < 1e-11) break;
  }
  return best;
}

std::vector<double> Fit::middle_of_ranges(std::vector<double> positions) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const double middle = (ranges_[i][0] + ranges_[i][1]) / 2;
    if (std::isfinite(middle)) positions[joints_[i].place] = middle;
  }
  return positions;
}

double Fit::beyond_limits(std::size_t joint, const std::vector<double>& positions) const {
  const double at = positions[joints_[joint].place];
  return std::max(0.0, at - ranges_[joint][1]) + std::min(0.0, at - ranges_[joint][0]);
}

double Fit::beyond_limits(const std::vector<double>& positions) const {
  double beyond = 0;
  for (std::size_t i = 0; i < joints_.size(); ++i) beyond += std::abs(beyond_limits(i, positions));
  return beyond;
}

// The same orientation can be reached by several sets of angles: that within the limits is meant, and rows that follow
// start at the one before.
Fit::Attempt Fit::solve_first() {
  Attempt best = solve(0, env_.get_values(MIMO_JOINT_POSITION, all_));
  if (best.cost < 1e-16 && beyond_limits(best.positions) == 0) return best;
  Attempt other = solve(0, middle_of_ranges(best.positions));
  const double slack = 1e-9;
  const bool as_near = other.cost < best.cost + slack && other.cost > best.cost - slack;
  const bool better = as_near ? beyond_limits(other.positions) < beyond_limits(best.positions) : other.cost < best.cost;
  return better ? other : best;
}

// A straight elbow does not feel how its upper arm is turned, so a forearm that is bent out of the plane of the row
// before may not be followed from there.
Fit::Attempt Fit::solve_next(std::size_t row) {
  constexpr double kWell = 0.01;  // a tenth of a radian, or a centimetre, in all
  Attempt next = solve(row, rows_.back());
  if (next.cost < kWell) return next;
  Attempt other = solve(row, middle_of_ranges(rows_.back()));
  return other.cost < next.cost / 2 ? other : next;
}

void Fit::note(std::size_t row, const std::vector<double>& positions) {
  const double share = 1.0 / static_cast<double>(movement_.times.size());
  const Eigen::VectorXd left = differences(row, positions);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    PoseError& error = errors_[i];
    if (turns_at_[i] >= 0) {
      const double angle = left.segment<3>(turns_at_[i]).norm();
      error.angle_largest = std::max(error.angle_largest, angle);
      error.angle_mean += share * angle;
    }
    if (places_at_[i] >= 0) {
      const double distance = left.segment<3>(places_at_[i]).norm() / kPerMetre;
      error.distance_largest = std::max(error.distance_largest, distance);
      error.distance_mean += distance / static_cast<double>(rows_seen(movement_.bodies[i]));
    }
  }
}

void Fit::run() {
  const std::size_t rows = movement_.times.size();
  Progress progress(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    rows_.push_back(row == 0 ? solve_first().positions : solve_next(row).positions);
    note(row, rows_.back());
    progress.show(row + 1);
  }
}

void Fit::add_tracks(Movement& movement) const {
  for (const Joint& joint : joints_) {
    for (std::size_t place = joint.place; place < joint.place + joint.width; ++place) {
      JointTrack& track = movement.joints[place];
      track.hinge = joint.width == 1 ? joint.id : -1;
      for (const std::vector<double>& row : rows_) track.values.push_back(row[place]);
    }
  }
}

}  // namespace

std::vector<PoseError> fit_poses(Movement& movement, mimo::Env& env) {
  if (movement.bodies.empty()) return {};
  Fit fit(movement, env);
  fit.run();
  fit.add_tracks(movement);
  return fit.errors();
}

}  // namespace cli
