#include "tasks/behaviour/parts.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "base/fail.h"
#include "base/names.h"
#include "body/face.h"

namespace mimo::tasks {
namespace {

struct Group {
  std::string_view word;
  std::vector<const char*> parts;
};

std::vector<const char*> group(std::string_view word) {
  const Group groups[] = {{"hands", {"left_hand", "right_hand"}},
                          {"feet", {"left_foot", "right_foot"}},
                          {"knees", {"left_lower_leg", "right_lower_leg"}},
                          {"thighs", {"left_upper_leg", "right_upper_leg"}},
                          {"forearms", {"left_lower_arm", "right_lower_arm"}},
                          {"trunk", {"hip", "lower_body", "upper_body"}}};
  for (const Group& candidate : groups) {
    if (candidate.word == word) return candidate.parts;
  }
  return {};
}

bool ends_with(const std::string& name, const std::string& end) {
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

}  // namespace

Eigen::Vector3d Point::in(const mjData& data) const {
  const Eigen::Vector3d middle = center(data, origins);
  if (offset.isZero()) return middle;
  using Frame = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  return middle + Eigen::Map<const Frame>(data.xmat + 9 * origins.front()) * offset;
}

int Parts::find(const std::string& name) const {
  const int own = engine::find(model_, engine::Kind::kBody, (body_.prefix + name).c_str());
  return own >= 0 ? own : engine::find(model_, engine::Kind::kBody, name.c_str());
}

Part Parts::part(const std::string& name) const {
  if (ends_with(name, "_fingers")) {
    const int hand = find(name.substr(0, name.find('_')) + "_hand");
    if (hand >= 0) {
      std::vector<int> fingers = body::subtree(model_, hand);
      fingers.erase(fingers.begin());
      if (!fingers.empty()) return {fingers, fingers};
    }
  }
  const int id = find(name);
  if (id < 0) {
    fail(Status::kModel,
         "{}: the scene has no body named \"{}\", and no part is called so; it may be a part that this infant's body "
         "lacks",
         names::kReached, name);
  }
  const bool whole = !body_.has(id) || ends_with(name, "_hand") || ends_with(name, "_foot");
  return {whole ? body::subtree(model_, id) : std::vector<int>{id}, {id}};
}

std::vector<Part> Parts::one(const std::string& word) const {
  if (word == "ground") return {{{0}, {0}}};
  std::vector<Part> parts;
  if (word == "body") {
    for (const int id : body_.bodies) parts.push_back({{id}, {id}});
  } else if (word == "outside") {
    for (int id = 0; id < model_.nbody; ++id) {
      if (!body_.has(id)) parts.push_back({{id}, {id}});
    }
  } else {
    for (const char* name : group(word)) parts.push_back(part(name));
    if (parts.empty()) parts.push_back(part(word));
  }
  return parts;
}

std::vector<Part> Parts::parts(const std::string& words) const {
  std::vector<Part> all;
  const std::vector<std::string> without = split(words, '-');
  if (without.empty()) fail(Status::kModel, "{}: \"{}\" names no part", names::kReached, words);
  for (const std::string& word : split(without.front(), ',')) {
    for (Part& part : one(word)) all.push_back(std::move(part));
  }
  for (std::size_t i = 1; i < without.size(); ++i) {
    for (const Part& gone : one(without[i])) {
      const auto is_gone = [&](const Part& part) {
        return std::find(gone.bodies.begin(), gone.bodies.end(), part.bodies.front()) != gone.bodies.end();
      };
      all.erase(std::remove_if(all.begin(), all.end(), is_gone), all.end());
    }
  }
  if (all.empty()) fail(Status::kModel, "{}: \"{}\" leaves no part", names::kReached, words);
  return all;
}

// Between its corners, on the surface of the head, whose first geom is its skull.
Point Parts::mouth() const {
  const auto mouth = body::find_mouth(model_, body_);
  if (!mouth || model_.body_geomnum[body_.head] == 0) {
    fail(Status::kModel, "{}: the infant's body has no mouth", names::kReached);
  }
  const double radius = model_.geom_size[3 * model_.body_geomadr[body_.head]];
  const Eigen::Vector3d forward = (mouth->corners[0] + mouth->corners[1]).normalized();
  return {{body_.head}, mouth->middle + radius * forward};
}

Point Parts::point(const std::string& word) const {
  if (word == "mouth") return mouth();
  const std::vector<Part> found = one(word);
  Point point;
  for (const Part& part : found) point.origins.insert(point.origins.end(), part.origins.begin(), part.origins.end());
  return point;
}

int Parts::frame(const std::string& word) const {
  const std::vector<Part> found = one(word);
  if (found.size() != 1 || found.front().origins.size() != 1) {
    fail(Status::kModel, "{}: \"{}\" stands where one part is expected", names::kReached, word);
  }
  return found.front().origins.front();
}

}  // namespace mimo::tasks
