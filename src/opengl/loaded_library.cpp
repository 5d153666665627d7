#include "opengl/loaded_library.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>

namespace mimo::opengl {

namespace {

struct Search {
  std::initializer_list<const char*> prefixes;
  std::array<char, 4096> path{};
};

const char* file_name(const char* path) {
  const char* slash = std::strrchr(path, '/');
  return slash == nullptr ? path : slash + 1;
}

int visit(dl_phdr_info* info, std::size_t, void* argument) {
  Search& search = *static_cast<Search*>(argument);
  for (const char* prefix : search.prefixes) {
    if (std::strncmp(file_name(info->dlpi_name), prefix, std::strlen(prefix)) != 0) continue;
    std::snprintf(search.path.data(), search.path.size(), "%s", info->dlpi_name);
    return 1;  // ends the iteration
  }
  return 0;
}

}  // namespace

std::array<char, 4096> first_loaded(std::initializer_list<const char*> prefixes) {
  Search search;
  search.prefixes = prefixes;
  dl_iterate_phdr(visit, &search);
  return search.path;
}

void* load_first(const std::vector<std::string>& names, std::string& why) {
  for (const std::string& name : names) {
    // RTLD_LOCAL: with its 1300 gl* functions in the global scope, OSMesa would take the place of the OpenGL that
    // libraries loaded later by the host mean.
    if (void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return handle;
    if (why.empty()) why = dlerror();
  }
  return nullptr;
}

LoadedLibrary::LoadedLibrary(std::initializer_list<const char*> prefixes) {
  // Asking dlopen alone (RTLD_NOLOAD) would search the file system in every picture of a process without it.
  const std::array<char, 4096> path = first_loaded(prefixes);
  if (path[0] != '\0') handle_ = dlopen(path.data(), RTLD_LAZY | RTLD_NOLOAD);
}

LoadedLibrary::~LoadedLibrary() {
  if (handle_ != nullptr) dlclose(handle_);
}

void* LoadedLibrary::address(const char* name) const { return handle_ == nullptr ? nullptr : dlsym(handle_, name); }

struct ImportSlot::Search {
  const void* inside;
  const char* function;
  void** place = nullptr;
  bool read_only = false;
};

#if defined(__GLIBC__) && defined(__LP64__)
namespace {

// What the dynamic linker works with: symbols, their names, and the two tables of places to fill in.
struct Tables {
  const ElfW(Sym) * symbols = nullptr;
  const char* names = nullptr;
  const ElfW(Rela) * relocations[2] = {};
  std::size_t bytes[2] = {};
};

Tables read_tables(const ElfW(Dyn) * entry) {
  Tables tables;
  for (; entry->d_tag != DT_NULL; ++entry) {
    const ElfW(Addr) address = entry->d_un.d_ptr;  // glibc has made it absolute
    switch (entry->d_tag) {
      case DT_SYMTAB: tables.symbols = reinterpret_cast<const ElfW(Sym)*>(address); break;
      case DT_STRTAB: tables.names = reinterpret_cast<const char*>(address); break;
      case DT_JMPREL: tables.relocations[0] = reinterpret_cast<const ElfW(Rela)*>(address); break;
      case DT_PLTRELSZ: tables.bytes[0] = entry->d_un.d_val; break;
      case DT_RELA: tables.relocations[1] = reinterpret_cast<const ElfW(Rela)*>(address); break;
      case DT_RELASZ: tables.bytes[1] = entry->d_un.d_val; break;
      default: break;
    }
  }
  return tables;
}

void** find_place(const Tables& tables, ElfW(Addr) base, const char* function) {
  if (tables.symbols == nullptr || tables.names == nullptr) return nullptr;
  for (int table = 0; table < 2; ++table) {
    const std::size_t count = tables.bytes[table] / sizeof(ElfW(Rela));
    for (std::size_t i = 0; i < count; ++i) {
      const ElfW(Rela)& relocation = tables.relocations[table][i];
      const ElfW(Sym)& symbol = tables.symbols[ELF64_R_SYM(relocation.r_info)];
      if (std::strcmp(tables.names + symbol.st_name, function) != 0) continue;
      return reinterpret_cast<void**>(base + relocation.r_offset);
    }
  }
  return nullptr;
}

bool within(const dl_phdr_info& library, const ElfW(Phdr) & segment, const void* address) {
  return reinterpret_cast<ElfW(Addr)>(address) - (library.dlpi_addr + segment.p_vaddr) < segment.p_memsz;
}

int search_library(dl_phdr_info* library, std::size_t, void* argument) {
  ImportSlot::Search& search = *static_cast<ImportSlot::Search*>(argument);
  const ElfW(Phdr)* dynamic = nullptr;
  const ElfW(Phdr)* read_only = nullptr;
  bool here = false;
  for (const ElfW(Phdr)* segment = library->dlpi_phdr; segment != library->dlpi_phdr + library->dlpi_phnum; ++segment) {
    if (segment->p_type == PT_LOAD && within(*library, *segment, search.inside)) here = true;
    if (segment->p_type == PT_GNU_RELRO) read_only = segment;
    if (segment->p_type == PT_DYNAMIC) dynamic = segment;
  }
  if (!here) return 0;
  if (dynamic != nullptr) {
    const Tables tables = read_tables(reinterpret_cast<const ElfW(Dyn)*>(library->dlpi_addr + dynamic->p_vaddr));
    search.place = find_place(tables, library->dlpi_addr, search.function);
    search.read_only = read_only != nullptr && within(*library, *read_only, search.place);
  }
  return 1;  // ends the iteration
}

void search_libraries(ImportSlot::Search& search) { dl_iterate_phdr(search_library, &search); }

}  // namespace
#else
namespace {
void search_libraries(ImportSlot::Search&) {}
}  // namespace
#endif

ImportSlot::ImportSlot(const void* inside, const char* function) {
  Search search{inside, function};
  if (inside != nullptr) search_libraries(search);
  place_ = search.place;
  read_only_ = search.read_only;
}

void* ImportSlot::exchange(void* function) {
  const auto page_size = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  void* page = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(place_) & ~(page_size - 1));
  if (read_only_ && mprotect(page, page_size, PROT_READ | PROT_WRITE) != 0) return nullptr;
  void* before = __atomic_exchange_n(place_, function, __ATOMIC_ACQ_REL);
  if (read_only_) mprotect(page, page_size, PROT_READ);
  return before;
}

}  // namespace mimo::opengl

// What atexit() is made of.
extern "C" int __cxa_atexit(void (*function)(void*), void* argument, void* library);  // NOLINT: the C library's name

namespace mimo::opengl {

namespace {

struct Handler {
  void (*function)(void*);
  void* argument;
  pid_t process;
};

// Runs once.
void run_at_home(void* argument) {
  const std::unique_ptr<const Handler> handler(static_cast<const Handler*>(argument));
  if (handler->process == getpid()) handler->function(handler->argument);
}

// From now on the process may call run_at_home at its end: unloading libmimo must leave it where it is.
void stay_loaded() {
  Dl_info self;
  if (dladdr(reinterpret_cast<void*>(run_at_home), &self) != 0) {
    dlopen(self.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
  }
}

int register_at_home(void (*function)(void*), void* argument, void* library) {
  auto* handler = new (std::nothrow) Handler{function, argument, getpid()};
  if (handler == nullptr) return -1;
  stay_loaded();
  return __cxa_atexit(run_at_home, handler, library);
}

}  // namespace

void keep_exit_handlers_from_children(const void* inside) {
  static std::once_flag once;
  std::call_once(once, [inside] {
    ImportSlot slot(inside, "__cxa_atexit");
    if (!slot.empty()) slot.exchange(reinterpret_cast<void*>(register_at_home));
  });
}

}  // namespace mimo::opengl
