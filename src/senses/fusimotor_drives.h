// What a host tells the fusimotor neurons of an agent's muscles.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "receptors/muscles.h"

namespace mimo::senses {

class FusimotorDrives {
 public:
  // Of the two muscles of each of these motors.
  explicit FusimotorDrives(const std::vector<int>& motors);

  // Of one motor: dynamic and static rate of the muscle that pulls to the negative side, then of the other. Hz.
  static constexpr int kNumbers = 4;
  bool has(int motor) const { return at_.count(motor) != 0; }
  void get(int motor, double* numbers) const;
  void set(int motor, const double* numbers);
  // All as usual.
  void reset();

  // First those that pull to the negative side.
  const std::vector<receptors::FusimotorDrive>& all() const { return drives_; }

  void save(ByteWriter& to) const;
  void load(ByteReader& from);

 private:
  std::map<int, std::size_t> at_;  // place of a motor's negative muscle
  std::vector<receptors::FusimotorDrive> drives_;
};

}  // namespace mimo::senses
