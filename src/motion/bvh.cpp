#include "motion/bvh.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>
#include <string_view>

#include "motion/movement.h"
#include "programs/csv.h"
#include "programs/files.h"
#include "programs/joints.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr std::size_t kMostJoints = 1000;
constexpr double kLeastSeconds = kLeastRowSeconds, kMostSeconds = 3600;  // of a frame

// Exporters write keywords in any case: "End Site", "End site", "END SITE".
bool same_word(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

// Words of a text, and where they are. A bracket is a word of its own.
class Words {
 public:
  explicit Words(const std::string& path) : path_(path), text_(read_file(path)) {
    rest_ = text_;
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);  // the mark that some editors put first
  }

  // "" at the end. A colon ends a word: "Frames:2" is two.
  std::string_view next() {
    while (!rest_.empty() && is_space(rest_[0])) skip();
    std::size_t length = rest_.empty() ? 0 : 1;
    while (length < rest_.size() && !is_bracket(rest_[0]) && rest_[length - 1] != ':' && !ends_word(rest_[length])) {
      ++length;
    }
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  void expect(std::string_view what) {
    const std::string_view word = next();
    if (!same_word(word, what)) fail("expected '" + std::string(what) + "'", word);
  }

  // The rest of the line, up to a bracket: names may have spaces ("Bip01 L Thigh").
  std::string name() {
    std::string name = rest_of_line();
    if (name.empty()) fail("expected a joint's name", next());
    return name;
  }

  std::string rest_of_line() {
    const std::string_view line = rest_.substr(0, rest_.find_first_of("{\n"));
    rest_.remove_prefix(line.size());
    return std::string(trim(line));
  }

  // All numbers up to the end of the file.
  std::vector<double> numbers() {
    std::vector<double> all;
    for (std::string_view word = next(); !word.empty(); word = next()) all.push_back(to_number(word));
    return all;
  }

  double number() { return to_number(next()); }

  std::size_t count(std::size_t most) {
    const std::string_view word = next();
    const double value = number_of_file(word).value_or(-1);
    if (value < 0 || value > static_cast<double>(most) || value != std::floor(value)) {
      fail("expected a whole number from 0 to " + std::to_string(most), word);
    }
    return static_cast<std::size_t>(value);
  }

  [[noreturn]] void fail(const std::string& what, std::string_view found) const {
    throw Failure(path_ + ", line " + std::to_string(line_) + ": " + what + ", " +
                  (found.empty() ? "but the file ends" : "not '" + std::string(found.substr(0, 60)) + "'"));
  }

 private:
  double to_number(std::string_view word) const {
    const std::optional<double> value = number_of_file(word);
    if (!value) fail(std::string("expected ") + kNumberOfFile, word);
    return *value;
  }

  static bool is_bracket(char c) { return c == '{' || c == '}'; }
  static bool ends_word(char c) { return is_space(c) || is_bracket(c); }
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip() {
    if (rest_[0] == '\n') ++line_;
    rest_.remove_prefix(1);
  }

  std::string path_, text_;
  std::string_view rest_;
  std::size_t line_ = 1;
};

Eigen::Vector3d read_offset(Words& words) {
  const double x = words.number(), y = words.number();
  return {x, y, words.number()};
}

char read_channel(Words& words) {
  const std::string_view word = words.next();
  for (const char axis : {'X', 'Y', 'Z'}) {
    if (same_word(word, axis + std::string("position"))) return axis;
    if (same_word(word, axis + std::string("rotation"))) return static_cast<char>(axis - 'A' + 'a');
  }
  words.fail("expected a channel (Xposition ... Zrotation)", word);
}

class Hierarchy {
 public:
  Hierarchy(Words& words, Bvh& bvh) : words_(words), bvh_(bvh) {}

  std::size_t read() {
    words_.expect("HIERARCHY");
    words_.expect("ROOT");
    do {
      read_joint(-1);
      const std::string_view word = words_.next();
      if (same_word(word, "MOTION")) return channels_;
      if (!same_word(word, "ROOT")) words_.fail("expected 'MOTION' or another ROOT", word);
    } while (true);
  }

 private:
  void read_joint(int parent) {
    if (bvh_.joints.size() == kMostJoints) words_.fail("expected at most 1000 joints", "JOINT");
    const auto number = bvh_.joints.size();
    bvh_.joints.push_back({words_.name(), parent, {0, 0, 0}, {0, 0, 0}, "", channels_});
    words_.expect("{");
    words_.expect("OFFSET");
    bvh_.joints[number].offset = read_offset(words_);
    words_.expect("CHANNELS");
    for (std::size_t left = words_.count(6); left > 0; --left, ++channels_) {
      std::string& channels = bvh_.joints[number].channels;
      const char channel = read_channel(words_);
      if (channel <= 'Z' && channels.find(channel) != std::string::npos) {
        words_.fail("expected each position once", channel + std::string("position, of which there are two"));
      }
      channels += channel;
    }
    for (std::string_view word = words_.next(); word != "}"; word = words_.next()) {
      if (same_word(word, "JOINT")) {
        read_joint(static_cast<int>(number));
      } else if (same_word(word, "End")) {
        bvh_.joints[number].end = read_end();
      } else {
        words_.fail("expected JOINT, End Site or }", word);
      }
    }
  }

  Eigen::Vector3d read_end() {
    words_.expect("Site");
    words_.rest_of_line();  // some programs name it
    words_.expect("{");
    words_.expect("OFFSET");
    Eigen::Vector3d end = read_offset(words_);
    words_.expect("}");
    return end;
  }

  Words& words_;
  Bvh& bvh_;
  std::size_t channels_ = 0;
};

Eigen::Isometry3d local_pose(const BvhJoint& joint, const double* values) {
  Eigen::Vector3d place = joint.offset;
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    const char channel = joint.channels[i];
    if (channel <= 'Z') {
      place[channel - 'X'] = values[joint.first + i];  // in place of the offset
    } else {
      orientation =
          orientation * Eigen::AngleAxisd(values[joint.first + i] * kDegree, Eigen::Vector3d::Unit(channel - 'x'));
    }
  }
  return Eigen::Translation3d(place) * orientation;
}

// Some programs write a frame more, or one less, than they say.
void read_frames(Words& words, std::size_t channels, std::size_t said, Bvh& bvh) {
  const std::vector<double> numbers = words.numbers();
  if (channels == 0) words.fail("expected channels", "joints without any");
  if (numbers.size() % channels != 0) {
    words.fail("expected " + std::to_string(channels) + " numbers for each frame",
               std::to_string(numbers.size() % channels) + "' for the last one of '" + std::to_string(numbers.size()));
  }
  const std::size_t found = numbers.size() / channels;
  if (found == 0 || found + 1 < said || found > said + 1) {
    words.fail("expected " + std::to_string(said) + " frames, as 'Frames:' says", std::to_string(found));
  }
  if (found != said) {
    bvh.notes.push_back("'Frames:' says " + std::to_string(said) + ", the file has " + std::to_string(found) +
                        ": all of these are read");
  }
  for (auto row = numbers.begin(); row != numbers.end(); row += static_cast<std::ptrdiff_t>(channels)) {
    bvh.frames.emplace_back(row, row + static_cast<std::ptrdiff_t>(channels));
  }
}

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

std::vector<Eigen::Isometry3d> Bvh::poses(std::size_t frame) const {
  std::vector<Eigen::Isometry3d> all;
  for (const BvhJoint& joint : joints) {
    const Eigen::Isometry3d local = local_pose(joint, frames[frame].data());
    all.push_back(joint.parent < 0 ? local : all[static_cast<std::size_t>(joint.parent)] * local);
  }
  return all;
}

std::vector<Eigen::Isometry3d> Bvh::rest() const {
  std::vector<Eigen::Isometry3d> all;
  for (const BvhJoint& joint : joints) {
    const Eigen::Isometry3d local(Eigen::Translation3d(joint.offset));
    all.push_back(joint.parent < 0 ? local : all[static_cast<std::size_t>(joint.parent)] * local);
  }
  return all;
}

Bvh read_bvh(const std::string& path) {
  Words words(path);
  Bvh bvh;
  const std::size_t channels = Hierarchy(words, bvh).read();
  words.expect("Frames:");
  const std::size_t frames = words.count(100000000);
  if (frames == 0) words.fail("expected at least one frame", "0");
  words.expect("Frame");
  words.expect("Time:");
  const std::string_view time = words.next();
  bvh.frame_seconds = number_of_file(time).value_or(0);
  if (!(bvh.frame_seconds >= kLeastSeconds && bvh.frame_seconds <= kMostSeconds)) {
    words.fail("expected a frame time from 1e-6 to 3600 s", time);
  }
  read_frames(words, channels, frames, bvh);
  return bvh;
}

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
