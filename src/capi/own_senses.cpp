// Senses of the user's own: their tables, who has them, and what their functions ask for.
#include "base/random.h"
#include "capi/calls.h"
#include "capi/check.h"
#include "capi/objects.h"
#include "capi/own_sense.h"
#include "capi/structs.h"
#include "capi/use.h"

namespace mimo::capi {
namespace {

env::OwnSense made_by(const SensePlanPtr& plan) {
  env::OwnSense sense = plan->described;
  sense.make = [plan](const env::World& world, std::size_t agent, const std::vector<double>& values) {
    return std::make_unique<RunningSense>(plan, world, agent, values);
  };
  return sense;
}

void add(mimo_scene* scene, std::size_t agent, const SensePlanPtr& plan) {
  open(scene).blueprint.edit([&](blueprint::SceneEdit& edit) {
    edit.agents.add_sense(agent, made_by(plan));
    note(edit, {{"call", "add_sense"}, {"agent", agent}, {"sense", plan->described.name}, {"path", plan->path}});
  });
  take_over(*plan);
}

void add(mimo_recording* recording, const SensePlanPtr& plan) {
  RecordingObject& object = open(recording);
  check_recorded_sense(*object.recording, plan->described.name);
  object.senses[plan->described.name] = plan;
  take_over(*plan);
}

RunningSense& sense_of(const mimo_env* env) {
  RunningSense* const sense = open(env).sense;
  require(sense != nullptr, "env is a world, expected the handle that the library passes to a function of a sense");
  return *sense;
}

}  // namespace

void add_recorded_sense(mimo_scene* scene, std::size_t agent, const SensePlanPtr& plan) { add(scene, agent, plan); }

}  // namespace mimo::capi

using namespace mimo;
using namespace mimo::capi;

extern "C" {

mimo_status mimo_sense_init(mimo_sense* sense, size_t size) noexcept {
  return guard([&] { write_struct(sense, size, empty_sense(), "sense"); });
}

mimo_status mimo_sense_field_init(mimo_sense_field* field, size_t size) noexcept {
  return guard([&] { write_struct(field, size, empty_sense_field(), "field"); });
}

mimo_status mimo_sense_add_field(const mimo_env* env, const mimo_sense_field* field) noexcept {
  return guard(env, [&] {
    RunningSense& sense = sense_of(env);
    require(field != nullptr, "field is NULL");
    sense.add_field(read_struct(field, "field"));
  });
}

mimo_status mimo_sense_feel(const mimo_env* env, size_t field, const void** values) noexcept {
  return guard(env, [&] {
    RunningSense& sense = sense_of(env);
    out(values, "values") = sense.feel(field);
  });
}

double mimo_sense_noise(uint64_t seed, uint64_t tick, uint64_t number) noexcept {
  Hash all;
  for (const std::uint64_t one : {seed, tick, number}) all.add(one);
  return Noise(all.value()).next();
}

mimo_status mimo_scene_add_sense(mimo_scene* scene, size_t agent, const mimo_sense* sense) noexcept {
  return guard(scene, [&] {
    open(scene);
    add(scene, agent, sense_plan(sense));
  });
}

mimo_status mimo_scene_load_sense(mimo_scene* scene, size_t agent, const char* path) noexcept {
  return guard(scene, [&] {
    open(scene);
    add(scene, agent, load_sense_plan(path));
  });
}

mimo_status mimo_scene_sense_parameter(const mimo_scene* scene, size_t index, mimo_parameter* parameter) noexcept {
  return guard(scene, [&] {
    const auto all = open(scene).blueprint.current().agents.sense_parameters();
    if (index >= all.size()) fail(Status::kNotFound, "index is {}, but there are {} parameters", index, all.size());
    mimo_parameter ours{};
    ours.name = all[index]->name.c_str();
    ours.description = all[index]->description.c_str();
    ours.standard = all[index]->standard;
    ours.low = all[index]->low;
    ours.high = all[index]->high;
    write_described(parameter, ours, "parameter");
  });
}

mimo_status mimo_recording_add_sense(mimo_recording* recording, const mimo_sense* sense) noexcept {
  return guard(recording, [&] {
    open(recording);
    add(recording, sense_plan(sense));
  });
}

mimo_status mimo_recording_load_sense(mimo_recording* recording, const char* path) noexcept {
  return guard(recording, [&] {
    open(recording);
    add(recording, load_sense_plan(path));
  });
}

}  // extern "C"
