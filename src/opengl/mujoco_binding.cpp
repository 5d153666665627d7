#include "opengl/mujoco_binding.h"

#include <dlfcn.h>

#include <cstring>
#include <string_view>
#include <thread>

#include "base/fail.h"
#include "opengl/import_slot.h"
#include "opengl/loaded_library.h"

namespace mimo::opengl {
namespace {

std::mutex one_at_a_time;
const char* confirmed = nullptr;  // what MuJoCo draws with, by its name, as soon as it has

// Goes the same steps as MuJoCo's look-up.
bool finds_by_itself(const Platform& platform) {
  void* process = dlopen(nullptr, RTLD_LAZY);
  for (const char* finder : {"eglGetProcAddress", "OSMesaGetProcAddress", "glXGetProcAddressARB"}) {
    if (void* found = dlsym(process, finder)) return found == platform.finder();
  }
  const LoadedLibrary first({"libGLX.so", "libGL.so", "libEGL.so", "libOSMesa.so"});
  return first.find<void*>(platform.finder_name()) == platform.finder();
}

// Whose look-up is led, and to where. Other threads see no difference.
std::thread::id led_thread;
const Platform* led_to = nullptr;

void* leading_dlsym(void* handle, const char* name) {
  if (std::this_thread::get_id() == led_thread) {
    if (std::strcmp(name, led_to->finder_name()) == 0) return led_to->finder();
    if (std::strcmp(name, "eglGetProcAddress") == 0) return nullptr;  // which MuJoCo asks for before OSMesa's
  }
  return dlsym(handle, name);
}

}  // namespace

// Lets libmujoco call leading_dlsym instead of dlsym.
class MujocoBinding::Detour {
 public:
  explicit Detour(const Platform& platform) : slot_(dlsym(RTLD_DEFAULT, "mjr_makeContext"), "dlsym") {
    led_thread = std::this_thread::get_id();
    led_to = &platform;
    if (!slot_.empty()) original_ = slot_.exchange(reinterpret_cast<void*>(leading_dlsym));
    if (original_ != nullptr) return;
    fail(Status::kUnsupported,
         "{} cannot be drawn with in this process: another OpenGL is loaded, and MuJoCo would take that",
         platform.name());
  }
  ~Detour() { slot_.exchange(original_); }
  Detour(const Detour&) = delete;
  Detour& operator=(const Detour&) = delete;

 private:
  ImportSlot slot_;
  void* original_ = nullptr;
};

MujocoBinding::MujocoBinding(const Platform& platform) : platform_(platform), lock_(one_at_a_time) {
  if (confirmed != nullptr && confirmed != std::string_view(platform.name())) {
    fail(Status::kUnsupported,
         "this process draws with {}, and MuJoCo keeps to its first OpenGL; draw with {} in a process of its own",
         confirmed, platform.name());
  }
  if (confirmed == nullptr && !finds_by_itself(platform)) detour_ = std::make_unique<Detour>(platform);
}

MujocoBinding::~MujocoBinding() = default;

void MujocoBinding::confirm() { confirmed = platform_.name(); }

}  // namespace mimo::opengl
