// Where there is no Debian, there is no step of its MuJoCo to measure with.
#include "bench/reference.h"
#include "programs/failure.h"

namespace cli {

class Reference::Here {};
class Reference::Child {};

Reference::Reference(std::uint64_t, std::size_t room) : times_(room) {}
Reference::~Reference() = default;
void Reference::run(std::size_t) {}
void Reference::warm_up() {}

void serve_reference(std::uint64_t) { throw Failure("reference steps are measured on Linux only"); }

}  // namespace cli
