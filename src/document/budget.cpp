#include "document/budget.h"

#include <mujoco/mjdata.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

#include "base/fail.h"
#include "document/attributes.h"
#include "document/defaults.h"
#include "document/report.h"
#include "document/xml.h"
#include "engine/compiler.h"

namespace mimo::document {
namespace {

// Elements that one of a composite becomes: a body, a geom, and up to three joints.
constexpr double kEach = 5;
constexpr double kDegreesEach = 3;
constexpr double kNumber = sizeof(mjtNum);
constexpr double kMostNumeric = 500;  // more are refused

bool makes_many(pugi::xml_node node) { return is_one_of(node, {"composite", "flexcomp"}); }

// What stands in a <replicate> is there that many times.
double copies_of(pugi::xml_node node) {
  double copies = 1;
  for (pugi::xml_node outer = node.parent(); outer; outer = outer.parent()) {
    if (is(outer, "replicate")) copies *= std::max(number(outer, "count").value_or(1), 1.0);
  }
  return copies;
}

double text_of(pugi::xml_node node) {
  std::size_t bytes = 0;
  for (const pugi::xml_attribute attribute : node.attributes()) bytes += std::strlen(attribute.value());
  return static_cast<double>(bytes);
}

bool is_muscle_type(pugi::xml_attribute type) { return std::strcmp(type.value(), "muscle") == 0; }

// MuJoCo sizes its buffers for the worst case, 19 MB a world. In ten hours of random movement an infant with mitten
// hands needed up to 37 contacts, 175 constraints (210 with every joint locked) and 23,000 numbers of stack; one with
// five fingers, whose contacts have six constraints, in ten minutes 68, 410 and 63,000. The solver's part of the stack
// grows with the square of the degrees of freedom: ten infants in a heap needed 5.1 numbers for each entry of their
// matrix, 1.4 million. A buffer that is full after all shows as a warning, never as a crash.
struct Buffers {
  int contacts, constraints, stack;
};
constexpr Buffers kRoom = {20, 60, 20000};
constexpr Buffers kMitten = {100, 340, 50000};
constexpr Buffers kFingers = {200, 900, 80000};
constexpr Buffers kObject = {20, 60, 5000};
constexpr int kStackPerEntry = 10;

int degrees_of_freedom(pugi::xml_node root) {
  int count = 0;
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      const std::string kind = node.name(), type = node.attribute("type").value();
      if (kind == "joint") count += type == "free" ? 6 : type == "ball" ? 3 : 1;
      if (kind == "freejoint") count += 6;
    });
  }
  return count;
}

// An attribute of the document's elements of that name in sections of that name; 0 where none has it. The last one
// counts, as MuJoCo reads them.
double setting(pugi::xml_node root, const char* section, const char* element, const char* attribute) {
  double value = 0;
  const auto read = [&](pugi::xml_node node) {
    const std::vector<double> given = numbers(node.attribute(attribute));
    if (given.size() == 1) value = given[0];
  };
  for (const pugi::xml_node part : root.children(section)) {
    if (element == nullptr) {
      read(part);
    } else {
      for (const pugi::xml_node node : part.children(element)) read(node);
    }
  }
  return value;
}

}  // namespace

double made_by(pugi::xml_node element) {
  double all = 1;
  for (const double count : numbers_in(element, "count")) all *= std::max(count, 1.0);
  return all;
}

void Counts::add_made(pugi::xml_node node, double made) {
  elements_ += kEach * made;
  degrees_ += kDegreesEach * made;
  double along = 0;
  for (const double count : numbers_in(node, "count")) along += std::max(count, 1.0);
  chains_ += kDegreesEach * made * kDegreesEach * along;
  name_bytes_ += kEach * made * static_cast<double>(std::strlen(node.attribute("prefix").value()));
}

// As deep as elements may be nested, each body has at most six that move everything behind it.
void Counts::add_degrees(pugi::xml_node node, double copies) {
  constexpr double kDeepest = 6 * 256;
  const bool is_free = is(node, "freejoint") || std::strcmp(node.attribute("type").value(), "free") == 0;
  const double own = is_free ? 6 : std::strcmp(node.attribute("type").value(), "ball") == 0 ? 3 : 1;
  degrees_ += own * copies;
  chains_ += own * copies * std::min(degrees_, kDeepest);
}

void Counts::add(pugi::xml_node node) {
  const double copies = copies_of(node);
  elements_ += copies;
  text_bytes_ += text_of(node) * copies;
  longest_user_ = std::max(longest_user_, static_cast<double>(words(node.attribute("user"))));
  if (makes_many(node)) add_made(node, made_by(node) * copies);
  if (is_one_of(node, {"joint", "freejoint"})) add_degrees(node, copies);
  if (is(node.parent(), "actuator")) {
    actuators_ += copies;
    moved_.push_back(node);
  }
  if (is(node, "lengthrange")) lengths_ = node;
  if (is(node.parent(), "tendon")) tendons_ += copies;
  if (node.attribute("mocap")) mocaps_ += copies;
  if (is(node, "numeric")) numeric_ += std::clamp(number(node, "size").value_or(0), 0.0, kMostNumeric);
  if (is(node.parent(), "sensor")) sensed_ += std::max(number(node, "dim").value_or(0), 0.0);
  if (is(node, "option") && node.attribute("jacobian")) {
    dense_ = std::strcmp(node.attribute("jacobian").value(), "dense") == 0;
  }
  if (is(node, "key")) {
    ++keyframes_;
    last_key_ = node;
  }
  if (is(node, "size")) sizes_.push_back(node);
  if (!(elements_ <= static_cast<double>(limits_.elements))) most_at_ = most_at_ ? most_at_ : node;
}

void Counts::check(pugi::xml_node root, Budget& budget) const {
  if (most_at_) {
    fail(Status::kModel, "{}: the document has, or composites in it become, {} elements, more than max_elements ({})",
         where(most_at_), elements_, limits_.elements);
  }
  const double keyframes = std::max(keyframes_, size("nkey", 0));
  if (!(keyframes <= static_cast<double>(limits_.keyframes))) {
    fail(Status::kModel, "{}: {} keyframes, more than max_keyframes ({})", where(last_key_), keyframes,
         limits_.keyframes);
  }
  const double rows = size("njmax", 500), dense = dense_ ? cost::kDense * (degrees_ + rows) : 0;
  budget.add_time(root, cost::kTextByte * text_bytes_ + cost::kElements * elements_ * elements_ +
                            (cost::kDegrees + dense) * degrees_ * degrees_);
  budget.add_time(lengths_ ? lengths_ : root, lengths_seconds(root));
  budget.add_bytes(root, model_bytes());
  budget.add_bytes(last_key_ ? last_key_ : root, key_bytes());
}

// An attribute of <size>, the last one that counts; those below 0 say nothing.
double Counts::size(const char* name, double otherwise) const {
  for (const pugi::xml_node sizes : sizes_) {
    const double given = number(sizes, name).value_or(-1);
    if (!(given < 0)) otherwise = given;
  }
  return otherwise;
}

// But for what lies in files. A number of two characters becomes eight bytes.
double Counts::model_bytes() const {
  constexpr double kElement = 512, kGrowth = 4;
  double user = longest_user_;
  for (const char* name : {"nuser_body", "nuser_jnt", "nuser_geom", "nuser_site", "nuser_cam", "nuser_tendon",
                           "nuser_actuator", "nuser_sensor"}) {
    user = std::max(user, size(name, 0));
  }
  return (kElement + kNumber * user) * elements_ + kGrowth * text_bytes_ + name_bytes_ + kNumber * numeric_;
}

double Counts::key_bytes() const {
  constexpr double kPositions = 7.0 / 6, kMocap = 7;
  const double each = 1 + (1 + kPositions) * degrees_ + 2 * actuators_ + kMocap * mocaps_;
  return kNumber * each * std::max(keyframes_, size("nkey", 0));
}

// Muscles, or all actuators, are moved to both ends, step by step, to find their range of length, unless the document
// gives it.
double Counts::lengths_seconds(pugi::xml_node root) const {
  constexpr double kStep = 1e-6, kDegree = 0.2e-6, kEnds = 2;
  const std::string mode = lengths_.attribute("mode").value();
  if (mode == "none" || moved_.empty()) return 0;
  const Defaults defaults(root);
  const auto needs = [&](pugi::xml_node actuator) {
    if (defaults.find(actuator, "lengthrange")) return false;
    const bool is_muscle = is(actuator, "muscle") || is_muscle_type(defaults.find(actuator, "gaintype")) ||
                           is_muscle_type(defaults.find(actuator, "biastype"));
    return is_muscle || !(mode.empty() || mode == "muscle");
  };
  const auto moved = static_cast<double>(std::count_if(moved_.begin(), moved_.end(), needs));
  const double steps = number(lengths_, "inttotal").value_or(10) / number(lengths_, "timestep").value_or(0.01);
  return kEnds * moved * std::max(steps, 0.0) * (kStep + kDegree * degrees_);
}

// As MuJoCo sizes a world's buffers: where the document does not say, for the worst case.
void Counts::check_world(pugi::xml_node root, Budget& budget) const {
  const double contacts = size("nconmax", 100), rows = size("njmax", 500);
  const double worst = 5 * (rows + degrees_) * (rows + degrees_);
  const double stack = size("nstack", 0) > 0 ? size("nstack", 0) : worst;
  const double numbers = stack + size("nuserdata", 0) + rows * (1.5 * rows + 3 * degrees_ + 40) + sensed_ +
                         (actuators_ + tendons_) * degrees_ + 3 * chains_;
  const double buffers = numbers * kNumber + contacts * sizeof(mjContact), bytes = buffers + budget.bytes();
  if (bytes <= static_cast<double>(limits_.world_bytes)) {
    return budget.add_time(sizes_.empty() ? root : sizes_.back(), cost::kByte * buffers);
  }
  fail(Status::kModel,
       "{}: a world would need about {:.3g} bytes (its model {:.3g}, nconmax {}, njmax {}, nstack {}, {} degrees of "
       "freedom), more than max_world_bytes ({})",
       sizes_.empty() ? "the scene" : where(sizes_.back()), bytes, budget.bytes(), contacts, rows, stack, degrees_,
       limits_.world_bytes);
}

void Budget::add_time(pugi::xml_node node, double seconds) {
  constexpr double kMillisecond = 1e-3;
  seconds_ += seconds;
  if (seconds_ <= static_cast<double>(limits_.compile_ms) * kMillisecond) return;
  fail(Status::kModel,
       "{}: with this <{}>, compiling the document would take about {:.3g} s, more than max_compile_ms ({})",
       where(node), node.name(), seconds_, limits_.compile_ms);
}

void Budget::add_bytes(pugi::xml_node node, double bytes) {
  bytes_ += bytes;
  const auto allowed = static_cast<double>(limits_.world_bytes);
  if (bytes_ > allowed) {
    fail(Status::kModel, "{}: with this <{}>, the model would have about {:.3g} bytes, more than max_world_bytes ({})",
         where(node), node.name(), bytes_, limits_.world_bytes);
  }
  if (bytes_ > engine::most_model_bytes()) {
    fail(Status::kModel, "{}: with this <{}>, the model would have about {:.3g} bytes, more than {} can count ({:.0f})",
         where(node), node.name(), bytes_, engine::compiler_name(), engine::most_model_bytes());
  }
}

void size_buffers(pugi::xml_node root, int mittens, int fingers, int objects) {
  if (mittens + fingers == 0) return;
  const auto sum = [=](int Buffers::*which) {
    return kRoom.*which + mittens * kMitten.*which + fingers * kFingers.*which + objects * kObject.*which;
  };
  const int matrix = degrees_of_freedom(root) * degrees_of_freedom(root);
  const std::array<std::pair<const char*, int>, 3> needed = {
      {{"nconmax", sum(&Buffers::contacts)},
       {"njmax", sum(&Buffers::constraints)},
       {"nstack", sum(&Buffers::stack) + kStackPerEntry * matrix}}};
  bool decided = false;  // by the document's author, who could not know of the infants
  for (const pugi::xml_node given : root.children("size")) {
    for (const auto& [name, least] : needed) {
      const pugi::xml_attribute number = given.attribute(name);
      decided = decided || number;
      if (number && number.as_int(-1) >= 0 && number.as_int() < least) set(given, name, std::to_string(least));
    }
  }
  if (decided) return;
  const pugi::xml_node size = section(root, "size");
  for (const auto& [name, least] : needed) set(size, name, std::to_string(least));
}

void keep_hands_in_sight(pugi::xml_node root) {
  constexpr double kNear = 0.005, kExtent = 2;
  const double extent = setting(root, "statistic", nullptr, "extent"), near = setting(root, "visual", "map", "znear");
  if (extent > 0 && near > 0) return;
  const double own_extent = extent > 0 ? extent : near > 0 ? kNear / near : kExtent;
  if (extent == 0) set(section(root, "statistic"), "extent", Span<const double>(&own_extent, 1));
  if (near > 0) return;
  const double own_near = kNear / own_extent;
  const pugi::xml_node visual = section(root, "visual");
  set(section(visual, "map"), "znear", Span<const double>(&own_near, 1));
}

}  // namespace mimo::document
