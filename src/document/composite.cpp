#include "document/composite.h"

#include <algorithm>
#include <cmath>

#include "base/fail.h"
#include "base/format.h"
#include "document/lines.h"
#include "document/report.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

constexpr std::initializer_list<const char*> kTypes = {"particle", "grid", "rope",     "loop",
                                                       "cloth",    "box",  "cylinder", "ellipsoid"};
constexpr std::initializer_list<const char*> kAttributes = {"prefix", "type",        "count",        "spacing",
                                                            "offset", "flatinertia", "solrefsmooth", "solimpsmooth"};

bool holds(std::initializer_list<const char*> names, const std::string& name) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return name == one; });
}

// What came with versions between 2.2 and those that have no composites.
void require_known(pugi::xml_node node) {
  for (const pugi::xml_attribute attribute : node.attributes()) {
    if (is_note(attribute) || holds(kAttributes, attribute.name())) continue;
    refuse_unknown(node, format("the attribute {} of <composite> (\"{}\")", attribute.name(), attribute.value()));
  }
  const std::string type = node.attribute("type").value();
  if (!holds(kTypes, type)) refuse_unknown(node, format("<composite> of type \"{}\"", type));
}

}  // namespace

Composite::Composite(pugi::xml_node element)
    : node(element),
      prefix(element.attribute("prefix").value()),
      type(element.attribute("type").value()),
      skin(element.child("skin")) {
  require_known(node);
  std::array<double, 3> counts{1, 1, 1};
  read(node.attribute("count"), counts);
  read(node.attribute("spacing"), Span<double>(&spacing, 1));
  read(node.attribute("offset"), offset);
  if (!(spacing > 1e-14)) refuse(format("spacing is \"{}\", expected a length", node.attribute("spacing").value()));
  bool single = false;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const bool whole = counts[i] >= 1 && counts[i] <= 1e6 && counts[i] == std::floor(counts[i]);
    if (!whole || (single && counts[i] > 1)) {
      refuse(format("count is \"{}\", expected numbers from 1, those of 1 last", node.attribute("count").value()));
    }
    count[i] = static_cast<int>(counts[i]);
    single = count[i] == 1;
    dimensions += single ? 0 : 1;
  }
}

bool Composite::is(std::initializer_list<const char*> types) const { return holds(types, type); }

std::string Composite::named(const char* kind, std::initializer_list<int> numbers) const {
  return prefix + kind + join(numbers, "_");
}

void Composite::read(pugi::xml_attribute attribute, Span<double> values) const {
  const std::vector<double> given = numbers(attribute);
  if (given.size() > values.size()) {
    refuse(format("{} is \"{}\", expected at most {} numbers", attribute.name(), attribute.value(), values.size()));
  }
  std::copy(given.begin(), given.end(), values.begin());
}

void Composite::refuse(const std::string& what) const {
  fail(Status::kModel, "{}: composite of type \"{}\": {}", where(node), type, what);
}

}  // namespace mimo::document
