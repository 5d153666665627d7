#include "capi/own_sense.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/bytes.h"
#include "base/format.h"
#include "capi/check.h"
#include "capi/handed.h"
#include "capi/objects.h"
#include "capi/own_code.h"
#include "capi/structs.h"

namespace mimo::capi {
namespace {

constexpr std::size_t kZone = 64;
constexpr std::uint8_t kUntouched = 0xa5;
constexpr std::size_t kMostBytes = 16777216;  // of memory, and of all fields

thread_local const RunningSense* at_work = nullptr;

// This thread runs a function of the sense as long as this lives.
class AtWork {
 public:
  explicit AtWork(const RunningSense& sense) : before_(at_work) { at_work = &sense; }
  ~AtWork() { at_work = before_; }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  const RunningSense* before_;
};

bool is_checked() {
  const char* const wanted = std::getenv("MIMO_CHECK_PLUGINS");
  return wanted != nullptr && std::strcmp(wanted, "1") == 0;
}

std::uint64_t hash_of(const std::string& name) {
  Hash hash;
  hash.add(name);
  return hash.value();
}

double value_at(const observation::Field& field, const std::uint8_t* values, std::size_t i) {
  const std::uint8_t* const at = values + i * size_of(field.type);
  const auto as = [at](auto number) {
    std::memcpy(&number, at, sizeof number);
    return static_cast<double>(number);
  };
  switch (field.type) {
    case observation::Type::kU8: return as(std::uint8_t{});
    case observation::Type::kI32: return as(std::int32_t{});
    case observation::Type::kF32: return as(float{});
    case observation::Type::kF64: return as(double{});
  }
  return 0;
}

// A bound as numbers of a field have it.
double as_told(const observation::Field& field, double bound) {
  return field.type == observation::Type::kF32 ? static_cast<double>(static_cast<float>(bound)) : bound;
}

}  // namespace

GuardedBytes::GuardedBytes(std::size_t size) : room_(size + 3 * kZone, kUntouched), size_(size) {
  const auto first = reinterpret_cast<std::uintptr_t>(room_.data()) + kZone;
  start_ = room_.data() + kZone + (kZone - first % kZone) % kZone;
  clear();
}

void GuardedBytes::clear() { std::fill_n(start_, size_, std::uint8_t{0}); }

const char* GuardedBytes::violated() {
  const auto touched = [](std::uint8_t* zone) {
    const bool all = std::all_of(zone, zone + kZone, [](std::uint8_t byte) { return byte == kUntouched; });
    std::fill_n(zone, kZone, kUntouched);
    return !all;
  };
  const bool before = touched(start_ - kZone), past = touched(start_ + size_);
  return before ? "before" : past ? "past" : nullptr;
}

OwnMemory::OwnMemory(Owner& owner, const SensePlan& plan, std::size_t bytes)
    : Process("sense/" + plan.described.name, plan.table.version), owner_(owner), bytes_(bytes) {}

void OwnMemory::rest(const mjModel&, const mjData&) {
  tick_ = 0;
  bytes_.clear();
  owner_.reset();
}

void OwnMemory::go_on(const mjModel&, const mjData&) {
  ++tick_;
  owner_.advance();
}

void OwnMemory::save(ByteWriter& to) const {
  to.put(tick_);
  to.put(Span<const std::uint8_t>(bytes_.data(), bytes_.size()));
}

void OwnMemory::load(ByteReader& from) {
  tick_ = from.take<std::uint64_t>();
  from.take(Span<std::uint8_t>(bytes_.data(), bytes_.size()));
}

RunningSense::Opened::~Opened() {
  if (!whole || plan->table.close == nullptr) return;
  try {
    plan->table.close(plan->table.user, own);
  } catch (...) {  // the user's own affair
  }
}

void RunningSense::Dispose::operator()(mimo_env* env) const noexcept {
  await_nobody(env);
  dispose(env);
}

RunningSense::RunningSense(std::shared_ptr<const SensePlan> plan, const env::World& world, std::size_t agent,
                           const std::vector<double>& parameters)
    : plan_(std::move(plan)),
      world_(world),
      agent_(agent),
      prefix_(world.agents()[agent].name.empty() ? "" : world.agents()[agent].name + "/"),
      parameters_(parameters),
      name_hash_(hash_of(prefix_ + plan_->described.name)),
      checked_(is_checked()),
      before_(env::describe(world)),
      env_(wrap<mimo_env>(std::make_unique<EnvObject>(*this))),
      opened_{plan_} {
  keep_for_owner(env_.get());
  const observation::Observer& observer = world.observer();
  for (std::size_t i = 0; i < observer.layout().size(); ++i) {
    std::size_t sense = 0;
    while (!observer.sense(sense).has(observer.layout()[i])) ++sense;
    sense_of_.push_back(sense);
  }
  felt_in_.resize(observer.senses());
  open();
}

bool RunningSense::is_at_work() const { return at_work == this; }

void RunningSense::open() {
  Handed<mimo_sense_moment> now;
  tell(*now);
  Handed<mimo_sense_needs> needs;
  opening_ = true;
  run("open", [&] { return plan_->table.open(plan_->table.user, env_.get(), now.get(), needs.get()); });
  opening_ = false;
  opened_.own = needs->own;
  opened_.whole = true;
  require(needs.newer_at() == 0, "{} needs an interface newer than {}.{}", plan_->whose, MIMO_API_MAJOR,
          MIMO_API_MINOR);
  check_flag(needs->sensors, (plan_->whose + ": sensors").c_str());
  require(needs->memory_bytes <= kMostBytes, "{}: memory_bytes is {}, expected up to {}", plan_->whose,
          needs->memory_bytes, kMostBytes);
  require(!fields_.empty(), "{} declares no field in open", plan_->whose);
  sensors_ = needs->sensors != 0;
  auto memory = std::make_unique<OwnMemory>(*this, *plan_, needs->memory_bytes);
  memory_ = memory.get();
  keep(std::move(memory));
  if (checked_) memory_before_.resize(needs->memory_bytes);
  for (const observation::Field& field : fields_) values_.emplace_back(field.bytes());
  for (GuardedBytes& values : values_) places_.push_back(values.data());
}

void RunningSense::tell(mimo_sense_moment& moment) const {
  Hash seed;
  seed.add(world_.noise());
  seed.add(name_hash_);
  moment.world = world_.number();
  moment.agent = agent_;
  moment.prefix = prefix_.c_str();
  moment.timestep = world_.model().opt.timestep;
  moment.step_ticks = static_cast<std::size_t>(world_.frame_skip());
  moment.seed = seed.value();
  moment.parameters = parameters_.empty() ? nullptr : parameters_.data();
  moment.own = opened_.own;
  if (memory_ == nullptr) return;
  moment.tick = memory_->tick();
  moment.memory = memory_->bytes().size() == 0 ? nullptr : memory_->bytes().data();
}

template <typename Call>
void RunningSense::run(const char* function, Call&& call) {
  const AtWork here(*this);
  ++call_;
  call_out(plan_->whose, function, call);
}

// What fails is told when everything else has happened.
template <typename Call>
bool RunningSense::attempt(const char* function, Call&& call) {
  try {
    run(function, call);
    if (checked_) check_zones(function);
    return true;
  } catch (const Error& error) {
    if (!failure_) failure_ = error;
    return false;
  }
}

void RunningSense::reset() {
  failure_.reset();
  if (plan_->table.reset == nullptr) return;
  Handed<mimo_sense_moment> now;
  tell(*now);
  attempt("reset", [&] { return plan_->table.reset(plan_->table.user, env_.get(), now.get()); });
}

void RunningSense::advance() {
  if (plan_->table.advance == nullptr) return;
  Handed<mimo_sense_moment> now;
  tell(*now);
  attempt("advance", [&] { return plan_->table.advance(plan_->table.user, env_.get(), now.get()); });
}

void RunningSense::write(const mjModel&, const mjData&, std::uint8_t* block) {
  bool filled = false;
  for (GuardedBytes& values : values_) values.clear();
  if (plan_->table.write != nullptr && memory_->has_begun() && !failure_) {
    Handed<mimo_sense_moment> now;
    tell(*now);
    now->fields = places_.data();
    now->field_count = places_.size();
    std::copy_n(memory_->bytes().data(), memory_before_.size(), memory_before_.begin());
    filled = attempt("write", [&] {
      const mimo_status status = plan_->table.write(plan_->table.user, env_.get(), now.get());
      if (checked_ && status == MIMO_OK) check_values("write");
      return status;
    });
  }
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (!filled) values_[i].clear();
    std::copy_n(values_[i].data(), values_[i].size(), at<std::uint8_t>(block, i));
  }
}

void RunningSense::complain() {
  if (!failure_) return;
  const Error failure = std::move(*failure_);
  failure_.reset();
  throw failure;
}

void RunningSense::check_zones(const char* function) {
  if (const char* where = memory_->bytes().violated()) {
    fail(Status::kTask, "{}'s function {} wrote {} the {} bytes of its memory", plan_->whose, function, where,
         memory_->bytes().size());
  }
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const char* const where = values_[i].violated();
    if (where == nullptr) continue;
    fail(Status::kTask, "{}'s function {} wrote {} its field \"{}\" of {} bytes", plan_->whose, function, where,
         fields_[i].name, fields_[i].bytes());
  }
}

void RunningSense::check_values(const char* function) const {
  const GuardedBytes& memory = memory_->bytes();
  if (!std::equal(memory_before_.begin(), memory_before_.end(), memory.data())) {
    fail(Status::kTask, "{}'s function {} changed its memory, which only reset and advance may", plan_->whose,
         function);
  }
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const observation::Field& field = fields_[i];
    const double low = as_told(field, field.low), high = as_told(field, field.high);
    for (std::size_t k = 0; k < field.count(); ++k) {
      const double value = value_at(field, values_[i].data(), k);
      if (std::isfinite(value) && value >= low && value <= high) continue;
      const std::string bounds = std::isfinite(low) || std::isfinite(high) ? format(" from {} to {}", low, high) : "";
      fail(Status::kTask, "{}'s function {} gave {}[{}] as {}, expected a finite number{}", plan_->whose, function,
           field.name, k, value, bounds);
    }
  }
}

void RunningSense::add_field(const mimo_sense_field& field) {
  require(opening_, "env is in another function of {}, expected open", plan_->whose);
  const std::string argument = format("{}: field {}", plan_->whose, fields_.size());
  require(fields_.size() < kMostParts, "{}: there are {} fields, expected up to {}", plan_->whose, fields_.size() + 1,
          kMostParts);
  observation::Field ours = field_of(field, argument);
  std::size_t bytes = ours.bytes();
  for (const observation::Field& other : fields_) {
    require(other.name != ours.name, "{}: there are two fields \"{}\"", plan_->whose, ours.name);
    bytes += other.bytes();
  }
  require(bytes <= kMostBytes, "{}: its fields have {} bytes together, expected up to {}", plan_->whose, bytes,
          kMostBytes);
  fields_.push_back(std::move(ours));
}

observation::Field RunningSense::field_of(const mimo_sense_field& field, const std::string& argument) const {
  observation::Field ours;
  const std::string name = text(field.name);
  if (!name.empty()) check_path(name, argument);
  ours.name = plan_->described.name + (name.empty() ? "" : "/" + name);
  check_choice(field.dtype, MIMO_U8, MIMO_F64, (argument + ": dtype").c_str());
  ours.type = static_cast<observation::Type>(field.dtype);
  describe_field(field, kMostBytes, argument, ours);
  ours.exempt = plan_->table.host_fills != 0;
  if (field.labels != nullptr || field.label_count != 0) {
    check_given(field.label_count, ours.count(), (argument + ": label_count").c_str());
    for (const char* label : array(field.labels, field.label_count, (argument + ": labels").c_str())) {
      ours.labels.push_back(text(label));
    }
  }
  add_receptors(field, argument, ours);
  return ours;
}

void RunningSense::add_receptors(const mimo_sense_field& field, const std::string& argument,
                                 observation::Field& ours) const {
  require(std::isfinite(field.nerve_speed) && field.nerve_speed >= 0,
          "{}: nerve_speed is {}, expected a finite number of at least 0 m/s", argument, field.nerve_speed);
  if (field.skin == nullptr) {
    require(field.receptors == nullptr && field.receptor_count == 0 && field.nerve_speed == 0,
            "{}: receptors and nerve_speed go with skin, which is NULL", argument);
    return;
  }
  const auto before = before_.read();
  const std::string name = prefix_ + field.skin;
  const auto found = std::find_if(before->fields.begin(), before->fields.end(),
                                  [&](const observation::Field& other) { return other.name == name; });
  if (found == before->fields.end() || found->receptors.empty()) {
    std::vector<std::string> skins;
    for (const observation::Field& other : before->fields) {
      if (!other.receptors.empty() && begins_with(other.name, prefix_))
        skins.push_back(other.name.substr(prefix_.size()));
    }
    fail(Status::kNotFound, "{}: skin is \"{}\", expected a field of the agent's touch; it has: {}", argument,
         field.skin, some_of(std::move(skins)));
  }
  auto chosen = std::make_shared<std::vector<observation::Receptor>>(found->receptors.begin(), found->receptors.end());
  if (field.receptors != nullptr || field.receptor_count != 0) {
    const auto all = std::move(*chosen);
    chosen->clear();
    for (const std::int32_t id : array(field.receptors, field.receptor_count, (argument + ": receptors").c_str())) {
      require(id >= 0 && static_cast<std::size_t>(id) < all.size(), "{}: receptors[{}] is {}, expected 0 to {}",
              argument, chosen->size(), id, all.size() - 1);
      chosen->push_back(all[static_cast<std::size_t>(id)]);
    }
  }
  require(ours.shape[0] == chosen->size(), "{}: shape[0] is {}, expected {}: one for each receptor", argument,
          ours.shape[0], chosen->size());
  ours.receptors = Span<const observation::Receptor>(*chosen);
  ours.own_receptors = std::move(chosen);
  ours.nerve_speed = field.nerve_speed;
}

const void* RunningSense::feel(std::size_t field) {
  const observation::Layout& layout = world_.observer().layout();
  require(field < sense_of_.size(), "field is {}, expected one of the {} fields that {} comes after", field,
          sense_of_.size(), plan_->whose);
  if (!felt_) felt_.emplace(before_.read()->block_bytes);
  const std::size_t sense = sense_of_[field];
  if (felt_in_[sense] != call_) {
    world_.observer().write(sense, world_.model(), world_.data(), felt_->data(), nullptr);
    felt_in_[sense] = call_;
  }
  return felt_->data() + layout[field].offset;
}

mimo_sense_field empty_sense_field() {
  mimo_sense_field field{};
  field.struct_size = sizeof field;
  field.dtype = MIMO_F32;
  field.low = -std::numeric_limits<double>::infinity();
  field.high = std::numeric_limits<double>::infinity();
  return field;
}

}  // namespace mimo::capi
