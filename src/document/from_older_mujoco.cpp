#include <cstring>
#include <set>
#include <string>

#include "base/fail.h"
#include "base/format.h"
#include "base/names.h"
#include "document/composites.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/other_versions.h"
#include "document/report.h"
#include "document/xml.h"

namespace mimo::document {
namespace {

struct Renamed {
  const char *element, *attribute, *instead;
};
constexpr Renamed kRenamed[] = {{"lengthrange", "inteval", "interval"},
                                {"option", "mpr_iterations", "ccd_iterations"},
                                {"option", "mpr_tolerance", "ccd_tolerance"}};

struct Gone {
  const char *element, *attribute, *why;
};
constexpr Gone kGone[] = {{"option", "apirate", "it is left out, as it never did anything"},
                          {"compiler", "convexhull", "it is left out: meshes collide by their convex hulls"},
                          {"flag", "sensornoise", "it is left out: MuJoCo's sensors have no noise"}};

std::string about(const char* element, const char* attribute) {
  return format("{}the attribute {} of <{}>; ", nobody_knows(), attribute, element);
}

template <typename Visit>
void visit_settings(pugi::xml_node root, Visit&& visit) {
  for (const char* section : {"compiler", "option"}) {
    for (const pugi::xml_node node : root.children(section)) walk(node, visit);
  }
}

void replace_settings(pugi::xml_node root, Report& report) {
  visit_settings(root, [&](pugi::xml_node node) {
    for (const auto& [element, attribute, instead] : kRenamed) {
      if (!is(node, element) || !node.attribute(attribute)) continue;
      if (!node.attribute(instead)) set(node, instead, node.attribute(attribute).value());
      node.remove_attribute(attribute);
      report.add(node, about(element, attribute) + format("it is {} now", instead));
    }
    for (const auto& [element, attribute, why] : kGone) {
      if (!is(node, element) || !node.remove_attribute(attribute)) continue;
      report.add(node, about(element, attribute) + why);
    }
    if (is(node, "flag") && node.attribute("passive")) {
      for (const char* part : {"spring", "damper"}) set(node, part, node.attribute("passive").value());
      node.remove_attribute("passive");
      report.add(node, about("flag", "passive") + "it is spring and damper now");
    }
  });
}

template <typename Visit>
void visit_geoms(pugi::xml_node root, Visit&& visit) {
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      if (is(node, "geom")) visit(node);
    });
  }
}

// Which collisions were looked for: all, those of chosen pairs, or those of all but these.
void replace_collisions(pugi::xml_node root, Report& report) {
  std::string chosen;
  for (pugi::xml_node option : root.children("option")) {
    if (!option.attribute("collision")) continue;
    chosen = option.attribute("collision").value();
    option.remove_attribute("collision");
    report.add(option, about("option", "collision") + "its effect is now in the attributes of geoms and pairs");
  }
  if (chosen == "predefined") {
    visit_geoms(root, [](pugi::xml_node geom) {
      for (const char* attribute : {"contype", "conaffinity"}) set(geom, attribute, "0");
    });
  } else if (chosen == "dynamic") {
    for (pugi::xml_node contact : root.children("contact")) {
      while (contact.child("pair")) contact.remove_child("pair");
    }
  }
}

template <typename Visit>
void visit_meshes(pugi::xml_node root, Visit&& visit) {
  for (const pugi::xml_node assets : root.children("asset")) {
    for (const pugi::xml_node mesh : assets.children("mesh")) visit(mesh);
  }
}

void replace_exact_inertias(pugi::xml_node root, Report& report) {
  std::string exact;
  for (pugi::xml_node compiler : root.children("compiler")) {
    if (!compiler.attribute("exactmeshinertia")) continue;
    exact = compiler.attribute("exactmeshinertia").value();
    compiler.remove_attribute("exactmeshinertia");
    report.add(compiler, about("compiler", "exactmeshinertia") + "the attribute inertia of its meshes replaces it");
  }
  if (exact.empty()) return;
  visit_meshes(root, [&](pugi::xml_node mesh) {
    if (!mesh.attribute("inertia")) set(mesh, "inertia", exact == "true" ? "exact" : "legacy");
  });
}

// How mass lies in a mesh is no longer said of the geoms that show it.
void replace_shells(pugi::xml_node root, Report& report) {
  const Defaults defaults(root);
  std::set<std::string> shells, solids;
  std::vector<pugi::xml_node> geoms;
  visit_geoms(root, [&](pugi::xml_node geom) {
    const std::string mesh = defaults.find(geom, "mesh").value();
    if (mesh.empty()) return;
    const bool shell = std::strcmp(defaults.find(geom, "shellinertia").value(), "true") == 0;
    (shell ? shells : solids).insert(mesh);
    if (shell && solids.count(mesh) + shells.count(mesh) == 2) {
      refuse_unknown(geom, format("shellinertia of one geom of mesh \"{}\" and not of another", mesh));
    }
    if (shell) geoms.push_back(geom);
  });
  for (const pugi::xml_node geom : geoms) {
    set(geom, "shellinertia", "false");
    report.add(geom, nobody_knows() + "shellinertia of geoms with a mesh; it is inertia=\"shell\" of the mesh now");
  }
  visit_meshes(root, [&](pugi::xml_node mesh) {
    const std::string name =
        mesh.attribute("name") ? mesh.attribute("name").value() : stem_of(mesh.attribute("file").value());
    if (shells.count(name) > 0) set(mesh, "inertia", "shell");
  });
}

// The main class had a name of one's own.
void replace_main_class(pugi::xml_node root, Report& report) {
  for (const pugi::xml_node top : root.children("default")) {
    const std::string name = top.attribute("class").value();
    if (name.empty() || name == "main") continue;
    report.add(top,
               nobody_knows() + format("another name for the main class; \"{}\" is a class of all elements now", name));
    return name_main_defaults(root, name);
  }
}

void refuse_distances(pugi::xml_node root) {
  for (const pugi::xml_node equalities : root.children("equality")) {
    const pugi::xml_node distance = equalities.child("distance");
    if (distance) refuse_unknown(distance, "<distance> in <equality>");
  }
}

}  // namespace

void upgrade_older(pugi::xml_node root, const Limits& limits, Report& report) {
  refuse_distances(root);
  replace_main_class(root, report);
  replace_settings(root, report);
  replace_exact_inertias(root, report);
  replace_shells(root, report);
  expand_composites(root, limits, report);
  replace_collisions(root, report);
}

}  // namespace mimo::document
