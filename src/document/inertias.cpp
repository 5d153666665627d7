#include "document/inertias.h"

#include <array>

#include "base/fail.h"
#include "base/names.h"
#include "document/compiler.h"
#include "document/composition.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

// With the values that do nothing.
struct Setting {
  const char* name;
  const char* harmless;
};
constexpr std::array<Setting, 9> kSettings = {{{"inertiafromgeom", "auto"},
                                               {"inertiagrouprange", "0 5"},
                                               {"settotalmass", "-1"},
                                               {"boundmass", "0"},
                                               {"boundinertia", "0"},
                                               {"balanceinertia", "false"},
                                               {"exactmeshinertia", "false"},
                                               {"discardvisual", "false"},
                                               {"fusestatic", "false"}}};

std::vector<pugi::xml_node> bodies_of(pugi::xml_node root) {
  std::vector<pugi::xml_node> bodies;
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      if (std::string(node.name()) == "body") bodies.push_back(node);
    });
  }
  return bodies;
}

std::string working_setting(pugi::xml_node root) {
  for (const Setting& setting : kSettings) {
    const std::string value = compiler_setting(root, setting.name);
    if (!value.empty() && value != setting.harmless) return std::string(setting.name) + "=\"" + value + "\"";
  }
  return "";
}

void remove_setting(pugi::xml_node root, const char* name) {
  for (pugi::xml_node compiler : root.children("compiler")) {
    while (compiler.remove_attribute(name)) {
    }
  }
}

std::string name_for(std::size_t body) { return names::kNameless + std::to_string(body); }

// The document as it is, but that every body can be found in the model: none without a name, none fused with another.
engine::ModelPtr compile_with_names(const pugi::xml_document& document, const Limits& limits) {
  pugi::xml_document named = copy(document);
  const pugi::xml_node root = named.document_element();
  remove_setting(root, "fusestatic");
  std::size_t number = 0;
  for (const pugi::xml_node body : bodies_of(root)) {
    if (!body.attribute("name")) set(body, "name", name_for(number));
    ++number;
  }
  return compile_quietly(named, limits);
}

void set_inertia(pugi::xml_node body, const mjModel& model, int id) {
  while (body.remove_child("inertial")) {
  }
  const pugi::xml_node inertial = body.prepend_child("inertial");
  if (inertial.empty()) throw std::bad_alloc();
  set(inertial, "pos", Span<const double>(model.body_ipos + 3 * id, 3));
  set(inertial, "quat", Span<const double>(model.body_iquat + 4 * id, 4));
  set(inertial, "mass", Span<const double>(model.body_mass + id, 1));
  set(inertial, "diaginertia", Span<const double>(model.body_inertia + 3 * id, 3));
}

}  // namespace

void weigh_alone(pugi::xml_document& document, const std::string& what, const Limits& limits) {
  const pugi::xml_node root = document.document_element();
  const std::string setting = working_setting(root);
  if (setting.empty()) return;
  if (root.find_node([](pugi::xml_node node) { return std::string(node.name()) == "composite"; })) {
    fail(Status::kUnsupported, "{} has a composite and compiler {}, which would count for what is put beside it, too",
         what, setting);
  }
  const engine::ModelPtr model = compile_with_names(document, limits);
  std::size_t number = 0;
  for (const pugi::xml_node body : bodies_of(root)) {
    const pugi::xml_attribute name = body.attribute("name");
    const std::string found = name ? name.value() : name_for(number);
    set_inertia(body, *model, engine::find_or_fail(*model, engine::Kind::kBody, found));
    ++number;
  }
  for (const Setting& entry : kSettings) remove_setting(root, entry.name);
}

}  // namespace mimo::document
