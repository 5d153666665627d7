#include "senses/fusimotor_drives.h"

#include <algorithm>

#include "base/fail.h"

namespace mimo::senses {

using receptors::FusimotorDrive;

FusimotorDrives::FusimotorDrives(const std::vector<int>& motors) : drives_(2 * motors.size()) {
  for (std::size_t i = 0; i < motors.size(); ++i) at_[motors[i]] = i;
}

void FusimotorDrives::get(int motor, double* numbers) const {
  for (std::size_t i = at_.at(motor); i < drives_.size(); i += at_.size()) {
    *numbers++ = drives_[i].dynamic_rate;
    *numbers++ = drives_[i].static_rate;
  }
}

void FusimotorDrives::set(int motor, const double* numbers) {
  for (std::size_t i = at_.at(motor); i < drives_.size(); i += at_.size()) {
    drives_[i] = {numbers[0], numbers[1]};
    numbers += 2;
  }
}

void FusimotorDrives::reset() { std::fill(drives_.begin(), drives_.end(), FusimotorDrive{}); }

void FusimotorDrives::save(ByteWriter& to) const {
  for (const FusimotorDrive& drive : drives_) {
    to.put(drive.dynamic_rate);
    to.put(drive.static_rate);
  }
}

void FusimotorDrives::load(ByteReader& from) {
  for (FusimotorDrive& drive : drives_) {
    for (double* rate : {&drive.dynamic_rate, &drive.static_rate}) {
      *rate = from.take_finite("a fusimotor drive");
      require(*rate >= 0 && *rate <= receptors::kMostFusimotorDrive,
              "the state holds {} for a fusimotor drive, expected 0 to {}", *rate, receptors::kMostFusimotorDrive);
    }
  }
}

}  // namespace mimo::senses
