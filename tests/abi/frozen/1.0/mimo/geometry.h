/**
 * @file mimo/geometry.h
 * For engines that draw the world themselves: shapes as triangles, and poses. For materials, textures and lights see
 * experimental/looks.h.
 *
 * Read shapes once, and again after a change of MIMO_GEOM_SIZE, MIMO_GEOM_COLOR or MIMO_AGENT_FACE, and after a reset
 * to another age; read poses after each step.
 */
#ifndef MIMO_GEOMETRY_H
#define MIMO_GEOMETRY_H

#include "access.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Frames. In libmimo's frame the infant looks along x, y is to its left, z is up. In an engine's frame it looks along
 * the engine's forward axis. Lengths are metres, except in Unreal: centimetres.
 */
#define MIMO_AXES_MIMO 0   /**< libmimo, MuJoCo, ROS: x forward, y left, z up. Quaternions w x y z. */
#define MIMO_AXES_UNITY 1  /**< Left-handed: x right, y up, z forward. Quaternions x y z w, as in all below. */
#define MIMO_AXES_UNREAL 2 /**< Left-handed: x forward, y right, z up; cm. */
#define MIMO_AXES_GODOT 3  /**< Right-handed: x right, y up, z backward. */
#define MIMO_AXES_GLTF 4   /**< Right-handed: x left, y up, z forward: glTF, three.js. */

/**
 * Converts points in place: positions, or the places of touch sensors.
 * @param points three numbers each, in libmimo's frame.
 */
MIMO_API mimo_status mimo_convert_points(int32_t axes, float *points, size_t point_count) MIMO_NOEXCEPT;

/**
 * Converts directions in place: normals, forces, velocities; their lengths do not change.
 * @param directions three numbers each, in libmimo's frame.
 */
MIMO_API mimo_status mimo_convert_directions(int32_t axes, float *directions, size_t direction_count) MIMO_NOEXCEPT;

/**
 * Converts poses in place, for example of single bodies: mimo_env_get_float and mimo_batch_get_float read them
 * (MIMO_BODY_POSE, with MIMO_NOW the current ones). Like mimo_env_poses for all elements of a kind.
 *
 * The axes of the bodies are converted as well as those of the world: a body that is not turned in one frame is not
 * turned in any. So what lies in a body's frame (a mesh, the places of its sensors) needs the same conversion. The
 * quaternion keeps its sign and its length: w stays the same number, and q and -q, which are the same rotation, stay
 * apart; for a pose between two others, negate one quaternion if their dot product is negative.
 * @param poses seven numbers each: position and quaternion w x y z in libmimo's frame; the converted quaternion has the
 *              order of the frame.
 */
MIMO_API mimo_status mimo_convert_poses(int32_t axes, float *poses, size_t pose_count) MIMO_NOEXCEPT;

/**
 * Current poses of all elements of a kind, one after the other: position, and a quaternion in the order of the frame.
 * @param kind        MIMO_BODY, MIMO_GEOM, MIMO_SITE or MIMO_CAMERA.
 * @param axes        a MIMO_AXES_ constant.
 * @param value_count length of poses: seven times mimo_env_count.
 * A camera looks along its own -z axis in libmimo's frame, and along the converted axis in another one.
 */
MIMO_API mimo_status mimo_env_poses(const mimo_env *env, mimo_kind kind, int32_t axes, float *poses,
                                    size_t value_count) MIMO_NOEXCEPT;

/**
 * A geom as triangles, in the geom's own frame: they move with its pose. Call mimo_env_mesh twice: with NULL for the
 * arrays, to learn the numbers of vertices and indices, and again with arrays of that size.
 */
typedef struct mimo_mesh {
  uint32_t struct_size;   /**< sizeof(mimo_mesh), set by mimo_mesh_init. */
  int32_t axes;           /**< In: a MIMO_AXES_ constant. It also sets the order of a triangle's corners, seen from
                               outside: counter-clockwise, in Unity and Godot clockwise. */
  uint32_t segments;      /**< In: level of detail: segments of a circle, a multiple of 4, 4 to 256. Default 24. */
  uint32_t reserved;      /**< 0. */
  double plane;           /**< In: half the size of infinite planes, m, > 0. Default 20. */
  float *positions;       /**< In: three for each vertex, or NULL. */
  float *normals;         /**< In: three for each vertex, length 1, or NULL. */
  float *texcoords;       /**< In: two for each vertex, or NULL. (0, 0) is the start of the texture's first row; flat
                               textures repeat beyond 0 and 1. Zeros if the geom has no texture. */
  uint32_t *indices;      /**< In: three for each triangle, or NULL. */
  size_t vertex_capacity; /**< In: number of vertices that fit into the arrays. */
  size_t index_capacity;  /**< In: number of indices that fit. */
  size_t vertex_count;    /**< Out. */
  size_t index_count;     /**< Out. */
} mimo_mesh;

/** Fills a mesh with defaults: no arrays, libmimo's frame. */
MIMO_API mimo_status mimo_mesh_init(mimo_mesh *mesh, size_t size) MIMO_NOEXCEPT;

/**
 * A geom as triangles. Meshes and height fields of the model are copied as they are, independent of segments. Skins,
 * tendons and sites, which MuJoCo also draws, are not available.
 * Errors: MIMO_E_BUFFER_TOO_SMALL, with nothing written; the message gives the required sizes.
 */
MIMO_API mimo_status mimo_env_mesh(const mimo_env *env, int32_t geom, mimo_mesh *mesh) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
