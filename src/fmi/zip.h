// ZIP archives, as units of FMI are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cli {

class Zip {
 public:
  // A file that is in it from then on, by its path with slashes.
  void add(const std::string& path, std::string_view bytes);
  std::string finish();  // the whole archive

 private:
  std::string files_, directory_;
  std::uint16_t count_ = 0;
};

}  // namespace cli
