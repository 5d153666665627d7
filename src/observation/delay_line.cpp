#include "observation/delay_line.h"

#include <algorithm>

#include "base/bytes.h"
#include "base/numbers.h"

namespace mimo::observation {

std::size_t Lateness::least() const {
  std::size_t least = runs.empty() ? 0 : runs[0].ticks;
  for (const Run& run : runs) least = std::min(least, run.ticks);
  return least;
}

std::size_t Lateness::most() const {
  std::size_t most = 0;
  for (const Run& run : runs) most = std::max(most, run.ticks);
  return most;
}

void Lateness::tell(Span<double> seconds) const {
  std::fill(seconds.begin(), seconds.end(), 0.0);
  for (const Run& run : runs) {
    std::fill_n(seconds.begin() + run.first, run.count, static_cast<double>(run.ticks) * tick);
  }
}

DelayLine::DelayLine(const Field& field, const std::vector<double>& seconds, const Clock& clock)
    : field_(&field), lateness_{clock.tick, {}} {
  const std::size_t grain = clock.within_a_step ? 1 : clock.per_step;  // ticks
  const std::size_t elements = seconds.size() == 1 ? field.count() : 1;
  for (const double late : seconds)
    add(elements, steps_of_delay(late, static_cast<double>(grain) * clock.tick) * grain);
  if (lateness_.most() == 0) return;
  choose_ticks(clock.per_step);
  past_.resize(rows_ * field.bytes());
}

void DelayLine::add(std::size_t elements, std::size_t ticks) {
  std::vector<Run>& runs = lateness_.runs;
  if (!runs.empty() && runs.back().ticks == ticks) {
    runs.back().count += elements;
  } else {
    runs.push_back({runs.empty() ? 0 : runs.back().first + runs.back().count, elements, ticks});
  }
}

// Where all delays differ by whole steps, one tick of each step is enough.
void DelayLine::choose_ticks(std::size_t per_step) {
  const std::size_t most = lateness_.most(), phase = most % per_step;
  const auto alike = [&](const Run& run) { return run.ticks % per_step == phase; };
  if (std::all_of(lateness_.runs.begin(), lateness_.runs.end(), alike)) {
    stride_ = per_step;
    phase_ = phase;
  }
  rows_ = most / stride_ + 1;
}

void DelayLine::begin(const std::uint8_t* block) {
  begun_ = true;
  for (std::size_t at = 0; at < past_.size(); at += field_->bytes()) {
    std::copy_n(block + field_->offset, field_->bytes(), past_.data() + at);
  }
}

void DelayLine::keep(const std::uint8_t* block, std::uint64_t tick) {
  if (!begun_) return begin(block);
  if (wants(tick)) std::copy_n(block + field_->offset, field_->bytes(), past_.data() + row((tick + phase_) / stride_));
}

// Rows of ticks before the episode hold what it began with: `rows` are added so that their numbers are not negative.
void DelayLine::recall(std::uint8_t* block, std::uint64_t tick) const {
  if (!begun_) return;
  const std::size_t size = size_of(field_->type);
  for (const Run& run : lateness_.runs) {
    const std::uint64_t number = (tick + phase_ + rows_ * stride_ - run.ticks) / stride_;
    std::copy_n(past_.data() + row(number) + run.first * size, run.count * size,
                block + field_->offset + run.first * size);
  }
}

Section DelayLine::section() {
  Hash kind;
  for (const Run& run : lateness_.runs) {
    kind.add(std::uint64_t{run.first});
    kind.add(std::uint64_t{run.ticks});
  }
  kind.add(std::uint64_t{stride_});
  kind.add(static_cast<std::uint64_t>(field_->type));
  for (const std::size_t extent : field_->shape) kind.add(std::uint64_t{extent});
  Section section;
  section.name = "delay/" + field_->name;
  section.kind = kind.value();
  section.essential = false;
  section.save = [this](ByteWriter& to) {
    to.put(begun_);
    to.put(Span<const std::uint8_t>(past_));
  };
  section.load = [this](ByteReader& from) {
    begun_ = from.take_flag();
    from.take(Span<std::uint8_t>(past_));
  };
  section.forget = [this] { forget(); };
  return section;
}

}  // namespace mimo::observation
