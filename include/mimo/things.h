/**
 * @file mimo/things.h
 * What the things of a scene are like: how warm they are, and what they are made of.
 */
#ifndef MIMO_THINGS_H
#define MIMO_THINGS_H

#include "agent.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Sets how warm the room is: its air, and all that has no temperature of its own. Default 24, at which naked skin is
 * 33.0. Infants are as warm as skin in that room. For environments made and senses attached from now on.
 * @param celsius -40 to 80.
 */
MIMO_API mimo_status mimo_scene_set_room_temperature(mimo_scene *scene, double celsius) MIMO_NOEXCEPT;

/**
 * Sets how warm a body of the scene is, with all that hangs on it; it stays so whatever touches it. Where several calls
 * concern a body, the last one counts. A flex of MuJoCo 4 hangs on a body if all its vertices do.
 * @param body    its name in the model, "cup", "anna/left_hand".
 * @param celsius -273.15 (absolute zero) to 1000.
 * Errors: a body that the model does not have is MIMO_E_NOT_FOUND from mimo_env_create and mimo_senses_attach.
 */
MIMO_API mimo_status mimo_scene_set_temperature(mimo_scene *scene, const char *body, double celsius) MIMO_NOEXCEPT;

/**
 * Sets what a body of the scene is made of, with all that hangs on it: how well it takes heat, how it feels to slide
 * over, and how it sounds when it is struck. Default "plastic", of infants "skin".
 * @param body     as in mimo_scene_set_temperature.
 * @param material one of mimo_material_name.
 * Errors: MIMO_E_NOT_FOUND for an unknown material, with a list of those that there are; bodies as in
 *         mimo_scene_set_temperature.
 */
MIMO_API mimo_status mimo_scene_set_material(mimo_scene *scene, const char *body, const char *material) MIMO_NOEXCEPT;

/**
 * Name of the index-th material, or NULL past the last: "copper", "aluminium", "steel", "granite", "glass", "water",
 * "polyethylene", "plastic", "rubber", "leather", "hardwood", "softwood", "cotton", "cork", "foam", "skin", "iron",
 * "ceramic", "cardboard", "concrete", "carpet". Static string.
 */
MIMO_API const char *mimo_material_name(size_t index) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
