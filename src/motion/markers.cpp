#include "motion/markers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
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

// On the head, in radii of its sphere from the centre: forward, left, up.
struct OnHead {
  const char *point, *names;
  std::array<double, 3> place;
};

constexpr OnHead kOnHead[] = {{"nose", "nose nosevertex", {1.0, 0.0, -0.15}},
                              {"left_ear", "leftear earleft lear", {0.0, 1.0, 0.0}},
                              {"right_ear", "rightear earright rear", {0.0, -1.0, 0.0}}};

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
    for (const TextRow& row : read_texts(map)) read_line(map, row);
    own_file_ = map;
  }

  std::int32_t body(const std::string& name) const {
    const auto found = bodies_.find(prefix_ + name);
    return found == bodies_.end() ? -1 : found->second;
  }

  std::optional<Spot> spot_of(const std::string& marker, bool arms_begin_at_clavicles, bool own_names) const {
    if (!own_file_.empty()) {
      const auto found = own_.find(marker);
      if (found == own_.end()) return std::nullopt;
      std::optional<Spot> it = usual(plain(found->second.point), false);
      if (!it) throw Failure(own_file_ + ": no point or body '" + found->second.point + "'");
      if (found->second.offset) {
        if (body(found->second.point) < 0) {
          throw Failure(own_file_ + ": no body '" + found->second.point + "', in which x, y, z could be");
        }
        it = Spot{marker, body(found->second.point), *found->second.offset};
      }
      return it;
    }
    if (own_names && body(marker) > 0) return Spot{marker, body(marker), Eigen::Vector3d::Zero()};
    const std::string name = plain(marker);
    if (arms_begin_at_clavicles && is_among(name, "leftshoulder rightshoulder")) return std::nullopt;
    return usual(name, true);
  }

 private:
  // What a line of the map says of a marker.
  struct Told {
    std::string point;
    std::optional<Eigen::Vector3d> offset;  // in the body of that name
  };

  void read_line(const std::string& map, const TextRow& row) {
    const auto fail = [&](const std::string& why) { throw Failure(map + text(", line %zu: ", row.line) + why); };
    if (row.cells.size() != 2 && row.cells.size() != 5) fail("expected marker,point or marker,body,x,y,z");
    Told told{row.cells[1], {}};
    if (row.cells.size() == 5) {
      told.offset.emplace();
      for (std::size_t i = 0; i < 3; ++i) {
        const auto value = number_of_file(row.cells[2 + i]);
        if (!value) fail("the place of '" + row.cells[0] + "' is '" + row.cells[2 + i] + "', expected metres");
        (*told.offset)[Eigen::Index(i)] = *value;
      }
    }
    if (!own_.emplace(row.cells[0], told).second) fail("the marker '" + row.cells[0] + "' is there twice");
  }

  // Bodies by their own names only where a map says so: a marker "head" may be anywhere on it.
  std::optional<Spot> usual(const std::string& name, bool of_file) const {
    for (const OnHead& it : kOnHead) {
      if (is_among(name, it.names) && body("head") >= 0) return on_head(it);
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

  Spot on_head(const OnHead& it) const {
    const std::int32_t head = body("head");
    Spot target{it.point, head, Eigen::Vector3d::Zero()};
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
  std::map<std::string, Told> own_;
};

bool is_seen(const Eigen::Vector3d& point) { return point.allFinite(); }

struct Point {
  Spot target;
  std::vector<std::size_t> markers;  // several, as at both sides of a wrist: their middle
  std::vector<Eigen::Vector3d> places;
  std::vector<double> weights;
};

std::vector<Point> points_of(const Markers& markers, const Mapping& mapping, std::vector<std::string>& notes) {
  const auto has = [&](const char* name) {
    return std::any_of(markers.names.begin(), markers.names.end(), [&](const auto& it) { return plain(it) == name; });
  };
  const bool clavicles = has("leftupperarm") || has("leftarm");
  std::vector<Point> points;
  std::string left_out;
  for (std::size_t i = 0; i < markers.names.size(); ++i) {
    const std::optional<Spot> target = mapping.spot_of(markers.names[i], clavicles, markers.has_own_names);
    if (!target) {
      left_out += (left_out.empty() ? "" : ", ") + (markers.names[i].empty() ? "one without a name" : markers.names[i]);
      continue;
    }
    const auto same = [&](const Point& it) { return it.target.point == target->point; };
    const auto there = std::find_if(points.begin(), points.end(), same);
    if (there == points.end()) {
      points.push_back({*target, {i}, {}, {}});
    } else {
      there->markers.push_back(i);
    }
  }
  constexpr std::size_t kLeast = 4;
  if (points.size() < kLeast) {
    throw Failure(markers.source +
                  text(": %zu markers have a name that tells where they are, expected %zu or more; it has ",
                       points.size(), kLeast) +
                  left_out + "; --map gives lines of marker,point, as LSHO,left_shoulder");
  }
  if (!left_out.empty()) notes.push_back(markers.source + ": these markers move nothing: " + left_out);
  return points;
}

// Seen where all of its markers are, with the mean of their weights.
void place(Point& point, const Markers& markers, const std::string& up) {
  for (std::size_t row = 0; row < markers.rows.size(); ++row) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double weight = 0;
    for (const std::size_t marker : point.markers) {
      middle += markers.rows[row][marker] / double(point.markers.size());
      weight += (markers.weights.empty() ? 1 : markers.weights[row][marker]) / double(point.markers.size());
    }
    point.places.push_back(up == "y" ? Eigen::Vector3d(middle.z(), middle.x(), middle.y()) : middle);
    point.weights.push_back(is_seen(middle) ? weight : 0);
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
      for (std::size_t k = i; k < end; ++k) {
        point.places[k] = from + (times[k] - times[i - 1]) / gap * (to - from);
        point.weights[k] = std::min(point.weights[i - 1], point.weights[end]);
      }
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

bool has_marker_ending(const std::string& path) {
  return has_ending(path, ".trc") || has_ending(path, ".tsv") || has_ending(path, ".c3d");
}

bool is_folder(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_directory(path, none);
}

Markers read_any(const std::string& path, double rate) {
  if (is_mini_rgbd(path)) return read_mini_rgbd(path, rate);
  if (is_folder(path)) return read_openpose(path, rate);
  if (!has_marker_ending(path) && is_deeplabcut(path)) return read_deeplabcut(path, rate);
  if (rate > 0) throw Failure("--rate: " + path + " has times itself");
  if (has_ending(path, ".trc")) return read_trc(path);
  if (has_ending(path, ".c3d")) return read_c3d(path);
  return has_ending(path, ".tsv") ? read_qualisys(path) : read_key_points(path);
}

void require_fitting(const Markers& markers, const RetargetOptions& options) {
  if (options.rest_frame >= 0) throw Failure("--rest-frame has no effect on markers");
  if (!markers.in_pixels) {
    if (!options.camera.empty())
      throw Failure("--camera: the points of " + markers.source + " are in m, not in pixels");
    return;
  }
  if (!markers.camera) throw Failure(markers.source + ": its points are pixels, expected --camera");
  if (options.scale > 0) throw Failure("--scale has no effect on points in pixels");
  if (!options.up.empty()) throw Failure("--up has no effect on points in pixels: the camera says where up is");
}

void scale(std::vector<Point>& points, const Markers& markers, double given, const mimo::Env& env,
           std::vector<std::string>& notes) {
  const double factor = given > 0 ? given : scale_of(points, points_now(points, env));
  for (Point& point : points) {
    for (Eigen::Vector3d& at : point.places) at *= factor;
  }
  if (given > 0) return;
  notes.push_back(markers.source +
                  text(": the measured limbs are %.4g times as long as the infant's; places are divided by that "
                       "(--scale 1 takes them as they are)",
                       1 / factor));
}

}  // namespace

void Markers::begin_row(double time) {
  times.push_back(time);
  rows.emplace_back();
  weights.emplace_back();
}

void Markers::add_weighted(const Eigen::Vector3d& place, double weight) {
  const bool seen = weight > 0 && place.allFinite();
  rows.back().push_back(seen ? place : kUnseen);
  weights.back().push_back(seen ? weight : 0);
}

void require_rate(const std::string& path, double rate) {
  if (!(rate > 0)) throw Failure(path + " has no times: expected --rate, its frames a second");
}

bool has_points(const std::string& path) {
  if (has_marker_ending(path) || is_folder(path)) return true;
  return !has_ending(path, ".bvh") && (is_deeplabcut(path) || has_key_points(path));
}

Markers read_points(const std::string& path, const RetargetOptions& options) {
  Markers markers = read_any(path, options.rate);
  markers.source = path;
  if (!options.camera.empty()) markers.camera = read_camera(options.camera);
  require_fitting(markers, options);
  return markers;
}

Movement point_movement(const Markers& markers, const RetargetOptions& options, mimo::Env& env) {
  Movement movement;
  movement.notes = markers.notes;
  const Mapping mapping(env, options.map);
  std::vector<Point> points = points_of(markers, mapping, movement.notes);
  for (Point& point : points) {
    place(point, markers, options.up);
    bridge(point, markers.times, markers.source, movement.notes);
  }
  const auto never = [](const Point& it) {
    return std::none_of(it.weights.begin(), it.weights.end(), [](double weight) { return weight > 0; });
  };
  points.erase(std::remove_if(points.begin(), points.end(), never), points.end());
  if (points.size() < 3) throw Failure(markers.source + ": fewer than 3 of the markers that it names are ever seen");
  if (!markers.in_pixels) scale(points, markers, options.scale, env, movement.notes);
  movement.source = markers.source;
  movement.times = markers.times;
  movement.of_another = movement.of_points = true;
  movement.robust = options.robust;
  if (markers.in_pixels) movement.camera = markers.camera;
  for (Point& point : points) {
    BodyTrack track;
    track.body = point.target.body;
    track.offset = point.target.offset;
    track.point = point.target.point;
    track.weights = point.weights;
    for (const Eigen::Vector3d& at : point.places) {
      track.positions.push_back(is_seen(at) ? at : Eigen::Vector3d(Eigen::Vector3d::Zero()));
    }
    movement.bodies.push_back(std::move(track));
  }
  return movement;
}

}  // namespace cli
