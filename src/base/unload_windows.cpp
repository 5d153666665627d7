#include <windows.h>

#include "base/unload.h"

namespace {

bool unloading = false;

}  // namespace

// Runs before static objects are destroyed. Windows passes a pointer where the process ends.
extern "C" BOOL WINAPI DllMain(HINSTANCE, DWORD reason, LPVOID process_ends) {
  unloading = unloading || (reason == DLL_PROCESS_DETACH && process_ends == nullptr);
  return TRUE;
}

namespace mimo {

bool is_unloading() { return unloading; }

void watch_the_end() {}

}  // namespace mimo
