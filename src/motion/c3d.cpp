// C3D files (www.c3d.org, the format's manual): points of a block of numbers, and what parameters say of them.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

#include "motion/markers.h"
#include "programs/csv.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::uint8_t kIntel = 84, kDec = 85, kMips = 86;

struct Parameter {
  std::int8_t type = 0;  // -1 text, 1 byte, 2 whole numbers, 4 floats
  std::vector<std::size_t> sizes;
  std::size_t at = 0;  // of its data in the file
};

class C3d {
 public:
  explicit C3d(const std::string& path) : path_(path) {
    std::ifstream file = open_to_read(path);
    std::ostringstream content;
    content << file.rdbuf();
    bytes_ = content.str();
    if (bytes_.size() < kBlock || byte(1) != 0x50) throw Failure(path + " is no C3D file: it does not begin as one");
    read_parameters();
  }

  Markers read() const;

 private:
  std::uint8_t byte(std::size_t at) const {
    if (at >= bytes_.size()) throw Failure(path_ + text(" ends after %zu bytes; was it cut off?", bytes_.size()));
    return static_cast<std::uint8_t>(bytes_[at]);
  }
  std::uint16_t word(std::size_t at) const {
    const unsigned first = byte(at), second = byte(at + 1);
    return static_cast<std::uint16_t>(processor_ == kMips ? first << 8 | second : second << 8 | first);
  }
  double real(std::size_t at) const;

  void read_parameters();
  const Parameter* find(const std::string& name) const;
  double number(const std::string& name, double otherwise) const;
  std::vector<std::string> texts(const std::string& name) const;
  std::size_t frames(std::size_t told) const;

  std::string path_, bytes_;
  std::uint8_t processor_ = kIntel;
  std::map<std::string, Parameter> parameters_;  // "POINT:LABELS"
};

double C3d::real(std::size_t at) const {
  std::uint8_t order[4];  // lowest byte first
  const std::size_t places[3][4] = {{0, 1, 2, 3}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  for (std::size_t i = 0; i < 4; ++i) order[i] = byte(at + places[processor_ - kIntel][i]);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= std::uint32_t{order[i]} << (8 * i);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return processor_ == kDec ? double(value) / 4 : double(value);  // DEC's exponent counts from another zero
}

void C3d::read_parameters() {
  const std::size_t start = (std::size_t{byte(0)} - 1) * kBlock;
  if (byte(0) < 1) throw Failure(path_ + " is no C3D file: it has no parameters");
  processor_ = byte(start + 3);
  if (processor_ < kIntel || processor_ > kMips) {
    throw Failure(path_ + text(": processor type %d, expected 84 (Intel), 85 (DEC) or 86 (MIPS)", int(processor_)));
  }
  std::map<int, std::string> groups;
  std::map<std::string, std::pair<int, Parameter>> found;
  for (std::size_t at = start + 4;;) {
    const auto length = static_cast<std::size_t>(std::abs(static_cast<std::int8_t>(byte(at))));
    const int group = static_cast<std::int8_t>(byte(at + 1));
    if (length == 0) break;
    std::string name;
    for (std::size_t i = 0; i < length; ++i) name += static_cast<char>(std::toupper(byte(at + 2 + i)));
    const std::size_t offset_at = at + 2 + length;
    if (group < 0) {
      groups[-group] = name;
    } else {
      Parameter it;
      it.type = static_cast<std::int8_t>(byte(offset_at + 2));
      const std::size_t dimensions = byte(offset_at + 3);
      for (std::size_t i = 0; i < dimensions; ++i) it.sizes.push_back(byte(offset_at + 4 + i));
      it.at = offset_at + 4 + dimensions;
      found[std::to_string(group) + ':' + name] = {group, it};
    }
    if (word(offset_at) == 0) break;
    at = offset_at + word(offset_at);
  }
  for (const auto& [name, entry] : found) {
    parameters_[groups[entry.first] + name.substr(name.find(':'))] = entry.second;
  }
}

const Parameter* C3d::find(const std::string& name) const {
  const auto found = parameters_.find(name);
  return found == parameters_.end() ? nullptr : &found->second;
}

double C3d::number(const std::string& name, double otherwise) const {
  const Parameter* it = find(name);
  if (it == nullptr) return otherwise;
  if (it->type == 4) return real(it->at);
  return it->type == 2 ? double(word(it->at)) : double(byte(it->at));
}

// A line of text for each column of a table of letters.
std::vector<std::string> C3d::texts(const std::string& name) const {
  std::vector<std::string> all;
  const Parameter* it = find(name);
  if (it == nullptr || it->type != -1 || it->sizes.empty()) return all;
  const std::size_t length = it->sizes[0], count = it->sizes.size() > 1 ? it->sizes[1] : 1;
  for (std::size_t i = 0; i < count; ++i) {
    std::string line;
    for (std::size_t k = 0; k < length; ++k) line += static_cast<char>(byte(it->at + i * length + k));
    all.emplace_back(trim(line.substr(0, line.find('\0'))));
  }
  return all;
}

// Numbers of frames above 65535 do not fit in the header.
std::size_t C3d::frames(std::size_t told) const {
  const double more = number("POINT:FRAMES", 0);
  return more > 65535 && std::isfinite(more) ? static_cast<std::size_t>(more) : told;
}

Markers C3d::read() const {
  Markers markers;
  const std::size_t points = word(2), analog = word(4), first = word(6), last = word(8);
  if (points == 0) throw Failure(path_ + " has no points, expected markers");
  if (last < first) throw Failure(path_ + text(": its last frame is %zu, before the first, %zu", last, first));
  const double rate = number("POINT:RATE", real(20)), scale = number("POINT:SCALE", real(12));
  if (!(rate > 0 && rate < 1e6)) throw Failure(path_ + text(": POINT:RATE is %g, expected frames a second", rate));
  const std::vector<std::string> units = texts("POINT:UNITS");
  const double metres = metres_of(units.empty() ? "mm" : units[0]);
  if (metres == 0) throw Failure(path_ + ": POINT:UNITS is '" + units[0] + "', expected mm, cm or m");
  markers.names = texts("POINT:LABELS");
  for (int more = 2; markers.names.size() < points; ++more) {  // a table holds 255
    const std::vector<std::string> next = texts("POINT:LABELS" + std::to_string(more));
    if (next.empty()) break;
    markers.names.insert(markers.names.end(), next.begin(), next.end());
  }
  if (markers.names.size() < points) {
    throw Failure(path_ +
                  text(": %zu names in POINT:LABELS, expected the %zu of its points", markers.names.size(), points));
  }
  markers.names.resize(points);
  for (const std::string& name : markers.names) {
    if (!name.empty() && std::count(markers.names.begin(), markers.names.end(), name) > 1) {
      throw Failure(path_ + ": the marker '" + name + "' is there twice");
    }
  }
  const bool floats = scale < 0;
  const std::size_t width = floats ? 4 : 2, frame_bytes = width * (4 * points + analog);
  const std::size_t start = (static_cast<std::size_t>(number("POINT:DATA_START", word(16))) - 1) * kBlock;
  const std::size_t count = frames(last - first + 1);
  if (start < kBlock || start > bytes_.size()) throw Failure(path_ + ": POINT:DATA_START lies outside of the file");
  if ((bytes_.size() - start) / frame_bytes < count) {
    throw Failure(path_ + text(" ends in frame %zu, expected %zu frames; was it cut off?",
                               (bytes_.size() - start) / frame_bytes + 1, count));
  }
  for (std::size_t frame = 0; frame < count; ++frame) {
    markers.times.push_back(static_cast<double>(frame) / rate);
    markers.rows.emplace_back();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t at = start + frame * frame_bytes + 4 * width * i;
      const auto value = [&](std::size_t k) {
        return floats ? real(at + 4 * k) : scale * static_cast<std::int16_t>(word(at + 2 * k));
      };
      const double residual = floats ? real(at + 12) : double(static_cast<std::int16_t>(word(at + 6)));
      const Eigen::Vector3d place = metres * Eigen::Vector3d(value(0), value(1), value(2));
      if (residual >= 0 && place.array().isFinite().all() && place.norm() > 1e9) {
        throw Failure(path_ +
                      text(", frame %zu: %s is %g m away", first + frame, markers.names[i].c_str(), place.norm()));
      }
      markers.rows.back().push_back(residual >= 0 && place.allFinite() ? place : kUnseen);
    }
  }
  return markers;
}

}  // namespace

Markers read_c3d(const std::string& path) { return C3d(path).read(); }

}  // namespace cli
