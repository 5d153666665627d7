#include "body/faces.h"

#include "capi/check.h"
#include "capi/guard.h"
#include "capi/objects.h"

using namespace mimo;
using namespace mimo::capi;

extern "C" {

const char* mimo_face_name(size_t index) noexcept {
  return index < body::kFaces.size() ? body::kFaces[index] : nullptr;
}

mimo_status mimo_env_set_face(mimo_env* env, size_t agent, const char* name) noexcept {
  return guard(env, [&] {
    env::World& world = open(env).world;
    check_agent(world.agents(), agent);
    require(name != nullptr, "name is NULL");
    world.set_face(agent, name);
  });
}

mimo_status mimo_env_face(const mimo_env* env, size_t agent, const char** name) noexcept {
  return guard(env, [&] {
    const env::World& world = open(env).world;
    check_agent(world.agents(), agent);
    out(name, "name") = world.face(agent).c_str();
  });
}

}  // extern "C"
