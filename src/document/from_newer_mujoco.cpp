#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/format.h"
#include "base/functions.h"
#include "base/numbers.h"
#include "document/attributes.h"
#include "document/defaults.h"
#include "document/names.h"
#include "document/other_versions.h"
#include "document/report.h"
#include "document/xml.h"
#include "engine/compiler.h"

namespace mimo::document {
namespace {

using Two = std::array<double, 2>;

constexpr const char* kTranslated[] = {"sensorsize",     "focal",        "focalpixel", "principal",
                                       "principalpixel", "orthographic", "projection"};

// Width and height of an attribute, the camera's own or its class's.
std::optional<Two> two(const Defaults& defaults, pugi::xml_node camera, const char* attribute) {
  const std::vector<double> given = numbers_in(defaults.giver(camera, attribute), attribute);
  if (given.size() != 2) return std::nullopt;
  return Two{given[0], given[1]};
}

// A length on the sensor, which may be given in pixels.
Two on_sensor(const Defaults& defaults, pugi::xml_node camera, const char* length, const char* pixels, Two pixel) {
  if (const std::optional<Two> given = two(defaults, camera, pixels)) {
    return {(*given)[0] * pixel[0], (*given)[1] * pixel[1]};
  }
  return two(defaults, camera, length).value_or(Two{0, 0});
}

bool is_orthographic(const Defaults& defaults, pugi::xml_node camera) {
  const auto says = [&](const char* attribute, const char* word) {
    return std::strcmp(defaults.find(camera, attribute).value(), word) == 0;
  };
  return says("orthographic", "true") || says("projection", "orthographic");
}

void tell_losses(pugi::xml_node camera, Two sensor, Two pixel, Two focal, Two principal, Report& report) {
  constexpr double kNearly = 0.01;
  if (principal[0] != 0 || principal[1] != 0) {
    report.add(camera,
               format("{}principal points: the picture of this <camera> is moved by {:.3g} % of its width and {:.3g} % "
                      "of its height against what it shows",
                      nobody_knows(), 100 * principal[0] / sensor[0], 100 * principal[1] / sensor[1]));
  }
  const double aspect = pixel[0] / focal[0] / (pixel[1] / focal[1]);
  if (std::abs(aspect - 1) > kNearly) {
    report.add(camera,
               format("{}pixels that are not square: those of this <camera> are {:.3g} times as wide as high; its "
                      "field of view is right in height only",
                      nobody_knows(), aspect));
  }
}

// Whether there was a lens before a sensor.
bool translate(pugi::xml_node camera, const Defaults& defaults, Report& report) {
  const std::optional<Two> sensor = two(defaults, camera, "sensorsize");
  if (!sensor || !((*sensor)[0] > 0 && (*sensor)[1] > 0)) return false;
  const Two resolution = two(defaults, camera, "resolution").value_or(Two{1, 1});
  const Two pixel{(*sensor)[0] / resolution[0], (*sensor)[1] / resolution[1]};
  const Two focal = on_sensor(defaults, camera, "focal", "focalpixel", pixel);
  if (!(focal[0] > 0 && focal[1] > 0)) return false;
  const double fovy = 2 * fixed::atan((*sensor)[1] / 2 / focal[1]) / kDegree;
  set(camera, "fovy", Span<const double>(&fovy, 1));
  tell_losses(camera, *sensor, pixel, focal, on_sensor(defaults, camera, "principal", "principalpixel", pixel), report);
  return true;
}

// Whose fovy is a length.
bool show_in_perspective(pugi::xml_node camera, Report& report) {
  set(camera, "fovy", "45");
  report.add(camera, nobody_knows() + "orthographic cameras; this one shows in perspective, 45 degrees high");
  return true;
}

using engine::SchemaElement;

// Tables are constants, not made at their first use: a child that is forked while another thread makes one would wait
// for it for ever.
using Names = std::initializer_list<const char*>;

struct Attributes {
  const char* element;
  Names names;
};

// Attributes that say nothing of how things move: what pictures look like, how the compiler and the solver of newer
// versions go about their work, what is written back to files.
constexpr Attributes kHarmlessAttributes[] = {
    {"compiler", {"alignfree", "saveinertial", "savecanonical", "savecompiled", "conflict"}},
    {"option",
     {"ccd_iterations", "ccd_tolerance", "ls_iterations", "ls_tolerance", "sdf_iterations", "sdf_initpoints",
      "sleep_tolerance"}},
    {"flag", {"autoreset", "eulerdamp", "invdiscrete", "island", "midphase", "nativeccd", "sleep", "diagexact"}},
    {"size", {"memory"}},
    {"mesh", {"maxhullvert", "content_type", "material", "octree_maxdepth"}},
    {"hfield", {"content_type"}},
    {"texture", {"colorspace", "content_type", "nchannel", "embed"}},
    {"material", {"metallic", "roughness"}},
    {"geom", {"castshadow"}},
    {"camera",
     {"focal", "focalpixel", "output", "principal", "principalpixel", "projection", "orthographic", "resolution",
      "sensorsize"}},
    {"light", {"bulbradius", "intensity", "range", "softness", "texture", "type"}},
    {"body", {"sleep", "simple", "fuse"}},
    {"freejoint", {"align"}},
};

// Values that newer versions give attributes by themselves: who writes them says nothing.
constexpr Names kHarmlessZeros = {"gravcomp", "dampratio",   "kv",       "timeconst", "inheritrange",
                                  "adhesion", "springyield", "armature", "damping",   "delay",
                                  "nsample",  "tausmooth",   "plastic"};

struct Word {
  const char *attribute, *value;
};
constexpr Word kHarmlessWords[] = {{"actearly", "false"},
                                   {"actuatorgravcomp", "false"},
                                   {"spring", "enable"},
                                   {"damper", "enable"},
                                   {"actuatorfrclimited", "false"},
                                   {"actuatorgroupdisable", ""},
                                   {"inertia", "legacy"},
                                   {"inertia", "exact"},
                                   {"inertia", "convex"},
                                   {"actdim", "-1"}};

// Whole elements: sensors that are only missing from the output, and defaults of elements that have none in this
// version.
constexpr Names kHarmlessSensors = {
    "camprojection", "jointactuatorfrc", "tendonactuatorfrc", "insidesite", "distance", "normal",
    "fromto",        "contact",          "e_potential",       "e_kinetic",  "tactile"};

bool equal(const char* one, const char* two) { return std::strcmp(one, two) == 0; }

bool holds(Names names, const char* name) {
  return std::any_of(names.begin(), names.end(), [name](const char* one) { return equal(one, name); });
}

bool is_harmless_element(pugi::xml_node node) {
  const char *name = node.name(), *parent = node.parent().name();
  if (equal(parent, "sensor")) return holds(kHarmlessSensors, name);
  return (equal(parent, "default") && equal(name, "texture")) || (equal(parent, "material") && equal(name, "layer"));
}

struct Nearest {
  const char *element, *attribute, *value, *instead;
};
constexpr Nearest kNearest[] = {{"option", "integrator", "implicitfast", "implicit"},
                                {"general", "dyntype", "filterexact", "filter"}};

bool is_picture_setting(pugi::xml_node node) { return is(node.parent(), "visual") || is(node, "visual"); }

bool is_zero(pugi::xml_attribute attribute) {
  const std::vector<double> values = numbers(attribute);
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
}

bool is_harmless_word(pugi::xml_attribute attribute) {
  return std::any_of(std::begin(kHarmlessWords), std::end(kHarmlessWords), [&](const Word& word) {
    return equal(word.attribute, attribute.name()) && equal(word.value, attribute.value());
  });
}

bool is_harmless(pugi::xml_node node, pugi::xml_attribute attribute) {
  if (is_picture_setting(node) || is_harmless_word(attribute)) return true;
  if (holds(kHarmlessZeros, attribute.name()) && is_zero(attribute)) return true;
  return std::any_of(std::begin(kHarmlessAttributes), std::end(kHarmlessAttributes), [&](const Attributes& harmless) {
    return is(node, harmless.element) && holds(harmless.names, attribute.name());
  });
}

void take_nearest(pugi::xml_node root, Report& report) {
  walk(root, [&](pugi::xml_node node) {
    for (const Nearest& entry : kNearest) {
      if (!is(node, entry.element) || !equal(node.attribute(entry.attribute).value(), entry.value)) continue;
      set(node, entry.attribute, entry.instead);
      report.add(node, format("{}{}=\"{}\" of <{}>; \"{}\" comes nearest and is taken", nobody_knows(), entry.attribute,
                              entry.value, entry.element, entry.instead));
    }
  });
}

void rename(pugi::xml_node node, const char* attribute, const char* name) {
  if (!node.attribute(attribute)) return;
  if (!node.attribute(name)) set(node, name, node.attribute(attribute).value());
  node.remove_attribute(attribute);
}

// How mass lies in a mesh was once said of the geoms that show it.
void take_shells(pugi::xml_node root) {
  std::set<std::string> shells;
  for (const pugi::xml_node assets : root.children("asset")) {
    for (pugi::xml_node mesh : assets.children("mesh")) {
      if (!equal(mesh.attribute("inertia").value(), "shell")) continue;
      shells.insert(mesh.attribute("name") ? mesh.attribute("name").value() : stem_of(mesh.attribute("file").value()));
      mesh.remove_attribute("inertia");
    }
  }
  if (shells.empty()) return;
  const Defaults defaults(root);
  for (const pugi::xml_node world : root.children("worldbody")) {
    walk(world, [&](pugi::xml_node node) {
      const bool shows = is(node, "geom") && shells.count(defaults.find(node, "mesh").value()) > 0;
      if (shows) set(node, "shellinertia", "true");
    });
  }
}

// What has another name or form now, and the same meaning.
void take_same(pugi::xml_node root) {
  for (const pugi::xml_node compiler : root.children("compiler")) {
    for (const pugi::xml_node lengths : compiler.children("lengthrange")) rename(lengths, "interval", "inteval");
  }
  walk(root, [](pugi::xml_node node) {
    if (is(node, "light") && equal(node.attribute("type").value(), "directional")) {
      node.remove_attribute("type");
      set(node, "directional", "true");
    }
    const bool paints = is(node.parent(), "material") && is(node, "layer");
    if (paints && equal(node.attribute("role").value(), "rgb")) {
      set(node.parent(), "texture", node.attribute("texture").value());
    }
  });
}

void check_attributes(pugi::xml_node node, const SchemaElement& known, Report& report) {
  for (pugi::xml_attribute attribute = node.first_attribute(); attribute;) {
    const pugi::xml_attribute next = attribute.next_attribute();
    const std::string name = attribute.name();
    if (known.attributes.count(name) == 0 && !is_note(attribute)) {
      const std::string what = format("the attribute {} of <{}>", name, node.name());
      if (!is_harmless(node, attribute)) refuse_unknown(node, format("{} (\"{}\")", what, attribute.value()));
      report.add(node, nobody_knows() + what + "; it is left out");
      node.remove_attribute(attribute);
    }
    attribute = next;
  }
}

const SchemaElement* find(const SchemaElement& known, const char* self, const char* name) {
  if (known.nests && equal(self, name)) return &known;
  const auto found = known.children.find(name);
  return found == known.children.end() ? nullptr : &found->second;
}

struct Known {
  pugi::xml_node node;
  const SchemaElement* kind;
};

// Adds the children that are known; the others are left out or refused.
void check_children(const Known& parent, std::vector<Known>& known, Report& report) {
  pugi::xml_node node = parent.node;
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    const SchemaElement* kind = find(*parent.kind, node.name(), child.name());
    if (child.type() == pugi::node_element && kind != nullptr) {
      known.push_back({child, kind});
    } else if (child.type() == pugi::node_element) {
      const std::string what = format("<{}> in <{}>", child.name(), node.name());
      if (!is_harmless_element(child)) refuse_unknown(child, what);
      report.add(child, nobody_knows() + what + "; it is left out");
      node.remove_child(child);
    }
    child = next;
  }
}

// In the document's order, and without recursion: hosts have small stacks, documents deep nests.
void check(pugi::xml_node root, const SchemaElement& known, Report& report) {
  std::vector<Known> waiting = {{root, &known}};
  while (!waiting.empty()) {
    const Known next = waiting.back();
    waiting.pop_back();
    check_attributes(next.node, *next.kind, report);
    const auto before = static_cast<std::ptrdiff_t>(waiting.size());
    check_children(next, waiting, report);
    std::reverse(waiting.begin() + before, waiting.end());
  }
}

}  // namespace

void translate_cameras(pugi::xml_node root, Report& report) {
  const Defaults defaults(root);
  std::vector<pugi::xml_node> classes, done;
  walk(root, [&](pugi::xml_node camera) {
    if (!is(camera, "camera")) return;
    if (is(camera.parent(), "default")) return classes.push_back(camera);
    const bool translated =
        is_orthographic(defaults, camera) ? show_in_perspective(camera, report) : translate(camera, defaults, report);
    if (translated) done.push_back(camera);
  });
  // Elements that are omitted without a translation are reported elsewhere.
  if (!done.empty()) done.insert(done.end(), classes.begin(), classes.end());
  for (pugi::xml_node camera : done) {
    for (const char* attribute : kTranslated) camera.remove_attribute(attribute);
  }
}

void translate_newer(pugi::xml_node root, Report& report) {
  take_same(root);
  take_shells(root);
  translate_actuators(root);
  translate_cameras(root, report);
  take_nearest(root, report);
  check(root, engine::schema(), report);
}

}  // namespace mimo::document
