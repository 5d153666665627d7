#include "senses/touch/skin_sense.h"

#include <algorithm>
#include <limits>
#include <utility>

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
         const TouchOptions& options, touch::ThingsPtr things, double tick)
      : Process("touch"),
        skin_(std::move(skin)),
        things_(std::move(things)),
        patches_(touch::patches(model, body, *skin_)),
        wants_warmth_(options.receptors.warmth() || options.receptors.pain()),
        wants_pain_(options.receptors.pain()),
        wants_rates_of_warmth_(options.receptors.cold || options.receptors.warm),
        felt_(*skin_, options.response, {options.receptors.ra || options.receptors.pc, wants_pain_}, *things_),
        afferents_(patches_, options.slip_threshold, tick),
        warmth_(patches_, things_->air, tick),
        pain_(patches_, tick) {}

  std::vector<Signal> signals(const SkinReceptorOptions& wanted) const;

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
    if (wants_warmth_) warmth_.go_on(felt_, afferents_, *things_);
    if (wants_pain_) pain_.go_on(felt_, warmth_);
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
    if (wants_rates_of_warmth_) warmth_.tell();
    stale_ = false;
  }

  Signal signal(const char* name, const std::vector<float>& values, const char* unit = "Hz") const;
  Signal units() const;

  std::shared_ptr<const touch::Skin> skin_;
  touch::ThingsPtr things_;
  std::vector<touch::Patch> patches_;
  bool wants_warmth_, wants_pain_, wants_rates_of_warmth_;
  mutable bool stale_ = false;  // rates are of an earlier step
  touch::Felt felt_;
  mutable touch::Afferents afferents_;
  mutable touch::Warmth warmth_;
  touch::Pain pain_;
};

Signal Nerves::signal(const char* name, const std::vector<float>& values, const char* unit) const {
  Field field;
  field.name = std::string("touch/") + name;
  field.shape = {skin_->sensors().size()};
  if (values.size() > skin_->sensors().size()) {
    field.shape.push_back(values.size() / skin_->sensors().size());
    field.frame = "skin";
  }
  field.unit = unit;
  if (unit == std::string("Hz")) field.low = 0;
  field.receptors = skin_->sensors();
  return {field, [this, &values](const mjModel&, const mjData&, float* out) {
            tell();
            std::copy(values.begin(), values.end(), out);
          }};
}

// How many afferents of each kind a sensor stands for; on a regular grid of triangles it has 0.87 of its spacing's
// square to itself.
Signal Nerves::units() const {
  std::vector<float> counts;
  for (const touch::Patch& patch : patches_) {
    const double area = 0.87 * patch.spacing * patch.spacing;
    for (std::size_t kind = 0; kind < receptors::kTouchKinds; ++kind) {
      counts.push_back(static_cast<float>(area * receptors::afferents_per_square_metre(patch.region, kind)));
    }
  }
  Signal signal = this->signal("units", counts, "");
  signal.field.frame = "";
  signal.field.low = 0;
  signal.write = [counts](const mjModel&, const mjData&, float* out) { std::copy(counts.begin(), counts.end(), out); };
  return signal;
}

std::vector<Signal> Nerves::signals(const SkinReceptorOptions& wanted) const {
  std::vector<Signal> signals;
  // Thinner nerves than those of touch are slower: cold 6.3 and warm 0.7 m/s (Hensel and Iggo 1971), pain 13 and 0.8.
  const auto add = [&](bool is, Signal signal, double share = 1, double speed = 0) {
    if (!is) return;
    signal.field.nerve_share = share;
    signal.field.nerve_speed = speed;
    signals.push_back(std::move(signal));
  };
  add(wanted.sa1, signal("sa1", afferents_.sa1()));
  add(wanted.ra, signal("ra", afferents_.ra()));
  add(wanted.pc, signal("pc", afferents_.pc()));
  add(wanted.sa2, signal("sa2", afferents_.sa2()));
  add(wanted.temperature, signal("temperature", warmth_.temperature(), "degC"));
  add(wanted.cold, signal("cold", warmth_.cold()), 6.3 / 56);
  add(wanted.warm, signal("warm", warmth_.warm()), 1, 0.7);
  add(wanted.nociception_fast, signal("nociception_fast", pain_.fast()), receptors::kFastShare);
  add(wanted.nociception_slow, signal("nociception_slow", pain_.slow()), 1, receptors::kSlowSpeed);
  add(wanted.units, units());
  return signals;
}

}  // namespace

std::unique_ptr<observation::Sense> make_skin_sense(const mjModel& model, const body::Body& body,
                                                    std::shared_ptr<const touch::Skin> skin,
                                                    const TouchOptions& options, touch::ThingsPtr things, double tick) {
  auto nerves = std::make_unique<Nerves>(model, body, std::move(skin), options, std::move(things), tick);
  auto sense = std::make_unique<observation::Signals>(observation::Share::kTouch, nerves->signals(options.receptors));
  sense->keep(std::move(nerves));
  return sense;
}

}  // namespace mimo::senses
