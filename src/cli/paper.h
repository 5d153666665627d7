// mimo bench --paper: the measurements of the paper's Fig. 3.
#pragma once

#include <string>

namespace cli {

struct PaperOptions {
  std::string renderer;
  bool brief;       // one episode instead of sixty
  std::string csv;  // a file, or "" for none
};

// Measures, and prints the table.
void run_paper(const PaperOptions& options);

}  // namespace cli
