#include "fmi/needed.h"

#ifndef _WIN32

#include "programs/program.h"

namespace cli {

std::vector<NeededLibrary> needed_libraries() { throw Failure("--fmu: units of FMI are made on Linux and Windows"); }

}  // namespace cli

#endif
