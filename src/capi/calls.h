// The calls that made a world besides its scene's document, as JSON in the header's words: recordings keep them.
#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "blueprint/blueprint.h"
#include "capi/check.h"
#include "capi/members.h"
#include "capi/structs.h"

namespace mimo::capi {

using Json = nlohmann::ordered_json;

template <typename T>
Json json_of_member(const T& member) {
  if constexpr (std::is_same_v<T, const char*>) {
    return text(member);
  } else if constexpr (std::is_array_v<T>) {
    return std::vector<std::remove_extent_t<T>>(std::begin(member), std::end(member));
  } else {
    return member;
  }
}

inline Json text_or_null(const char* given) { return given == nullptr ? Json(nullptr) : Json(given); }

// JSON has no infinite numbers.
inline Json number_or_null(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

// The members of a struct that are numbers and texts.
template <typename Struct>
Json json_of(Struct all) {
  Json json = Json::object();
  for_each_member(all, [&](const char* name, const auto& member) { json[name] = json_of_member(member); });
  return json;
}

// Keeps a call, {"call": "limit_sense", ...}, named as the function is behind mimo_scene_.
inline void note(blueprint::SceneEdit& edit, const Json& call) {
  edit.calls.push_back(call.dump(-1, ' ', false, Json::error_handler_t::replace));
}

// Of agents whose bodies the scene has by then.
inline Json call_of_agents(const char* call, mimo_agent_config config) {
  const mimo_agent_config standing{};
  if (text(config.root).empty()) config.acts = 0;
  config.body = "scene";
  config.place = MIMO_PLACE_SCENE;
  std::copy_n(standing.position, 3, config.position);
  std::copy_n(standing.orientation, 4, config.orientation);
  return {{"call", call}, {"config", json_of(config)}};
}

}  // namespace mimo::capi
