#include <windows.h>

#include <string>
#include <system_error>

#include "programs/this_program.h"

namespace cli {

std::filesystem::path folder_of_this_program() {
  std::wstring path(32768, L'\0');
  path.resize(GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
  std::error_code unknown;
  return std::filesystem::canonical(path, unknown).parent_path();
}

}  // namespace cli
