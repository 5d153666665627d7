// The libraries without which libmimo does not run elsewhere.
#pragma once

#include <string>
#include <vector>

namespace cli {

struct NeededLibrary {
  std::string name, path;  // the name by which it is asked for
};

// libmimo, and what it needs of what not every system has. Throws a Failure on systems where units cannot be made.
std::vector<NeededLibrary> needed_libraries();

}  // namespace cli
