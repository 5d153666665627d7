#include "opengl/osmesa.h"

#include <dlfcn.h>

#include <array>

#include "opengl/loaded_library.h"
#include "opengl/renderer.h"

namespace mimo::opengl {
namespace {

class OsmesaHandle final : public Handle {
 public:
  explicit OsmesaHandle(const Osmesa& library) : library_(library) {
    context_ = library_.CreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
    if (context_ == nullptr) fail(Status::kRender, "OSMesa cannot create a context");
  }
  ~OsmesaHandle() override { library_.DestroyContext(context_); }
  OsmesaHandle(const OsmesaHandle&) = delete;
  OsmesaHandle& operator=(const OsmesaHandle&) = delete;

  void make_current() override {
    if (library_.MakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) return;
    fail(Status::kRender, "OSMesa cannot make its context current");
  }
  void release() noexcept override { library_.MakeCurrent(nullptr, nullptr, 0, 0, 0); }

 private:
  const Osmesa library_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> pixel_{};
};

class OsmesaPlatform final : public Platform {
 public:
  explicit OsmesaPlatform(const Osmesa& library) : library_(library) {}
  const char* name() const override { return "OSMesa"; }
  void* finder() const override { return reinterpret_cast<void*>(library_.GetProcAddress); }
  const char* finder_name() const override { return "OSMesaGetProcAddress"; }
  void* find(const char* function) const override { return reinterpret_cast<void*>(library_.GetProcAddress(function)); }
  std::unique_ptr<Handle> make_handle() const override { return std::make_unique<OsmesaHandle>(library_); }

 private:
  const Osmesa library_;
};

}  // namespace

Osmesa load_osmesa(const std::vector<std::string>& names) {
  std::string why;
  void* handle = load_first(names, why);
  if (handle == nullptr) {
    fail(Status::kUnsupported,
         "the renderer osmesa needs the library OSMesa (Debian package libosmesa6), which cannot be loaded: {}", why);
  }
  const auto look_up = [handle](auto& function, const char* name) {
    assign(function, dlsym(handle, name), "OSMesa", name);
  };
  Osmesa library;
  look_up(library.CreateContextExt, "OSMesaCreateContextExt");
  look_up(library.DestroyContext, "OSMesaDestroyContext");
  look_up(library.MakeCurrent, "OSMesaMakeCurrent");
  look_up(library.GetCurrentContext, "OSMesaGetCurrentContext");
  look_up(library.GetIntegerv, "OSMesaGetIntegerv");
  look_up(library.GetColorBuffer, "OSMesaGetColorBuffer");
  look_up(library.GetProcAddress, "OSMesaGetProcAddress");
  keep_exit_handlers_from_children(reinterpret_cast<const void*>(library.CreateContextExt));
  return library;
}

PlatformPtr osmesa(const std::vector<std::string>& libraries) {
  return std::make_shared<OsmesaPlatform>(load_osmesa(libraries));
}

PlatformPtr osmesa() { return osmesa(kOsmesaNames); }

}  // namespace mimo::opengl
