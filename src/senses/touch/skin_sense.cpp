#include "senses/touch/skin_sense.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "base/bits.h"
#include "observation/signals.h"
#include "receptors/nociceptors.h"
#include "senses/touch/pain.h"

namespace mimo::senses {
namespace {

using observation::Field;
using observation::Signal;

// The process of a whole skin; later parts need what earlier ones found.
class Nerves : public observation::Process {
 public:
  Nerves(const mjModel& model, const body::Body& body, std::shared_ptr<const touch::Skin> skin,
         const TouchOptions& options, touch::ThingsPtr things, touch::Rattle& rattle, double tick)
      : Process("touch"),
        skin_(std::move(skin)),
        things_(std::move(things)),
        patches_(touch::patches(model, body, *skin_)),
        wants_warmth_(has_bit(options.wanted, kWarmthNerves | kPainNerves)),
        wants_pain_(has_bit(options.wanted, kPainNerves)),
        wants_rates_of_warmth_(has_bit(options.wanted, MIMO_TOUCH_COLD | MIMO_TOUCH_WARM)),
        felt_(*skin_, options.response,
              {has_bit(options.wanted, kTouchNerves | kPainNerves), wants_pain_, options.slip_threshold}, *things_),
        rattle_(rattle),
        afferents_(patches_, rattle, options.slip_threshold, tick),
        warmth_(patches_, *things_, tick),
        pain_(patches_, tick) {}

  std::vector<Signal> signals(std::uint32_t wanted) const;

 private:
  void rest(const mjModel& model, const mjData& data) override {
    felt_.take_in(model, data);
    afferents_.rest(felt_);
    stale_ = false;
    warmth_.rest();
    pain_.rest();
  }
  void go_on(const mjModel& model, const mjData& data) override {
    felt_.take_in(model, data);
    afferents_.go_on(felt_);
    stale_ = true;
    if (wants_warmth_) warmth_.go_on(felt_, afferents_);
    if (wants_pain_) pain_.go_on(felt_, rattle_, warmth_);
  }
  void save(ByteWriter& to) const override {
    tell();
    afferents_.save(to);
    if (wants_warmth_) warmth_.save(to);
    if (wants_pain_) pain_.save(to);
  }
  void load(ByteReader& from) override {
    stale_ = false;
    afferents_.load(from);
    if (wants_warmth_) warmth_.load(from);
    if (wants_pain_) pain_.load(from);
  }

  // Rates are worked out when they are looked at.
  void tell() const {
    if (!stale_) return;
    afferents_.tell(felt_, *things_);
    if (wants_warmth_) warmth_.tell(wants_rates_of_warmth_);
    stale_ = false;
  }

  // Fills all of a field.
  using Fill = std::function<void(float* out)>;
  Signal signal(const char* name, std::size_t channels, Fill fill, const char* unit = "Hz") const;
  Signal rate(const char* name, touch::Afferents::Rate rate) const;
  Signal rate(const char* name, touch::Pain::Rate rate) const;
  Signal stretch() const;
  Signal told(const char* name, const std::vector<float>& values, const char* unit = "Hz") const;
  Signal units() const;

  std::shared_ptr<const touch::Skin> skin_;
  touch::ThingsPtr things_;
  std::vector<touch::Patch> patches_;
  bool wants_warmth_, wants_pain_, wants_rates_of_warmth_;
  mutable bool stale_ = false;  // rates are of an earlier step
  touch::Felt felt_;
  const touch::Rattle& rattle_;
  mutable touch::Afferents afferents_;
  mutable touch::Warmth warmth_;
  touch::Pain pain_;
};

Signal Nerves::signal(const char* name, std::size_t channels, Fill fill, const char* unit) const {
  Field field;
  field.name = std::string("touch/") + name;
  field.shape = {skin_->sensors().size()};
  if (channels > 1) {
    field.shape.push_back(channels);
    field.frame = "skin";
  }
  field.unit = unit;
  if (unit == std::string("Hz")) field.low = 0;
  field.receptors = skin_->sensors();
  return {field, [this, fill = std::move(fill)](const mjModel&, const mjData&, float* out) {
            tell();
            fill(out);
          }};
}

// Most sensors are silent.
Signal Nerves::rate(const char* name, touch::Afferents::Rate rate) const {
  return signal(name, 1, [this, rate](float* out) {
    std::fill_n(out, patches_.size(), 0.0F);
    afferents_.fill_in(rate, out);
  });
}

Signal Nerves::rate(const char* name, touch::Pain::Rate rate) const {
  return signal(name, 1, [this, rate](float* out) {
    std::fill_n(out, patches_.size(), 0.0F);
    pain_.fill_in(rate, out);
  });
}

Signal Nerves::stretch() const {
  return signal("sa2", 2, [this](float* out) {
    std::fill_n(out, 2 * patches_.size(), 0.0F);
    afferents_.fill_in(touch::Afferents::kSa2Along, out, 2);
    afferents_.fill_in(touch::Afferents::kSa2Across, out + 1, 2);
  });
}

Signal Nerves::told(const char* name, const std::vector<float>& values, const char* unit) const {
  return signal(
      name, 1, [&values](float* out) { std::copy(values.begin(), values.end(), out); }, unit);
}

// How many afferents of each kind a sensor stands for.
Signal Nerves::units() const {
  std::vector<float> counts;
  for (const touch::Patch& patch : patches_) {
    for (std::size_t kind = 0; kind < receptors::kTouchKinds; ++kind) {
      counts.push_back(static_cast<float>(patch.afferents * receptors::share_of(patch.region, kind)));
    }
  }
  const auto fill = [counts](float* out) { std::copy(counts.begin(), counts.end(), out); };
  Signal signal = this->signal("units", receptors::kTouchKinds, fill, "");
  signal.field.frame = "";
  signal.field.low = 0;
  return signal;
}

std::vector<Signal> Nerves::signals(std::uint32_t wanted) const {
  std::vector<Signal> signals;
  // Thinner nerves than those of touch are slower: cold 6.3 and warm 0.7 m/s (Hensel and Iggo 1971), pain 13 and 0.8.
  const auto add = [&](std::uint32_t bit, Signal signal, double share = 1, double speed = 0) {
    if (!has_bit(wanted, bit)) return;
    signal.field.nerve_share = share;
    signal.field.nerve_speed = speed;
    signals.push_back(std::move(signal));
  };
  add(MIMO_TOUCH_SA1, rate("sa1", touch::Afferents::kSa1));
  add(MIMO_TOUCH_RA, rate("ra", touch::Afferents::kRa));
  add(MIMO_TOUCH_PC, rate("pc", touch::Afferents::kPc));
  add(MIMO_TOUCH_SA2, stretch());
  add(MIMO_TOUCH_TEMPERATURE, told("temperature", warmth_.temperature(), "degC"));
  add(MIMO_TOUCH_COLD, told("cold", warmth_.cold()), 6.3 / 56);
  add(MIMO_TOUCH_WARM, told("warm", warmth_.warm()), 1, 0.7);
  add(MIMO_TOUCH_NOCICEPTION_FAST, rate("nociception_fast", touch::Pain::kFast), receptors::kFastShare);
  add(MIMO_TOUCH_NOCICEPTION_SLOW, rate("nociception_slow", touch::Pain::kSlow), 1, receptors::kSlowSpeed);
  add(MIMO_TOUCH_UNITS, units());
  return signals;
}

}  // namespace

std::unique_ptr<observation::Sense> make_skin_sense(const mjModel& model, const body::Body& body,
                                                    std::shared_ptr<const touch::Skin> skin,
                                                    const TouchOptions& options, touch::ThingsPtr things, double tick) {
  auto rattle = std::make_unique<touch::Rattle>(skin->sensors().size(), things->all.size(), tick);
  auto nerves = std::make_unique<Nerves>(model, body, std::move(skin), options, std::move(things), *rattle, tick);
  auto sense = std::make_unique<observation::Signals>(observation::Share::kTouch, nerves->signals(options.wanted));
  sense->keep(std::move(rattle));
  sense->keep(std::move(nerves));
  return sense;
}

}  // namespace mimo::senses
