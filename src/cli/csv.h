// Tables of numbers: a header of names, then rows.
#pragma once

#include <string>
#include <vector>

namespace cli {

struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;  // each as long as names
};

// `named` says what the columns are, "actuator". Throws a Failure that names the file, and the line where there is one.
NumberTable read_numbers(const std::string& path, const std::string& named);

}  // namespace cli
