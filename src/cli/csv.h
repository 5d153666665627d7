// Tables of numbers: a header of names, then rows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cli {

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
