// A sense that the user has written as C functions, at work for one agent of one world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/fail.h"
#include "capi/sense_plan.h"
#include "env/description.h"
#include "env/world.h"
#include "mimo/experimental.h"
#include "observation/sense.h"

namespace mimo::capi {

// Bytes at a multiple of 64, with a zone on both sides that shows whether somebody wrote past them.
class GuardedBytes {
 public:
  explicit GuardedBytes(std::size_t size);
  GuardedBytes(GuardedBytes&&) = default;

  std::uint8_t* data() { return start_; }
  const std::uint8_t* data() const { return start_; }
  std::size_t size() const { return size_; }
  void clear();
  // "before", "past", or null where the zones are as they were, which they are from then on.
  const char* violated();

 private:
  std::vector<std::uint8_t> room_;
  std::uint8_t* start_;
  std::size_t size_;
};

// What it remembers: the user's bytes, and how many physics steps they are old.
class OwnMemory : public observation::Process {
 public:
  class Owner {
   public:
    virtual void reset() = 0;
    virtual void advance() = 0;

   protected:
    ~Owner() = default;
  };

  OwnMemory(Owner& owner, const SensePlan& plan, std::size_t bytes);

  GuardedBytes& bytes() { return bytes_; }
  std::uint64_t tick() const { return tick_; }
  bool has_begun() const { return begun(); }

 private:
  void rest(const mjModel& model, const mjData& data) override;
  void go_on(const mjModel& model, const mjData& data) override;
  void save(ByteWriter& to) const override;
  void load(ByteReader& from) override;

  Owner& owner_;
  std::uint64_t tick_ = 0;
  GuardedBytes bytes_;
};

class RunningSense : public observation::Sense, public OwnMemory::Owner {
 public:
  RunningSense(std::shared_ptr<const SensePlan> plan, const env::World& world, std::size_t agent,
               const std::vector<double>& parameters);

  observation::Share share() const override { return observation::Share::kRequest; }
  void write(const mjModel& model, const mjData& data, std::uint8_t* block) override;
  void complain() override;
  bool follows_sensors() const override { return sensors_; }

  // For the world's handle that its functions get.
  const env::World& world() const { return world_; }
  const env::LiveDescription& before() const { return before_; }  // of the fields that it comes after
  bool is_at_work() const;                                        // on this thread

  // What its functions ask for.
  void add_field(const mimo_sense_field& field);
  const void* feel(std::size_t field);

 private:
  // Closes what was opened.
  struct Opened {
    std::shared_ptr<const SensePlan> plan;
    void* own = nullptr;
    bool whole = false;
    ~Opened();
  };
  struct Dispose {
    void operator()(mimo_env* env) const noexcept;
  };

  void open();
  void reset() override;
  void advance() override;
  void tell(mimo_sense_moment& moment) const;
  template <typename Call>
  void run(const char* function, Call&& call);
  template <typename Call>
  bool attempt(const char* function, Call&& call);
  void check_zones(const char* function);
  void check_values(const char* function) const;
  observation::Field field_of(const mimo_sense_field& field, const std::string& argument) const;
  void add_receptors(const mimo_sense_field& field, const std::string& argument, observation::Field& ours) const;

  std::shared_ptr<const SensePlan> plan_;
  const env::World& world_;
  const std::size_t agent_;
  const std::string prefix_;
  const std::vector<double> parameters_;
  const std::uint64_t name_hash_;
  const bool checked_;
  env::LiveDescription before_;
  std::unique_ptr<mimo_env, Dispose> env_;
  Opened opened_;
  bool opening_ = false, sensors_ = false;
  OwnMemory* memory_ = nullptr;              // a process of this sense
  std::vector<GuardedBytes> values_;         // of its fields
  std::vector<void*> places_;                // of these
  std::vector<std::uint8_t> memory_before_;  // to see whether write changes it
  std::optional<Error> failure_;             // the first one that has not been told
  // What it has felt in this call.
  std::uint64_t call_ = 0;
  std::vector<std::size_t> sense_of_;   // by field
  std::vector<std::uint64_t> felt_in_;  // the call, by sense
  std::optional<GuardedBytes> felt_;    // a block
};

mimo_sense_field empty_sense_field();

}  // namespace mimo::capi
