#include "scene/check.h"

#include <mujoco/mjdata.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/fail.h"
#include "scene/attributes.h"
#include "scene/check_meshes.h"
#include "scene/check_pictures.h"
#include "scene/lines.h"
#include "scene/xml.h"

namespace mimo::scene {
namespace {

void require_at_most(pugi::xml_node node, const char* attribute, double most, const char* limit) {
  const std::optional<double> value = number(node, attribute);
  if (!value || *value <= most) return;
  fail(Status::kModel, "{}: {}=\"{}\" is more than {} ({})", where(node), attribute, node.attribute(attribute).value(),
       limit, most);
}

void check_option(pugi::xml_node option, const Limits& limits) {
  const std::optional<double> step = number(option, "timestep");
  if (step && !(*step > 0 && std::isfinite(*step))) {
    fail(Status::kModel, "{}: timestep=\"{}\", expected seconds above 0", where(option),
         option.attribute("timestep").value());
  }
  for (const char* name :
       {"iterations", "noslip_iterations", "mpr_iterations", "ccd_iterations", "ls_iterations", "sdf_iterations"}) {
    require_at_most(option, name, static_cast<double>(limits.iterations), "max_iterations");
  }
}

// How far muscles and motors are moved to find their lengths, step by step.
void check_length_range(pugi::xml_node lengths) {
  constexpr double kMostSteps = 1e6;
  const double time = number(lengths, "inttotal").value_or(10), step = number(lengths, "timestep").value_or(0.01);
  if (step > 0 && time / step <= kMostSteps) return;
  fail(Status::kModel, "{}: inttotal {} over timestep {} of <lengthrange>, expected at most {} steps", where(lengths),
       time, step, kMostSteps);
}

// The compiler has room for 500 numbers, and believes what it is told.
void check_numeric(pugi::xml_node numeric) {
  constexpr double kMost = 500;
  const std::optional<double> size = number(numeric, "size");
  const double given = static_cast<double>(words(numeric.attribute("data")));
  if (size.value_or(given) <= kMost && given <= kMost) return;
  fail(Status::kModel, "{}: <numeric> of {} numbers, expected at most {}", where(numeric), size.value_or(given), kMost);
}

double product(const std::vector<double>& counts) {
  double all = 1;
  for (const double count : counts) all *= std::max(count, 1.0);
  return all;
}

// Elements that one of a composite becomes: a body, a geom, and up to three joints.
constexpr double kEach = 5;
constexpr double kDegreesEach = 3;

double made_by(pugi::xml_node composite) { return product(numbers_in(composite, "count")); }

void check_composite_skin(pugi::xml_node composite, const Limits& limits) {
  const double fineness = 1 + std::max(0.0, number(composite.child("skin"), "subgrid").value_or(0));
  const double count = made_by(composite) * fineness * fineness;
  if (count <= static_cast<double>(limits.vertices)) return;
  fail(Status::kModel, "{}: the skin of a composite would have {} vertices, more than max_vertices ({})",
       where(composite), count, limits.vertices);
}

class Counts {
 public:
  void add(pugi::xml_node node) {
    ++elements_;
    if (is(node, "composite")) {
      elements_ += kEach * made_by(node);
      degrees_ += kDegreesEach * made_by(node);
    }
    if (is(node, "joint")) {
      const std::string type = node.attribute("type").value();
      degrees_ += type == "free" ? 6 : type == "ball" ? 3 : 1;
    }
    if (is(node, "freejoint")) degrees_ += 6;
    if (is(node, "key")) {
      ++keyframes_;
      last_key_ = node;
    }
    if (is(node, "size")) sizes_.push_back(node);
    if (!(elements_ <= most_)) most_at_ = most_at_ ? most_at_ : node;
  }

  explicit Counts(const Limits& limits) : limits_(limits), most_(static_cast<double>(limits.elements)) {}

  void check() const {
    if (most_at_) {
      fail(Status::kModel, "{}: the document has, or composites in it become, {} elements, more than max_elements ({})",
           where(most_at_), elements_, limits_.elements);
    }
    const double keyframes = std::max(keyframes_, size("nkey", 0));
    if (!(keyframes <= static_cast<double>(limits_.keyframes))) {
      fail(Status::kModel, "{}: {} keyframes, more than max_keyframes ({})", where(last_key_), keyframes,
           limits_.keyframes);
    }
    check_bytes();
  }

 private:
  // An attribute of <size>, the last one that counts; those below 0 say nothing.
  double size(const char* name, double otherwise) const {
    for (const pugi::xml_node sizes : sizes_) {
      const double given = number(sizes, name).value_or(-1);
      if (!(given < 0)) otherwise = given;
    }
    return otherwise;
  }

  // As MuJoCo sizes a world's buffers: where the document does not say, for the worst case.
  void check_bytes() const {
    const double contacts = size("nconmax", 100), rows = size("njmax", 500);
    const double worst = 5 * (rows + degrees_) * (rows + degrees_);
    const double stack = size("nstack", 0) > 0 ? size("nstack", 0) : worst;
    double numbers = stack + size("nuserdata", 0) + rows * (1.5 * rows + 3 * degrees_ + 40);
    for (const char* name : {"nuser_body", "nuser_jnt", "nuser_geom", "nuser_site", "nuser_cam", "nuser_tendon",
                             "nuser_actuator", "nuser_sensor"}) {
      numbers += size(name, 0) * elements_;
    }
    const double bytes = numbers * sizeof(mjtNum) + contacts * sizeof(mjContact);
    if (bytes <= static_cast<double>(limits_.world_bytes)) return;
    fail(
        Status::kModel,
        "{}: a world would need about {:.3g} bytes (nconmax {}, njmax {}, nstack {}, {} degrees of freedom), more than "
        "max_world_bytes ({})",
        sizes_.empty() ? "the scene" : where(sizes_.back()), bytes, contacts, rows, stack, degrees_,
        limits_.world_bytes);
  }

  const Limits& limits_;
  double most_;
  double elements_ = 0, degrees_ = 0, keyframes_ = 0;
  std::vector<pugi::xml_node> sizes_;
  pugi::xml_node most_at_, last_key_;
};

}  // namespace

void check(pugi::xml_node root, const Limits& limits) {
  Counts counts(limits);
  walk(root, [&](pugi::xml_node node) { counts.add(node); });
  counts.check();
  walk(root, [&](pugi::xml_node node) {
    if (is(node, "option")) check_option(node, limits);
    if (is(node, "lengthrange")) check_length_range(node);
    if (is(node, "numeric")) check_numeric(node);
    if (is(node, "composite")) check_composite_skin(node, limits);
    if (is(node, "quality")) check_shadows(node, limits);
    if (!is(node.parent(), "asset")) return;
    if (is(node, "texture")) check_texture(node, limits);
    if (is(node, "hfield")) check_height_field(node, limits);
    if (is(node, "mesh")) check_mesh(node, root, limits);
    if (is(node, "skin")) check_skin(node, limits);
  });
}

}  // namespace mimo::scene
