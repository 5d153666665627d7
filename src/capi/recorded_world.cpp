#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <string_view>

#include "base/format.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/configs.h"
#include "capi/handed.h"
#include "capi/objects.h"
#include "capi/read_json.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

constexpr std::size_t kMostCalls = 10000;

void check(mimo_status status) {
  if (status != MIMO_OK) throw Error(static_cast<Status>(status), mimo_last_error());
}

[[noreturn]] void fail_damaged(const std::string& what) { fail(Status::kFile, "'world' of the recording: {}", what); }

// The arguments of one call. Texts live as long as this.
class Arguments {
 public:
  explicit Arguments(const ReadJson& call) : call_(call) {}

  const ReadJson& at(const char* name) const {
    const ReadJson* const found = call_.find(name);
    if (found == nullptr) fail_damaged(format("a call with {} arguments lacks \"{}\"", call_.parts.size(), name));
    return *found;
  }
  bool is_null(const char* name) const { return at(name).is(ReadJson::Kind::kNull); }
  template <typename T>
  T number(const char* name) const {
    return number_of<T>(at(name), name);
  }
  // May be null.
  const char* text(const char* name) { return is_null(name) ? nullptr : text_of(at(name), name); }
  std::vector<const char*> texts(const ReadJson& list, const char* name) {
    std::vector<const char*> all;
    for (const ReadJson& one : list_of(list, name).parts) all.push_back(text_of(one, name));
    return all;
  }
  template <typename T>
  std::vector<T> numbers(const ReadJson& list, const char* name) const {
    std::vector<T> all;
    for (const ReadJson& one : list_of(list, name).parts) all.push_back(number_of<T>(one, name));
    return all;
  }
  // What is not said stays as it is.
  template <typename Struct>
  void read(const char* name, Struct& all) {
    const ReadJson& json = at(name);
    if (!json.is(ReadJson::Kind::kObject)) fail_damaged(format("\"{}\" is no object", name));
    std::size_t known = 0;
    for_each_member(all, [&](const char* member, auto& value) {
      const ReadJson* const found = json.find(member);
      if (found == nullptr) return;
      ++known;
      take(*found, member, value);
    });
    if (known == json.parts.size()) return;
    fail(Status::kUnsupported,
         "the recording was made by a newer library: \"{}\" has members that this library does not know", name);
  }
  const char* text_of(const ReadJson& json, const char* name) {
    if (!json.is(ReadJson::Kind::kText)) fail_damaged(format("\"{}\" is no text", name));
    return texts_.emplace_back(json.text).c_str();
  }

 private:
  template <typename T>
  static T number_of(const ReadJson& json, const char* name) {
    const std::optional<T> number = json.number<T>();
    if (!number) fail_damaged(format("\"{}\" is not a number that it can have", name));
    return *number;
  }
  static const ReadJson& list_of(const ReadJson& json, const char* name) {
    if (!json.is(ReadJson::Kind::kList)) fail_damaged(format("\"{}\" is no list", name));
    return json;
  }
  template <typename T>
  void take(const ReadJson& json, const char* name, T& value) {
    if constexpr (std::is_same_v<T, const char*>) {
      value = text_of(json, name);
    } else if constexpr (std::is_array_v<T>) {
      const auto all = numbers<std::remove_extent_t<T>>(json, name);
      if (all.size() != std::extent_v<T>) fail_damaged(format("\"{}\" has {} numbers", name, all.size()));
      std::copy(all.begin(), all.end(), std::begin(value));
    } else {
      value = number_of<T>(json, name);
    }
  }

  const ReadJson& call_;
  std::deque<std::string> texts_;
};

// A scene, on which the calls of a recording are made again.
class RecordedScene {
 public:
  RecordedScene(const scene::Source& source, const std::optional<mimo_agent_config>& senses, const Senses& own)
      : scene_(wrap<mimo_scene>(std::make_unique<SceneObject>(SceneObject{blueprint::Blueprint(source)}))),
        senses_(senses),
        own_senses_(own) {
    check(mimo_env_config_init(&config_, sizeof config_));
  }
  ~RecordedScene() { mimo_scene_destroy(scene_); }
  RecordedScene(const RecordedScene&) = delete;
  RecordedScene& operator=(const RecordedScene&) = delete;

  void call(const ReadJson& call);
  blueprint::Blueprint& blueprint() const { return open(scene_).blueprint; }
  const mimo_env_config& config() const { return config_; }
  const char* renderer() const { return renderer_.c_str(); }
  const char* task() const { return task_.c_str(); }
  bool has_own_task() const { return has_own_task_; }
  // Whether it was made of another recording, with other senses.
  bool forgives_limits() const { return forgives_limits_; }

 private:
  using Make = void (RecordedScene::*)(Arguments&);
  static const std::pair<const char*, Make> kCalls[];

  mimo_agent_config agent(Arguments& given) const {
    mimo_agent_config config{};
    check(mimo_agent_config_init(&config, sizeof config));
    given.read("config", config);
    if (senses_ && text(config.root).empty()) take_senses(config, *senses_);
    return config;
  }
  void add_agent(Arguments& given) {
    const mimo_agent_config config = agent(given);
    check(mimo_scene_add_agent(scene_, &config, nullptr));
  }
  void add_agents(Arguments& given) {
    const mimo_agent_config config = agent(given);
    check(mimo_scene_add_agents(scene_, &config, nullptr));
  }
  void set_touch(Arguments& given) {
    check(mimo_scene_set_touch(scene_, given.number<std::size_t>("agent"), given.text("body"),
                               given.number<double>("spacing")));
  }
  void read_joint(Arguments& given) {
    check(mimo_scene_read_joint(scene_, given.number<std::size_t>("agent"), given.text("joint")));
  }
  mimo_limits limits(Arguments& given) const {
    mimo_limits limits{};
    check(mimo_limits_init(&limits, sizeof limits));
    given.read("limits", limits);
    return limits;
  }
  void limit_sense(Arguments& given) {
    const mimo_limits ours = limits(given);
    check(mimo_scene_limit_sense(scene_, given.number<std::size_t>("agent"), given.text("path"), &ours));
  }
  void forgive_limits(Arguments& /*given*/) { forgives_limits_ = true; }
  void limit_motor(Arguments& given) {
    const mimo_limits ours = limits(given);
    check(mimo_scene_limit_motor(scene_, given.number<std::size_t>("agent"), given.text("path"), &ours));
  }
  void set_maturity(Arguments& given) {
    mimo_maturity maturity{};
    check(mimo_maturity_init(&maturity, sizeof maturity));
    const bool own = !given.is_null("maturity");
    if (own) given.read("maturity", maturity);
    check(mimo_scene_set_maturity(scene_, given.number<std::size_t>("agent"), own ? &maturity : nullptr));
  }
  void set_sensory_delay(Arguments& given) {
    check(mimo_scene_set_sensory_delay(scene_, given.number<std::size_t>("agent"), given.text("body"),
                                       given.number<double>("seconds")));
  }
  void add_camera(Arguments& given) {
    mimo_camera_config config{};
    check(mimo_camera_config_init(&config, sizeof config));
    given.read("config", config);
    check(mimo_scene_add_camera(scene_, &config));
  }
  void add_field(Arguments& given) {
    mimo_field_config config{};
    check(mimo_field_config_init(&config, sizeof config));
    given.read("config", config);
    const std::vector<const char*> elements = given.texts(given.at("elements"), "elements");
    config.elements = elements.data();
    config.element_count = elements.size();
    check(mimo_scene_add_field(scene_, &config));
  }
  // A file loads no code: the host brings it along.
  void add_sense(Arguments& given) {
    const std::string name = text(given.text("sense")), path = text(given.text("path"));
    const auto found = own_senses_.find(name);
    if (found == own_senses_.end()) {
      fail(Status::kUnsupported,
           "the recording needs the sense \"{}\"{}: mimo_recording_add_sense, mimo_recording_load_sense or the "
           "program's "
           "option --sense gives it",
           name, path.empty() ? "" : " (of " + path + ")");
    }
    add_recorded_sense(scene_, given.number<std::size_t>("agent"), found->second);
  }
  void set_room_temperature(Arguments& given) {
    check(mimo_scene_set_room_temperature(scene_, given.number<double>("celsius")));
  }
  void set_temperature(Arguments& given) {
    check(mimo_scene_set_temperature(scene_, given.text("body"), given.number<double>("celsius")));
  }
  void set_material(Arguments& given) {
    check(mimo_scene_set_material(scene_, given.text("body"), given.text("material")));
  }
  void set_sources(Arguments& given) {
    check(mimo_scene_set_sources(scene_, given.number<std::size_t>("count"), given.number<double>("seconds")));
  }
  void direct_source(Arguments& given) {
    std::vector<double> place = given.numbers<double>(given.at("place"), "place");
    std::vector<double> axis = given.numbers<double>(given.at("axis"), "axis");
    place.resize(3);
    axis.resize(3);
    check(mimo_scene_direct_source(scene_, given.text("body"), place.data(), axis.data(),
                                   given.number<double>("directivity")));
  }
  void set_parameter(Arguments& given) {
    check(mimo_scene_set_parameter(scene_, given.text("name"), given.number<double>("value")));
  }
  // A task that does nothing, in place of the user's own.
  void set_task(Arguments& given) {
    has_own_task_ = !given.is_null("task");
    if (!has_own_task_) return check(mimo_scene_set_task(scene_, nullptr));
    Arguments said(given.at("task"));
    mimo_task task{};
    check(mimo_task_init(&task, sizeof task));
    task.evaluate = [](void*, mimo_env*, const mimo_task_moment*, mimo_task_verdict*) -> mimo_status {
      return MIMO_OK;
    };
    task.memory_bytes = said.number<std::size_t>("memory_bytes");
    const std::vector<const char*> terms = said.texts(said.at("terms"), "terms");
    task.terms = terms.data();
    task.term_count = terms.size();
    std::vector<mimo_task_field> fields;
    std::deque<std::vector<std::size_t>> shapes;
    for (const ReadJson& one : said.at("fields").parts) {
      Arguments field(one);
      mimo_task_field& ours = fields.emplace_back();
      check(mimo_task_field_init(&ours, sizeof ours));
      ours.name = said.text_of(field.at("name"), "name");
      ours.unit = said.text_of(field.at("unit"), "unit");
      ours.frame = said.text_of(field.at("frame"), "frame");
      const std::vector<std::size_t>& shape =
          shapes.emplace_back(field.numbers<std::size_t>(field.at("shape"), "shape"));
      ours.shape = shape.data();
      ours.ndim = static_cast<std::uint32_t>(shape.size());
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      ours.low = field.is_null("low") ? -kInfinity : field.number<double>("low");
      ours.high = field.is_null("high") ? kInfinity : field.number<double>("high");
    }
    task.fields = fields.data();
    task.field_count = fields.size();
    check(mimo_scene_set_task(scene_, &task));
  }
  void env_create(Arguments& given) {
    given.read("config", config_);
    renderer_ = text(config_.renderer);
    task_ = text(config_.task);
  }

  mimo_scene* scene_;
  std::optional<mimo_agent_config> senses_;
  const Senses& own_senses_;
  mimo_env_config config_{};
  std::string renderer_ = "auto", task_;
  bool has_own_task_ = false, forgives_limits_ = false;
};

const std::pair<const char*, RecordedScene::Make> RecordedScene::kCalls[] = {
    {"add_agent", &RecordedScene::add_agent},
    {"add_agents", &RecordedScene::add_agents},
    {"add_camera", &RecordedScene::add_camera},
    {"add_field", &RecordedScene::add_field},
    {"add_sense", &RecordedScene::add_sense},
    {"direct_source", &RecordedScene::direct_source},
    {"env_create", &RecordedScene::env_create},
    {"forgive_limits", &RecordedScene::forgive_limits},
    {"limit_motor", &RecordedScene::limit_motor},
    {"limit_sense", &RecordedScene::limit_sense},
    {"read_joint", &RecordedScene::read_joint},
    {"set_material", &RecordedScene::set_material},
    {"set_maturity", &RecordedScene::set_maturity},
    {"set_parameter", &RecordedScene::set_parameter},
    {"set_room_temperature", &RecordedScene::set_room_temperature},
    {"set_sensory_delay", &RecordedScene::set_sensory_delay},
    {"set_sources", &RecordedScene::set_sources},
    {"set_task", &RecordedScene::set_task},
    {"set_temperature", &RecordedScene::set_temperature},
    {"set_touch", &RecordedScene::set_touch},
};

void RecordedScene::call(const ReadJson& call) {
  if (!call.is(ReadJson::Kind::kObject)) fail_damaged("a call is no object");
  Arguments given(call);
  const std::string name = given.text_of(given.at("call"), "call");
  for (const auto& [known, make] : kCalls) {
    if (name == known) return (this->*make)(given);
  }
  fail(Status::kUnsupported,
       "the recording was made by a newer library: \"{}\" is a call that this library does not know", name);
}

std::vector<ReadJson> calls_of(const recording::Recording& recording) {
  std::optional<ReadJson> calls = read_json(recording.world());
  if (!calls || !calls->is(ReadJson::Kind::kList)) fail_damaged("it is no list");
  if (calls->parts.size() > kMostCalls) fail_damaged(format("it has {} calls", calls->parts.size()));
  return std::move(calls->parts);
}

// Callers may choose these members of mimo_env_config, and the log; all others come from the recording.
constexpr std::string_view kChosen[] = {"renderer", "timing", "render", "samples", "render_threads", "step_contacts"};

template <typename T>
bool is_same(const T& one, const T& other) {
  if constexpr (std::is_same_v<T, const char*>) {
    return text(one) == text(other);
  } else {
    return one == other;
  }
}

mimo_env_config chosen(const RecordedScene& scene, const std::optional<mimo_env_config>& given) {
  mimo_env_config config = scene.config();
  config.renderer = scene.renderer();
  config.task = scene.task();
  if (!given) return config;
  mimo_env_config own = *given;
  const auto take = [](const char* name, auto& value, const auto& recorded, const auto& usual) {
    if (std::find(std::begin(kChosen), std::end(kChosen), name) != std::end(kChosen)) return;
    require(is_same(value, usual), "config: {} comes from the recording; leave it as mimo_env_config_init sets it",
            name);
    value = recorded;
  };
  for_each_member(own, take, config, default_env_config());
  return own;
}

std::unique_ptr<EnvObject> make(const RecordingObject& object, const std::optional<mimo_env_config>& given,
                                const std::optional<mimo_agent_config>& wanted) {
  const std::shared_ptr<recording::Recording>& recording = object.recording;
  scene::Source source = recording->scene();
  if (given) source.log = log_sink(given->log, given->log_user);
  RecordedScene scene(source, wanted, object.senses);
  for (const ReadJson& call : calls_of(*recording)) scene.call(call);
  const mimo_env_config ours = chosen(scene, given);
  const recording::Growths ages = recording->growths();
  scene.blueprint().edit([&](blueprint::SceneEdit& edit) {
    if (!ages.empty()) edit.agents.be_as_old_as(ages);
    if (!wanted && !scene.forgives_limits()) return;
    edit.agents.forgive_limits();  // of fields that the caller leaves out
    note(edit, {{"call", "forgive_limits"}});
  });
  // Only for other ages the file stays open.
  const auto file = recording->bodies() > 1 ? recording : nullptr;
  const auto described_at = [file, ages, edit = scene.blueprint().current()](const blueprint::Growths& growths) {
    if (growths == ages) return edit;
    if (file == nullptr) fail(Status::kUnsupported, "growth: the recording has its infants at one age only");
    blueprint::SceneEdit at = edit;
    at.scene = scene::Scene(file->scene(growths));
    at.agents.be_as_old_as(growths);
    return at;
  };
  blueprint::WorldsByAgePtr worlds = worlds_of(scene.blueprint(), ours, described_at);
  env::CompiledWorldPtr compiled = worlds->as_described({}, source.log);
  auto env = std::make_unique<EnvObject>(std::move(worlds), std::move(compiled));
  env->task_is_missing = scene.has_own_task() && env->world().task_name() == "custom";
  return env;
}

// Whether a call was given what it cannot take.
bool refuses(const Error& error) {
  return error.status() == Status::kInvalidArgument || error.status() == Status::kNotFound;
}

void require_whole(const RecordingObject& recording) {
  try {
    make(recording, {}, {});
  } catch (const Error& error) {
    if (refuses(error)) fail_damaged(error.message());
  }
}

}  // namespace

void check_recorded_sense(const recording::Recording& recording, const std::string& name) {
  std::vector<std::string> names;
  for (const ReadJson& call : calls_of(recording)) {
    Arguments given(call);
    if (text(given.text("call")) != "add_sense") continue;
    names.push_back(text(given.text("sense")));
    if (names.back() == name) return;
  }
  fail(Status::kNotFound, "the recording has no sense \"{}\" of its own; it has: {}", name, some_of(std::move(names)));
}

std::unique_ptr<EnvObject> make_recorded(const RecordingObject& recording, const mimo_env_config* config,
                                         const mimo_agent_config* senses) {
  std::optional<mimo_agent_config> wanted;
  if (senses != nullptr) wanted = read_struct(senses, default_agent_config(), "senses");
  std::optional<mimo_env_config> given;
  if (config != nullptr) given = read_struct(config, default_env_config(), "config");
  try {
    return make(recording, given, wanted);
  } catch (const Error& error) {
    // The caller is at fault only where the recording makes a world without the caller's wishes.
    if (refuses(error)) require_whole(recording);
    throw;
  }
}

}  // namespace mimo::capi
