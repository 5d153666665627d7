#include "fmi/needed.h"
#include "programs/program.h"

namespace cli {

std::vector<NeededLibrary> needed_libraries() { throw Failure("--fmu: units of FMI are made on Linux"); }

}  // namespace cli
