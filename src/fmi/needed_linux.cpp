#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <cstring>

#include "fmi/needed.h"
#include "programs/program.h"

namespace cli {
namespace {

// What every Linux on which a simulator runs has.
constexpr const char* kOfSystem[] = {"ld-linux",   "libc.so",     "libm.so",      "libdl.so", "librt.so",
                                     "libpthread", "libgcc_s.so", "libstdc++.so", "libz.so",  "linux-vdso"};

struct Loaded {
  std::string path, name;  // as other libraries ask for it
  std::vector<std::string> needs;
  bool has_mimo = false;
};

bool is_of_system(const std::string& name) {
  return std::any_of(std::begin(kOfSystem), std::end(kOfSystem),
                     [&](const char* start) { return name.compare(0, std::strlen(start), start) == 0; });
}

const ElfW(Dyn) * dynamic_of(const dl_phdr_info& info) {
  for (int i = 0; i < info.dlpi_phnum; ++i) {
    if (info.dlpi_phdr[i].p_type == PT_DYNAMIC) {
      return reinterpret_cast<const ElfW(Dyn)*>(info.dlpi_addr + info.dlpi_phdr[i].p_vaddr);
    }
  }
  return nullptr;
}

bool has(const dl_phdr_info& info, const void* function) {
  const auto address = reinterpret_cast<ElfW(Addr)>(function);
  for (int i = 0; i < info.dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = info.dlpi_phdr[i];
    const ElfW(Addr) first = info.dlpi_addr + part.p_vaddr;
    if (part.p_type == PT_LOAD && address >= first && address < first + part.p_memsz) return true;
  }
  return false;
}

int note(dl_phdr_info* info, std::size_t, void* list) {
  Loaded it;
  it.path = info->dlpi_name;
  it.name = it.path.substr(it.path.find_last_of('/') + 1);
  it.has_mimo = has(*info, dlsym(RTLD_DEFAULT, "mimo_abi_version"));
  const char* strings = nullptr;
  const ElfW(Dyn)* const dynamic = dynamic_of(*info);
  for (const ElfW(Dyn)* entry = dynamic; entry != nullptr && entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_STRTAB) strings = reinterpret_cast<const char*>(entry->d_un.d_ptr);
  }
  for (const ElfW(Dyn)* entry = dynamic; strings != nullptr && entry->d_tag != DT_NULL && !it.path.empty(); ++entry) {
    if (is_of_system(it.name)) break;  // the table of the kernel's own is somewhere else
    if (entry->d_tag == DT_NEEDED) it.needs.emplace_back(strings + entry->d_un.d_val);
    if (entry->d_tag == DT_SONAME) it.name = strings + entry->d_un.d_val;
  }
  static_cast<std::vector<Loaded>*>(list)->push_back(std::move(it));
  return 0;
}

}  // namespace

std::vector<NeededLibrary> needed_libraries() {
  std::vector<Loaded> loaded;
  dl_iterate_phdr(note, &loaded);
  std::vector<const Loaded*> found;
  for (const Loaded& it : loaded) {
    if (it.has_mimo) found.push_back(&it);
  }
  if (found.empty() || found[0]->path.empty()) throw Failure("the library libmimo.so is not found in this process");
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const std::string& name : std::vector<std::string>(found[i]->needs)) {
      const auto it =
          std::find_if(loaded.begin(), loaded.end(), [&](const Loaded& other) { return other.name == name; });
      if (it == loaded.end() || is_of_system(name)) continue;
      if (std::find(found.begin(), found.end(), &*it) == found.end()) found.push_back(&*it);
    }
  }
  std::vector<NeededLibrary> all;
  for (const Loaded* it : found) all.push_back({it->name, it->path});
  return all;
}

}  // namespace cli
