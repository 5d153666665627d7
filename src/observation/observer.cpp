#include "observation/observer.h"

#include <algorithm>
#include <utility>

#include "base/fail.h"

namespace mimo::observation {
namespace {

constexpr std::size_t kAlignment = 64;

std::size_t aligned(std::size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

void Layout::add(Field& field) {
  field.offset = bytes_;
  bytes_ += aligned(field.bytes());
  fields_.push_back(&field);
}

void Layout::clear_gaps(std::uint8_t* block) const {
  for (const Field* field : fields_) {
    const std::size_t end = field->offset + field->bytes();
    std::fill(block + end, block + aligned(end), std::uint8_t{0});
  }
}

void Observer::add(Sense& sense) {
  for (Field& field : sense.fields()) {
    for (std::size_t i = 0; i < layout_.size(); ++i) {
      require(layout_[i].name != field.name, "there are two fields \"{}\"", field.name);
    }
    layout_.add(field);
  }
  senses_.push_back(&sense);
}

void Observer::add(std::unique_ptr<Sense> sense) {
  own_.push_back(std::move(sense));
  add(*own_.back());
}

void Observer::write(std::size_t sense, const mjModel& model, const mjData& data, std::uint8_t* block,
                     ShareTimes* times) const {
  ShareTimes nobodys{};
  ShareTimes& sums = times != nullptr ? *times : nobodys;
  const Stopwatch watch(times != nullptr, sums[static_cast<std::size_t>(senses_[sense]->share())]);
  senses_[sense]->write(model, data, block);
}

void Observer::begin(const mjModel& model, const mjData& data) const {
  for (const Sense* sense : senses_) {
    for (const auto& process : sense->processes()) process->begin(model, data);
  }
}

void Observer::advance(const mjModel& model, const mjData& data, ShareTimes* times) const {
  ShareTimes nobodys{};
  ShareTimes& sums = times != nullptr ? *times : nobodys;
  for (const Sense* sense : senses_) {
    if (sense->processes().empty()) continue;
    const Stopwatch watch(times != nullptr, sums[static_cast<std::size_t>(sense->share())]);
    for (const auto& process : sense->processes()) process->advance(model, data);
  }
}

void Observer::list(std::vector<Section>& sections) const {
  for (const Sense* sense : senses_) {
    for (const auto& process : sense->processes()) sections.push_back(process->section());
  }
}

void Observer::observe_share(Share share, const mjModel& model, const mjData& data, std::uint8_t* block) const {
  for (Sense* sense : senses_) {
    if (sense->share() == share) sense->write(model, data, block);
  }
}

}  // namespace mimo::observation
