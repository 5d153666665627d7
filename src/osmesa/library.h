// libOSMesa: Mesa's software OpenGL without a window. It is loaded at run time and never linked, so that libmimo
// also loads where it is absent.
#pragma once

#include <GL/osmesa.h>

#include <string>
#include <vector>

#include "base/fail.h"

namespace mimo::osmesa {

// Named like what they stand for, without the prefix OSMesa.
struct Library {
  decltype(&OSMesaCreateContextExt) CreateContextExt = nullptr;
  decltype(&OSMesaDestroyContext) DestroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) MakeCurrent = nullptr;
  decltype(&OSMesaGetCurrentContext) GetCurrentContext = nullptr;
  decltype(&OSMesaGetIntegerv) GetIntegerv = nullptr;
  decltype(&OSMesaGetColorBuffer) GetColorBuffer = nullptr;
  decltype(&OSMesaGetProcAddress) GetProcAddress = nullptr;
};

// Debian 12 has .8; .6 is the name in older releases, the last one that of the development package.
inline const std::vector<std::string> kLibraryNames = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};

// Loads the first of these libraries that is there; it stays loaded until the process ends, because Mesa's threads and
// MuJoCo's function pointers live on in it. Throws Status::kUnsupported.
Library load_library(const std::vector<std::string>& names = kLibraryNames);

// Makes a function of what was found under a name. Throws Status::kUnsupported where that is nothing.
template <typename Function, typename Address>
void assign(Function& function, Address found, const char* name) {
  if (found == nullptr) fail(Status::kUnsupported, "the installed OSMesa has no function {}", name);
  function = reinterpret_cast<Function>(found);
}

}  // namespace mimo::osmesa
