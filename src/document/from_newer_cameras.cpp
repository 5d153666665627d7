#include "document/from_newer_cameras.h"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/angle.h"
#include "base/format.h"
#include "document/attributes.h"
#include "document/defaults.h"
#include "document/xml.h"

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
  const double fovy = 2 * std::atan((*sensor)[1] / 2 / focal[1]) / kDegree;
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
  // What is left out without having been translated is told of elsewhere.
  if (!done.empty()) done.insert(done.end(), classes.begin(), classes.end());
  for (pugi::xml_node camera : done) {
    for (const char* attribute : kTranslated) camera.remove_attribute(attribute);
  }
}

}  // namespace mimo::document
