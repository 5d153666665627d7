// Where there is no Debian, there is no step of its MuJoCo to measure with.
#include "bench/measurements.h"
#include "programs/program.h"

namespace cli {

class ReferenceStep::InThisProcess {};
class ReferenceStep::InChildProcess {};

ReferenceStep::ReferenceStep(std::uint64_t, std::size_t room) : times_(room) {}
ReferenceStep::~ReferenceStep() = default;
void ReferenceStep::run(std::size_t) {}
void ReferenceStep::warm_up() {}

void serve_reference(std::uint64_t) { throw Failure("reference steps are measured on Linux only"); }

}  // namespace cli
