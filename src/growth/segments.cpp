#include "growth/segments.h"

#include <string>
#include <unordered_map>

#include "base/fail.h"
#include "growth/parts.h"

namespace mimo::growth {
namespace {

using Table = std::unordered_map<std::string_view, Segment>;

Table make_table() {
  Table table = {{"mimo_location", Segment::kTrunk}, {"hip", Segment::kTrunk},         {"lower_body", Segment::kTrunk},
                 {"upper_body", Segment::kTrunk},    {"head", Segment::kHead},         {"eye", Segment::kHead},
                 {"upper_arm", Segment::kUpperArm},  {"lower_arm", Segment::kForearm}, {"upper_leg", Segment::kThigh},
                 {"lower_leg", Segment::kShank},     {"foot", Segment::kFoot},         {"toes", Segment::kFoot},
                 {"big_toe", Segment::kFoot}};
  for (const char* bone :
       {"hand", "fingers", "ffknuckle", "ffmiddle", "ffdistal", "mfknuckle", "mfmiddle", "mfdistal", "rfknuckle",
        "rfmiddle", "rfdistal", "lfmetacarpal", "lfknuckle", "lfmiddle", "lfdistal", "thbase", "thhub", "thdistal"}) {
    table[bone] = Segment::kHand;
  }
  return table;
}

}  // namespace

Segment segment_of(std::string_view bone) {
  static const Table table = make_table();
  const auto found = table.find(without_side(bone));
  if (found != table.end()) return found->second;
  fail(Status::kUnsupported, "the infant has a body \"{}\", and growth knows none of that name", bone);
}

bool is_limb(Segment segment) {
  return segment == Segment::kUpperArm || segment == Segment::kForearm || segment == Segment::kThigh ||
         segment == Segment::kShank;
}

}  // namespace mimo::growth
