#include "motion/skeleton_names.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "programs/failure.h"

namespace cli {
namespace {

// A body and what joints that move it are called, without side, case and signs; what is more certain comes first.
struct Usual {
  const char* body;
  std::vector<const char*> parts;
};

// A shoulder is the upper arm where no joint is called one (Biovision, SMPL), else the collar bone. A joint moves one
// body: SMPL's foot is the toes, for its ankle is the foot.
const std::vector<Usual> kSides = {
    {"upper_arm", {"uparm", "upperarm", "shldr", "arm", "shoulder"}},
    {"lower_arm", {"forearm", "lowarm", "lowerarm", "elbow"}},
    {"hand", {"wrist", "hand"}},
    {"upper_leg", {"upleg", "upperleg", "thigh", "hip"}},
    {"lower_leg", {"lowleg", "lowerleg", "shin", "calf", "leg", "knee"}},
    {"foot", {"ankle", "foot"}},
    {"toes", {"toebase", "toe", "toes", "toe0", "ball", "foot"}},
};
const std::vector<Usual> kTrunk = {
    {"hip", {"hips", "pelvis", "hip"}},
    {"lower_body", {"lowerback", "abdomen", "spine", "spine1"}},
    {"upper_body", {"chest", "thorax", "spine1", "spine2"}},
    {"head", {"head"}},
};

// What infants have to have told, and what hangs on what.
const std::vector<std::pair<const char*, const char*>> kChains = {{"upper_arm", "lower_arm"},
                                                                  {"lower_arm", "hand"},
                                                                  {"upper_leg", "lower_leg"},
                                                                  {"lower_leg", "foot"},
                                                                  {"foot", "toes"}};
const std::vector<const char*> kNeeded = {"upper_arm", "lower_arm", "upper_leg", "lower_leg"};

bool is(char c, int (*kind)(int)) { return kind(static_cast<unsigned char>(c)) != 0; }

// "mixamorig:LeftForeArm" is left, fore, arm; "LHip" is l, hip; digits stay with what is before them.
std::vector<std::string> words_of(const std::string& name) {
  const std::string_view own = std::string_view(name).substr(name.rfind(':') + 1);
  std::vector<std::string> words;
  bool fresh = true;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (!is(own[i], std::isalnum)) {
      fresh = true;
      continue;
    }
    const bool upper = is(own[i], std::isupper);
    const bool after_lower = i > 0 && !is(own[i - 1], std::isupper);
    const bool before_lower = i + 1 < own.size() && is(own[i + 1], std::islower);
    if (fresh || (upper && (after_lower || before_lower))) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(own[i])));
    fresh = false;
  }
  return words;
}

// What programs put before all names of a skeleton: "Bip01 L Thigh", "J_Bip_L_UpperLeg", "Character1_LeftArm".
bool is_prefix(const std::string& word) {
  const std::string letters = word.substr(0, word.find_last_not_of("0123456789") + 1);
  const bool numbered = letters.size() < word.size();
  return letters == "bip" || letters == "mixamorig" || word == "j" || word == "c" ||
         (letters == "character" && numbered);
}

struct JointName {
  std::string side;  // "left_", "right_" or ""
  std::string part;
};

bool is_part(const std::string& part) {
  return std::any_of(kSides.begin(), kSides.end(), [&](const Usual& usual) {
    return std::find(usual.parts.begin(), usual.parts.end(), part) != usual.parts.end();
  });
}

// Takes a side from a word: "left", "l", or what is written together with its part, "leftarm", "lhip".
std::string take_side(std::string& word) {
  for (const std::string side : {"left", "right"}) {
    if (word == side || word == side.substr(0, 1)) {
      word.clear();
    } else if (word.compare(0, side.size(), side) == 0) {
      word.erase(0, side.size());
    } else if (word[0] == side[0] && is_part(word.substr(1))) {
      word.erase(0, 1);
    } else {
      continue;
    }
    return side + "_";
  }
  return "";
}

JointName parse(const std::string& name) {
  JointName result;
  std::vector<std::string> words = words_of(name);
  while (words.size() > 1 && is_prefix(words[0])) words.erase(words.begin());
  for (std::string& word : words) {
    if (result.side.empty()) result.side = take_side(word);
    result.part += word;
  }
  // "spine_01" is spine1
  const std::size_t digits = result.part.find_last_not_of("0123456789") + 1;
  while (digits + 1 < result.part.size() && result.part[digits] == '0') result.part.erase(digits, 1);
  return result;
}

bool hangs_on(const std::vector<BvhJoint>& joints, std::size_t joint, std::size_t other) {
  int at = static_cast<int>(joint);
  while (at >= 0 && at != static_cast<int>(other)) at = joints[static_cast<std::size_t>(at)].parent;
  return at >= 0;
}

std::size_t root_of(const std::vector<BvhJoint>& joints, std::size_t joint) {
  while (joints[joint].parent >= 0) joint = static_cast<std::size_t>(joints[joint].parent);
  return joint;
}

// Two that are called the same, or that belong to two persons of one file.
void check_sole(const std::map<std::string, std::size_t>& bodies, const std::vector<BvhJoint>& joints,
                const std::string& source, const std::string& remedy) {
  const std::size_t hip = bodies.at("hip");
  std::map<std::string_view, int> called;
  for (const BvhJoint& joint : joints) ++called[joint.name];
  for (const auto& [body, number] : bodies) {
    const std::string& name = joints[number].name;
    if (called[name] > 1)
      throw Failure(source + ": " + std::to_string(called[name]) + " joints are called '" + name +
                    "', expected one for " + body);
    if (root_of(joints, number) == root_of(joints, hip)) continue;
    throw Failure(source + ": joint '" + name + "' is called as " + body +
                  " usually is, but hangs on another ROOT than '" + joints[hip].name + "'" + remedy);
  }
}

}  // namespace

std::map<std::string, std::size_t> usual_bodies(const std::vector<BvhJoint>& joints) {
  std::vector<JointName> names;
  for (const BvhJoint& joint : joints) names.push_back(parse(joint.name));
  std::map<std::string, std::size_t> bodies;
  std::set<std::size_t> taken;
  const auto choose = [&](const std::string& side, const Usual& usual) {
    for (const char* const part : usual.parts) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].side != side || names[i].part != part || !taken.insert(i).second) continue;
        bodies[side + usual.body] = i;
        return;
      }
    }
  };
  for (const Usual& usual : kTrunk) choose("", usual);
  for (const std::string side : {"left_", "right_"}) {
    for (const Usual& usual : kSides) choose(side, usual);
  }
  return bodies;
}

void check_whole(const std::map<std::string, std::size_t>& bodies, const std::vector<BvhJoint>& joints,
                 const std::string& source) {
  const std::string remedy = "; --map FILE.csv tells which joints move which bodies, in lines of joint,body";
  std::string missing = bodies.count("hip") != 0 ? "" : ", hip";
  for (const std::string side : {"left_", "right_"}) {
    for (const char* const body : kNeeded) {
      if (bodies.count(side + body) == 0) missing += ", " + side + body;
    }
  }
  if (!missing.empty()) {
    std::string names;
    for (const BvhJoint& joint : joints) {
      if (names.size() < 300) names += (names.empty() ? "" : ", ") + joint.name;
    }
    throw Failure(source + ": no joint has a usual name for " + missing.substr(2) + remedy +
                  ". Its joints are: " + names);
  }
  check_sole(bodies, joints, source, remedy);
  for (const std::string side : {"left_", "right_"}) {
    for (const auto& [upper, lower] : kChains) {
      const auto found = bodies.find(side + lower);
      if (found == bodies.end() || bodies.count(side + upper) == 0 ||
          hangs_on(joints, found->second, bodies.at(side + upper)))
        continue;
      throw Failure(source + ": joint '" + joints[found->second].name + "' is called as " + side + lower +
                    " usually is, but does not hang on '" + joints[bodies.at(side + upper)].name +
                    "', which is called as " + side + upper + " is" + remedy);
    }
  }
}

}  // namespace cli
