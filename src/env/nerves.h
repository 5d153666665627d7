// How well an infant sees, and how late it senses and acts, by nature.
#pragma once

#include <optional>
#include <vector>

#include "actuation/motor_path.h"
#include "env/options.h"
#include "env/perception.h"
#include "observation/limited_senses.h"

namespace mimo::env {

// Of its senses: touch is late by the part of the body, proprioception by the joint, vision and the vestibular organ by
// themselves. Null where eyes are perfect and nerves take no time; the agent outlives it.
observation::NatureOf nature_of_senses(const mjModel& model, const Perception& agent, const AgentOptions& options);

// By action, how late its motors are, in seconds; empty where nerves take no time.
std::vector<double> motor_delays(const mjModel& model, const body::Body& body, const actuation::Actuation& actuation,
                                 const AgentOptions& options);

}  // namespace mimo::env
