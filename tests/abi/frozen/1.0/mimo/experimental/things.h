/**
 * @file mimo/experimental/things.h
 * Temperatures and materials of the things in a scene.
 */
#ifndef MIMO_EXPERIMENTAL_THINGS_H
#define MIMO_EXPERIMENTAL_THINGS_H

#include "../agent.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Sets the temperature of the room: of its air, and of every body without a temperature of its own. Default 24, in
 * which naked skin has 33.0. Infants have the temperature of skin in that room. For environments made and senses
 * attached from now on.
 * @param celsius -40 to 80.
 */
MIMO_API mimo_status mimo_scene_set_room_temperature(mimo_scene *scene, double celsius) MIMO_NOEXCEPT;

/**
 * Sets the temperature of a body of the scene and its child bodies. It is constant; contact does not change it. If
 * several calls set a body, the last one applies. A flex of MuJoCo 4 belongs to a body if all its vertices do.
 * @param body    its name in the model, "cup", "anna/left_hand".
 * @param celsius -273.15 (absolute zero) to 1000.
 * Errors: mimo_env_create and mimo_senses_attach return MIMO_E_NOT_FOUND for an unknown body.
 */
MIMO_API mimo_status mimo_scene_set_temperature(mimo_scene *scene, const char *body, double celsius) MIMO_NOEXCEPT;

/**
 * Sets the material of a body of the scene and its child bodies. It determines how the body conducts heat, how its
 * surface feels in sliding, and how it sounds when struck. Default "plastic", for infants "skin".
 * @param body     as in mimo_scene_set_temperature.
 * @param material one of mimo_material_name.
 * Errors: MIMO_E_NOT_FOUND for an unknown material, with a list of all; bodies as in mimo_scene_set_temperature.
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
