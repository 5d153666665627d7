#include <windows.h>

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "fmi/needed.h"
#include "programs/program.h"

namespace cli {
namespace {

std::string path_of(HMODULE module) {
  wchar_t wide[32768];
  const DWORD length = GetModuleFileNameW(module, wide, 32768);
  std::string path(3 * std::size_t(length), '\0');
  const int bytes = WideCharToMultiByte(CP_UTF8, 0, wide, static_cast<int>(length), path.data(),
                                        static_cast<int>(path.size()), nullptr, nullptr);
  path.resize(static_cast<std::size_t>(std::max(bytes, 0)));
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

std::string small(std::string letters) {
  std::transform(letters.begin(), letters.end(), letters.begin(), [](unsigned char c) { return std::tolower(c); });
  return letters;
}

// Windows' own, which lie in its folder.
bool is_of_system(const std::string& path) {
  wchar_t folder[MAX_PATH];
  const UINT length = GetWindowsDirectoryW(folder, MAX_PATH);
  std::string start;
  for (UINT i = 0; i < length; ++i) start += folder[i] == L'\\' ? '/' : static_cast<char>(folder[i]);
  return small(path).compare(0, start.size(), small(start)) == 0;
}

// Names of the libraries that a loaded one asks for, out of its table of imports.
std::vector<std::string> needs_of(HMODULE module) {
  const auto* const first = reinterpret_cast<const std::uint8_t*>(module);
  const auto* const dos = reinterpret_cast<const IMAGE_DOS_HEADER*>(first);
  const auto* const header = reinterpret_cast<const IMAGE_NT_HEADERS*>(first + dos->e_lfanew);
  const DWORD at = header->OptionalHeader.DataDirectory[IMAGE_DIRECTORY_ENTRY_IMPORT].VirtualAddress;
  std::vector<std::string> names;
  if (at == 0) return names;
  for (const auto* it = reinterpret_cast<const IMAGE_IMPORT_DESCRIPTOR*>(first + at); it->Name != 0; ++it) {
    names.emplace_back(reinterpret_cast<const char*>(first + it->Name));
  }
  return names;
}

}  // namespace

std::vector<NeededLibrary> needed_libraries() {
  std::vector<NeededLibrary> all;
  std::vector<HMODULE> found = {GetModuleHandleA("mimo.dll")};
  if (found[0] == nullptr) throw Failure("the library mimo.dll is not found in this process");
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string path = path_of(found[i]);
    all.push_back({path.substr(path.find_last_of('/') + 1), path});
    for (const std::string& name : needs_of(found[i])) {
      const HMODULE module = GetModuleHandleA(name.c_str());
      if (module == nullptr || is_of_system(path_of(module))) continue;
      if (std::find(found.begin(), found.end(), module) == found.end()) found.push_back(module);
    }
  }
  return all;
}

}  // namespace cli
