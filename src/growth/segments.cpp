#include "growth/segments.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/fail.h"
#include "growth/parts.h"

namespace mimo::growth {
namespace {

constexpr std::pair<std::string_view, Segment> kTable[] = {
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

Segment segment_of(std::string_view bone) {
  const std::string_view name = without_side(bone);
  const auto* found = std::find_if(std::begin(kTable), std::end(kTable), [&](auto& row) { return row.first == name; });
  if (found != std::end(kTable)) return found->second;
  fail(Status::kUnsupported, "the infant has a body \"{}\", and growth knows none of that name", bone);
}

bool is_limb(Segment segment) {
  return segment == Segment::kUpperArm || segment == Segment::kForearm || segment == Segment::kThigh ||
         segment == Segment::kShank;
}

}  // namespace mimo::growth
