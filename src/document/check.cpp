#include "document/check.h"

#include <cmath>
#include <string>

#include "base/fail.h"
#include "document/attributes.h"
#include "document/check_meshes.h"
#include "document/check_pictures.h"
#include "document/counts.h"
#include "document/lines.h"
#include "document/xml.h"

namespace mimo::document {
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

void check_composite_skin(pugi::xml_node composite, const Limits& limits) {
  const double fineness = 1 + std::max(0.0, number(composite.child("skin"), "subgrid").value_or(0));
  const double count = made_by(composite) * fineness * fineness;
  if (count <= static_cast<double>(limits.vertices)) return;
  fail(Status::kModel, "{}: the skin of a composite would have {} vertices, more than max_vertices ({})",
       where(composite), count, limits.vertices);
}

}  // namespace

Budget check(pugi::xml_node root, const Limits& limits) {
  Budget budget(limits);
  Counts counts(limits);
  walk(root, [&](pugi::xml_node node) { counts.add(node); });
  counts.check(root, budget);
  Meshes meshes(root, limits);
  walk(root, [&](pugi::xml_node node) {
    if (is(node, "option")) check_option(node, limits);
    if (is(node, "lengthrange")) check_length_range(node);
    if (is(node, "numeric")) check_numeric(node);
    if (is(node, "composite")) check_composite_skin(node, limits);
    if (is(node, "quality")) check_shadows(node, limits);
    if (!is(node.parent(), "asset")) return;
    if (is(node, "texture")) check_texture(node, limits, budget);
    if (is(node, "hfield")) check_height_field(node, limits, budget);
    if (is(node, "mesh")) meshes.check(node, budget);
    if (is(node, "skin")) check_skin(node, limits, budget);
  });
  counts.check_world(root, budget);
  return budget;
}

}  // namespace mimo::document
