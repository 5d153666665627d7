#include <system_error>

#include "programs/this_program.h"
#if defined(__APPLE__)
#include <mach-o/dyld.h>

#include <cstdint>
#include <string>
#endif

namespace cli {
namespace {

std::filesystem::path file_of_this_program() {
#if defined(__APPLE__)
  std::uint32_t size = 0;
  _NSGetExecutablePath(nullptr, &size);  // says how long it is
  std::string path(size, '\0');
  return _NSGetExecutablePath(path.data(), &size) == 0 ? path.c_str() : "";
#else
  return "/proc/self/exe";
#endif
}

}  // namespace

std::filesystem::path folder_of_this_program() {
  std::error_code unknown;
  return std::filesystem::canonical(file_of_this_program(), unknown).parent_path();
}

}  // namespace cli
