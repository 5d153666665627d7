/**
 * @file mimo/sight.h
 * Pictures of the world.
 */
#ifndef MIMO_SIGHT_H
#define MIMO_SIGHT_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MIMO_PICTURE_RGBA 0x1u      /**< Four bytes per pixel, the last one 255. */
#define MIMO_PICTURE_BOTTOM_UP 0x2u /**< Row 0 is the bottom, as in OpenGL's textures; also for depth. */

/** Settings of a picture. */
typedef struct mimo_picture_config {
  uint32_t struct_size; /**< sizeof(mimo_picture_config), set by mimo_picture_config_init. */
  uint32_t width;       /**< Pixels, 1 to 4096. Default 640. */
  uint32_t height;      /**< Pixels, 1 to 4096. Default 480. */
  uint32_t format;      /**< MIMO_PICTURE_ bits. Default 0: RGB, row 0 is the top. */
  const char *camera;   /**< A camera of the model; NULL: the free camera below. */
  double look_at[3];    /**< Free camera: the point in the middle, world, m. */
  double distance;      /**< Free camera: its distance from that point, m, > 0. */
  double azimuth;       /**< Free camera: degrees; 0 looks along +x, 90 along +y. */
  double elevation;     /**< Free camera: degrees; negative looks down. */
  double fovy;          /**< Vertical field of view, degrees, 1 to 170; 0: the camera's own, for the
                             free camera the model's. */
  double foveation;     /**< As vision_foveation of mimo_agent_config, for colour and projected points. Default 0. */
} mimo_picture_config;

/**
 * Fills a config with defaults: a free camera that sees the infant from the front.
 * @param size sizeof(mimo_picture_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_picture_config_init(mimo_picture_config *config, size_t size) MIMO_NOEXCEPT;

/** Buffers for a picture. A part whose buffer is NULL is not drawn. */
typedef struct mimo_picture {
  uint32_t struct_size;      /**< sizeof(mimo_picture), set by the caller. */
  uint32_t reserved;         /**< 0. */
  uint8_t *rgb;              /**< height x width x 3 bytes, or 4 with MIMO_PICTURE_RGBA. */
  size_t rgb_bytes;          /**< Length of rgb. */
  float *depth;              /**< height x width, metres along the camera's axis. */
  size_t depth_count;        /**< Length of depth. */
  int32_t *segmentation;     /**< height x width geom ids, -1 is background. */
  size_t segmentation_count; /**< Length of segmentation. */
} mimo_picture;

/**
 * Draws the current state: poses follow from the current positions, as with MIMO_NOW. The values of mimo_env_get do not
 * change.
 * @param config  NULL means defaults.
 * @param picture the buffers.
 */
MIMO_API mimo_status mimo_env_render(mimo_env *env, const mimo_picture_config *config,
                                     const mimo_picture *picture) MIMO_NOEXCEPT;

/**
 * Projects points of the world into the picture that mimo_env_render draws, also with the current positions; for
 * drawing over it.
 * @param config NULL means defaults, as in mimo_env_render.
 * @param points count x 3, metres, world frame, C order; finite.
 * @param pixels count x 3: pixels to the right of the left edge, pixels below the upper edge, and depth along the
 *               camera's axis in metres. A depth of 0 or less is behind the camera; its pixels have no meaning.
 */
MIMO_API mimo_status mimo_env_project(const mimo_env *env, const mimo_picture_config *config, const double *points,
                                      size_t count, double *pixels) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
