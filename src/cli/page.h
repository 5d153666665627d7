// A recording as one page for browsers.
#pragma once

#include <string>

namespace cli {

struct PageOptions {
  std::string out;      // "" where no page was asked for
  std::string without;  // the page without a recording; "": as it is installed or built
};

// Writes the page with the recording inside. Throws a Failure, and leaves then what was there, where the file is no
// recording or a browser could not play it.
void write_page(const PageOptions& options, const std::string& recording);

}  // namespace cli
