// TRC files and Qualisys' TSV files: lines of cells between tabs.
#include <algorithm>
#include <cmath>

#include "motion/markers.h"
#include "programs/csv.h"
#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

namespace cli {
namespace {

constexpr std::size_t kMostCounted = 100000000;  // rows or markers of a file that is none

class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path) {
    std::ifstream file = open_to_read(path);
    for (std::string line; std::getline(file, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      lines_.push_back(std::move(line));
    }
    if (!lines_.empty() && lines_[0].compare(0, 3, "\xEF\xBB\xBF") == 0) lines_[0].erase(0, 3);
  }

  bool ended() const { return next_ >= lines_.size(); }
  std::size_t number() const { return next_; }  // of the line that was taken last, from 1
  void back() { --next_; }

  std::vector<std::string> take(const char* what) {
    if (ended()) throw Failure(path_ + text(" ends after line %zu; expected ", lines_.size()) + what);
    return cells_of(lines_[next_++]);
  }

  [[noreturn]] void fail(const std::string& why) const { throw Failure(path_ + text(", line %zu: ", next_) + why); }

  double number_in(const std::string& cell, const std::string& what) const {
    const auto value = number_of_file(cell);
    if (!value) fail(what + " is '" + cell + "', expected " + kNumberOfFile);
    return *value;
  }

  std::size_t count_in(const std::string& cell, const std::string& what) const {
    const double value = number_in(cell, what);
    if (value < 1 || value > double(kMostCounted) || value != std::floor(value)) {
      fail(what + " is " + cell + ", expected a whole number from 1");
    }
    return static_cast<std::size_t>(value);
  }

 private:
  static std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t from = 0;
    for (std::size_t to = 0; to != std::string::npos; from = to + 1) {
      to = line.find('\t', from);
      cells.emplace_back(trim(std::string_view(line).substr(from, to == std::string::npos ? to : to - from)));
    }
    while (!cells.empty() && cells.back().empty()) cells.pop_back();
    return cells;
  }

  std::string path_;
  std::vector<std::string> lines_;
  std::size_t next_ = 0;
};

bool is_blank(const std::vector<std::string>& cells) { return cells.empty(); }

// Three numbers, or nothing, or words for nothing: a marker that was not seen.
Eigen::Vector3d point_of(const Lines& lines, const std::vector<std::string>& cells, std::size_t first,
                         const std::string& name, double metres) {
  const auto cell = [&](std::size_t i) { return first + i < cells.size() ? cells[first + i] : std::string(); };
  const auto none = [](const std::string& it) { return it.empty() || it == "nan" || it == "NaN" || it == "null"; };
  if (none(cell(0)) && none(cell(1)) && none(cell(2))) return kUnseen;
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < 3; ++i) point[i] = metres * lines.number_in(cell(i), name + " " + "xyz"[i]);
  return point;
}

void require_names(const Lines& lines, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) lines.fail(text("marker %zu has no name", i + 1));
    if (std::count(names.begin(), names.end(), names[i]) > 1)
      lines.fail("the marker '" + names[i] + "' is there twice");
  }
}

void require_next(const Lines& lines, const std::vector<double>& times, double time) {
  if (!times.empty() && !(time >= times.back() + kLeastRowSeconds)) {
    lines.fail(text("time is %.9g s after %.9g s, expected a later one", time, times.back()));
  }
}

// One row more or less is what some programs count otherwise.
void require_count(const std::string& path, Markers& markers, std::size_t told) {
  const std::size_t there = markers.times.size();
  if (there == 0) throw Failure(path + " has no rows of numbers");
  if (there == told) return;
  const std::string counts = text("it has %zu rows and says %zu", there, told);
  if (there + 1 != told && told + 1 != there) throw Failure(path + ": " + counts + "; was it cut off?");
  markers.notes.push_back(path + ": " + counts);
}

}  // namespace

double metres_of(std::string unit) {
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  if (unit == "mm" || unit == "millimeters") return 0.001;
  if (unit == "cm" || unit == "centimeters") return 0.01;
  return unit == "m" || unit == "meters" ? 1 : 0;
}

Markers read_trc(const std::string& path) {
  Lines lines(path);
  const std::vector<std::string> kind = lines.take("a line that begins with PathFileType");
  if (is_blank(kind) || kind[0] != "PathFileType") lines.fail("expected PathFileType, as TRC files begin");
  const std::vector<std::string> keys = lines.take("names of the header"), values = lines.take("values of the header");
  const auto value_of = [&](const char* key) {
    const auto found = std::find(keys.begin(), keys.end(), key);
    const auto at = static_cast<std::size_t>(found - keys.begin());
    if (found == keys.end() || at >= values.size()) lines.fail(std::string("the header has no ") + key);
    return values[at];
  };
  const std::size_t told = lines.count_in(value_of("NumFrames"), "NumFrames");
  const std::size_t count = lines.count_in(value_of("NumMarkers"), "NumMarkers");
  const double metres = metres_of(value_of("Units"));
  if (metres == 0) lines.fail("Units is '" + value_of("Units") + "', expected mm, cm or m");
  const std::vector<std::string> titles = lines.take("names of markers");
  Markers markers;
  for (std::size_t i = 2; i < titles.size(); i += 3) markers.names.push_back(titles[i]);
  if (titles.size() < 2 || titles[0] != "Frame#" || markers.names.size() != count) {
    lines.fail(text("%zu names of markers, expected Frame#, Time, and the %zu of NumMarkers, each above three columns",
                    markers.names.size(), count));
  }
  require_names(lines, markers.names);
  lines.take("a line of X1, Y1, Z1, ...");
  while (!lines.ended()) {
    const std::vector<std::string> cells = lines.take("numbers");
    if (is_blank(cells)) continue;
    if (cells.size() > 2 + 3 * count || cells.size() < 2) {
      lines.fail(text("%zu cells, expected Frame#, Time and %zu numbers", cells.size(), 3 * count));
    }
    const double time = lines.number_in(cells[1], "Time");
    require_next(lines, markers.times, time);
    markers.times.push_back(time);
    markers.rows.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      markers.rows.back().push_back(point_of(lines, cells, 2 + 3 * i, markers.names[i], metres));
    }
  }
  require_count(path, markers, told);
  return markers;
}

namespace {

// The lines before the numbers: a word in capitals, then its values.
struct QualisysHeader {
  std::size_t frames = 0, markers = 0;
  double rate = 0;
  std::vector<std::string> names;
  bool skeleton = false;
};

bool is_key(const std::string& word) {
  return word.size() > 2 &&
         std::all_of(word.begin(), word.end(), [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; });
}

QualisysHeader header_of(Lines& lines) {
  QualisysHeader header;
  while (!lines.ended()) {
    std::vector<std::string> cells = lines.take("a header");
    if (is_blank(cells)) continue;
    if (!is_key(cells[0])) {
      lines.back();
      break;
    }
    const std::string key = cells[0], value = cells.size() > 1 ? cells[1] : "";
    if (key == "NO_OF_FRAMES") header.frames = lines.count_in(value, key);
    if (key == "NO_OF_MARKERS") header.markers = lines.count_in(value, key);
    if (key == "FREQUENCY") header.rate = lines.number_in(value, key);
    if (key == "MARKER_NAMES") header.names.assign(cells.begin() + 1, cells.end());
    if (key == "REFERENCE") {
      header.skeleton = true;
      if (value != "GLOBAL") lines.fail("REFERENCE is '" + value + "', expected GLOBAL; export the skeleton so");
    }
    if (key == "DATA_INCLUDED" && value != "3D") lines.fail("DATA_INCLUDED is '" + value + "', expected 3D");
  }
  if (header.frames == 0) lines.fail("the header has no NO_OF_FRAMES, as Qualisys' TSV files begin");
  if (!(header.rate > 0)) lines.fail("the header has no FREQUENCY above 0");
  return header;
}

// Segments of a skeleton, by the header of its columns: NAME X Y Z QX QY QZ QW, with or without NAME at each.
std::vector<std::string> segments_of(const Lines& lines, const std::vector<std::string>& titles,
                                     std::vector<std::size_t>& columns) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i + 2 < titles.size(); ++i) {
    const auto ends = [&](std::size_t at, const char* axis) {
      const std::string& title = titles[at];
      return title == axis || (title.size() > 2 && title.substr(title.size() - 2) == std::string(" ") + axis);
    };
    if (!ends(i, "X") || !ends(i + 1, "Y") || !ends(i + 2, "Z")) continue;
    names.push_back(titles[i] == "X" ? (i == 0 ? "" : titles[i - 1]) : titles[i].substr(0, titles[i].size() - 2));
    columns.push_back(i);
  }
  if (names.empty()) lines.fail("expected a line with the names of the segments, and X, Y, Z, QX, QY, QZ, QW of each");
  return names;
}

}  // namespace

Markers read_qualisys(const std::string& path) {
  constexpr double kMillimetre = 0.001;  // Qualisys' unit
  Lines lines(path);
  const QualisysHeader header = header_of(lines);
  Markers markers;
  markers.names = header.names;
  std::vector<std::size_t> columns;
  std::size_t first = 0;  // columns of frame and time, where there are any
  std::vector<std::string> cells = lines.take("rows of numbers");
  const bool titled = !number_of_file(cells.empty() ? "" : cells[0]);
  if (header.skeleton) {
    markers.names = segments_of(lines, cells, columns);
  } else {
    if (titled && !cells.empty() && cells[0] == "Frame") first = cells.size() > 1 && cells[1] == "Time" ? 2 : 1;
    for (std::size_t i = 0; i < markers.names.size(); ++i) columns.push_back(first + 3 * i);
  }
  if (!titled) lines.back();
  require_names(lines, markers.names);
  if (markers.names.empty() || (header.markers != 0 && header.markers != markers.names.size())) {
    lines.fail(
        text("%zu names in MARKER_NAMES, expected the %zu of NO_OF_MARKERS", markers.names.size(), header.markers));
  }
  const std::size_t width = header.skeleton ? cells.size() : first + 3 * markers.names.size();
  while (!lines.ended()) {
    cells = lines.take("numbers");
    if (is_blank(cells)) continue;
    if (cells.size() > width) lines.fail(text("%zu cells, expected %zu", cells.size(), width));
    markers.times.push_back(static_cast<double>(markers.times.size()) / header.rate);
    markers.rows.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Eigen::Vector3d point = point_of(lines, cells, columns[i], markers.names[i], kMillimetre);
      markers.rows.back().push_back(point.isZero(0) ? kUnseen : point);  // how older versions write a gap
    }
  }
  require_count(path, markers, header.frames);
  return markers;
}

}  // namespace cli
