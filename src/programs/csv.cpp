#include "programs/csv.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>
#include <unordered_set>

#include "programs/files.h"
#include "programs/program.h"
#include "programs/text.h"

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

// Reads rows and knows where it is.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), text_(read_file(path)) {
    rest_ = text_;
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);  // the mark that some spreadsheets put first
    separator_ = separator_of(rest_.substr(0, rest_.find_first_of(kEnds)));
  }

  // False at the end. Lines end with any of the three marks that systems use.
  bool next() {
    ++number_;
    if (rest_.empty()) return false;
    line_ = rest_.substr(0, rest_.find_first_of(kEnds));
    rest_.remove_prefix(line_.size());
    rest_.remove_prefix(rest_.substr(0, 2) == "\r\n" ? 2 : rest_.empty() ? 0 : 1);
    return true;
  }

  bool is_blank() const { return trim(line_).empty(); }

  std::vector<std::string> cells() const {
    std::vector<std::string> cells;
    std::string_view line = line_;
    for (bool more = true; more;) {
      cells.push_back(take_cell(line));
      more = !line.empty();
      if (more) line.remove_prefix(1);  // the separator
    }
    return cells;
  }

  std::size_t number() const { return number_; }
  char separator() const { return separator_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(path_ + ", line " + std::to_string(number_) + ": " + what);
  }

 private:
  static constexpr char kEnds[] = "\r\n";

  // Takes a cell off the line, up to the separator.
  std::string take_cell(std::string_view& line) const {
    skip_blanks(line);
    if (!line.empty() && line[0] == '"') return take_quoted(line);
    const std::string_view cell = line.substr(0, line.find(separator_));
    line.remove_prefix(cell.size());
    if (cell.find('"') != std::string_view::npos) {
      fail("the cell " + shown(cell) +
           " has a quote within; expected it to be quoted as a whole, and its quotes doubled");
    }
    return std::string(trim(cell));
  }

  // As RFC 4180 has them: a quote within is written twice, and nothing follows the last one.
  std::string take_quoted(std::string_view& line) const {
    const std::string_view whole = line;
    std::string cell;
    for (;;) {
      line.remove_prefix(1);  // the quote
      const std::size_t length = line.find('"');
      if (length == std::string_view::npos) fail("the quote before " + shown(whole.substr(1)) + " is not closed");
      cell += line.substr(0, length);
      line.remove_prefix(length + 1);
      if (line.empty() || line[0] != '"') break;
      cell += '"';
    }
    skip_blanks(line);
    if (!line.empty() && line[0] != separator_) {
      fail("the quoted cell " + shown(cell) + " is followed by " + shown(line) + "; expected the next cell");
    }
    return cell;
  }

  static std::string shown(std::string_view text) { return "'" + std::string(text.substr(0, 60)) + "'"; }

  void skip_blanks(std::string_view& line) const {
    while (!line.empty() && line[0] != separator_ && (line[0] == ' ' || line[0] == '\t')) line.remove_prefix(1);
  }

  std::string path_, text_;
  std::string_view rest_, line_;
  std::size_t number_ = 0;
  char separator_ = ',';
};

std::vector<std::string> read_header(const Reader& reader, const std::string& named) {
  std::vector<std::string> names = reader.cells();
  std::unordered_set<std::string_view> known;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) reader.fail("column " + std::to_string(i + 1) + " has no " + named + "'s name");
    if (!known.insert(names[i]).second) reader.fail("there are two columns '" + names[i] + "'");
  }
  return names;
}

double read_number(const Reader& reader, const std::string& cell, const std::string& column) {
  std::string plain = cell;
  if (reader.separator() != ',') std::replace(plain.begin(), plain.end(), ',', '.');  // of decimals
  const std::optional<double> value = number_of_file(plain);
  if (!value) reader.fail("column '" + column + "' should be " + kNumberOfFile + ", not '" + cell + "'");
  return *value;
}

std::vector<double> read_row(const Reader& reader, const std::vector<std::string>& names) {
  const std::vector<std::string> cells = reader.cells();
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
  while (reader.next()) {
    if (!reader.is_blank()) rows.push_back({reader.number(), reader.cells()});
  }
  return rows;
}

NumberTable read_numbers(const std::string& path, const std::string& named) {
  Reader reader(path);
  if (!reader.next() || reader.is_blank()) reader.fail("expected a header of " + named + " names");
  NumberTable table;
  table.names = read_header(reader, named);
  bool ended = false;
  while (reader.next()) {
    if (reader.is_blank()) {
      ended = true;  // files may end with empty lines
      continue;
    }
    if (ended) reader.fail("there is an empty line before this one");
    table.rows.push_back(read_row(reader, table.names));
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
