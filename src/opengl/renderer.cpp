#include "opengl/renderer.h"

#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>
#include <string_view>
#include <thread>

#include "base/fail.h"
#include "engine/guard.h"
#include "opengl/context.h"
#include "opengl/loaded_library.h"
#include "render/pixels.h"
#include "render/visual_scene.h"

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

using Current = Context::Current;

// One function of MuJoCo under the guard.
template <typename Call>
void run(const char* what, const LogSink& log, Call&& call) {
  const engine::Complaint complaint = engine::guarded(call);
  if (complaint.failed) fail(Status::kRender, "{}: {}", what, complaint.error.data());
  if (complaint.warnings > 0) log(LogLevel::kWarning, complaint.warning.data());
}

// What belongs to one model in one OpenGL context: textures, meshes, shadow map, and the buffer that is drawn into.
// All calls want the context current.
class Canvas {
 public:
  // `samples` a pixel; 0: what the model says. OpenGL may give fewer.
  Canvas(const mjModel& model, int samples, const Context& context, const LogSink& log);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // Makes the buffer at least this large. Textures stay where they are.
  void make_room(int width, int height);
  // Draws the scene and reads what is asked for, as OpenGL gives it.
  void draw(mjvScene* scene, int width, int height, unsigned char* rgb, float* depth);

 private:
  void store(GLuint buffer, GLenum format, int samples);

  const char* platform_;
  const Context::Functions& gl_;
  const LogSink& log_;
  mjrContext buffers_;
};

Canvas::Canvas(const mjModel& model, int samples, const Context& context, const LogSink& log)
    : platform_(context.platform().name()), gl_(context.gl()), log_(log) {
  mjr_defaultContext(&buffers_);
  // MuJoCo 2.2.2 checks for 1000 textures but has room for 100.
  if (model.ntex > static_cast<int>(std::size(buffers_.texture))) {
    fail(Status::kRender, "the model has {} textures; MuJoCo can draw at most {}", model.ntex,
         std::size(buffers_.texture));
  }
  mjModel sized = model;  // the struct only
  if (samples > 0) sized.vis.quality.offsamples = samples == 1 ? 0 : samples;
  sized.vis.global.offwidth = sized.vis.global.offheight = 1;
  MujocoBinding binding(context.platform());
  run("MuJoCo cannot draw with this OpenGL (has this process drawn with MuJoCo and another OpenGL before?)", log_,
      [&] { mjr_makeContext(&sized, &buffers_, mjFONTSCALE_100); });
  binding.confirm();
  run("MuJoCo has no buffer to draw into", log_, [&] { mjr_setBuffer(mjFB_OFFSCREEN, &buffers_); });
}

Canvas::~Canvas() {
  engine::guarded([&] { mjr_freeContext(&buffers_); });
}

void Canvas::make_room(int width, int height) {
  if (width <= buffers_.offWidth && height <= buffers_.offHeight) return;
  GLint most = 0;
  gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  require(width <= most && height <= most, "a picture of {}x{} pixels: {} draws at most {}x{}", width, height,
          platform_, most, most);
  buffers_.offWidth = std::max(width, buffers_.offWidth);
  buffers_.offHeight = std::max(height, buffers_.offHeight);
  store(buffers_.offColor, GL_RGBA8, buffers_.offSamples);
  store(buffers_.offDepthStencil, GL_DEPTH24_STENCIL8, buffers_.offSamples);
  if (buffers_.offSamples > 0) {  // the averages of the samples
    store(buffers_.offColor_r, GL_RGBA8, 0);
    store(buffers_.offDepthStencil_r, GL_DEPTH24_STENCIL8, 0);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, buffers_.offFBO);
  const GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
  const GLenum error = gl_.GetError();
  if (status == GL_FRAMEBUFFER_COMPLETE && error == GL_NO_ERROR) return;
  fail(Status::kRender, "{} has no buffer of {}x{} pixels with {} samples (status {:#x}, error {:#x})", platform_,
       buffers_.offWidth, buffers_.offHeight, buffers_.offSamples, status, error);
}

// Gives a buffer of MuJoCo's its new size.
void Canvas::store(GLuint buffer, GLenum format, int samples) {
  gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, buffers_.offWidth, buffers_.offHeight);
}

void Canvas::draw(mjvScene* scene, int width, int height, unsigned char* rgb, float* depth) {
  const mjrRect rectangle{0, 0, width, height};
  run("MuJoCo cannot draw the scene", log_, [&] { mjr_render(rectangle, scene, &buffers_); });
  run("MuJoCo cannot read the picture", log_, [&] { mjr_readPixels(rgb, depth, rectangle, &buffers_); });
}

class OpenGlRenderer final : public render::Renderer {
 public:
  OpenGlRenderer(engine::ModelPtr model, const render::Quality& quality, const LogSink& log, PlatformPtr platform)
      : model_(std::move(model)),
        samples_(quality.samples),
        log_(log),
        platform_(std::move(platform)),
        scene_(*model_, quality) {}
  ~OpenGlRenderer() override { forget(); }

  void draw(const mjModel& model, const mjData& data, const render::View& view,
            const render::Picture& picture) override;

 private:
  void draw_current(const render::Picture& picture);
  void paint(const render::Picture& picture);
  void measure(const render::Picture& picture);
  void forget() noexcept;

  engine::ModelPtr model_;
  int samples_;
  LogSink log_;
  const PlatformPtr platform_;
  render::VisualScene scene_;
  std::vector<unsigned char> ids_;
  // Made for the first picture: a world that never draws has no context. (EGL has looked for a display before.)
  std::unique_ptr<Context> context_;
  std::unique_ptr<Canvas> canvas_;
};

void check(const render::View& view, const render::Picture& picture) {
  require(picture.width > 0 && picture.height > 0, "a picture of {}x{} pixels", picture.width, picture.height);
  require(view.fovy > 0 && (view.parallel || view.fovy < 180),
          "a field of view of {} degrees; expected more than 0 and less than 180", view.fovy);
}

void OpenGlRenderer::draw(const mjModel& model, const mjData& data, const render::View& view,
                          const render::Picture& picture) {
  check(view, picture);
  scene_.update(model, data, view);
  try {
    if (!context_) context_ = std::make_unique<Context>(platform_);
    draw_current(picture);
  } catch (...) {
    forget();  // an error amid OpenGL calls leaves a context in no known state; the next picture begins with a new one
    throw;
  }
}

void OpenGlRenderer::draw_current(const render::Picture& picture) {
  const Current current(*context_);
  if (!canvas_) canvas_ = std::make_unique<Canvas>(*model_, samples_, *context_, log_);
  canvas_->make_room(picture.width, picture.height);
  if (picture.rgb != nullptr) paint(picture);
  if (picture.depth != nullptr || picture.segmentation != nullptr) measure(picture);
}

void OpenGlRenderer::paint(const render::Picture& picture) {
  scene_.show_ids(false);
  canvas_->draw(scene_.get(), picture.width, picture.height, picture.rgb, nullptr);
  render::flip_rows(picture.rgb, static_cast<std::size_t>(picture.width) * 3, picture.height);
}

// Depth and ids come from a drawing of their own. The samples of the coloured one lie beside the pixels' centres, and
// it leaves transparent geoms out of the depth; in this one MuJoCo switches multisampling off and everything is opaque,
// so ids are not averaged and each pixel's depth is that of the geom it names.
void OpenGlRenderer::measure(const render::Picture& picture) {
  const std::size_t count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  const bool segment = picture.segmentation != nullptr;
  if (segment && ids_.size() < 3 * count) ids_.resize(3 * count);
  scene_.show_ids(true);
  canvas_->draw(scene_.get(), picture.width, picture.height, segment ? ids_.data() : nullptr, picture.depth);
  if (segment) {
    render::ids_to_geoms(ids_.data(), count, scene_.geoms(), picture.segmentation);
    render::flip_rows(reinterpret_cast<unsigned char*>(picture.segmentation),
                      static_cast<std::size_t>(picture.width) * 4, picture.height);
  }
  if (picture.depth != nullptr) {
    render::depth_to_metres(picture.depth, count, scene_.near(), scene_.far(), scene_.parallel());
    render::flip_rows(reinterpret_cast<unsigned char*>(picture.depth), static_cast<std::size_t>(picture.width) * 4,
                      picture.height);
  }
}

// Gives back everything of OpenGL.
void OpenGlRenderer::forget() noexcept {
  if (!context_) return;
  try {
    const Current current(*context_);
    canvas_.reset();
  } catch (const Error&) {
    // Without our context, deleting would reach into the host's. What cannot be given back is left (Canvas has no
    // memory of its own).
    static_cast<void>(canvas_.release());
  }
  context_.reset();
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
         "{} cannot be drawn with in this process: another OpenGL is loaded, and MuJoCo would use that one",
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

std::unique_ptr<render::Renderer> make_renderer(engine::ModelPtr model, const render::Quality& quality,
                                                const LogSink& log, const PlatformPtr& platform) {
  return std::make_unique<OpenGlRenderer>(std::move(model), quality, log, platform);
}

}  // namespace mimo::opengl
