/**
 * @file mimo/experimental/looks.h
 * Looks of a world: materials, textures and lights, for engines that draw it themselves.
 */
#ifndef MIMO_EXPERIMENTAL_LOOKS_H
#define MIMO_EXPERIMENTAL_LOOKS_H

#include "../geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The appearance of a geom. For its physical material see mimo_scene_set_material. */
typedef struct mimo_appearance {
  uint32_t struct_size; /**< sizeof(mimo_appearance), set by the caller. */
  uint32_t visible;     /**< 1: MuJoCo would draw it: its group is 0 to 2, and it is not fully transparent. */
  int32_t group;        /**< Its group in MuJoCo. */
  int32_t texture;      /**< Id of its texture, -1 for none; for a face the one that the agent shows. */
  float color[4];       /**< Red, green, blue, opacity, 0 to 1; multiplied with the texture. */
  float emission;       /**< Share of its colour that it emits, 0 to 1. */
  float specular;       /**< Strength of highlights, 0 to 1. */
  float shininess;      /**< Their sharpness, 0 to 1: Phong's exponent is 128 times this. */
  float reflectance;    /**< Share of light that it mirrors, 0 to 1; planes and boxes only. */
} mimo_appearance;

/** Current appearance of a geom. Set appearance->struct_size first. */
MIMO_API mimo_status mimo_env_appearance(const mimo_env *env, int32_t geom, mimo_appearance *appearance) MIMO_NOEXCEPT;

#define MIMO_TEXTURE_FLAT 0 /**< One picture, repeated beyond its edges. */
#define MIMO_TEXTURE_CUBE 1 /**< Six square pictures, one above the other; texcoords of meshes refer to them. */
#define MIMO_TEXTURE_SKY 2  /**< A cube around the scene: right, left, up, down, front, back from inside. */

/** A texture as pixels. Call mimo_env_texture twice, as for a mesh. */
typedef struct mimo_texture {
  uint32_t struct_size; /**< sizeof(mimo_texture), set by the caller. */
  int32_t type;         /**< Out: a MIMO_TEXTURE_ constant. */
  uint32_t width;       /**< Out: pixels. */
  uint32_t height;      /**< Out: pixels, of all six pictures of a cube together. */
  uint8_t *pixels;      /**< In: red, green, blue, 255 of each pixel, row after row; or NULL. */
  size_t pixel_bytes;   /**< In: length of pixels: 4 width height. */
} mimo_texture;

/** Number of textures; ids are 0 to count - 1. */
MIMO_API mimo_status mimo_env_texture_count(const mimo_env *env, size_t *count) MIMO_NOEXCEPT;

/** A texture. Set texture->struct_size, pixels and pixel_bytes first. */
MIMO_API mimo_status mimo_env_texture(const mimo_env *env, int32_t texture_id, mimo_texture *texture) MIMO_NOEXCEPT;

#define MIMO_HEADLIGHT -1 /**< The light that every camera carries. */

/** The current state of a light. */
typedef struct mimo_light {
  uint32_t struct_size;  /**< sizeof(mimo_light), set by the caller. */
  int32_t axes;          /**< In: a MIMO_AXES_ constant. */
  uint32_t active;       /**< 1: it is on. */
  uint32_t directional;  /**< 1: parallel light along direction, as from the sun; 0: a cone from position. */
  uint32_t casts_shadow; /**< 1: it casts shadows. */
  float cutoff;          /**< Half angle of the cone, degrees; 180: all directions. */
  float exponent;        /**< Concentration towards the middle of the cone; 0: even. */
  float position[3];     /**< Current position; zero for the headlight, which is at its camera. */
  float direction[3];    /**< Direction of its light, unit vector. */
  float ambient[3];      /**< Red, green, blue of its ambient part. */
  float diffuse[3];      /**< Red, green, blue of its diffuse part. */
  float specular[3];     /**< Red, green, blue of highlights. */
  float attenuation[3];  /**< Its strength at a distance d in metres is divided by a0 + a1 d + a2 d^2. */
  uint32_t reserved;     /**< 0. */
} mimo_light;

/**
 * A light. Set light->struct_size and axes first.
 * @param id a MIMO_LIGHT, or MIMO_HEADLIGHT.
 */
MIMO_API mimo_status mimo_env_light(const mimo_env *env, int32_t id, mimo_light *light) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
