#include "osmesa/mujoco_binding.h"

#include <dlfcn.h>

#include <cstring>
#include <thread>

#include "base/fail.h"
#include "osmesa/import_slot.h"
#include "osmesa/loaded_library.h"

namespace mimo::osmesa {
namespace {

std::mutex one_at_a_time;
bool confirmed = false;

// Goes the same steps as MuJoCo's look-up.
bool finds_osmesa_by_itself(const Library& library) {
  void* process = dlopen(nullptr, RTLD_LAZY);
  if (dlsym(process, "eglGetProcAddress") != nullptr) return false;
  if (void* osmesa = dlsym(process, "OSMesaGetProcAddress")) {
    return osmesa == reinterpret_cast<void*>(library.GetProcAddress);
  }
  if (dlsym(process, "glXGetProcAddressARB") != nullptr) return false;
  const LoadedLibrary first({"libGLX.so", "libGL.so", "libEGL.so", "libOSMesa.so"});
  return first.find<decltype(library.GetProcAddress)>("OSMesaGetProcAddress") == library.GetProcAddress;
}

// Whose look-up is led, and to where. Other threads see no difference.
std::thread::id led_thread;
void* led_to = nullptr;

void* leading_dlsym(void* handle, const char* name) {
  if (std::this_thread::get_id() == led_thread) {
    if (std::strcmp(name, "eglGetProcAddress") == 0) return nullptr;
    if (std::strcmp(name, "OSMesaGetProcAddress") == 0) return led_to;
  }
  return dlsym(handle, name);
}

}  // namespace

// Lets libmujoco call leading_dlsym instead of dlsym.
class MujocoBinding::Detour {
 public:
  explicit Detour(const Library& library) : slot_(dlsym(RTLD_DEFAULT, "mjr_makeContext"), "dlsym") {
    led_thread = std::this_thread::get_id();
    led_to = reinterpret_cast<void*>(library.GetProcAddress);
    if (!slot_.empty()) original_ = slot_.exchange(reinterpret_cast<void*>(leading_dlsym));
    if (original_ != nullptr) return;
    fail(Status::kUnsupported,
         "the renderer osmesa cannot work in this process: another OpenGL (EGL or GLX) is loaded, and MuJoCo would "
         "take that");
  }
  ~Detour() { slot_.exchange(original_); }
  Detour(const Detour&) = delete;
  Detour& operator=(const Detour&) = delete;

 private:
  ImportSlot slot_;
  void* original_ = nullptr;
};

MujocoBinding::MujocoBinding(const Library& library) : lock_(one_at_a_time) {
  if (!confirmed && !finds_osmesa_by_itself(library)) detour_ = std::make_unique<Detour>(library);
}

MujocoBinding::~MujocoBinding() = default;

void MujocoBinding::confirm() { confirmed = true; }

}  // namespace mimo::osmesa
