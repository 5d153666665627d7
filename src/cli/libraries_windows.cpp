#include <windows.h>

#include <cstring>
#include <filesystem>

#include "libraries.h"

namespace cli {

void* open_library(const char* name) { return LoadLibraryA(name); }

void* find_symbol(void* library, const char* name) {
  const FARPROC found = GetProcAddress(static_cast<HMODULE>(library), name);
  void* address = nullptr;
  std::memcpy(&address, &found, sizeof address);
  return address;
}

std::string library_of(const void* inside) {
  HMODULE library = nullptr;
  const DWORD flags = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
  if (!GetModuleHandleExW(flags, static_cast<const wchar_t*>(inside), &library)) return "";
  std::wstring path(32768, L'\0');
  path.resize(GetModuleFileNameW(library, path.data(), static_cast<DWORD>(path.size())));
  return std::filesystem::path(path).u8string();
}

}  // namespace cli
