#include <io.h>
#include <windows.h>

#include <cstring>
#include <filesystem>

#include "base/format.h"
#include "recording/system.h"

namespace mimo::recording {

// What a library of a given place needs lies beside it.
void* open_library(const char* name) {
  const std::filesystem::path path = std::filesystem::u8path(name);
  return LoadLibraryExW(path.c_str(), nullptr, path.is_absolute() ? LOAD_WITH_ALTERED_SEARCH_PATH : 0);
}

void* symbol_of(void* library, const char* name) {
  const FARPROC found = GetProcAddress(static_cast<HMODULE>(library), name);
  void* address = nullptr;
  std::memcpy(&address, &found, sizeof address);
  return address;
}

std::string why_not_opened() { return format("error {} of the system", GetLastError()); }

std::string path_of_this_library() {
  HMODULE library = nullptr;
  const DWORD flags = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
  const void* const inside = reinterpret_cast<const void*>(&path_of_this_library);
  if (!GetModuleHandleExW(flags, static_cast<const wchar_t*>(inside), &library)) return "";
  std::wstring path(32768, L'\0');
  path.resize(GetModuleFileNameW(library, path.data(), static_cast<DWORD>(path.size())));
  return std::filesystem::path(path).u8string();
}

// HDF5 may be of another C library there, whose files are not ours.
void write_to_nowhere(int) {}

}  // namespace mimo::recording
