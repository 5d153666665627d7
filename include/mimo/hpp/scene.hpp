/**
 * @file mimo/hpp/scene.hpp
 * Scenes: what a world is made of. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_SCENE
#define MIMO_HPP_SCENE

#include <string>
#include <vector>

#include "configs.hpp"

namespace mimo {
inline namespace v1_0 {

namespace detail {
inline void destroy_scene(mimo_scene *scene) { mimo_scene_destroy(scene); }
}  // namespace detail

class Task;

/// What worlds are made of; not needed any more once they are.
class Scene : public Handle<mimo_scene, detail::destroy_scene> {
 public:
  explicit Scene(const mimo_scene_config &config) : Handle(create(config)) {}

  /// What the scene gives its next infant by itself.
  mimo_agent_config default_agent() const {
    mimo_agent_config config;
    check(mimo_scene_default_agent(get(), &config, sizeof config));
    return config;
  }
  std::size_t add_agent(const mimo_agent_config &config) {
    std::size_t agent = 0;
    check(mimo_scene_add_agent(get(), &config, &agent));
    return agent;
  }
  /// The scene's next infant as default_agent() gives it: in a scene made for a task with the senses of that task.
  std::size_t add_agent() {
    std::size_t agent = 0;
    check(mimo_scene_add_agent(get(), nullptr, &agent));
    return agent;
  }
  void set_touch(double spacing, std::size_t agent = 0) {
    check(mimo_scene_set_touch(get(), agent, nullptr, spacing));
  }
  void set_touch(const std::string &body, double spacing, std::size_t agent = 0) {
    check(mimo_scene_set_touch(get(), agent, body.c_str(), spacing));
  }
  /// How late an agent feels its whole body, or a part of it: seconds.
  void set_sensory_delay(double seconds, std::size_t agent = 0) {
    check(mimo_scene_set_sensory_delay(get(), agent, nullptr, seconds));
  }
  void set_sensory_delay(const std::string &body, double seconds, std::size_t agent = 0) {
    check(mimo_scene_set_sensory_delay(get(), agent, body.c_str(), seconds));
  }
  void read_joint(const std::string &joint, std::size_t agent = 0) {
    check(mimo_scene_read_joint(get(), agent, joint.c_str()));
  }
  void limit_sense(const std::string &path, const mimo_limits &limits, std::size_t agent = 0) {
    check(mimo_scene_limit_sense(get(), agent, path.c_str(), &limits));
  }
  /// A motor, a part of the body ("left_arm"), or "" for all.
  void limit_motor(const std::string &path, const mimo_limits &limits, std::size_t agent = 0) {
    check(mimo_scene_limit_motor(get(), agent, path.c_str(), &limits));
  }
  /// How warm the room is, and bodies with all that hangs on them: degrees Celsius.
  void set_room_temperature(double celsius) { check(mimo_scene_set_room_temperature(get(), celsius)); }
  void set_temperature(const std::string &body, double celsius) {
    check(mimo_scene_set_temperature(get(), body.c_str(), celsius));
  }
  /// How many bodies can play at once, and how long a sound can wait at each, s.
  void set_sources(std::size_t count, double seconds) { check(mimo_scene_set_sources(get(), count, seconds)); }
  /// From where and whereto a body plays, in its frame: see mimo_scene_direct_source.
  void direct_source(const std::string &body, const double (&place)[3], const double (&axis)[3], double directivity) {
    check(mimo_scene_direct_source(get(), body.c_str(), place, axis, directivity));
  }
  /// What a body is made of: one of mimo::material_names.
  void set_material(const std::string &body, const std::string &material) {
    check(mimo_scene_set_material(get(), body.c_str(), material.c_str()));
  }
  /// Eyes and nerves of one's own, in place of those that its growth says.
  void set_maturity(const mimo_maturity &maturity, std::size_t agent = 0) {
    check(mimo_scene_set_maturity(get(), agent, &maturity));
  }
  /// As its growth says.
  void clear_maturity(std::size_t agent = 0) { check(mimo_scene_set_maturity(get(), agent, nullptr)); }
  /// All infants that the scene names; returns how many.
  std::size_t add_agents(const mimo_agent_config *config = nullptr) {
    std::size_t count = 0;
    check(mimo_scene_add_agents(get(), config, &count));
    return count;
  }
  void set_room(const std::string &name) { check(mimo_scene_set_room(get(), name.c_str())); }
  void add_model(const mimo_model_config &config) { check(mimo_scene_add_model(get(), &config)); }
  /// Fastens a body to another one, or to the world where other is "", as they start.
  void weld(const std::string &body, const std::string &other = "") {
    check(mimo_scene_weld(get(), body.c_str(), other.empty() ? nullptr : other.c_str(), nullptr));
  }
  /// The same in a pose in the other's frame: position, then quaternion.
  void weld(const std::string &body, const std::string &other, const double (&pose)[7]) {
    check(mimo_scene_weld(get(), body.c_str(), other.empty() ? nullptr : other.c_str(), pose));
  }
  void lock(const std::string &joint, double value) { check(mimo_scene_lock(get(), joint.c_str(), value)); }
  void set_pose(const std::string &joint, double value) { check(mimo_scene_set_pose(get(), joint.c_str(), value)); }
  /// A number by which a task can be changed: see parameters().
  void set_parameter(const std::string &name, double value) {
    check(mimo_scene_set_parameter(get(), name.c_str(), value));
  }
  double parameter(const std::string &name) const {
    double value = 0;
    check(mimo_scene_get_parameter(get(), name.c_str(), &value));
    return value;
  }
  /// What the infant of a scene is to do whose task is "behaviour". Texts are valid until the scene is changed,
  /// destroyed or asked again.
  mimo_behaviour behaviour() {
    mimo_behaviour behaviour{};
    behaviour.struct_size = sizeof behaviour;
    check(mimo_scene_behaviour(get(), &behaviour));
    return behaviour;
  }
  void add_object(const mimo_object_config &config) { check(mimo_scene_add_object(get(), &config)); }
  void add_camera(const mimo_camera_config &config) { check(mimo_scene_add_camera(get(), &config)); }
  /// A further field of the observation.
  void add_field(const mimo_field_config &config) { check(mimo_scene_add_field(get(), &config)); }
  /// The same in one line: a quantity of some elements, in the frame of a body or, where that is "", of the world.
  void add_field(const std::string &name, mimo_quantity quantity, const std::vector<std::string> &elements,
                 const std::string &relative_to = "") {
    std::vector<const char *> names;
    for (const std::string &element : elements) names.push_back(element.c_str());
    mimo_field_config config = field_config();
    config.name = name.c_str();
    config.quantity = quantity;
    config.elements = names.data();
    config.element_count = names.size();
    config.relative_to = relative_to.empty() ? nullptr : relative_to.c_str();
    add_field(config);
  }
  /// Gives worlds made from now on a task of your own, which outlives them.
  inline void set_task(Task &task);
  /// Takes it away.
  void clear_task() { check(mimo_scene_set_task(get(), nullptr)); }
  /// Gives an agent of worlds made from now on a sense of your own: mimo::sense<Mine>("mine").
  inline void add_sense(const mimo_sense &sense, std::size_t agent = 0);
  /// The same for a sense in a shared library.
  inline void load_sense(const std::string &path, std::size_t agent = 0);
  /// The parameters of all senses of your own, for set_parameter.
  inline std::vector<mimo_parameter> sense_parameters() const;

  std::string xml() const {
    std::size_t length = 0;
    check(mimo_scene_xml(get(), nullptr, 0, &length));
    std::string text(length + 1, '\0');
    check(mimo_scene_xml(get(), &text[0], text.size(), &length));
    text.resize(length);
    return text;
  }

  void save(const std::string &folder) const { check(mimo_scene_save(get(), folder.c_str())); }

 private:
  static mimo_scene *create(const mimo_scene_config &config) {
    mimo_scene *scene = nullptr;
    check(mimo_scene_create(&config, &scene));
    return scene;
  }
};

}  // namespace v1_0
}  // namespace mimo

#endif
