// mimo-bench --paper: the measurements of the paper's Fig. 3.
#pragma once

#include <string>

#include "programs/world.h"

namespace cli {

struct PaperOptions {
  WorldOptions world;  // vision and touch are those of the paper
  bool brief;          // one episode instead of sixty
  std::string csv;     // a file, or "" for none
};

// Measures, and prints the table.
void run_paper(const PaperOptions& options);

}  // namespace cli
