// Tables of key points: one that says what its columns are, and DeepLabCut's.
#include <algorithm>
#include <cmath>
#include <map>

#include "motion/markers.h"
#include "programs/csv.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class KeyPointTable {
 public:
  explicit KeyPointTable(const std::string& path) : path_(path), lines_(read_texts(path)) {}

  const std::vector<TextRow>& lines() const { return lines_; }

  [[noreturn]] void fail(std::size_t line, const std::string& why) const {
    throw Failure(path_ + text(", line %zu: ", lines_[line].line) + why);
  }

  // NaN for an empty cell.
  double number(std::size_t line, std::size_t column, const std::string& name) const {
    std::string cell = lines_[line].cells[column];
    if (cell.empty() || cell == "nan" || cell == "NaN") return kNone;
    std::replace(cell.begin(), cell.end(), ',', '.');  // of decimals: cells lie between semicolons or tabs then
    const auto value = number_of_file(cell);
    if (!value) fail(line, "column '" + name + "' is '" + cell + "', expected " + kNumberOfFile);
    return *value;
  }

  void require_width(std::size_t line, std::size_t width) const {
    const std::size_t there = lines_[line].cells.size();
    if (there != width) fail(line, text("%zu cells, expected %zu as the header has", there, width));
  }

 private:
  std::string path_;
  std::vector<TextRow> lines_;
};

// A column's name and what it has of that: "left_wrist", 'u'.
std::pair<std::string, char> parts_of_column(const std::string& column) {
  if (column.size() < 3 || column[column.size() - 2] != ':') return {column, '\0'};
  return {column.substr(0, column.size() - 2), column.back()};
}

struct PointColumns {
  std::string name;
  std::map<char, std::size_t> parts;  // columns of x, y, z or u, v, and w
};

std::vector<PointColumns> point_columns(const std::string& path, const KeyPointTable& table) {
  std::vector<PointColumns> points;
  const std::vector<std::string>& header = table.lines()[0].cells;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (std::count(header.begin(), header.end(), header[i]) > 1) {
      table.fail(0, "column '" + header[i] + "' appears twice");
    }
    if (header[i] == "time") continue;
    const auto [name, part] = parts_of_column(header[i]);
    if (part == '\0' || std::string("xyzuvw").find(part) == std::string::npos) {
      table.fail(0, "column '" + header[i] + "' is not :x, :y, :z or :u, :v, or :w of a point");
    }
    const auto same = [&, wanted = name](const PointColumns& it) { return it.name == wanted; };
    auto there = std::find_if(points.begin(), points.end(), same);
    if (there == points.end()) there = points.insert(there, {name, {}});
    there->parts[part] = i;
  }
  if (points.empty()) throw Failure(path + " has no key points, expected columns NAME:x, :y, :z or NAME:u, :v");
  const bool in_pixels = points[0].parts.count('u') + points[0].parts.count('v') > 0;
  for (const PointColumns& it : points) {
    for (const char part : std::string(in_pixels ? "uv" : "xyz")) {
      if (it.parts.count(part) == 0) {
        throw Failure(path + " has no column '" + it.name + ':' + part + "'; expected " +
                      (in_pixels ? ":u and :v" : ":x, :y and :z") + " of each point");
      }
    }
    if (it.parts.size() - it.parts.count('w') != (in_pixels ? 2U : 3U)) {
      throw Failure(path + ": " + it.name + " has columns in m and in pixels, expected :x, :y, :z or :u, :v");
    }
  }
  return points;
}

}  // namespace

bool has_key_points(const std::string& path) {
  static constexpr const char* kPoints[] = {"shoulder", "elbow", "wrist", "hip", "knee", "ankle", "ear"};
  const std::vector<TextRow> lines = read_texts(path);
  if (lines.empty()) return false;
  return std::any_of(lines[0].cells.begin(), lines[0].cells.end(), [](const std::string& column) {
    const auto [name, part] = parts_of_column(column);
    if (part == 'u' || part == 'v' || part == 'w') return true;
    if (part != 'x' && part != 'y' && part != 'z') return false;
    const std::size_t side = name.find('_');
    const std::string point = name.substr(side == std::string::npos ? 0 : side + 1);
    const bool sided = name.compare(0, 5, "left_") == 0 || name.compare(0, 6, "right_") == 0;
    const bool capital = std::any_of(name.begin(), name.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    return capital || name == "nose" ||
           (sided && std::find(std::begin(kPoints), std::end(kPoints), point) != std::end(kPoints));
  });
}

Markers read_key_points(const std::string& path) {
  const KeyPointTable table(path);
  Markers markers;
  if (table.lines().empty()) throw Failure(path + " is empty, expected a header");
  const std::vector<std::string>& header = table.lines()[0].cells;
  const std::vector<PointColumns> points = point_columns(path, table);
  const auto time_at = static_cast<std::size_t>(std::find(header.begin(), header.end(), "time") - header.begin());
  if (time_at == header.size()) throw Failure(path + " has no column 'time'");
  markers.in_pixels = points[0].parts.count('u') > 0;
  markers.has_own_names = true;
  for (const PointColumns& it : points) markers.names.push_back(it.name);
  for (std::size_t line = 1; line < table.lines().size(); ++line) {
    table.require_width(line, header.size());
    const double time = table.number(line, time_at, "time");
    if (!(markers.times.empty() ? time == time : time >= markers.times.back() + kLeastRowSeconds)) {
      table.fail(line, markers.times.empty()
                           ? std::string("time is empty")
                           : text("time is %.9g s after %.9g s, expected a later one", time, markers.times.back()));
    }
    markers.begin_row(time);
    for (const PointColumns& it : points) {
      const auto value = [&](char part) { return table.number(line, it.parts.at(part), it.name + ':' + part); };
      const Eigen::Vector3d place = markers.in_pixels ? Eigen::Vector3d(value('u'), value('v'), 0)
                                                      : Eigen::Vector3d(value('x'), value('y'), value('z'));
      const double weight = it.parts.count('w') > 0 ? value('w') : 1;
      if (weight < 0) table.fail(line, text("column '%s:w' is %g, expected 0 or more", it.name.c_str(), weight));
      markers.add_weighted(place, weight);
    }
  }
  if (markers.times.empty()) throw Failure(path + ": no rows of numbers follow the header");
  return markers;
}

bool is_deeplabcut(const std::string& path) {
  std::ifstream file = open_to_read(path);
  std::string line(10, '\0');
  file.read(line.data(), static_cast<std::streamsize>(line.size()));
  if (line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);
  return line.compare(0, 7, "scorer,") == 0;
}

Markers read_deeplabcut(const std::string& path, double rate) {
  constexpr std::size_t kHeader = 3;
  require_rate(path, rate);
  const KeyPointTable table(path);
  const std::vector<TextRow>& lines = table.lines();
  const char* const heads[] = {"scorer", "bodyparts", "coords"};
  for (std::size_t i = 0; i < kHeader; ++i) {
    if (i < lines.size() && !lines[i].cells.empty() && lines[i].cells[0] == heads[i]) continue;
    if (i < lines.size() && !lines[i].cells.empty() && lines[i].cells[0] == "individuals") {
      table.fail(i, "the table has several animals, expected one");
    }
    throw Failure(path + text(", line %zu: expected %s, as DeepLabCut's tables begin", i + 1, heads[i]));
  }
  const std::vector<std::string>&parts = lines[1].cells, &coords = lines[2].cells;
  table.require_width(2, parts.size());
  Markers markers;
  markers.in_pixels = true;
  for (std::size_t i = 1; i < parts.size(); i += 3) {
    const bool whole = i + 2 < parts.size() && parts[i] == parts[i + 1] && parts[i] == parts[i + 2] &&
                       coords[i] == "x" && coords[i + 1] == "y" && coords[i + 2] == "likelihood";
    const bool twice = std::count(markers.names.begin(), markers.names.end(), parts[i]) > 0;
    if (!whole || twice) table.fail(2, "'" + parts[i] + "' has not x, y, likelihood once each");
    markers.names.push_back(parts[i]);
  }
  for (std::size_t line = kHeader; line < lines.size(); ++line) {
    table.require_width(line, parts.size());
    markers.begin_row(static_cast<double>(markers.times.size()) / rate);
    for (std::size_t i = 0; i < markers.names.size(); ++i) {
      const auto value = [&](std::size_t k) { return table.number(line, 1 + 3 * i + k, markers.names[i]); };
      const double sure = value(2);
      if (sure < 0 || sure > 1) {
        table.fail(line, text("the likelihood of '%s' is %g, expected 0 to 1", markers.names[i].c_str(), sure));
      }
      markers.add_weighted(sure > 0 ? Eigen::Vector3d(value(0), value(1), 0) : kUnseen, sure);
    }
  }
  if (markers.times.empty()) throw Failure(path + ": no rows of numbers follow the header");
  return markers;
}

}  // namespace cli
