/**
 * @file mimo/sight.h
 * Where infants look, and pictures for people.
 */
#ifndef MIMO_SIGHT_H
#define MIMO_SIGHT_H

#include "env.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Where an infant looks. */
typedef struct mimo_gaze {
  uint32_t struct_size;      /**< sizeof(mimo_gaze), set by the caller. */
  uint32_t meets;            /**< 1: the lines of sight come closest before both eyes; 0: they lead apart. */
  double left_position[3];   /**< Of the left eye's camera, world, m. */
  double left_direction[3];  /**< Its line of sight, unit vector, world. */
  double right_position[3];  /**< Of the right eye's camera. */
  double right_direction[3]; /**< Its line of sight. */
  double vergence;           /**< Angle between the lines of sight, rad; negative where they lead apart. */
  double point[3];           /**< Where they meet: half-way where they are closest, world, m; zero if they do not. */
  double miss;               /**< How far they pass each other there, m. */
} mimo_gaze;

/**
 * Where an agent looks, by its eyes' cameras where mimo_env_get has them: after a step as at the start of the last
 * physics step, after mimo_env_update as they are now. Set gaze->struct_size first.
 */
MIMO_API mimo_status mimo_env_gaze(const mimo_env *env, size_t agent, mimo_gaze *gaze) MIMO_NOEXCEPT;

#define MIMO_LOOK_EYES 0 /**< The eyes alone turn. They reach 45 degrees to the sides, 33 up and 47 down. */
#define MIMO_LOOK_HEAD 1 /**< The head turns first, so that the eyes have to turn little. */

/**
 * Angles of the joints that make an agent look at a point, from where its chest is now; nothing moves. For position
 * control, for locks, or for mimo_env_set. Eyes do not roll: their torsion is 0.
 * @param point    three numbers, metres, world frame.
 * @param how      MIMO_LOOK_EYES or MIMO_LOOK_HEAD.
 * @param joints   receives ids: pan, tilt and torsion of the left eye, then of the right one; with MIMO_LOOK_HEAD
 *                 swivel and tilt of the head before them. May be NULL.
 * @param angles   receives their angles, rad, cut to the joints' ranges; may be NULL.
 * @param capacity how many joints the arrays have room for; 0 where both are NULL, to learn the count.
 * @param count    receives how many there are; may be NULL.
 * @param errors   receives two angles, by which the left and the right eye miss the point because of their range, rad;
 *                 may be NULL.
 * Errors: MIMO_E_NOT_FOUND or MIMO_E_UNSUPPORTED for a body without such eyes; MIMO_E_BUFFER_TOO_SMALL.
 */
MIMO_API mimo_status mimo_env_look_angles(mimo_env *env, size_t agent, const double *point, int32_t how,
                                          int32_t *joints, double *angles, size_t capacity, size_t *count,
                                          double *errors) MIMO_NOEXCEPT;

/**
 * Makes an agent look at a point at once: its joints are set, as by mimo_env_set, not driven. Springs and motors
 * go on moving them in the next step.
 * @param errors as in mimo_env_look_angles.
 */
MIMO_API mimo_status mimo_env_look_at(mimo_env *env, size_t agent, const double *point, int32_t how,
                                      double *errors) MIMO_NOEXCEPT;

#define MIMO_PICTURE_RGBA 0x1u      /**< Four bytes a pixel, the last one 255. */
#define MIMO_PICTURE_BOTTOM_UP 0x2u /**< Row 0 is the bottom, as in OpenGL's textures; of depth, too. */

/** What to draw. */
typedef struct mimo_picture_config {
  uint32_t struct_size; /**< sizeof(mimo_picture_config), set by mimo_picture_config_init. */
  uint32_t width;       /**< Pixels, 1 to 4096. Default 640. */
  uint32_t height;      /**< Pixels, 1 to 4096. Default 480. */
  uint32_t format;      /**< MIMO_PICTURE_ bits. Default 0: RGB, row 0 is the top. */
  const char *camera;   /**< A camera of the model; NULL: the free camera below. */
  double look_at[3];    /**< Free camera: the point in the middle, world, m. */
  double distance;      /**< Free camera: from that point, m, > 0. */
  double azimuth;       /**< Free camera: degrees; 0 looks along +x, 90 along +y. */
  double elevation;     /**< Free camera: degrees; negative looks down. */
  double fovy;          /**< Vertical field of view, degrees; 0: the camera's own. */
  double foveation;     /**< Of colour and of places: as vision_foveation of mimo_agent_config. Default 0. */
} mimo_picture_config;

/**
 * Fills a config with defaults: a free camera that sees the infant from the front.
 * @param size sizeof(mimo_picture_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_picture_config_init(mimo_picture_config *config, size_t size) MIMO_NOEXCEPT;

/** Where a picture goes. What is NULL is not drawn. */
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
 * Draws the current state: poses follow from the current positions, as in MIMO_NOW. What mimo_env_get gives stays.
 * @param config  NULL means defaults.
 * @param picture says where it goes.
 */
MIMO_API mimo_status mimo_env_render(mimo_env *env, const mimo_picture_config *config,
                                     const mimo_picture *picture) MIMO_NOEXCEPT;

/**
 * Where points of the world lie in the picture that mimo_env_render draws, of the current positions as well; for
 * drawing over it.
 * @param config NULL means defaults, as in mimo_env_render.
 * @param points count x 3, metres, world frame, C order; finite.
 * @param pixels count x 3: pixels to the right of the left edge, pixels below the upper edge, and depth along the
 *               camera's axis in metres. A depth of 0 or less is behind the camera; the pixels then mean nothing.
 */
MIMO_API mimo_status mimo_env_project(const mimo_env *env, const mimo_picture_config *config, const double *points,
                                      size_t count, double *pixels) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
