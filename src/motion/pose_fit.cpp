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
#include "programs/summary.h"

namespace cli {
namespace {

constexpr double kPerMetre = 10;    // rad that a metre counts as
constexpr double kPerPixel = 0.02;  // and a pixel
// And a radian from the scene's pose, for what points hardly determine, as a picture does depth.
constexpr double kStiffness = 1e-3, kStiffnessInPictures = 3e-2;
constexpr double kUsual = 0.1;     // what errors of points are like; robust fits count those beyond less
constexpr double kNearest = 1e-3;  // m before a camera

Eigen::Quaterniond turn(const Eigen::Vector3d& axis_angle) {
  const double angle = axis_angle.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis_angle / angle));
}

double weight_of(const BodyTrack& track, std::size_t row) { return track.weights.empty() ? 1 : track.weights[row]; }

// The 24 ways to turn a cube.
std::vector<Eigen::Quaterniond> turns_of_cube() {
  std::vector<Eigen::Quaterniond> all;
  for (int face = 0; face < 6; ++face) {
    const Eigen::Vector3d axis = face < 4 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    const Eigen::Quaterniond tilt = turn((face < 4 ? face : 2 * face - 9) * kPi / 2 * axis);
    for (int quarter = 0; quarter < 4; ++quarter)
      all.push_back(turn(quarter * kPi / 2 * Eigen::Vector3d::UnitZ()) * tilt);
  }
  return all;
}

class Fit {
 public:
  Fit(const Movement& movement, mimo::Env& env);
  void run();
  double misfit(std::vector<std::vector<double>>& poses);
  void add_tracks(Movement& movement) const;
  std::vector<PoseError> errors() const { return errors_; }

 private:
  struct Attempt {
    std::vector<double> positions;
    double cost;
  };

  enum class Moves { kWhole, kJoints };  // the infant as a whole, or its joints as well

  Eigen::Index take_rows(Eigen::Index count);
  void choose_joints();
  void take_known(std::size_t row, std::vector<double>& positions) const;
  Eigen::VectorXd differences(std::size_t row, const std::vector<double>& positions);
  Eigen::MatrixXd jacobian(const std::vector<double>& positions, Moves moves);
  Eigen::VectorXd movements(const std::vector<double>& velocities) const;
  std::vector<double> moved(std::vector<double> positions, const Eigen::VectorXd& by) const;
  Attempt solve(std::size_t row, std::vector<double> start, Moves moves = Moves::kJoints);
  Attempt solve_first();
  Attempt solve_anywhere(std::size_t row);
  Eigen::Vector3d points_as_told(std::size_t row, const Eigen::Vector3d& from, double spread) const;
  std::vector<double> put_near(std::size_t row, std::vector<double> positions, const Eigen::Quaterniond& turned);
  void set_place(std::size_t body, std::size_t row, const double* pose, Eigen::VectorXd& all);
  std::size_t seen_in(std::size_t row) const;
  Attempt solve_next(std::size_t row);
  std::vector<double> middle_of_ranges(std::vector<double> positions) const;
  double beyond_limits(std::size_t joint, const std::vector<double>& positions) const;  // rad, with its sign
  double beyond_limits(const std::vector<double>& positions) const;                     // of all
  void note(std::size_t row, const std::vector<double>& positions);

  const Movement& movement_;
  mimo::Env& env_;
  std::vector<Joint> joints_;                   // that are looked for
  std::vector<std::array<double, 2>> ranges_;   // of each, or infinite
  std::vector<Eigen::Vector3d> pointers_;       // of each body, where it points now
  std::vector<Eigen::Vector3d> arms_, places_;  // where its point lies from its origin, and in the world
  std::vector<Eigen::Matrix3d> slopes_;         // of the differences of places by the point's place
  std::vector<double> apart_;                   // how far the point is from where it was told to be, m or pixels
  std::vector<double> rest_;                    // positions of the scene
  double stiffness_ = 0;
  const Joint* whole_ = nullptr;  // the joint that moves the whole infant
  Eigen::Index freedom_ = 0, values_ = 0;
  // Rows of differences: of each body's orientation and place, and of the joints' limits; -1 where there are none.
  std::vector<Eigen::Index> turns_at_, places_at_;
  Eigen::Index limits_at_ = -1, rest_at_ = -1;
  std::vector<std::int32_t> all_, bodies_;
  std::vector<std::vector<double>> rows_;
  std::vector<PoseError> errors_;
};

Fit::Fit(const Movement& movement, mimo::Env& env) : movement_(movement), env_(env), all_(env.ids(MIMO_JOINT)) {
  for (const BodyTrack& track : movement.bodies) {
    bodies_.push_back(track.body);
    turns_at_.push_back(track.orientations.empty() ? -1 : take_rows(3));
    places_at_.push_back(track.positions.empty() ? -1 : take_rows(3));
    errors_.emplace_back();
    errors_.back().body = track.body;
    errors_.back().point = track.point;
  }
  choose_joints();
  pointers_.resize(bodies_.size());
  arms_.resize(bodies_.size());
  places_.resize(bodies_.size());
  slopes_.resize(bodies_.size());
  apart_.resize(bodies_.size());
  rest_ = env.get_values(MIMO_JOINT_POSITION, all_);
  const auto count = static_cast<Eigen::Index>(joints_.size());
  if (movement.of_another) limits_at_ = take_rows(count);
  if (!movement.of_points) return;
  rest_at_ = take_rows(count);
  stiffness_ = movement.camera ? kStiffnessInPictures : kStiffness;
  const std::vector<std::int32_t> roots = infants(env);
  for (const Joint& joint : joints_) {
    if (joint.width == 7 && env.body_of(MIMO_JOINT, joint.id) == roots.at(0)) whole_ = &joint;
  }
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
    if (places_at_[i] >= 0) set_place(i, row, pose, all);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (limits_at_ >= 0) all[limits_at_ + at] = -beyond_limits(i, positions);
    if (rest_at_ < 0) continue;
    const std::size_t place = joints_[i].place;
    all[rest_at_ + at] = joints_[i].width == 1 ? stiffness_ * (rest_[place] - positions[place]) : 0;
  }
  return all;
}

// The difference of a point, and how it changes with the point's place. What lies behind the camera is far off,
// whatever its pixels are.
void Fit::set_place(std::size_t body, std::size_t row, const double* pose, Eigen::VectorXd& all) {
  const BodyTrack& told = movement_.bodies[body];
  arms_[body] = Eigen::Quaterniond(pose[3], pose[4], pose[5], pose[6]) * told.offset;
  places_[body] = Eigen::Vector3d(pose[0], pose[1], pose[2]) + arms_[body];
  Eigen::Vector3d difference = kPerMetre * (told.positions[row] - places_[body]);
  slopes_[body] = kPerMetre * Eigen::Matrix3d::Identity();
  apart_[body] = difference.norm() / kPerMetre;
  if (movement_.camera) {
    constexpr double kFarOff = 1e4;  // pixels
    const Camera& camera = *movement_.camera;
    const Eigen::Vector3d seen = camera * places_[body].homogeneous();
    const bool before = seen.z() > kNearest;
    const Eigen::Vector3d pixel = before ? Eigen::Vector3d(seen / seen.z()) : Eigen::Vector3d(kFarOff, kFarOff, 1);
    difference = kPerPixel * (told.positions[row] - pixel);
    difference.z() = 0;
    slopes_[body].setZero();
    if (before) {
      slopes_[body].topRows<2>() =
          kPerPixel / seen.z() * (camera.topLeftCorner<2, 3>() - pixel.head<2>() * camera.bottomLeftCorner<1, 3>());
    }
    apart_[body] = difference.norm() / kPerPixel;
  }
  const double root = std::sqrt(weight_of(told, row));
  difference *= root;
  slopes_[body] *= root;
  if (movement_.robust && root > 0) {  // 2 (sqrt(1 + z) - 1) in place of z
    const double z = difference.squaredNorm() / (kUsual * kUsual), less = std::sqrt(1 + z);
    const double share = std::sqrt(2 / (1 + less));  // of the difference that counts
    difference *= share;
    slopes_[body] *= 1 / (less * share);
  }
  all.segment<3>(places_at_[body]) = difference;
}

// How bodies move where one joint after the other moves at speed 1: exact, and as the model has its joints. The world
// is where `differences` was asked for.
Eigen::MatrixXd Fit::jacobian(const std::vector<double>& positions, Moves moves) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(values_, freedom_);
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    if (moves == Moves::kWhole && &joint != whole_) {
      column += static_cast<Eigen::Index>(joint.freedom);
      continue;
    }
    if (limits_at_ >= 0 && beyond_limits(i, positions) != 0) {
      all(limits_at_ + static_cast<Eigen::Index>(i), column) = 1;
    }
    if (rest_at_ >= 0 && joint.width == 1) all(rest_at_ + static_cast<Eigen::Index>(i), column) = stiffness_;
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

// Velocities of the bodies as changes of the differences; limits and the scene's pose are left at 0.
Eigen::VectorXd Fit::movements(const std::vector<double>& velocities) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(values_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Eigen::Map<const Eigen::Vector3d> linear(&velocities[6 * i]), angular(&velocities[6 * i + 3]);
    if (turns_at_[i] >= 0) {
      all.segment<3>(turns_at_[i]) = angular - pointers_[i].dot(angular) * pointers_[i];
    }
    if (places_at_[i] >= 0) all.segment<3>(places_at_[i]) = slopes_[i] * (linear + angular.cross(arms_[i]));
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
Fit::Attempt Fit::solve(std::size_t row, std::vector<double> start, Moves moves) {
  constexpr double kLeast = 1e-12, kMost = 1e8;
  take_known(row, start);
  Attempt best{std::move(start), 0};
  Eigen::VectorXd difference = differences(row, best.positions);
  best.cost = difference.squaredNorm();
  double damping = 1e-3;
  for (int round = 0; round < 100 && best.cost > 1e-28 && damping < kMost; ++round) {
    const Eigen::MatrixXd slopes = jacobian(best.positions, moves);
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
    if (step_length < (movement_.of_points ? 1e-6 : 1e-11)) break;  // points are no nearer to the truth
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
  if (whole_ != nullptr) {
    constexpr std::size_t kEnough = 6;  // points; where the first rows have fewer, they are fitted from a later one
    std::size_t best = 0;
    for (std::size_t row = 0; row < movement_.times.size() && seen_in(best) < kEnough; ++row) {
      if (seen_in(row) > seen_in(best)) best = row;
    }
    const Attempt found = solve_anywhere(best);
    return best == 0 ? found : solve(0, found.positions);
  }
  Attempt best = solve(0, env_.get_values(MIMO_JOINT_POSITION, all_));
  if (best.cost < 1e-16 && beyond_limits(best.positions) == 0) return best;
  Attempt other = solve(0, middle_of_ranges(best.positions));
  const double slack = 1e-9;
  const bool as_near = other.cost < best.cost + slack && other.cost > best.cost - slack;
  const bool better = as_near ? beyond_limits(other.positions) < beyond_limits(best.positions) : other.cost < best.cost;
  return better ? other : best;
}

std::size_t Fit::seen_in(std::size_t row) const {
  return static_cast<std::size_t>(
      std::count_if(movement_.bodies.begin(), movement_.bodies.end(),
                    [&](const BodyTrack& it) { return !it.positions.empty() && weight_of(it, row) > 0; }));
}

// The middle of what was told. A camera tells a direction: points that spread so many metres about their middle are
// where they take as many pixels as they did.
Eigen::Vector3d Fit::points_as_told(std::size_t row, const Eigen::Vector3d& from, double spread) const {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const double share = 1 / double(std::max<std::size_t>(1, seen_in(row)));
  const auto over_seen = [&](const auto& use) {
    for (const BodyTrack& it : movement_.bodies) {
      if (!it.positions.empty() && weight_of(it, row) > 0) use(it.positions[row]);
    }
  };
  over_seen([&](const Eigen::Vector3d& at) { middle += share * at; });
  if (!movement_.camera) return middle;
  double pixels = 0;
  over_seen([&](const Eigen::Vector3d& at) { pixels += share * (at - middle).squaredNorm(); });
  const Camera& camera = *movement_.camera;
  const Eigen::Matrix3d inner = camera.leftCols<3>(), back = inner.inverse();
  const double focal = inner.row(0).head<3>().cross(inner.row(2).head<3>()).norm();
  const double depth = pixels > 0 ? focal * spread / std::sqrt(pixels) : (camera * from.homogeneous()).z();
  return back * (std::max(depth, 10 * kNearest) * Eigen::Vector3d(middle.x(), middle.y(), 1) - camera.col(3));
}

// Turns the whole infant from where it is, and puts the middle of its points where that was told to be.
std::vector<double> Fit::put_near(std::size_t row, std::vector<double> positions, const Eigen::Quaterniond& turned) {
  double* root = &positions[whole_->place];
  const Eigen::Quaterniond next = turned * Eigen::Quaterniond(root[3], root[4], root[5], root[6]);
  const std::array<double, 4> q = {next.w(), next.x(), next.y(), next.z()};
  std::copy(q.begin(), q.end(), root + 3);
  differences(row, positions);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const double share = 1 / double(std::max<std::size_t>(1, seen_in(row)));
  double squares = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (places_at_[i] < 0 || weight_of(movement_.bodies[i], row) == 0) continue;
    middle += share * places_[i];
    squares += share * places_[i].squaredNorm();
  }
  const double spread = std::sqrt(std::max(0.0, squares - middle.squaredNorm()) * 2 / 3);  // in two of three directions
  const Eigen::Vector3d by = points_as_told(row, middle, spread) - middle;
  for (int i = 0; i < 3; ++i) root[i] += by[i];
  return positions;
}

// Nothing tells how the infant lies: its points are turned as a whole from all sides, and the joints move from the best
// of these places.
Fit::Attempt Fit::solve_anywhere(std::size_t row) {
  constexpr std::size_t kBest = 3;
  std::vector<Attempt> found;
  for (const Eigen::Quaterniond& turned : turns_of_cube()) {
    found.push_back(solve(row, put_near(row, rest_, turned), Moves::kWhole));
  }
  const auto is_nearer = [](const Attempt& a, const Attempt& b) { return a.cost < b.cost; };
  std::stable_sort(found.begin(), found.end(), is_nearer);
  std::vector<Attempt> best;
  for (std::size_t i = 0; i < found.size() && best.size() < kBest; ++i) {
    // Many sides lead to the same place.
    if (i > 0 && found[i].cost < found[i - 1].cost * (1 + 1e-3)) continue;
    best.push_back(solve(row, found[i].positions));
  }
  return *std::min_element(best.begin(), best.end(), is_nearer);
}

double Fit::misfit(std::vector<std::vector<double>>& poses) {
  constexpr std::size_t kMost = 5;
  const std::size_t rows = movement_.times.size(), count = std::min(kMost, rows);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = count == 1 ? 0 : i * (rows - 1) / (count - 1);
    Attempt it = i < poses.size() ? solve(row, poses[i]) : solve_anywhere(row);
    sum += it.cost;
    if (i < poses.size()) {
      poses[i] = std::move(it.positions);
    } else {
      poses.push_back(std::move(it.positions));
    }
  }
  return sum;
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
    if (places_at_[i] < 0) continue;
    const bool seen = weight_of(movement_.bodies[i], row) > 0;
    error.distances.push_back(seen ? apart_[i] : std::numeric_limits<double>::quiet_NaN());
    if (!seen) continue;
    error.distance_largest = std::max(error.distance_largest, apart_[i]);
    error.distance_mean += apart_[i];
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
  for (PoseError& error : errors_) {
    const auto seen = std::count_if(error.distances.begin(), error.distances.end(), [](double it) { return it == it; });
    if (seen > 0) error.distance_mean /= static_cast<double>(seen);
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

double misfit(const Movement& movement, mimo::Env& env, std::vector<std::vector<double>>& poses) {
  return Fit(movement, env).misfit(poses);
}

std::vector<PoseError> fit_poses(Movement& movement, mimo::Env& env) {
  if (movement.bodies.empty()) return {};
  Fit fit(movement, env);
  fit.run();
  fit.add_tracks(movement);
  return fit.errors();
}

}  // namespace cli
