// Control sequences: a header of names, then one row of numbers a physics step.
#pragma once

#include <string>
#include <vector>

namespace cli {

struct ControlTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;  // each as long as names
};

// Throws a Failure that names the file, and the line where there is one.
ControlTable read_controls(const std::string& path);

}  // namespace cli
