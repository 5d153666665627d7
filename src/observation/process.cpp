#include "observation/process.h"

#include "base/hash.h"

namespace mimo::observation {

void Process::begin(const mjModel& model, const mjData& data) {
  rest(model, data);
  begun_ = true;
}

void Process::advance(const mjModel& model, const mjData& data) { begun_ ? go_on(model, data) : begin(model, data); }

Section Process::section() {
  ByteWriter counter;
  save(counter);
  Hash kind;
  kind.add(std::uint64_t{counter.size()});
  Section section;
  section.name = "receptors/" + name_;
  section.kind = kind.value();
  section.essential = false;
  section.save = [this](ByteWriter& to) {
    to.put(begun_);
    save(to);
  };
  section.load = [this](ByteReader& from) {
    begun_ = from.take_flag();
    load(from);
  };
  section.forget = [this] { begun_ = false; };
  return section;
}

}  // namespace mimo::observation
