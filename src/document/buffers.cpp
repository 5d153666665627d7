#include "document/buffers.h"

#include <array>
#include <string>
#include <utility>

#include "document/xml.h"

namespace mimo::document {
namespace {

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
