// Sounds that a host plays.
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

std::string body_name(const char* body) {
  const std::string name = text(body);
  require(!name.empty(), "body is {}, expected a name", body == nullptr ? "NULL" : "\"\"");
  return name;
}

Eigen::Vector3d vector(const double* numbers, const char* what) {
  require(numbers != nullptr, "{} is NULL, expected three numbers", what);
  check_finite(numbers, 3, what);
  return Eigen::Vector3d(numbers);
}

// A world, or attached senses, play what a caller gives.
template <typename Plays>
void play(Plays& plays, const char* body, const float* samples, std::size_t count, double rate) {
  plays.play(body_name(body), array(samples, count, "samples"), rate);
}

}  // namespace
}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_scene_set_sources(mimo_scene* scene, size_t count, double seconds) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    require(count >= 1 && count <= 64, "count is {}, expected 1 to 64 bodies that play at once", count);
    require(seconds >= 0.01 && seconds <= 600, "seconds is {}, expected 0.01 to 600", seconds);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.play.sources = count, edit.play.seconds = seconds;
      note(edit, {{"call", "set_sources"}, {"count", count}, {"seconds", seconds}});
    });
  });
}

mimo_status mimo_scene_direct_source(mimo_scene* scene, const char* body, const double* place, const double* axis,
                                     double directivity) noexcept {
  return guard(scene, [&] {
    blueprint::Blueprint& blueprint = open(scene).blueprint;
    const senses::Direction direction{body_name(body), vector(place, "place"), vector(axis, "axis"), directivity};
    require(direction.axis.norm() > 1e-9, "axis is 0 0 0, expected a direction");
    require(directivity >= 0 && directivity <= 1, "directivity is {}, expected 0 to 1", directivity);
    blueprint.edit([&](blueprint::SceneEdit& edit) {
      edit.play.directions.push_back(direction);
      note(edit, {{"call", "direct_source"},
                  {"body", direction.body},
                  {"place", std::vector<double>(place, place + 3)},
                  {"axis", std::vector<double>(axis, axis + 3)},
                  {"directivity", directivity}});
    });
  });
}

mimo_status mimo_env_play(mimo_env* env, const char* body, const float* samples, size_t count, double rate) noexcept {
  return guard(env, [&] { play(open(env).world(), body, samples, count, rate); });
}

mimo_status mimo_senses_play(mimo_senses* senses, const char* body, const float* samples, size_t count,
                             double rate) noexcept {
  return guard(senses, [&] { play(open(senses).attached, body, samples, count, rate); });
}

}  // extern "C"
