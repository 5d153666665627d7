// The calls that made a world besides its scene's document, as JSON in the header's words: recordings keep them.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/format.h"
#include "blueprint/blueprint.h"
#include "capi/check.h"
#include "capi/members.h"
#include "capi/structs.h"

namespace mimo::capi {

// A value of JSON, as text. Values of a library for JSON allocate in their destructors: where memory runs out, that
// ends the process.
class Json {
 public:
  using Member = std::pair<const char*, Json>;

  Json(const char* text) : text_(text == nullptr ? "null" : as_json(text)) {}
  Json(const std::string& text) : text_(as_json(text)) {}
  Json(std::initializer_list<Member> members)
      : Json(object([&](auto&& add) {
          for (const Member& member : members) add(member.first, member.second);
        })) {}
  // JSON has no infinite numbers: they are null.
  template <typename T, std::enable_if_t<std::is_arithmetic_v<T>, int> = 0>
  Json(T number) : text_(std::isfinite(static_cast<double>(number)) ? format("{}", number) : "null") {}
  // A list.
  template <typename T>
  Json(const std::vector<T>& values) : text_("[") {
    for (const T& value : values) text_ += (text_.size() > 1 ? "," : "") + Json(value).text_;
    text_ += ']';
  }
  // An object whose members a function gives, which is handed add(name, value).
  template <typename Visit>
  static Json object(Visit&& visit) {
    Json json;
    json.text_ = "{";
    visit([&](const char* name, const Json& value) { json.add(name, value); });
    json.text_ += '}';
    return json;
  }

  const std::string& text() const { return text_; }

 private:
  Json() = default;

  void add(const char* name, const Json& value) {
    if (text_.size() > 1) text_ += ',';
    text_ += as_json(name) + ':' + value.text_;
  }

  std::string text_;
};

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

// The members of a struct that are numbers and texts.
template <typename Struct>
Json json_of(Struct all) {
  return Json::object([&](auto&& add) {
    for_each_member(all, [&](const char* name, const auto& member) { add(name, json_of_member(member)); });
  });
}

// Keeps a call, {"call": "limit_sense", ...}, named as the function is behind mimo_scene_.
inline void note(blueprint::SceneEdit& edit, const Json& call) { edit.calls.push_back(call.text()); }

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
