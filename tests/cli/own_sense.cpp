// A sense for tests of the program: how many physics steps an episode has had, times a parameter. It fails after
// "last".
#include <mimo/mimo.hpp>
#include <stdexcept>

namespace {

class Ticks : public mimo::Sense {
 public:
  static std::vector<mimo_parameter> parameters() {
    return {mimo::sense_parameter("gain", "factor", 1, 0, 5), mimo::sense_parameter("last", "tick", 1e9, 0, 1e9)};
  }
  explicit Ticks(mimo::SenseOpening& opening) {
    opening.add(mimo::SenseField());
    opening.memory_bytes = sizeof(double);
  }
  void advance(const mimo::SenseMoment& now) const override {
    if (static_cast<double>(now.told.tick) > now.told.parameters[1]) throw std::runtime_error("no more ticks");
    now.memory<double>() += now.told.parameters[0];
  }
  void write(const mimo::SenseMoment& now) const override {
    now.field(0)[0] = static_cast<float>(now.memory<double>());
  }
};

mimo_sense table() {
  mimo_sense made = mimo::sense<Ticks>("ticks");
#ifdef OTHER_SENSE
  made.interface_version = 7;
#endif
  return made;
}

}  // namespace

MIMO_SENSE(table())
