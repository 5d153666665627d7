// Folders with a file of key points for each frame of a video: OpenPose's, and those of the data set MINI-RGBD.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "motion/markers.h"
#include "programs/csv.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

// BODY_25. COCO's 18 points are the first 19 without the middle of the hips.
constexpr const char* kBody25[] = {"Nose",   "Neck",    "RShoulder", "RElbow", "RWrist", "LShoulder", "LElbow",
                                   "LWrist", "MidHip",  "RHip",      "RKnee",  "RAnkle", "LHip",      "LKnee",
                                   "LAnkle", "REye",    "LEye",      "REar",   "LEar",   "LBigToe",   "LSmallToe",
                                   "LHeel",  "RBigToe", "RSmallToe", "RHeel"};
constexpr std::size_t kCoco = 18, kMidHip = 8;

// SMIL's joints, and a vertex of the nose, in the order of MINI-RGBD's files.
constexpr const char* kSmil[] = {"global",    "leftThigh",    "rightThigh",    "spine",        "leftCalf",
                                 "rightCalf", "spine1",       "leftFoot",      "rightFoot",    "spine2",
                                 "leftToes",  "rightToes",    "neck",          "leftShoulder", "rightShoulder",
                                 "head",      "leftUpperArm", "rightUpperArm", "leftForeArm",  "rightForeArm",
                                 "leftHand",  "rightHand",    "leftFingers",   "rightFingers", "noseVertex"};

// The camera of its pictures, 640 x 480, in pixels: data set's depth_to_3D.py.
constexpr double kFocalX = 588.67905803875317, kFocalY = 590.25690113005601;
constexpr double kMiddleX = 322.22048191353628, kMiddleY = 237.46785983766890;

std::vector<std::string> files_of(const fs::path& folder, const std::string& first, const std::string& last) {
  std::vector<std::string> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (name.size() < first.size() + last.size() || name.compare(0, first.size(), first) != 0) continue;
    if (name.compare(name.size() - last.size(), last.size(), last) == 0) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Pixels and confidence of each point of the one person; nothing where nobody was found.
std::vector<double> person_of(const std::string& path) {
  std::vector<std::vector<double>> people;
  try {
    std::ifstream file = open_to_read(path);
    const nlohmann::json read = nlohmann::json::parse(file);
    for (const nlohmann::json& it : read.at("people")) people.push_back(it.at("pose_keypoints_2d"));
  } catch (const nlohmann::json::exception& error) {
    throw Failure(path + " is no file of OpenPose: " + error.what());
  }
  if (people.size() > 1) {
    throw Failure(path + text(" has %zu people, expected one at most (--number_people_max 1)", people.size()));
  }
  return people.empty() ? std::vector<double>() : people[0];
}

// Frames have numbers: a missing one is a frame in which nothing was seen.
std::size_t number_of(const std::string& path) {
  const std::string name = fs::path(path).stem().string();
  const std::size_t digits = name.find_last_of('_');
  const auto value = finite_number(std::string_view(name).substr(digits == std::string::npos ? 0 : digits + 1));
  if (!value || *value < 0 || *value > 1e8 || *value != std::floor(*value)) {
    throw Failure(path + ": expected a name that ends in the number of its frame");
  }
  return static_cast<std::size_t>(*value);
}

// Which of the two MINI-RGBD has for each frame: places in the picture, or in space before the camera.
struct MiniKind {
  const char *folder, *first;
};
constexpr MiniKind kPlane = {"joints_2Ddep", "syn_joints_2Ddep_"}, kSpace = {"joints_3D", "syn_joints_3D_"};

// The folder of that kind: itself, or one that is in it.
std::vector<std::string> frames_of(const std::string& folder, const MiniKind& kind) {
  std::vector<std::string> files = files_of(folder, kind.first, ".txt");
  return files.empty() ? files_of(fs::path(folder) / kind.folder, kind.first, ".txt") : files;
}

// 25 lines of three numbers and the joint's number.
std::vector<Eigen::Vector3d> joints_in(const std::string& path) {
  std::ifstream file = open_to_read(path);
  std::vector<Eigen::Vector3d> joints;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::istringstream words(line);
    std::vector<double> cells;
    for (std::string word; words >> word;) {
      const auto value = number_of_file(word);
      if (!value) throw Failure(path + text(", line %zu: '", number) + word + "', expected " + kNumberOfFile);
      cells.push_back(*value);
    }
    if (cells.empty()) continue;
    if (cells.size() != 4 || joints.size() >= std::size(kSmil) || cells[3] != double(joints.size())) {
      throw Failure(path + text(", line %zu: expected x, y, depth, and %zu, the joint's number; there are %zu joints",
                                number, joints.size(), std::size(kSmil)));
    }
    joints.emplace_back(cells[0], cells[1], cells[2]);
  }
  if (joints.size() != std::size(kSmil)) {
    throw Failure(path + text(" has %zu joints, expected %zu; was it cut off?", joints.size(), std::size(kSmil)));
  }
  return joints;
}

}  // namespace

Markers read_openpose(const std::string& folder, double rate) {
  const std::string ending = "_keypoints.json";
  const std::vector<std::string> files = files_of(folder, "", ending);
  if (files.empty()) {
    throw Failure(folder +
                  " has no files *_keypoints.json, as OpenPose writes them (--write_json), and none of MINI-RGBD");
  }
  require_rate(folder, rate);
  Markers markers;
  markers.in_pixels = true;
  for (const std::string& file : files) {
    const std::vector<double> numbers = person_of(file);
    const std::size_t count = numbers.size() / 3;
    if (!numbers.empty() && (numbers.size() % 3 != 0 || (count != kCoco && count != std::size(kBody25)))) {
      throw Failure(file + text(": %zu numbers of a person, expected %zu or %zu", numbers.size(),
                                3 * std::size(kBody25), 3 * kCoco));
    }
    if (markers.names.empty()) {
      for (std::size_t i = 0; i < (count == kCoco ? kCoco + 1 : count); ++i) {
        if (count != kCoco || i != kMidHip) markers.names.emplace_back(kBody25[i]);
      }
    }
    if (count != 0 && count != markers.names.size()) {
      throw Failure(file + text(": %zu points, expected %zu as in the files before", count, markers.names.size()));
    }
    markers.begin_row(static_cast<double>(markers.times.size()) / rate);
    for (std::size_t i = 0; i < count; ++i) {
      const double sure = numbers[3 * i + 2];
      if (!(sure >= 0 && sure <= 1)) {
        throw Failure(file + ": the confidence of " + markers.names[i] + text(" is %g, expected 0 to 1", sure));
      }
      markers.add_weighted(Eigen::Vector3d(numbers[3 * i], numbers[3 * i + 1], 0), sure);
    }
  }
  if (markers.names.empty()) throw Failure(folder + text(": nobody was found in any of %zu frames", files.size()));
  for (std::size_t row = 0; row < markers.rows.size(); ++row) {
    markers.rows[row].resize(markers.names.size(), kUnseen);
    markers.weights[row].resize(markers.names.size(), 0);
  }
  return markers;
}

bool is_mini_rgbd(const std::string& folder) {
  std::error_code none;
  return fs::is_directory(folder, none) && (!frames_of(folder, kPlane).empty() || !frames_of(folder, kSpace).empty());
}

Markers read_mini_rgbd(const std::string& folder, double rate) {
  require_rate(folder, rate);
  Markers markers;
  std::vector<std::string> files = frames_of(folder, kPlane);
  markers.in_pixels = !files.empty();
  if (files.empty()) files = frames_of(folder, kSpace);
  const std::size_t first = number_of(files.front()), count = number_of(files.back()) - first + 1;
  if (count > 2 * files.size() + 1000) {
    throw Failure(folder + text(": %zu files, and the last is of frame %zu; expected most of the frames from %zu on",
                                files.size(), first + count - 1, first));
  }
  markers.names.assign(std::begin(kSmil), std::end(kSmil));
  markers.rows.assign(count, std::vector<Eigen::Vector3d>(markers.names.size(), kUnseen));
  for (std::size_t i = 0; i < count; ++i) markers.times.push_back(static_cast<double>(i) / rate);
  for (const std::string& file : files) {
    std::vector<Eigen::Vector3d>& row = markers.rows[number_of(file) - first];
    row = joints_in(file);
    for (Eigen::Vector3d& at : row) {
      // The camera looks down: x is right, y towards the picture's lower edge, z away from it.
      at = markers.in_pixels ? Eigen::Vector3d(at.x(), at.y(), 0) : Eigen::Vector3d(at.x(), -at.y(), 1 - at.z());
    }
  }
  if (count > files.size()) {
    markers.notes.push_back(folder + text(": %zu of %zu frames have no file", count - files.size(), count));
  }
  if (markers.in_pixels) markers.camera = camera_from_above(kFocalX, kFocalY, kMiddleX, kMiddleY);
  return markers;
}

}  // namespace cli
