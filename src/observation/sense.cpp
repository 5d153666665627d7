#include "observation/sense.h"

#include <utility>

#include "base/bytes.h"

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
  if (version_ != 0) kind.add(std::uint64_t{version_});
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

Signals::Signals(Share share, std::vector<Signal> signals) : share_(share) {
  for (Signal& signal : signals) {
    if (signal.field.count() == 0) continue;
    fields_.push_back(std::move(signal.field));
    writers_.push_back(std::move(signal.write));
  }
}

void Signals::write(const mjModel& model, const mjData& data, std::uint8_t* block) {
  for (std::size_t i = 0; i < writers_.size(); ++i) writers_[i](model, data, at<float>(block, i));
}

}  // namespace mimo::observation
