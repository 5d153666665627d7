// What several commands tell of a world.
#pragma once

#include <cstdint>
#include <mimo/mimo.hpp>
#include <string>
#include <vector>

namespace cli {

std::vector<std::int32_t> infants(const mimo::Env& env);  // their root bodies, agents or not
std::string prefix(const mimo_agent_info& agent);         // of its fields
std::size_t touch_sensors(const mimo::Env& env);          // of all agents

// How the model calls a joint; "free:<body>" for one that moves a whole body and has no name.
std::string joint_label(const mimo::Env& env, std::int32_t joint);

const char* dtype_name(const mimo_field& field);
std::vector<std::size_t> shape(const mimo_field& field);
std::string shape_text(const mimo_field& field);  // "256x256x3"
std::string or_dash(const std::string& text);     // "-" where there is none

}  // namespace cli
