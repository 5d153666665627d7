#include "motion/markers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "programs/csv.h"
#include "programs/files.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/summary.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr double kBridged = 0.5;  // s; what is not seen for longer may have been anywhere

// Points of one side, by the bodies that begin there, and the names that markers and key points have for them: without
// the side, in small letters. Markers on the skin are taken for the joints below them.
struct Place {
  const char *point, *body, *names;
  bool at_joint;  // a point of the body before, where this one begins
};

constexpr Place kOfSides[] = {
    {"shoulder", "upper_arm", "shoulder sho shld acromion upperarm arm", true},
    {"elbow", "lower_arm", "elbow elb forearm lowerarm", true},
    {"wrist", "hand", "wrist wri wra wrb hand", true},
    {"hip", "upper_leg", "hip hjc upleg thigh upperleg", true},
    {"knee", "lower_leg", "knee kne calf leg lowerleg shin", true},
    {"ankle", "foot", "ankle ank foot", true},
    {"toes", "toes", "toes toe bigtoe toebase", false},
    {"eye", "eye", "eye", false},
};

// On the head, in radii of its sphere from the centre: forward, left, up, as mimo/key_points.py has them.
struct OnHead {
  const char* names;
  std::array<double, 3> place;
};

constexpr OnHead kOnHead[] = {
    {"nose nosevertex", {1.0, 0.0, -0.15}}, {"leftear lear", {0.0, 1.0, 0.0}}, {"rightear rear", {0.0, -1.0, 0.0}}};

// Small letters and digits, behind the subject's name: "Anna:L_Elbow" is "lelbow".
std::string plain(const std::string& name) {
  std::string letters;
  for (const char c : name.substr(name.find_last_of(':') + 1)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

bool is_among(const std::string& word, const std::string& list) {
  return !word.empty() && (' ' + list + ' ').find(' ' + word + ' ') != std::string::npos;
}

struct Spot {
  std::string point;
  std::int32_t body;
  Eigen::Vector3d offset;  // in the body's frame
};

// "left", "right" or "" of a plain name, and what is left of it.
std::pair<std::string, std::string> side_of(const std::string& name) {
  for (const char* side : {"left", "right"}) {
    const std::string word = side;
    if (name.compare(0, word.size(), word) == 0) return {word, name.substr(word.size())};
    if (name.size() > word.size() && name.compare(name.size() - word.size(), word.size(), word) == 0) {
      return {word, name.substr(0, name.size() - word.size())};
    }
  }
  if (name.size() > 2 && (name[0] == 'l' || name[0] == 'r')) return {name[0] == 'l' ? "left" : "right", name.substr(1)};
  return {"", name};
}

Eigen::Isometry3d pose_of(const mimo::Env& env, std::int32_t body) {
  const std::vector<double> pose = env.get_values(MIMO_BODY_POSE | MIMO_NOW, {body});
  return Eigen::Translation3d(pose[0], pose[1], pose[2]) * Eigen::Quaterniond(pose[3], pose[4], pose[5], pose[6]);
}

// Where a body begins, in its parent's frame, so that a hand that turns does not move the wrist.
Eigen::Vector3d start_in_parent(mimo::Env& env, std::int32_t body) {
  std::vector<std::int32_t> hinges;
  for (const Joint& joint : joints_of(env)) {
    if (env.body_of(MIMO_JOINT, joint.id) == body) hinges.push_back(joint.id);
  }
  const std::vector<double> angles = env.get_values(MIMO_JOINT_POSITION, hinges);
  env.set_values(MIMO_JOINT_POSITION, hinges, std::vector<double>(angles.size(), 0));
  const Eigen::Vector3d at = pose_of(env, body).translation();
  const Eigen::Vector3d inside = pose_of(env, env.body_of(MIMO_BODY, body)).inverse() * at;
  env.set_values(MIMO_JOINT_POSITION, hinges, angles);
  return inside;
}

class Mapping {
 public:
  Mapping(mimo::Env& env, const std::string& map) : env_(env) {
    const std::vector<std::int32_t> roots = infants(env);
    if (roots.empty()) throw Failure("the scene has no infant, whom markers could move");
    const std::string root = env.name(MIMO_BODY, roots[0]);
    prefix_ = root.substr(0, root.find('/') == std::string::npos ? 0 : root.find('/') + 1);
    for (const std::int32_t body : env.ids(MIMO_BODY)) bodies_[env.name(MIMO_BODY, body)] = body;
    if (map.empty()) return;
    for (const TextRow& row : read_texts(map)) {
      if (row.cells.size() != 2) throw Failure(map + text(", line %zu: expected marker,point", row.line));
      own_[row.cells[0]] = row.cells[1];
    }
    own_file_ = map;
  }

  std::int32_t body(const std::string& name) const {
    const auto found = bodies_.find(prefix_ + name);
    return found == bodies_.end() ? -1 : found->second;
  }

  std::optional<Spot> spot_of(const std::string& marker, bool arms_begin_at_clavicles) const {
    if (!own_file_.empty()) {
      const auto found = own_.find(marker);
      if (found == own_.end()) return std::nullopt;
      const std::optional<Spot> it = usual(plain(found->second), false);
      if (!it) throw Failure(own_file_ + ": no point or body '" + found->second + "'");
      return it;
    }
    const std::string name = plain(marker);
    if (arms_begin_at_clavicles && is_among(name, "leftshoulder rightshoulder")) return std::nullopt;
    return usual(name, true);
  }

 private:
  // Bodies by their own names only where a map says so: a marker "head" may be anywhere on it.
  std::optional<Spot> usual(const std::string& name, bool of_file) const {
    for (const OnHead& it : kOnHead) {
      if (is_among(name, it.names) && body("head") >= 0) return on_head(name, it);
    }
    const auto [side, part] = side_of(name);
    for (const Place& it : kOfSides) {
      const std::int32_t begins = side.empty() || !is_among(part, it.names) ? -1 : body(side + '_' + it.body);
      if (begins < 0) continue;
      if (!it.at_joint) return Spot{side + '_' + it.point, begins, Eigen::Vector3d::Zero()};
      return Spot{side + '_' + it.point, env_.body_of(MIMO_BODY, begins), start_in_parent(env_, begins)};
    }
    for (const auto& [full, id] : bodies_) {
      if (id == 0 || full.compare(0, prefix_.size(), prefix_) != 0) continue;
      const std::string own = full.substr(prefix_.size());
      if (plain(own) == name && (!of_file || own.find("fingers") != std::string::npos)) {
        return Spot{own, id, Eigen::Vector3d::Zero()};
      }
    }
    return std::nullopt;
  }

  Spot on_head(const std::string& name, const OnHead& it) const {
    const std::int32_t head = body("head");
    Spot target{name, head, Eigen::Vector3d::Zero()};
    for (const std::int32_t geom : env_.ids(MIMO_GEOM)) {
      if (env_.name(MIMO_GEOM, geom) != prefix_ + "head") continue;
      const std::vector<double> at = env_.get_values(MIMO_GEOM_POSITION | MIMO_NOW, {geom});
      const double radius = env_.get_values(MIMO_GEOM_SIZE, {geom})[0];
      target.offset = pose_of(env_, head).inverse() * Eigen::Vector3d(at[0], at[1], at[2]) +
                      radius * Eigen::Vector3d(it.place[0], it.place[1], it.place[2]);
    }
    return target;
  }

  mimo::Env& env_;
  std::string prefix_, own_file_;
  std::map<std::string, std::int32_t> bodies_;
  std::map<std::string, std::string> own_;
};

bool is_seen(const Eigen::Vector3d& point) { return point.allFinite(); }

struct Point {
  Spot target;
  std::vector<std::size_t> markers;  // several, as at both sides of a wrist: their middle
  std::vector<Eigen::Vector3d> places;
};

std::vector<Point> points_of(const std::string& path, Markers& markers, const Mapping& mapping) {
  const auto has = [&](const char* name) {
    return std::any_of(markers.names.begin(), markers.names.end(), [&](const auto& it) { return plain(it) == name; });
  };
  const bool clavicles = has("leftupperarm") || has("leftarm");
  std::vector<Point> points;
  std::string left_out;
  for (std::size_t i = 0; i < markers.names.size(); ++i) {
    const std::optional<Spot> target = mapping.spot_of(markers.names[i], clavicles);
    if (!target) {
      left_out += (left_out.empty() ? "" : ", ") + (markers.names[i].empty() ? "one without a name" : markers.names[i]);
      continue;
    }
    const auto same = [&](const Point& it) { return it.target.point == target->point; };
    const auto there = std::find_if(points.begin(), points.end(), same);
    if (there == points.end()) {
      points.push_back({*target, {i}, {}});
    } else {
      there->markers.push_back(i);
    }
  }
  constexpr std::size_t kLeast = 4;
  if (points.size() < kLeast) {
    throw Failure(path +
                  text(": %zu markers have a name that tells where they are, expected %zu or more; it has ",
                       points.size(), kLeast) +
                  left_out + "; --map gives lines of marker,point, as LSHO,left_shoulder");
  }
  if (!left_out.empty()) markers.notes.push_back(path + ": these markers move nothing: " + left_out);
  return points;
}

// Seen where all of its markers are.
void place(Point& point, const Markers& markers, const std::string& up) {
  for (const std::vector<Eigen::Vector3d>& row : markers.rows) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const std::size_t marker : point.markers) middle += row[marker] / double(point.markers.size());
    point.places.push_back(up == "y" ? Eigen::Vector3d(middle.z(), middle.x(), middle.y()) : middle);
  }
}

// Straight lines over short gaps. Says how many rows that were, and how many are left.
void bridge(Point& point, const std::vector<double>& times, const std::string& path, std::vector<std::string>& notes) {
  std::size_t filled = 0, open = 0;
  double longest = 0;
  for (std::size_t i = 0; i < times.size();) {
    if (is_seen(point.places[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < times.size() && !is_seen(point.places[end])) ++end;
    const bool inside = i > 0 && end < times.size();
    const double gap = inside ? times[end] - times[i - 1] : 0;
    if (inside) longest = std::max(longest, gap);
    if (inside && gap <= kBridged) {
      const Eigen::Vector3d from = point.places[i - 1], to = point.places[end];
      for (std::size_t k = i; k < end; ++k) point.places[k] = from + (times[k] - times[i - 1]) / gap * (to - from);
      filled += end - i;
    } else {
      open += end - i;
    }
    i = end;
  }
  if (filled + open == 0) return;
  notes.push_back(path +
                  text(": %s was not seen in %zu of %zu rows; %zu were filled by straight lines, %zu longer ones or "
                       "at an end have no weight; the longest gap takes %.3g s",
                       point.target.point.c_str(), filled + open, times.size(), filled, open, longest));
}

using Segment = std::array<const char*, 2>;
constexpr Segment kSegments[] = {{"left_shoulder", "left_elbow"},     {"right_shoulder", "right_elbow"},
                                 {"left_elbow", "left_wrist"},        {"right_elbow", "right_wrist"},
                                 {"left_hip", "left_knee"},           {"right_hip", "right_knee"},
                                 {"left_knee", "left_ankle"},         {"right_knee", "right_ankle"},
                                 {"left_shoulder", "right_shoulder"}, {"left_hip", "right_hip"}};

double middle(std::vector<double> values) {
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), half, values.end());
  return *half;
}

// By how much the infant's limbs are longer than the measured ones: least squares of all segments' lengths.
double scale_of(const std::vector<Point>& points, const std::vector<Eigen::Vector3d>& here) {
  double products = 0, squares = 0;
  for (const Segment& segment : kSegments) {
    std::size_t ends[2] = {points.size(), points.size()};
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t i = 0; i < points.size(); ++i) ends[k] = points[i].target.point == segment[k] ? i : ends[k];
    }
    if (ends[0] == points.size() || ends[1] == points.size()) continue;
    std::vector<double> lengths;
    for (std::size_t row = 0; row < points[0].places.size(); ++row) {
      const Eigen::Vector3d along = points[ends[0]].places[row] - points[ends[1]].places[row];
      if (is_seen(along)) lengths.push_back(along.norm());
    }
    if (lengths.empty()) continue;
    const double measured = middle(lengths), own = (here[ends[0]] - here[ends[1]]).norm();
    products += measured * own;
    squares += measured * measured;
  }
  return squares > 0 ? products / squares : 1;
}

// Where the world's infant has its points now.
std::vector<Eigen::Vector3d> points_now(const std::vector<Point>& points, const mimo::Env& env) {
  std::vector<Eigen::Vector3d> here;
  for (const Point& it : points) {
    here.push_back(pose_of(env, it.target.body) * it.target.offset);
  }
  return here;
}

// Turns and moves the whole infant so that its trunk lies nearest to the markers of the first row that has enough.
void put_near(const std::vector<Point>& points, const std::vector<Eigen::Vector3d>& here, mimo::Env& env) {
  const std::int32_t root = infants(env)[0];
  const auto joints = joints_of(env);
  const auto free = std::find_if(joints.begin(), joints.end(), [&](const Joint& it) {
    return it.width == 7 && env.body_of(MIMO_JOINT, it.id) == root;
  });
  if (free == joints.end()) return;
  const auto of_trunk = [](const Point& it) {
    return is_among(it.target.point, "left_shoulder right_shoulder left_hip right_hip");
  };
  const bool trunk = std::count_if(points.begin(), points.end(), of_trunk) >= 3;
  for (std::size_t row = 0; row < points[0].places.size(); ++row) {
    Eigen::Matrix3Xd from(3, 0), to(3, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_seen(points[i].places[row]) || (trunk && !of_trunk(points[i]))) continue;
      from.conservativeResize(3, from.cols() + 1);
      to.conservativeResize(3, to.cols() + 1);
      from.rightCols<1>() = here[i];
      to.rightCols<1>() = points[i].places[row];
    }
    if (from.cols() < 3) continue;
    const Eigen::Isometry3d move(Eigen::umeyama(from, to, false));
    const std::vector<double> pose = env.get_values(MIMO_JOINT_POSITION, {free->id});
    const Eigen::Vector3d at = move * Eigen::Vector3d(pose[0], pose[1], pose[2]);
    const Eigen::Quaterniond turn(move.rotation() * Eigen::Quaterniond(pose[3], pose[4], pose[5], pose[6]));
    env.set_values(MIMO_JOINT_POSITION, {free->id}, {at.x(), at.y(), at.z(), turn.w(), turn.x(), turn.y(), turn.z()});
    return;
  }
}

Markers read_any(const std::string& path) {
  if (has_ending(path, ".trc")) return read_trc(path);
  return has_ending(path, ".c3d") ? read_c3d(path) : read_qualisys(path);
}

}  // namespace

bool is_marker_file(const std::string& path) {
  return has_ending(path, ".trc") || has_ending(path, ".tsv") || has_ending(path, ".c3d");
}

Movement read_marker_movement(const std::string& path, const RetargetOptions& options, mimo::Env& env) {
  if (options.rest_frame >= 0) throw Failure("--rest-frame has no effect on markers");
  Markers markers = read_any(path);
  const Mapping mapping(env, options.map);
  std::vector<Point> points = points_of(path, markers, mapping);
  for (Point& point : points) {
    place(point, markers, options.up);
    bridge(point, markers.times, path, markers.notes);
  }
  const auto never = [](const Point& it) { return std::none_of(it.places.begin(), it.places.end(), is_seen); };
  points.erase(std::remove_if(points.begin(), points.end(), never), points.end());
  if (points.size() < 3) throw Failure(path + ": fewer than 3 of the markers that it names are ever seen");
  const std::vector<Eigen::Vector3d> here = points_now(points, env);
  const double scale = options.scale > 0 ? options.scale : scale_of(points, here);
  for (Point& point : points) {
    for (Eigen::Vector3d& at : point.places) at *= scale;
  }
  if (options.scale <= 0) {
    markers.notes.push_back(path +
                            text(": the measured limbs are %.4g times as long as the infant's; places are divided by "
                                 "that (--scale 1 takes them as they are)",
                                 1 / scale));
  }
  put_near(points, here, env);
  Movement movement;
  movement.source = path;
  movement.times = markers.times;
  movement.notes = std::move(markers.notes);
  movement.of_another = true;
  for (const Point& point : points) {
    BodyTrack track;
    track.body = point.target.body;
    track.positions = point.places;
    track.offset = point.target.offset;
    track.point = point.target.point;
    for (Eigen::Vector3d& at : track.positions) {
      track.seen.push_back(is_seen(at));
      if (!track.seen.back()) at.setZero();
    }
    movement.bodies.push_back(std::move(track));
  }
  return movement;
}

}  // namespace cli
