#include "growth/skeleton.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/fail.h"

namespace mimo::growth {
namespace {

std::string_view without(std::string_view name, std::string_view beginning) {
  return name.substr(0, beginning.size()) == beginning ? name.substr(beginning.size()) : name;
}

template <typename List>
auto* find(List& parts, std::string_view name) {
  for (auto& part : parts) {
    if (part.name == name) return &part;
  }
  return static_cast<decltype(&parts[0])>(nullptr);
}

template <typename Owner, typename List>
auto& find_in_bones(Owner& skeleton, List Bone::*list, std::string_view kind, std::string_view name) {
  for (auto& bone : skeleton.bones) {
    if (auto* part = find(bone.*list, name); part != nullptr) return *part;
  }
  fail(Status::kUnsupported, "the infant has no {} \"{}\", so it cannot grow", kind, name);
}

template <typename Owner>
auto& find_bone(Owner& skeleton, std::string_view name) {
  if (auto* bone = find(skeleton.bones, name); bone != nullptr) return *bone;
  fail(Status::kUnsupported, "the infant has no body \"{}\", so it cannot grow", name);
}

constexpr std::pair<std::string_view, Segment> kSegments[] = {
    {"mimo_location", Segment::kTrunk}, {"hip", Segment::kTrunk},         {"lower_body", Segment::kTrunk},
    {"upper_body", Segment::kTrunk},    {"head", Segment::kHead},         {"eye", Segment::kHead},
    {"upper_arm", Segment::kUpperArm},  {"lower_arm", Segment::kForearm}, {"upper_leg", Segment::kThigh},
    {"lower_leg", Segment::kShank},     {"foot", Segment::kFoot},         {"toes", Segment::kFoot},
    {"big_toe", Segment::kFoot},        {"hand", Segment::kHand},         {"fingers", Segment::kHand},
    {"ffknuckle", Segment::kHand},      {"ffmiddle", Segment::kHand},     {"ffdistal", Segment::kHand},
    {"mfknuckle", Segment::kHand},      {"mfmiddle", Segment::kHand},     {"mfdistal", Segment::kHand},
    {"rfknuckle", Segment::kHand},      {"rfmiddle", Segment::kHand},     {"rfdistal", Segment::kHand},
    {"lfmetacarpal", Segment::kHand},   {"lfknuckle", Segment::kHand},    {"lfmiddle", Segment::kHand},
    {"lfdistal", Segment::kHand},       {"thbase", Segment::kHand},       {"thhub", Segment::kHand},
    {"thdistal", Segment::kHand}};

}  // namespace

std::string_view without_side(std::string_view name) { return without(without(name, "left_"), "right_"); }

std::string_view plain_name(std::string_view name) { return without_side(without(without(name, "robot:"), "act:")); }

std::string side_of(std::string_view name) {
  name = without(without(name, "robot:"), "act:");
  return std::string(name.substr(0, name.size() - without_side(name).size()));
}

Bone& Parts::bone(std::string_view name) const { return find_bone(*skeleton_, name); }
Geom& Parts::geom(std::string_view name) const { return find_in_bones(*skeleton_, &Bone::geoms, "geom", name); }
Joint& Parts::joint(std::string_view name) const { return find_in_bones(*skeleton_, &Bone::joints, "joint", name); }
Mark& Parts::mark(std::string_view name) const { return find_in_bones(*skeleton_, &Bone::marks, "site", name); }

bool Parts::has_bone(std::string_view name) const { return find(skeleton_->bones, name) != nullptr; }

const Bone& bone(const Skeleton& skeleton, std::string_view name) { return find_bone(skeleton, name); }

const Geom& geom(const Skeleton& skeleton, std::string_view name) {
  return find_in_bones(skeleton, &Bone::geoms, "geom", name);
}

double total_mass(const Skeleton& skeleton) {
  double mass = 0;
  for (const Bone& bone : skeleton.bones) {
    for (const Geom& geom : bone.geoms) mass += geom.mass;
  }
  return mass;
}

Segment segment_of(std::string_view bone) {
  const std::string_view name = without_side(bone);
  const auto* found =
      std::find_if(std::begin(kSegments), std::end(kSegments), [&](auto& row) { return row.first == name; });
  if (found != std::end(kSegments)) return found->second;
  fail(Status::kUnsupported, "the infant has a body \"{}\", which growth does not know", bone);
}

bool is_limb(Segment segment) {
  return segment == Segment::kUpperArm || segment == Segment::kForearm || segment == Segment::kThigh ||
         segment == Segment::kShank;
}

}  // namespace mimo::growth
