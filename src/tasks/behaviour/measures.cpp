#include "tasks/behaviour/measures.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstring>

#include "base/fail.h"
#include "base/format.h"
#include "base/functions.h"
#include "base/names.h"
#include "base/numbers.h"
#include "body/face.h"
#include "engine/contacts.h"

namespace mimo::tasks {
namespace {

using Eigen::Vector3d;
using Words = std::vector<std::string>;

constexpr const char *kMetres = "m", *kDegrees = "deg", *kSpeed = "m/s", *kParts = "parts";

// An axis of a part's frame by its name: "x" is where the infant's front looks, "y" its left, "z" its head's end.
struct Axis {
  int body;
  int column;
  double sign;

  Vector3d in(const mjData& data) const {
    const double* matrix = data.xmat + 9 * body + column;
    return sign * Vector3d(matrix[0], matrix[3], matrix[6]);
  }
};

Axis axis_of(const Maker& maker, const std::string& part, const std::string& word) {
  const bool back = !word.empty() && word.front() == '-';
  const std::string letter = back ? word.substr(1) : word;
  const char* axes = "xyz";
  const char* found = letter.size() == 1 ? std::strchr(axes, letter[0]) : nullptr;
  if (found == nullptr) {
    fail(Status::kModel, "{}: \"{}\" stands where x, y, z, -x, -y or -z is expected", names::kReached, word);
  }
  return {maker.parts().frame(part), static_cast<int>(found - axes), back ? -1.0 : 1.0};
}

double degrees(double cosine) { return fixed::acos(std::clamp(cosine, -1.0, 1.0)) / kDegree; }

class Height : public Quantity {
 public:
  explicit Height(Point point) : Quantity(kMetres), point_(std::move(point)) {}
  double look(const Moment& now) const override { return point_.in(now.data).z(); }

 private:
  Point point_;
};

class Distance : public Quantity {
 public:
  Distance(Point one, Point other) : Quantity(kMetres), one_(std::move(one)), other_(std::move(other)) {}
  double look(const Moment& now) const override { return (one_.in(now.data) - other_.in(now.data)).norm(); }

 private:
  Point one_, other_;
};

// Between an axis of a part and straight up.
class Tilt : public Quantity {
 public:
  explicit Tilt(Axis axis) : Quantity(kDegrees), axis_(axis) {}
  double look(const Moment& now) const override { return degrees(axis_.in(now.data).z()); }

 private:
  Axis axis_;
};

// How many of some parts touch any of others.
class Touching : public Quantity {
 public:
  Touching(const mjModel& model, const std::vector<Part>& parts, const std::vector<Part>& others)
      : Quantity(kParts), part_(static_cast<std::size_t>(model.nbody), -1), other_(part_.size(), 0) {
    if (parts.size() > kMost) {
      fail(Status::kModel, "{}: contacts of {} parts are to be counted, expected {} at most", names::kReached,
           parts.size(), kMost);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (const int body : parts[i].bodies) {
        int& part = part_[static_cast<std::size_t>(body)];
        if (part >= 0) {
          fail(Status::kModel, "{}: body \"{}\" is in two of the parts whose contacts are counted", names::kReached,
               engine::name(model, engine::Kind::kBody, body));
        }
        part = static_cast<int>(i);
      }
    }
    for (const Part& other : others) {
      for (const int body : other.bodies) other_[static_cast<std::size_t>(body)] = 1;
    }
  }

  double look(const Moment& now) const override {
    std::bitset<kMost> touching;
    for (const engine::Meeting& met : engine::Contacts(now.model, now.data)) {
      for (const std::size_t side : {0u, 1u}) {
        const int part = part_[static_cast<std::size_t>(met.bodies[side])];
        if (part < 0 || other_[static_cast<std::size_t>(met.bodies[1 - side])] == 0) continue;
        const auto which = static_cast<std::size_t>(part);
        if (!touching[which] && presses(now.model, now.data, met.number)) touching.set(which);
      }
    }
    return static_cast<double>(touching.count());
  }

 private:
  static constexpr std::size_t kMost = 256;
  std::vector<int> part_;            // by body
  std::vector<std::uint8_t> other_;  // by body
};

// Between where the nearer eye looks and where a point is.
class GazeAngle : public Quantity {
 public:
  GazeAngle(const body::Eyes& eyes, Point point) : Quantity(kDegrees), eyes_(eyes), point_(std::move(point)) {}
  double look(const Moment& now) const override {
    const body::Gaze gaze = eyes_.gaze(now.data);
    const Vector3d at = point_.in(now.data);
    const auto off = [&](const body::Sightline& line) {
      return degrees((at - line.position).normalized().dot(line.direction.normalized()));
    };
    return std::min(off(gaze.left), off(gaze.right));
  }

 private:
  body::Eyes eyes_;
  Point point_;
};

class Speed : public Quantity {
 public:
  explicit Speed(int body) : Quantity(kSpeed), body_(body) {}
  double look(const Moment& now) const override {
    const auto v = engine::body_velocity(now.model, now.data, body_);
    return length_of(v[0], v[1], v[2]);
  }

 private:
  int body_;
};

// A hinge's angle.
class Bend : public Quantity {
 public:
  explicit Bend(int address) : Quantity(kDegrees), address_(address) {}
  double look(const Moment& now) const override { return now.data.qpos[address_] / kDegree; }

 private:
  int address_;
};

// How far a part has got over the ground since the episode began: in any direction, or along an axis that it had then.
class Moved : public Quantity {
 public:
  Moved(Maker& maker, Point point) : Quantity(kMetres), point_(std::move(point)), at_(maker.keep(5)) {}
  Moved(Maker& maker, Point point, Axis axis) : Moved(maker, std::move(point)) {
    axis_ = axis;
    along_ = true;
  }

  double look(const Moment& now) const override {
    const Vector3d is = point_.in(now.data);
    double* start = &now.memory[at_];
    if (now.begins()) {
      start[0] = is.x();
      start[1] = is.y();
      if (along_) put_direction(axis_.in(now.data), start + 2);
    }
    const double x = is.x() - start[0], y = is.y() - start[1];
    return along_ ? x * start[2] + y * start[3] : length_of(x, y);
  }

 private:
  static void put_direction(const Vector3d& axis, double* to) {
    const double level = length_of(axis.x(), axis.y());
    if (!(level > 0)) return;  // straight up: nowhere is ahead
    to[0] = axis.x() / level;
    to[1] = axis.y() / level;
  }

  Point point_;
  std::size_t at_;
  Axis axis_{};
  bool along_ = false;
};

int hinge(const Maker& maker, const std::string& name) {
  const mjModel& model = maker.parts().model();
  const std::string& prefix = maker.parts().body().prefix;
  int id = -1;
  for (const std::string& full : {prefix + names::kJoint + name, name}) {
    if (id < 0) id = engine::find(model, engine::Kind::kJoint, full.c_str());
  }
  if (id < 0 || model.jnt_type[id] != mjJNT_HINGE) {
    fail(Status::kModel, "{}: the scene has no hinge named \"{}\"", names::kReached, name);
  }
  return model.jnt_qposadr[id];
}

template <typename Made, typename... Arguments>
QuantityPtr make(Arguments&&... arguments) {
  return std::make_unique<const Made>(std::forward<Arguments>(arguments)...);
}

constexpr Kind kKinds[] = {
    {"height", "PART", [](Maker& m, const Words& w) { return make<Height>(m.parts().point(w[0])); }},
    {"distance", "PART PART",
     [](Maker& m, const Words& w) { return make<Distance>(m.parts().point(w[0]), m.parts().point(w[1])); }},
    {"tilt", "PART AXIS", [](Maker& m, const Words& w) { return make<Tilt>(axis_of(m, w[0], w[1])); }},
    {"contacts", "PARTS PARTS",
     [](Maker& m, const Words& w) {
       return make<Touching>(m.parts().model(), m.parts().parts(w[0]), m.parts().parts(w[1]));
     }},
    {"gaze", "PART",
     [](Maker& m, const Words& w) {
       return make<GazeAngle>(body::Eyes(m.parts().model(), m.parts().body()), m.parts().point(w[0]));
     }},
    {"speed", "PART", [](Maker& m, const Words& w) { return make<Speed>(m.parts().frame(w[0])); }},
    {"joint", "HINGE", [](Maker& m, const Words& w) { return make<Bend>(hinge(m, w[0])); }},
    {"moved", "PART", [](Maker& m, const Words& w) { return make<Moved>(m, m.parts().point(w[0])); }},
    {"advance", "PART AXIS",
     [](Maker& m, const Words& w) { return make<Moved>(m, m.parts().point(w[0]), axis_of(m, w[0], w[1])); }},
};

// How many words the arguments of a kind are.
std::size_t count(const char* arguments) {
  return static_cast<std::size_t>(std::count(arguments, arguments + std::strlen(arguments), ' ')) + 1;
}

bool is_length(const std::string& unit) { return unit == kMetres || unit == kSpeed; }

}  // namespace

Span<const Kind> present_kinds() { return {kKinds, std::size(kKinds)}; }

double Goal::progress(double value) const {
  if (!from) return met(value) ? 1 : 0;
  return std::clamp((value - *from) / (threshold - *from), 0.0, 1.0);
}

std::size_t Maker::keep(std::size_t count) {
  const std::size_t at = kept_;
  kept_ += count;
  return at;
}

QuantityPtr Maker::quantity(const std::string& text) {
  const Words words = words_of(text);
  std::vector<std::string> known;
  for (const Span<const Kind> kinds : {present_kinds(), remembered_kinds()}) {
    for (const Kind& kind : kinds) {
      known.emplace_back(kind.word);
      if (words.empty() || words[0] != kind.word) continue;
      if (words.size() - 1 != count(kind.arguments)) {
        fail(Status::kModel, "{}: \"{}\" has {} words behind \"{}\", expected {}", names::kReached, text,
             words.size() - 1, kind.word, kind.arguments);
      }
      return kind.make(*this, {words.begin() + 1, words.end()});
    }
  }
  const std::string wanted = words.empty() ? "" : words[0];
  fail(Status::kModel, "{}: nothing that can be measured is called \"{}\"; {}", names::kReached, wanted,
       choice_of(wanted, known));
}

Goal Maker::goal(const Clause& clause) {
  QuantityPtr measured = quantity(clause.quantity);
  if (clause.unit != measured->unit()) {
    fail(Status::kModel, "{}: \"{}\" is compared with a number of unit \"{}\", expected \"{}\"", names::kReached,
         clause.quantity, clause.unit, measured->unit());
  }
  const double size = is_length(clause.unit) ? parts_.body().stature : 1;
  std::optional<double> from = clause.from;
  if (from) *from *= size;
  return {std::move(measured), clause.at_least, size * clause.threshold, from};
}

}  // namespace mimo::tasks
