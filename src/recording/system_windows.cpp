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

void close_library(void* library) { FreeLibrary(static_cast<HMODULE>(library)); }

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

bool has_elevated_rights() { return false; }

bool environment_has(const std::string&) { return false; }

// HDF5 may be of another C library there, whose files are separate: no other program can remove a file that it has
// open.
void write_to_nowhere(int) {}

Claim::Claim(const std::string& path) {
  const std::filesystem::path file = std::filesystem::u8path(path);
  const HANDLE handle = CreateFileW(file.c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING, 0, nullptr);
  granted_ = handle != INVALID_HANDLE_VALUE;
  file_ = reinterpret_cast<std::intptr_t>(handle);
}

Claim::~Claim() {
  if (granted_) CloseHandle(reinterpret_cast<HANDLE>(file_));
}

void claim_for_writing(int) {}

void end_claim(int) {}

bool stands(int, const std::string&, std::uint64_t) { return true; }

std::uint64_t size_of(int) { return 0; }

const bool kNamesOpenFiles = false;

std::string name_file(const std::string&, const std::string&, bool) { return ""; }

}  // namespace mimo::recording
