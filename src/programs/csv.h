// Tables as files: cells between commas, or between semicolons or tabs where numbers have decimal commas; cells may be
// quoted.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// A line that is not empty.
struct TextRow {
  std::size_t line;  // its number, from 1
  std::vector<std::string> cells;
};

// Throws a Failure where the file cannot be read.
std::vector<TextRow> read_texts(const std::string& path);

// A header of names, then rows.
struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;  // each as long as names
};

// `named` says what the columns are, "actuator". Throws a Failure that names the file, and the line where there is one.
NumberTable read_numbers(const std::string& path, const std::string& named);

// Throws a Failure that names the file.
void write_numbers(const std::string& path, const NumberTable& table, int digits);

// Without spaces at both ends.
std::string_view trim(std::string_view text);

}  // namespace cli
