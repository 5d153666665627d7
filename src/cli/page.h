// A recording as one page for browsers.
#pragma once

#include <string>

namespace cli {

struct PageOptions {
  std::string out;      // "" where no page was asked for
  std::string without;  // the page without a recording; "": as it is installed or built
};

// Writes the page with the recording inside, and how this system's C library rounds in it: the recording is played for
// that. Warns on stderr where it comes out otherwise here. Throws a Failure, and leaves then what was there, where the
// file is no recording or a browser could not play it.
void write_page(const PageOptions& options, const std::string& recording);

}  // namespace cli
