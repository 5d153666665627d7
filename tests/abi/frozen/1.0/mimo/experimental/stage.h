/**
 * @file mimo/experimental/stage.h
 * A stage: shapes, surfaces, lights, materials and textures from plain arrays, moved by poses, drawn on the CPU by the
 * ray renderer of infants' eyes. It needs no simulation, no display and no graphics card, and knows no mjModel: any
 * engine can fill the arrays, and those of MuJoCo 2.2 to 4 are given as they lie in memory.
 *
 * Lengths are metres; the world is right-handed. Matrices are row by row. Pictures have the top row first. A stage has
 * no state but its arrays: the same arrays, poses and view give the same bytes, on any number of threads and any
 * processor. Structs of this header without an _init function are zeroed and given their sizeof in struct_size.
 */
#ifndef MIMO_EXPERIMENTAL_STAGE_H
#define MIMO_EXPERIMENTAL_STAGE_H

#include "../log.h"
#include "engine.h"
#include "looks.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Things that can be drawn. Its arrays are copied: the caller's are free after each call. */
typedef struct mimo_stage mimo_stage;

/*
 * Forms of shapes, numbered as MuJoCo's types of geoms, and the three numbers of their size. A shape's frame is in its
 * middle.
 */
#define MIMO_FORM_PLANE 0     /**< z = 0, seen from above: half sides along x and y, 0 for an endless one; unused. */
#define MIMO_FORM_FIELD 1     /**< A height field, which has its own size. */
#define MIMO_FORM_SPHERE 2    /**< Radius. */
#define MIMO_FORM_CAPSULE 3   /**< Along z: radius, half length of the straight part. */
#define MIMO_FORM_ELLIPSOID 4 /**< Three radii. */
#define MIMO_FORM_CYLINDER 5  /**< Along z: radius, half length. */
#define MIMO_FORM_BOX 6       /**< Three half sides. */
#define MIMO_FORM_MESH 7      /**< A mesh, which has its own size. */
#define MIMO_FORM_DISTANCE 8  /**< A signed distance field, drawn as its mesh. */

/**
 * Shapes: geoms, or sites. A shape whose form is none of MIMO_FORM_ is not drawn, and the log tells so once. Sizes are
 * finite and not negative.
 */
typedef struct mimo_stage_shapes {
  uint32_t struct_size;     /**< sizeof(mimo_stage_shapes), set by the caller. */
  int32_t object_type;      /**< What segmentation gives as their type, for example MuJoCo's 5 (geom) or 6 (site). */
  size_t count;             /**< How many. */
  const int32_t *forms;     /**< count: MIMO_FORM_ constants. */
  const double *sizes;      /**< count x 3, m. */
  const float *colors;      /**< count x 4: red, green, blue, opacity, 0 to 1. As in MuJoCo, exactly .5 .5 .5 1 stands
                                 for the material's colour. */
  const int32_t *materials; /**< count: a material or -1; NULL: none. */
  const int32_t *groups;    /**< count: groups 0 to 5, which views show or hide; less is 0, more is 5. NULL: all 0. */
  const int32_t *data;      /**< count: the mesh or height field of shapes that have one; NULL where none has. */
} mimo_stage_shapes;

/**
 * Triangle meshes, one after the other in each array, in the frames of the shapes that show them. Corners of a triangle
 * go counter-clockwise, seen from outside.
 */
typedef struct mimo_stage_meshes {
  uint32_t struct_size;              /**< sizeof(mimo_stage_meshes), set by the caller. */
  uint32_t reserved;                 /**< 0. */
  size_t count;                      /**< How many meshes. */
  const int32_t *vertex_counts;      /**< count: vertices of each mesh. */
  const int32_t *normal_counts;      /**< count: normals of each mesh, 0 for none: they then follow from the triangles.
                                          NULL: none has any. */
  const int32_t *texcoord_counts;    /**< count: texture coordinates of each mesh, 0 for none. NULL: none has any. */
  const int32_t *triangle_counts;    /**< count: triangles of each mesh. */
  const float *vertices;             /**< vertex_total x 3, m. */
  size_t vertex_total;               /**< Sum of vertex_counts. */
  const float *normals;              /**< normal_total x 3. */
  size_t normal_total;               /**< Sum of normal_counts. */
  const float *texcoords;            /**< texcoord_total x 2; (0, 0) is the start of the texture's first row. */
  size_t texcoord_total;             /**< Sum of texcoord_counts. */
  const int32_t *triangles;          /**< triangle_total x 3 vertices, each counted from its mesh's first. */
  const int32_t *normal_triangles;   /**< triangle_total x 3 normals, likewise; NULL: as triangles. */
  const int32_t *texcoord_triangles; /**< triangle_total x 3 texture coordinates, likewise; NULL: as triangles. */
  size_t triangle_total;             /**< Sum of triangle_counts. */
} mimo_stage_meshes;

/** Height fields: a grid of heights over a rectangle, with walls and a bottom. */
typedef struct mimo_stage_fields {
  uint32_t struct_size;   /**< sizeof(mimo_stage_fields), set by the caller. */
  uint32_t reserved;      /**< 0. */
  size_t count;           /**< How many. */
  const int32_t *rows;    /**< count: rows of each, along y, at least 2. */
  const int32_t *columns; /**< count: columns of each, along x, at least 2. */
  const double *sizes;    /**< count x 4, m: half sides along x and y, height of a 1, thickness below 0. */
  const float *heights;   /**< height_total: rows x columns of each field, one field after the other. */
  size_t height_total;    /**< How many there are. */
} mimo_stage_fields;

/** Textures. The first one of type MIMO_TEXTURE_SKY is the sky. */
typedef struct mimo_stage_textures {
  uint32_t struct_size;    /**< sizeof(mimo_stage_textures), set by the caller. */
  uint32_t reserved;       /**< 0. */
  size_t count;            /**< How many. */
  const int32_t *types;    /**< count: MIMO_TEXTURE_ constants. */
  const int32_t *widths;   /**< count: pixels, at least 1. */
  const int32_t *heights;  /**< count: pixels, at least 1; of a cube or sky the width (one picture for all six sides) or
                                six times the width (right, left, up, down, front, back). */
  const int32_t *channels; /**< count: bytes of a pixel: 1 or 2 (grey first), 3 or 4 (red, green, blue). NULL: 3. */
  const uint8_t *pixels;   /**< pixel_bytes: row after row, one texture after the other. */
  size_t pixel_bytes;      /**< Length of pixels. */
  const uint8_t *srgb;     /**< count: 1: colours of pixels are coded by sRGB and decoded before light falls on them, as
                                MuJoCo does with flat textures whose tex_colorspace is mjCOLORSPACE_SRGB; 0: they are
                                lit as they are; NULL: 0. */
} mimo_stage_textures;

/** Materials. Numbers are 0 to 1 where nothing else is said. */
typedef struct mimo_stage_materials {
  uint32_t struct_size;     /**< sizeof(mimo_stage_materials), set by the caller. */
  uint32_t from_corner;     /**< Where a flat texture begins on a shape without texture coordinates. 0: in the middle, as
                                 up to MuJoCo 3.11. 1: at the end of -x and +y, except on endless planes, as from
                                 MuJoCo 3.12 on. */
  size_t count;             /**< How many. */
  const float *colors;      /**< count x 4: red, green, blue, opacity; multiplied with the texture. */
  const float *emission;    /**< count: share of its colour that it emits; NULL: 0. */
  const float *specular;    /**< count: strength of highlights; NULL: .5. */
  const float *shininess;   /**< count: their sharpness, Phong's exponent over 128; NULL: .5. */
  const float *reflectance; /**< count: share of light that it mirrors; the first opaque plane or box that has some
                                 is the picture's one mirror, with its upper side. NULL: 0. */
  const int32_t *textures;  /**< count: a texture or -1; NULL: none. */
  const float *repeats;     /**< count x 2: how often a flat texture repeats along x and y; NULL: 1. */
  const uint8_t *uniform;   /**< count: 1: repeats (and cubes) are per metre, 0: per shape; NULL: 0. */
} mimo_stage_materials;

/**
 * Surfaces whose vertices move: skins, cloth, soft bodies, ropes. Normals follow from the triangles. Vertices are in the
 * world's frame.
 */
typedef struct mimo_stage_surfaces {
  uint32_t struct_size;             /**< sizeof(mimo_stage_surfaces), set by the caller. */
  uint32_t reserved;                /**< 0. */
  size_t count;                     /**< How many. */
  const int32_t *vertex_counts;     /**< count: vertices of each. */
  const int32_t *element_counts;    /**< count: triangles of each, or rods. */
  const int32_t *corners;           /**< count: 3: its elements are triangles; 2: rods between two vertices, whose ends
                                         are round. NULL: 3. */
  const int32_t *texcoord_counts;   /**< count: texture coordinates of each, 0 for none. NULL: none has any. */
  const double *vertices;           /**< vertex_total x 3, m: where they lie at rest; finite. Poses give where they are;
                                         these settle how rays look for the triangles. */
  size_t vertex_total;              /**< Sum of vertex_counts. */
  const int32_t *elements;          /**< element_length vertices, corners of them for each element, counted from its
                                         surface's first. Triangles go counter-clockwise, seen from outside. */
  const int32_t *texcoord_elements; /**< element_length texture coordinates, likewise; NULL: as elements. */
  size_t element_length;            /**< Sum of corners x element_counts. */
  const float *texcoords;           /**< texcoord_total x 2. */
  size_t texcoord_total;            /**< Sum of texcoord_counts. */
  const float *radii;               /**< count: m, finite, not negative: radius of rods; triangles are drawn so far
                                         outside of their vertices. NULL: 0. */
  const uint8_t *sheets;            /**< count: 1: it has two sides, so far apart as twice its radius, and an edge
                                         between; 0: it is closed. NULL: 0. */
  const uint8_t *flat;              /**< count: 1: each triangle has one normal; 0: they are smoothed. NULL: 0. */
  const float *colors;              /**< count x 4, as of shapes. */
  const int32_t *materials;         /**< count: a material or -1; NULL: none. */
  const int32_t *groups;            /**< count, as of shapes. */
  const int32_t *objects;           /**< count x 2: what segmentation gives, id and type; NULL: its number and 0. */
} mimo_stage_surfaces;

/** Tendons: strings along paths that poses give. */
typedef struct mimo_stage_tendons {
  uint32_t struct_size;     /**< sizeof(mimo_stage_tendons), set by the caller. */
  int32_t object_type;      /**< What segmentation gives as their type, for example MuJoCo's 18. */
  size_t count;             /**< How many. */
  const double *widths;     /**< count: their radii, m; half of that where they wrap around something. */
  const float *colors;      /**< count x 4, as of shapes. */
  const int32_t *materials; /**< count: a material or -1; NULL: none. */
  const int32_t *groups;    /**< count, as of shapes. */
} mimo_stage_tendons;

#define MIMO_LAMP_SPOT 0  /**< A cone from a position. */
#define MIMO_LAMP_SUN 1   /**< Parallel light along a direction. */
#define MIMO_LAMP_POINT 2 /**< From a position in all directions. */

/**
 * Lights, by MuJoCo's model: ambient and diffuse parts, and highlights after Phong. A view shows eight, the headlight
 * among them; the log tells once of more. A light of another type does not shine, and the log tells so once.
 */
typedef struct mimo_stage_lights {
  uint32_t struct_size;        /**< sizeof(mimo_stage_lights), set by the caller. */
  uint32_t reserved;           /**< 0. */
  size_t count;                /**< How many. */
  const int32_t *types;        /**< count: MIMO_LAMP_ constants. */
  const uint8_t *active;       /**< count: 1: it is on; NULL: all are. */
  const uint8_t *casts_shadow; /**< count: 1: it casts shadows; NULL: all do. */
  const float *ambient;        /**< count x 3: red, green, blue; NULL: 0. */
  const float *diffuse;        /**< count x 3; NULL: .7. */
  const float *specular;       /**< count x 3; NULL: .3. */
  const float *attenuation;    /**< count x 3: strength at d metres is divided by a0 + a1 d + a2 d^2; NULL: 1 0 0. */
  const float *cutoff;         /**< count: half angle of the cone, degrees; 180: all directions. NULL: 45. */
  const float *exponent;       /**< count: concentration towards the middle of the cone; NULL: 10. */
} mimo_stage_lights;

/** What a stage is in: how near and far its cameras see, haze and fog, and the light that every camera carries. */
typedef struct mimo_stage_air {
  uint32_t struct_size; /**< sizeof(mimo_stage_air), set by mimo_stage_air_init. */
  uint32_t headlight;   /**< 1: the camera carries a light. Default 1. */
  double near_plane;    /**< m, > 0: nothing nearer is drawn. Default .01. */
  double far_plane;     /**< m, > near_plane: nothing farther is drawn. Default 50. */
  double fog_start;     /**< m: where fog begins. Default 3. */
  double fog_end;       /**< m: where nothing else is seen. Default 10. */
  double haze;          /**< Height of the haze at the horizon, a share of the sky, 0 to 1. Default .3. */
  float fog_color[3];   /**< Red, green, blue. Default black. */
  float haze_color[3];  /**< Likewise. Default white. */
  float ambient[3];     /**< Of the headlight. Default .1. */
  float diffuse[3];     /**< Likewise. Default .4. */
  float specular[3];    /**< Likewise. Default .5. */
  uint32_t reserved;    /**< 0. */
  double sun_reach;     /**< m: lights of parallel rays let things cast shadows that are in front of their position and
                             no farther from their axis, to each side, as the shadow maps of MuJoCo's OpenGL do; 0
                             (default): all things. */
} mimo_stage_air;

/**
 * Fills it with MuJoCo's defaults for a scene of 1 m.
 * @param size sizeof(mimo_stage_air) as the caller knows it.
 */
MIMO_API mimo_status mimo_stage_air_init(mimo_stage_air *air, size_t size) MIMO_NOEXCEPT;

/** What a stage is made of. A part that is NULL has no elements; air then has its defaults. */
typedef struct mimo_stage_config {
  uint32_t struct_size;                  /**< sizeof(mimo_stage_config), set by the caller. */
  uint32_t threads;                      /**< That draw, the caller's among them, 1 to 256; 0: 1. */
  const mimo_stage_shapes *geoms;        /**< Shapes. */
  const mimo_stage_shapes *sites;        /**< Further shapes, that poses move apart. */
  const mimo_stage_meshes *meshes;       /**< Meshes. */
  const mimo_stage_fields *fields;       /**< Height fields. */
  const mimo_stage_textures *textures;   /**< Textures. */
  const mimo_stage_materials *materials; /**< Materials. */
  const mimo_stage_surfaces *surfaces;   /**< Surfaces. */
  const mimo_stage_tendons *tendons;     /**< Tendons. */
  const mimo_stage_lights *lights;       /**< Lights. */
  const mimo_stage_air *air;             /**< The rest. */
  mimo_log_fn log;                       /**< Receives messages during calls on the stage, or NULL: a warning for each
                                              thing that is not drawn, once. */
  void *log_user;                        /**< Passed to log. */
} mimo_stage_config;

/**
 * Makes a stage. All arrays are copied.
 * @param stage receives the handle; destroy it with mimo_stage_destroy.
 * Errors: MIMO_E_INVALID_ARGUMENT for arrays that are missing or do not fit each other, indices of what is not there
 *         and numbers that are not finite, with the array, the place and the value; MIMO_E_UNSUPPORTED for meshes and
 *         textures that are too large for the ray renderer (about 89 million triangles, 536 million texels).
 */
MIMO_API mimo_status mimo_stage_create(const mimo_stage_config *config, mimo_stage **stage) MIMO_NOEXCEPT;

/** Destroys a stage. NULL and destroyed handles are ignored. */
MIMO_API void mimo_stage_destroy(mimo_stage *stage) MIMO_NOEXCEPT;

/**
 * Replaces the parts that are given, all at once, and leaves the others as they are: for other colours, lights, sizes, a
 * changed texture. Geoms, sites, materials, tendons, lights and air cost little, so that it may be called before every
 * picture; meshes, fields, textures and surfaces are prepared anew.
 * @param config threads is 0 and log NULL: both stay.
 * Errors: as mimo_stage_create; the stage then stays as it is.
 */
MIMO_API mimo_status mimo_stage_update(mimo_stage *stage, const mimo_stage_config *config) MIMO_NOEXCEPT;

/**
 * Where all things are. Arrays are read during the call only; those of MuJoCo's mjData fit as they lie (geom_xpos,
 * geom_xmat, light_xdir, flexvert_xpos, wrap_xpos, ...). Numbers are finite. A count that is 0 is fine where the stage
 * has none of it, or where none of it is to be drawn: a stage with sites need not be given their places.
 */
typedef struct mimo_stage_poses {
  uint32_t struct_size;           /**< sizeof(mimo_stage_poses), set by the caller. */
  uint32_t reserved;              /**< 0. */
  size_t geom_count;              /**< As of the stage, or 0. */
  const double *geom_positions;   /**< geom_count x 3, m. */
  const double *geom_rotations;   /**< geom_count x 9, from the shape's frame to the world's; or NULL, and: */
  const double *geom_quaternions; /**< geom_count x 4: w x y z of length 1. */
  size_t site_count;              /**< As of the stage, or 0. */
  const double *site_positions;   /**< site_count x 3, m. */
  const double *site_rotations;   /**< site_count x 9, as of geoms. */
  const double *site_quaternions; /**< site_count x 4, as of geoms. */
  size_t light_count;             /**< As of the stage, or 0. */
  const double *light_positions;  /**< light_count x 3, m. */
  const double *light_directions; /**< light_count x 3: where they shine to, of length 1. */
  size_t vertex_count;            /**< As of the stage's surfaces, or 0. */
  const double *vertices;         /**< vertex_count x 3, m: of all surfaces, one after the other. */
  size_t tendon_count;            /**< As of the stage, or 0. */
  const int32_t *tendon_first;    /**< tendon_count: the first point of each path. */
  const int32_t *tendon_points;   /**< tendon_count: how many points it has; 0 for none. */
  const double *path_points;      /**< path_count x 3, m. */
  const int32_t *path_objects;    /**< path_count: -2: a pulley, where the path is interrupted; two points side by side
                                       with 0 or more: it wraps around something between them. NULL: all -1. */
  size_t path_count;              /**< Points of all paths. */
  size_t extra_count;             /**< Shapes of this picture alone: contacts, arrows, a marker. */
  const int32_t *extra_forms;     /**< extra_count: MIMO_FORM_ constants but field, mesh and distance. */
  const double *extra_sizes;      /**< extra_count x 3, m. */
  const double *extra_positions;  /**< extra_count x 3, m. */
  const double *extra_rotations;  /**< extra_count x 9. */
  const float *extra_colors;      /**< extra_count x 4, as of shapes. */
  const int32_t *extra_materials; /**< extra_count: a material or -1; NULL: none. */
  const int32_t *extra_objects;   /**< extra_count x 2: what segmentation gives, id and type; NULL: -1 -1. */
} mimo_stage_poses;

/**
 * A picture: from where, how, and into which buffers. A part whose buffer is NULL is not drawn. Strides are the distance
 * from one row to the next, at least a row; 0: a row.
 */
typedef struct mimo_stage_view {
  uint32_t struct_size;       /**< sizeof(mimo_stage_view), set by mimo_stage_view_init. */
  uint32_t pose;              /**< Which of the poses it shows. Default 0. */
  uint32_t width;             /**< Pixels, 1 to 16384. Default 320. */
  uint32_t height;            /**< Pixels, 1 to 16384. Default 240. */
  uint32_t render;            /**< MIMO_RENDER_ bits. Default: all but fog. */
  uint32_t samples;           /**< Rays per pixel of colours: 1, 4, 16 or 64; 0 (default): 1. Depth and segmentation are
                                   those of the middle of the pixel. */
  uint32_t geom_groups;       /**< Bit n: geoms of group n are shown. Default 0x7: groups 0, 1 and 2. */
  uint32_t site_groups;       /**< Likewise. Default 0x7. */
  uint32_t surface_groups;    /**< Likewise. Default 0x7. */
  uint32_t tendon_groups;     /**< Likewise. Default 0x7. */
  const double *position;     /**< 3: where the camera is, m. */
  const double *rotation;     /**< 9: from the camera's frame (x right, y up, z backward) to the world's. */
  double fovy;                /**< Vertical field of view, degrees, > 0 and < 180. Default 45. */
  double focal_x;             /**< Focal length along x, pixels, > 0; 0 (default): fovy counts. */
  double focal_y;             /**< Likewise along y. */
  double center_x;            /**< With focal lengths: the principal point, pixels from the left edge. */
  double center_y;            /**< Likewise from the upper edge. */
  uint8_t *rgb;               /**< height x width x 3: red, green, blue. */
  size_t rgb_bytes;           /**< Length of rgb. */
  size_t rgb_stride;          /**< Bytes. */
  float *depth;               /**< height x width: metres along the camera's axis, the far plane where nothing is. */
  size_t depth_count;         /**< Length of depth. */
  size_t depth_stride;        /**< Numbers. */
  int32_t *segmentation;      /**< height x width x 2: id and type of the object, -1 -1 where nothing is. What is
                                   transparent counts as opaque. */
  size_t segmentation_count;  /**< Length of segmentation. */
  size_t segmentation_stride; /**< Numbers. */
  double ortho_height;        /**< m, > 0: an orthographic camera, which sees so much from the lower edge to the upper
                                   one; fovy does not count then, and focal lengths are 0. 0 (default): a perspective. */
} mimo_stage_view;

/**
 * Fills a view with defaults: no buffers, and no camera, which has to be set.
 * @param size sizeof(mimo_stage_view) as the caller knows it.
 */
MIMO_API mimo_status mimo_stage_view_init(mimo_stage_view *view, size_t size) MIMO_NOEXCEPT;

/**
 * Draws pictures: one, several views of one pose, or many poses of the stage side by side, on the stage's threads.
 * Buffers of different views must not overlap.
 * @param poses      pose_count pointers: what views show.
 * @param pose_count at least 1.
 * @param views      view_count pointers.
 * @param view_count how many pictures.
 * Errors: MIMO_E_INVALID_ARGUMENT for poses that do not fit the stage or are not finite, and for views that cannot be;
 *         MIMO_E_BUFFER_TOO_SMALL. Nothing is drawn then, in none of the views.
 */
MIMO_API mimo_status mimo_stage_draw(mimo_stage *stage, const mimo_stage_poses *const *poses, size_t pose_count,
                                     const mimo_stage_view *const *views, size_t view_count) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
