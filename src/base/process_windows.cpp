#include <locale.h>
#include <windows.h>

#include <array>
#include <cstring>
#include <string>

#include "base/process.h"

namespace mimo {
namespace {

bool unloading = false;

// One of the C libraries of a process, with the locale that this thread had in it. Ours and MuJoCo's may be two, each
// with locales of its own.
class Runtime {
 public:
  explicit Runtime(const wchar_t* name) {
    const HMODULE library = GetModuleHandleW(name);
    if (library == nullptr) return;
    find(library, of_thread_, "_configthreadlocale");
    find(library, set_, "setlocale");
    if (of_thread_ == nullptr || set_ == nullptr) return;
    mode_ = of_thread_(_ENABLE_PER_THREAD_LOCALE);
    before_ = set_(LC_ALL, nullptr);
    set_(LC_ALL, "C");
  }
  ~Runtime() {
    if (before_.empty()) return;
    set_(LC_ALL, before_.c_str());
    of_thread_(mode_);
  }
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;

 private:
  template <typename Function>
  static void find(HMODULE library, Function& function, const char* name) {
    const FARPROC found = GetProcAddress(library, name);
    std::memcpy(&function, &found, sizeof function);
  }

  int (*of_thread_)(int) = nullptr;
  char* (*set_)(int, const char*) = nullptr;
  int mode_ = 0;
  std::string before_;
};

}  // namespace

// Windows has no fork().
int watch_forks(void (*)(), void (*)(), void (*)()) { return 0; }

// Windows sends no signals to threads.
struct SignalsBlocked::Mask {};

SignalsBlocked::SignalsBlocked() = default;
SignalsBlocked::~SignalsBlocked() = default;

bool is_unloading() { return unloading; }

void watch_the_end() {}

struct PlainNumbers::Locale {
  Runtime ours{L"msvcrt.dll"}, mujocos{L"ucrtbase.dll"};
};

PlainNumbers::PlainNumbers() : before_(std::make_unique<Locale>()) {}
PlainNumbers::~PlainNumbers() = default;

}  // namespace mimo

// Runs before static objects are destroyed. Windows passes a pointer where the process ends.
extern "C" BOOL WINAPI DllMain(HINSTANCE, DWORD reason, LPVOID process_ends) {
  mimo::unloading = mimo::unloading || (reason == DLL_PROCESS_DETACH && process_ends == nullptr);
  return TRUE;
}
