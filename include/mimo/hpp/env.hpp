/**
 * @file mimo/hpp/env.hpp
 * Environments: one simulated world with its agents' senses. Part of mimo.hpp, which programs include.
 * MIT licence, see LICENSE.
 */
#ifndef MIMO_HPP_ENV
#define MIMO_HPP_ENV

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry.hpp"
#include "layout.hpp"
#include "scene.hpp"

namespace mimo {
inline namespace v1_0 {

namespace detail {
inline void destroy_env(mimo_env *env) { mimo_env_destroy(env); }

/// Ids for the C interface, where NULL means all: an empty vector means none.
inline const std::int32_t *some(const std::vector<std::int32_t> &ids) {
  static const std::int32_t none = 0;
  return ids.empty() ? &none : ids.data();
}
}  // namespace detail

/// A world. Ids, kinds and quantities are those of mimo.h.
class Env : public Handle<mimo_env, detail::destroy_env> {
 public:
  explicit Env(mimo_env *env) : Handle(env) {}
  explicit Env(const Scene &scene, const mimo_env_config &config = env_config()) : Handle(create(scene, config)) {}

  std::string task() const {
    const char *name = nullptr;
    check(mimo_env_task(get(), &name));
    return name;
  }
  /// Physics steps per step.
  std::uint32_t frame_skip() const {
    std::uint32_t count = 0;
    check(mimo_env_frame_skip(get(), &count));
    return count;
  }
  /// Seconds of one physics step.
  double timestep() const {
    double seconds = 0;
    check(mimo_env_timestep(get(), &seconds));
    return seconds;
  }

  /// What it observes, acts with and is rewarded for.
  Layout layout() const { return detail::layout_of<mimo_env>(get(), mimo_env_layout); }
  /// Their names live as long as the environment.
  std::vector<mimo_agent_info> agents() const {
    std::vector<mimo_agent_info> all(layout().info().agents);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].struct_size = sizeof(mimo_agent_info);
      check(mimo_env_agent(get(), i, &all[i]));
    }
    return all;
  }

  Block make_block() const { return layout().make_block(); }
  Results make_results() const {
    const mimo_layout_info sizes = layout().info();
    const std::size_t count = sizes.agents;
    return Results{std::vector<double>(count), std::vector<std::uint8_t>(count), std::vector<std::uint8_t>(count),
                   std::vector<std::int32_t>(count), std::vector<double>(sizes.terms)};
  }

  void reset(std::uint64_t seed, Block &block) {
    const mimo_reset_config config = detail::seeded(seed);
    check(mimo_env_reset(get(), &config, block.data(), block.bytes()));
  }
  void reset(Block &block) { check(mimo_env_reset(get(), nullptr, block.data(), block.bytes())); }
  /// As the config says, with what infants become: one growth for all of them, or one for each agent.
  void reset(mimo_reset_config config, const std::vector<mimo_growth> &ages, Block &block) {
    const std::vector<const mimo_growth *> places = detail::places_of(ages);
    config.growth = places.data();
    config.growth_count = places.size();
    check(mimo_env_reset(get(), &config, block.data(), block.bytes()));
  }
  void observe(Block &block) { check(mimo_env_observe(get(), block.data(), block.bytes())); }

  /// One step of all agents; an empty vector of actions leaves the controls as they are. Allocates nothing.
  void step(const std::vector<float> &actions, Block &block, Results &results) {
    const mimo_env_results to = results.raw();
    check(mimo_env_step(get(), actions.empty() ? nullptr : actions.data(), actions.size(), block.data(), block.bytes(),
                        &to));
  }
  /// The same with results of its own.
  std::vector<Result> step(const std::vector<float> &actions, Block &block) {
    Results all = make_results();
    step(actions, block, all);
    std::vector<Result> results;
    for (std::size_t i = 0; i < all.reward.size(); ++i) {
      results.push_back(Result{all.reward[i], all.terminated[i] != 0, all.truncated[i] != 0, all.outcome[i]});
    }
    return results;
  }

  /// One step of a movement that is known: frame_skip x positions of all joints. Gives frame_skip x the forces that it
  /// takes, one for each degree of freedom.
  std::vector<double> follow(const std::vector<double> &positions, Block &block) {
    std::vector<double> forces(frame_skip() * get_values(MIMO_JOINT_VELOCITY).size());
    mimo_movement movement = {};
    movement.struct_size = sizeof movement;
    movement.positions = positions.data();
    movement.position_count = positions.size();
    movement.forces = forces.data();
    movement.force_count = forces.size();
    check(mimo_env_follow(get(), &movement, block.data(), block.bytes()));
    return forces;
  }
  /// Physics alone: no senses and no task.
  void physics_step(std::size_t count = 1) { check(mimo_env_physics_step(get(), count)); }
  /// Lets a body play samples, Pa at 1 m, from the next physics step on; none: what it plays ends.
  void play(const std::string &body, const std::vector<float> &samples, double rate) {
    check(mimo_env_play(get(), body.c_str(), samples.data(), samples.size(), rate));
  }

  double time() const {
    double seconds = 0;
    check(mimo_env_time(get(), &seconds));
    return seconds;
  }

  /// Numbers from 0 (inclusive) to 1 (exclusive) from the world's own random stream.
  std::vector<double> random(std::size_t count) {
    std::vector<double> values(count);
    check(mimo_env_random(get(), values.data(), values.size()));
    return values;
  }

  /// How many of a kind (MIMO_BODY ...) there are.
  std::size_t count(mimo_kind kind) const {
    std::size_t count = 0;
    check(mimo_env_count(get(), kind, &count));
    return count;
  }
  /// All of a kind.
  std::vector<std::int32_t> ids(mimo_kind kind) const {
    std::vector<std::int32_t> ids(count(kind));
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int32_t>(i);
    return ids;
  }
  std::int32_t find(mimo_kind kind, const std::string &name) const {
    std::int32_t id = 0;
    check(mimo_env_find(get(), kind, name.c_str(), &id));
    return id;
  }
  /// "" where the model gives no name.
  std::string name(mimo_kind kind, std::int32_t id) const {
    const char *name = nullptr;
    check(mimo_env_name(get(), kind, id, &name));
    return name;
  }
  /// The body that a joint, geom, site or camera belongs to, or the parent of a body.
  std::int32_t body_of(mimo_kind kind, std::int32_t id) const {
    std::int32_t body = 0;
    check(mimo_env_body_of(get(), kind, id, &body));
    return body;
  }
  /// How many values a quantity has for these ids together, and for all of its kind.
  std::size_t width(mimo_quantity quantity, const std::vector<std::int32_t> &ids) const {
    std::size_t count = 0;
    check(mimo_env_width(get(), quantity, detail::some(ids), ids.size(), &count));
    return count;
  }
  std::size_t width(mimo_quantity quantity) const {
    std::size_t count = 0;
    check(mimo_env_width(get(), quantity, nullptr, 0, &count));
    return count;
  }
  /// A quantity of some elements, or of all of its kind. MIMO_NOW may be or-ed to it.
  std::vector<double> get_values(mimo_quantity quantity, const std::vector<std::int32_t> &ids) const {
    std::vector<double> values(width(quantity, ids));
    check(mimo_env_get(get(), quantity, detail::some(ids), ids.size(), values.data(), values.size()));
    return values;
  }
  std::vector<double> get_values(mimo_quantity quantity) const {
    std::vector<double> values(width(quantity));
    check(mimo_env_get(get(), quantity, nullptr, 0, values.data(), values.size()));
    return values;
  }
  /// The same in single precision.
  std::vector<float> get_floats(mimo_quantity quantity, const std::vector<std::int32_t> &ids) const {
    std::vector<float> values(width(quantity, ids));
    check(mimo_env_get_float(get(), quantity, detail::some(ids), ids.size(), values.data(), values.size()));
    return values;
  }
  std::vector<float> get_floats(mimo_quantity quantity) const {
    std::vector<float> values(width(quantity));
    check(mimo_env_get_float(get(), quantity, nullptr, 0, values.data(), values.size()));
    return values;
  }
  void set_values(mimo_quantity quantity, const std::vector<std::int32_t> &ids, const std::vector<double> &values) {
    check(mimo_env_set(get(), quantity, detail::some(ids), ids.size(), values.data(), values.size()));
  }
  /// Of all of its kind.
  void set_values(mimo_quantity quantity, const std::vector<double> &values) {
    check(mimo_env_set(get(), quantity, nullptr, 0, values.data(), values.size()));
  }

  /// Brings the poses of bodies and what they carry up to where the joints are now.
  void update() { check(mimo_env_update(get())); }

  /// How many contacts the last physics step computed.
  std::size_t contact_count() const { return count(MIMO_CONTACT); }
  std::vector<Contact> contacts() const {
    const std::vector<double> geoms = get_values(MIMO_CONTACT_GEOMS), bodies = get_values(MIMO_CONTACT_BODIES),
                              positions = get_values(MIMO_CONTACT_POSITION), frames = get_values(MIMO_CONTACT_FRAME),
                              distances = get_values(MIMO_CONTACT_DISTANCE), forces = get_values(MIMO_CONTACT_FORCE),
                              torques = get_values(MIMO_CONTACT_TORQUE);
    std::vector<Contact> all(distances.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      detail::put_ids(geoms, i, all[i].geoms);
      detail::put_ids(bodies, i, all[i].bodies);
      all[i].position = detail::vector_of(positions, i);
      all[i].normal = detail::vector_of(frames, 3 * i);
      all[i].tangents[0] = detail::vector_of(frames, 3 * i + 1);
      all[i].tangents[1] = detail::vector_of(frames, 3 * i + 2);
      all[i].distance = distances[i];
      all[i].force = detail::vector_of(forces, i);
      all[i].torque = detail::vector_of(torques, i);
    }
    return all;
  }
  /// What touched what during the last step, in worlds whose config says step_contacts = 1.
  std::vector<StepContact> step_contacts() const {
    const std::vector<double> geoms = get_values(MIMO_STEP_CONTACT_GEOMS),
                              bodies = get_values(MIMO_STEP_CONTACT_BODIES),
                              starts = get_values(MIMO_STEP_CONTACT_START), ends = get_values(MIMO_STEP_CONTACT_END),
                              impulses = get_values(MIMO_STEP_CONTACT_IMPULSE),
                              forces = get_values(MIMO_STEP_CONTACT_PEAK_FORCE),
                              positions = get_values(MIMO_STEP_CONTACT_PEAK_POSITION);
    std::vector<StepContact> all(starts.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      detail::put_ids(geoms, i, all[i].geoms);
      detail::put_ids(bodies, i, all[i].bodies);
      all[i].start = starts[i];
      all[i].end = ends[i];
      all[i].impulse = detail::vector_of(impulses, i);
      all[i].peak_force = detail::vector_of(forces, i);
      all[i].peak_position = detail::vector_of(positions, i);
    }
    return all;
  }
  /// How many physics steps had a warning (MIMO_WARNING_...) since the world was made.
  std::uint64_t warning_steps(std::int32_t warning) const {
    return static_cast<std::uint64_t>(get_values(MIMO_WARNING_STEPS, {warning})[0]);
  }

  /// Draws the current state; MIMO_VISION_ bits say what of it. Colour has three bytes a pixel here: for
  /// MIMO_PICTURE_RGBA there is mimo_env_render.
  Pictures render(const mimo_picture_config &config, std::uint32_t outputs = MIMO_VISION_RGB) {
    Pictures pictures = {};
    render(config, outputs, pictures);
    return pictures;
  }
  /// The same into pictures whose memory is used again.
  void render(const mimo_picture_config &config, std::uint32_t outputs, Pictures &pictures) {
    check(mimo_env_project(get(), &config, nullptr, 0, nullptr));  // before there is room for a picture of any size
    detail::make_room(pictures.color, config, (outputs & MIMO_VISION_RGB) != 0);
    detail::make_room(pictures.depth, config, (outputs & MIMO_VISION_DEPTH) != 0);
    detail::make_room(pictures.segmentation, config, (outputs & MIMO_VISION_SEGMENTATION) != 0);
    std::vector<Rgb> &color = pictures.color.pixels;
    std::vector<float> &depth = pictures.depth.pixels;
    std::vector<std::int32_t> &ids = pictures.segmentation.pixels;
    mimo_picture to = {};
    to.struct_size = sizeof to;
    to.rgb = color.empty() ? nullptr : &color[0].r;
    to.rgb_bytes = sizeof(Rgb) * color.size();
    to.depth = depth.empty() ? nullptr : depth.data();
    to.depth_count = depth.size();
    to.segmentation = ids.empty() ? nullptr : ids.data();
    to.segmentation_count = ids.size();
    check(mimo_env_render(get(), &config, &to));
  }
  /// Where points of the world lie in the picture: pixels from its left and its upper edge, and depth in metres.
  std::vector<Vector> project(const mimo_picture_config &config, const std::vector<Vector> &points) const {
    std::vector<Vector> pixels(points.size());
    if (points.empty()) return pixels;
    check(mimo_env_project(get(), &config, points[0].data(), points.size(), pixels[0].data()));
    return pixels;
  }

  /// A geom as triangles. segments: pieces of a circle; plane: half the size of endless planes, m.
  Mesh mesh(std::int32_t geom, std::int32_t axes = MIMO_AXES_MIMO, std::uint32_t segments = 24,
            double plane = 20) const {
    return detail::mesh_of(get(), geom, axes, segments, plane);
  }
  mimo_appearance appearance(std::int32_t geom) const {
    mimo_appearance appearance = {};
    appearance.struct_size = sizeof appearance;
    check(mimo_env_appearance(get(), geom, &appearance));
    return appearance;
  }
  std::size_t texture_count() const {
    std::size_t count = 0;
    check(mimo_env_texture_count(get(), &count));
    return count;
  }
  Texture texture(std::int32_t id) const { return detail::texture_of(get(), id); }
  /// A light by its id, or MIMO_HEADLIGHT.
  mimo_light light(std::int32_t id, std::int32_t axes = MIMO_AXES_MIMO) const {
    mimo_light light = {};
    light.struct_size = sizeof light;
    light.axes = axes;
    check(mimo_env_light(get(), id, &light));
    return light;
  }
  /// Where all of a kind are now: seven numbers each, see mimo_env_poses.
  std::vector<float> poses(mimo_kind kind, std::int32_t axes = MIMO_AXES_MIMO) const {
    std::vector<float> poses(7 * count(kind));
    read_poses(kind, axes, poses);
    return poses;
  }
  /// The same into memory that is there.
  void read_poses(mimo_kind kind, std::int32_t axes, std::vector<float> &poses) const {
    check(mimo_env_poses(get(), kind, axes, poses.data(), poses.size()));
  }

  /// Where the time of steps went, in worlds whose config says timing = 1.
  mimo_timing timing() const {
    mimo_timing timing = {};
    timing.struct_size = sizeof timing;
    check(mimo_env_timing(get(), &timing));
    return timing;
  }
  void reset_timing() { check(mimo_env_timing_reset(get())); }

  /// The face that an agent shows, "" for none; see mimo_face_name.
  std::string face(std::size_t agent = 0) const {
    const auto face = static_cast<std::int32_t>(get_values(MIMO_AGENT_FACE, {static_cast<std::int32_t>(agent)})[0]);
    return face < 0 ? "" : name(MIMO_FACE, face);
  }
  void set_face(const std::string &name, std::size_t agent = 0) {
    const double face = find(MIMO_FACE, name);
    set_values(MIMO_AGENT_FACE, {static_cast<std::int32_t>(agent)}, {face});
  }

  /// What the motors of an infant do by themselves: actions for the next step, as many as it has. `which` are
  /// MIMO_MOVEMENT_ bits.
  void spontaneous(std::vector<float> &actions, std::uint32_t which = MIMO_MOVEMENT_ALL, std::size_t agent = 0) const {
    check(mimo_env_spontaneous(get(), agent, which, actions.data(), actions.size()));
  }
  mimo_gaze gaze(std::size_t agent = 0) const {
    mimo_gaze gaze;
    gaze.struct_size = sizeof gaze;
    check(mimo_env_gaze(get(), agent, &gaze));
    return gaze;
  }
  /// Turns the eyes, and the head with MIMO_LOOK_HEAD, to a point at once.
  Misses look_at(double x, double y, double z, std::int32_t how = MIMO_LOOK_EYES, std::size_t agent = 0) {
    const double point[3] = {x, y, z};
    Misses misses;
    check(mimo_env_look_at(get(), agent, point, how, misses.data()));
    return misses;
  }
  /// The angles that would do so; nothing moves.
  Look look_angles(double x, double y, double z, std::int32_t how = MIMO_LOOK_EYES, std::size_t agent = 0) {
    const double point[3] = {x, y, z};
    std::size_t count = 0;
    Look look;
    check(mimo_env_look_angles(get(), agent, point, how, nullptr, nullptr, 0, &count, nullptr));
    look.joints.resize(count);
    look.angles.resize(count);
    check(mimo_env_look_angles(get(), agent, point, how, look.joints.data(), look.angles.data(), count, nullptr,
                               look.misses.data()));
    return look;
  }

  /// Holds a joint at an angle, softly, from the next step on.
  void lock(std::int32_t joint, double angle) { set_values(MIMO_JOINT_LOCK, {joint}, {1, angle}); }
  void unlock(std::int32_t joint) {
    set_values(MIMO_JOINT_LOCK, {joint}, {0, get_values(MIMO_JOINT_LOCK, {joint})[1]});
  }
  void set_gravity(double x, double y, double z) { set_values(MIMO_WORLD_GRAVITY, {x, y, z}); }

  /// Everything that the future depends on; a world that loads it goes on exactly so.
  std::vector<std::uint8_t> save() const {
    std::size_t bytes = 0;
    check(mimo_env_state_size(get(), &bytes));
    std::vector<std::uint8_t> state(bytes);
    check(mimo_env_state_save(get(), state.data(), state.size()));
    return state;
  }
  /// What the state lacks of a delay starts fresh. The report's strings are valid until the next load.
  mimo_load_report load(const std::vector<std::uint8_t> &state) {
    mimo_load_report report = detail::described<mimo_load_report>();
    check(mimo_env_state_load(get(), state.data(), state.size(), &report));
    return report;
  }
  /// Another world in the same state.
  Env clone() const {
    mimo_env *twin = nullptr;
    check(mimo_env_clone(get(), &twin));
    return Env(twin);
  }

 private:
  static mimo_env *create(const Scene &scene, const mimo_env_config &config) {
    mimo_env *env = nullptr;
    check(mimo_env_create(scene.get(), &config, &env));
    return env;
  }
};

/// The usual case: a built-in scene with its own infants.
inline Env make(const std::string &scene_name) {
  mimo_env *env = nullptr;
  check(mimo_env_make(scene_name.c_str(), &env));
  return Env(env);
}

}  // namespace v1_0
}  // namespace mimo

#endif
