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

// What stands between the cells of a table whose first line this is: a comma, or what programs write in its place where
// the comma is for decimals.
char separator_of(std::string_view line) {
  bool quoted = false;
  std::size_t semicolons = 0, tabs = 0;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ',') return ',';
    semicolons += c == ';' ? 1 : 0;
    tabs += c == '\t' ? 1 : 0;
  }
  return semicolons > 0 ? ';' : tabs > 0 ? '\t' : ',';
}

// A cell without what quotes it (RFC 4180).
std::string unquoted(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return std::string(cell);
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    text += cell[i];
    if (cell[i] == '"' && cell[i + 1] == '"' && i + 2 < cell.size()) ++i;
  }
  return text;
}

std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> cells;
  std::size_t first = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != separator)) continue;
    cells.push_back(unquoted(trim(line.substr(first, i - first))));
    first = i + 1;
  }
  return cells;
}

// Reads lines and knows where it is.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), file_(open_to_read(path)) {}

  bool next(std::string& line) {
    const bool first = ++number_ == 1;
    if (!std::getline(file_, line)) return false;
    if (!first) return true;
    if (line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // the mark that some spreadsheets put first
    separator_ = separator_of(line);
    return true;
  }

  std::size_t number() const { return number_; }
  char separator() const { return separator_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(path_ + ", line " + std::to_string(number_) + ": " + what);
  }

 private:
  std::string path_;
  std::ifstream file_;
  std::size_t number_ = 0;
  char separator_ = ',';
};

std::vector<std::string> read_header(Reader& reader, const std::string& line, const std::string& named) {
  std::vector<std::string> names;
  for (const std::string& cell : split(line, reader.separator())) {
    if (cell.empty()) reader.fail("column " + std::to_string(names.size() + 1) + " has no " + named + "'s name");
    if (std::find(names.begin(), names.end(), cell) != names.end()) {
      reader.fail("there are two columns '" + cell + "'");
    }
    names.push_back(cell);
  }
  return names;
}

double read_number(const Reader& reader, const std::string& cell, const std::string& column) {
  std::string plain = cell;
  if (reader.separator() != ',') std::replace(plain.begin(), plain.end(), ',', '.');  // of decimals
  const std::optional<double> value = finite_number(plain);
  if (!value) reader.fail("column '" + column + "' should be a finite number, not '" + cell + "'");
  return *value;
}

std::vector<double> read_row(Reader& reader, const std::string& line, const std::vector<std::string>& names) {
  const auto cells = split(line, reader.separator());
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

std::vector<TextRow> read_texts(const std::string& path) {
  Reader reader(path);
  std::vector<TextRow> rows;
  for (std::string line; reader.next(line);) {
    if (!trim(line).empty()) rows.push_back({reader.number(), split(line, reader.separator())});
  }
  return rows;
}

NumberTable read_numbers(const std::string& path, const std::string& named) {
  Reader reader(path);
  std::string line;
  if (!reader.next(line) || trim(line).empty()) reader.fail("expected a header of " + named + " names");
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
