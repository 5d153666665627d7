// libOSMesa: Mesa's software OpenGL without a window. It is loaded at run time and never linked, so that libmimo
// also loads where it is absent.
#pragma once

#include <GL/osmesa.h>

#include <string>
#include <vector>

#include "opengl/context.h"

namespace mimo::opengl {

// Named like what they stand for, without the prefix OSMesa.
struct Osmesa {
  decltype(&OSMesaCreateContextExt) CreateContextExt = nullptr;
  decltype(&OSMesaDestroyContext) DestroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) MakeCurrent = nullptr;
  decltype(&OSMesaGetCurrentContext) GetCurrentContext = nullptr;
  decltype(&OSMesaGetIntegerv) GetIntegerv = nullptr;
  decltype(&OSMesaGetColorBuffer) GetColorBuffer = nullptr;
  decltype(&OSMesaGetProcAddress) GetProcAddress = nullptr;
};

// Debian 12 has .8; .6 is the name in older releases, the last one that of the development package.
inline const std::vector<std::string> kOsmesaNames = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};

// Loads the first of these libraries that is there; it stays loaded until the process ends, because Mesa's threads and
// MuJoCo's function pointers live on in it. Throws Status::kUnsupported.
Osmesa load_osmesa(const std::vector<std::string>& names = kOsmesaNames);

}  // namespace mimo::opengl
