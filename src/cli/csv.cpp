#include "csv.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "failure.h"
#include "files.h"
#include "text.h"

namespace cli {
namespace {

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    cells.push_back(trim(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  cells.push_back(trim(line));
  return cells;
}

// Reads lines and knows where it is.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), file_(open_to_read(path)) {}

  bool next(std::string& line) {
    ++number_;
    return static_cast<bool>(std::getline(file_, line));
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(path_ + ", line " + std::to_string(number_) + ": " + what);
  }

 private:
  std::string path_;
  std::ifstream file_;
  std::size_t number_ = 0;
};

std::vector<std::string> read_header(Reader& reader, const std::string& line, const std::string& named) {
  std::vector<std::string> names;
  for (const std::string_view cell : split(line)) {
    if (cell.empty()) reader.fail("column " + std::to_string(names.size() + 1) + " has no " + named + "'s name");
    if (std::find(names.begin(), names.end(), cell) != names.end()) {
      reader.fail("there are two columns '" + std::string(cell) + "'");
    }
    names.emplace_back(cell);
  }
  return names;
}

double read_number(const Reader& reader, std::string_view cell, const std::string& column) {
  const std::optional<double> value = finite_number(cell);
  if (!value) reader.fail("column '" + column + "' should be a finite number, not '" + std::string(cell) + "'");
  return *value;
}

std::vector<double> read_row(Reader& reader, const std::string& line, const std::vector<std::string>& names) {
  const auto cells = split(line);
  if (cells.size() != names.size()) {
    reader.fail("expected " + std::to_string(names.size()) + " numbers as the header has names, found " +
                std::to_string(cells.size()));
  }
  std::vector<double> row;
  for (std::size_t i = 0; i < cells.size(); ++i) row.push_back(read_number(reader, cells[i], names[i]));
  return row;
}

}  // namespace

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

NumberTable read_numbers(const std::string& path, const std::string& named) {
  Reader reader(path);
  std::string line;
  if (!reader.next(line) || trim(line).empty()) reader.fail("expected a header of " + named + " names");
  if (line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // the mark that some spreadsheets put first
  NumberTable table;
  table.names = read_header(reader, line, named);
  bool ended = false;
  while (reader.next(line)) {
    if (trim(line).empty()) {
      ended = true;  // files may end with empty lines
      continue;
    }
    if (ended) reader.fail("there is an empty line before this one");
    table.rows.push_back(read_row(reader, line, table.names));
  }
  if (table.rows.empty()) throw Failure(path + ": no rows of numbers follow the header");
  return table;
}

void write_numbers(const std::string& path, const NumberTable& table, int digits) {
  std::ostringstream file;
  const char* comma = "";
  for (const std::string& name : table.names) {
    file << comma << name;
    comma = ",";
  }
  for (const std::vector<double>& row : table.rows) {
    comma = "\n";
    for (const double number : row) {
      file << comma << text("%.*g", digits, number);
      comma = ",";
    }
  }
  file << "\n";
  write_file(path, file.str());
}

}  // namespace cli
