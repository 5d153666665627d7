#include "fmi/unit_file.h"

#include <cstdint>
#include <filesystem>
#include <random>
#include <sstream>

#include "fmi/description.h"
#include "fmi/needed.h"
#include "fmi/unit.h"
#include "fmi/zip.h"
#include "programs/files.h"
#include "programs/program.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

// Systems differ in names, and in where they look for the libraries that the adapter needs: Linux where its run path
// says, Windows beside it.
#if defined(_WIN32)
constexpr char kFolder3[] = "x86_64-windows", kFolder2[] = "win64";
#elif defined(__x86_64__)
constexpr char kFolder3[] = "x86_64-linux", kFolder2[] = "linux64";
#elif defined(__aarch64__)
constexpr char kFolder3[] = "aarch64-linux", kFolder2[] = "";  // FMI 2 has no name for it
#else
constexpr char kFolder3[] = "", kFolder2[] = "";
#endif

#ifdef _WIN32
constexpr char kEnding[] = ".dll";
constexpr bool kBeside = true;
#else
constexpr char kEnding[] = ".so";
constexpr bool kBeside = false;
#endif

std::string content_of(const std::string& path) {
  std::ifstream file = open_to_read(path);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

// A folder for as long as this lives.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / text("mimo-unit-%08x%08x", random_(), random_())) {
    std::error_code error;
    if (!fs::create_directory(path_, error)) throw Failure("no folder can be made at " + path_.string());
    fs::permissions(path_, fs::perms::owner_all, error);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  std::random_device random_;
  fs::path path_;
};

// The scene's file and all that it refers to; its place in the unit.
std::string add_scene_file(const std::string& path, Zip& zip) {
  const Scratch scratch;
  auto config = mimo::scene_config();
  config.file = path.c_str();
  mimo::Scene(config).save((scratch.path() / "scene").string());
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path())) {
    if (!entry.is_regular_file()) continue;
    const std::string name = fs::relative(entry.path(), scratch.path()).generic_string();
    zip.add("resources/" + name, content_of(entry.path().string()));
  }
  return "scene/scene.xml";
}

std::string token_of(const std::vector<std::string>& words, const std::vector<Variable>& variables) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  const auto add = [&](const std::string& part) {
    for (const char c : part + '\n') hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  };
  add(mimo_version());
  for (const std::string& word : words) add(word);
  for (const Variable& it : variables) add(it.name);
  return text("{mimo-%016llx}", static_cast<unsigned long long>(hash));
}

bool is_builtin(const std::string& scene) {
  for (const std::string& name : mimo::scene_names()) {
    if (name == scene) return true;
  }
  return false;
}

}  // namespace

void write_unit(const std::string& path, const UnitOptions& options, std::vector<std::string> words,
                std::string_view adapter) {
  require_writable(path);
  const std::string folder = options.version == 3 ? kFolder3 : kFolder2;
  const std::vector<NeededLibrary> libraries = needed_libraries();
  if (folder.empty() || adapter.empty()) {
    throw Failure("--fmu: FMI " + std::to_string(options.version) + " has no units for this machine");
  }
  const mimo::Env env = open_unit_world(options);
  const std::vector<Variable> variables = variables_of(env, options);
  Zip zip;
  words.push_back("--scene");
  words.push_back(is_builtin(options.world.scene) ? options.world.scene : add_scene_file(options.world.scene, zip));
  const std::string token = token_of(words, variables);
  std::string arguments = token + '\n';
  for (const std::string& word : words) arguments += word + '\n';
  const double step = env.timestep() * env.frame_skip();
  const UnitFacts facts = {fs::path(path).stem().string(), env.task(), token, step, options.world.seed};
  zip.add("modelDescription.xml", model_description(facts, variables, options.version));
  zip.add("resources/" + std::string(kUnitArguments), arguments);
  const std::string binaries = "binaries/" + folder + '/', beside = kBeside ? binaries : "resources/";
  zip.add(binaries + kUnitIdentifier + kEnding, adapter);
  for (const NeededLibrary& library : libraries) zip.add(beside + library.name, content_of(library.path));
  write_file(path, zip.finish());
}

}  // namespace cli
