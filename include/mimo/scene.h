/**
 * @file mimo/scene.h
 * Scenes. A scene describes a room, objects, infants and cameras; environments are made from it.
 */
#ifndef MIMO_SCENE_H
#define MIMO_SCENE_H

#include "log.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A description of what is to be simulated. It may be changed or destroyed once environments exist. */
typedef struct mimo_scene mimo_scene;

/** How a scene starts. At most one of name, file and xml may be set; none of them gives an empty world. */
typedef struct mimo_scene_config {
  uint32_t struct_size;  /**< sizeof(mimo_scene_config), set by mimo_scene_config_init. */
  uint32_t reserved;     /**< 0. */
  const char *name;      /**< Built-in scene: "reach", "benchmark", ...; see mimo_scene_name. */
  const char *file;      /**< Path of an MJCF file. Its includes may name built-in files as "mimo/mitten.xml". */
  const char *xml;       /**< MJCF text; relative paths in it start from the working directory. */
  const char *model_dir; /**< Folder to take built-in models from instead of those inside the library, or NULL. */
  mimo_log_fn log;       /**< Messages about the scene's making, or NULL. */
  void *log_user;        /**< Passed to log. */
  /* What a document may ask for; 0 means the default. What asks for more is refused with MIMO_E_MODEL. */
  uint64_t max_file_bytes;  /**< Bytes of each file that is read. Default 268435456. */
  uint64_t max_pixels;      /**< Pixels of a texture, height field or shadow map. Default 67108864. */
  uint64_t max_vertices;    /**< Vertices of a mesh or skin, and its faces. Default 1000000. */
  uint64_t max_elements;    /**< Elements of the document, and those that composites become. Default 40000. */
  uint64_t max_keyframes;   /**< Default 10000. */
  uint64_t max_iterations;  /**< Iterations of each solver in a physics step. Default 10000. */
  uint64_t max_world_bytes; /**< What the buffers of one world and its model (textures, meshes, ...) may need, as
                                 estimated. Default 4294967296; MuJoCo 2.2 counts a model's bytes up to 2147483647. */
  uint32_t confined;        /**< 1: includes and assets must lie in the folder of the document that names them, or
                                 below; 0: anywhere. */
  uint32_t limits_reserved; /**< 0. */
  uint64_t max_compile_ms;  /**< Milliseconds that MuJoCo's compiler may work at the document, as estimated for one core
                                 of a processor of 2022. No other world of the process is made meanwhile; above a
                                 second log is told. Default 10000. */
} mimo_scene_config;

/**
 * Fills a config with defaults: an empty world, silent.
 * @param size sizeof(mimo_scene_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_scene_config_init(mimo_scene_config *config, size_t size) MIMO_NOEXCEPT;

/** Name of the index-th built-in scene, or NULL past the last. Static string. */
MIMO_API const char *mimo_scene_name(size_t index) MIMO_NOEXCEPT;

/**
 * Makes a scene. Parses the MJCF but compiles nothing yet. Elements may be nested 256 deep.
 * @param config NULL means defaults.
 * @param scene  receives the handle; destroy it with mimo_scene_destroy.
 */
MIMO_API mimo_status mimo_scene_create(const mimo_scene_config *config, mimo_scene **scene) MIMO_NOEXCEPT;

/** Destroys a scene. NULL and destroyed handles are ignored. Environments made from it live on. */
MIMO_API void mimo_scene_destroy(mimo_scene *scene) MIMO_NOEXCEPT;

/** Name of the index-th room ("playroom"), or NULL past the last. Static string. */
MIMO_API const char *mimo_room_name(size_t index) MIMO_NOEXCEPT;

/**
 * Gives a scene that has none a room: floor, sky, light, and a place for an infant. What the scene says itself about
 * solver, statistics and pictures stays.
 * Errors: MIMO_E_NOT_FOUND for an unknown room; MIMO_E_INVALID_ARGUMENT for a scene that has a room or a floor already.
 */
MIMO_API mimo_status mimo_scene_set_room(mimo_scene *scene, const char *name) MIMO_NOEXCEPT;

#define MIMO_SHAPE_SPHERE 1    /**< size: radius. */
#define MIMO_SHAPE_CAPSULE 2   /**< size: radius, half length of the cylindrical part (along z). */
#define MIMO_SHAPE_ELLIPSOID 3 /**< size: three radii. */
#define MIMO_SHAPE_CYLINDER 4  /**< size: radius, half length (along z). */
#define MIMO_SHAPE_BOX 5       /**< size: three half lengths. */

/** A rigid object of one primitive shape. */
typedef struct mimo_object_config {
  uint32_t struct_size;  /**< sizeof(mimo_object_config), set by mimo_object_config_init. */
  int32_t shape;         /**< A MIMO_SHAPE_ constant. */
  const char *name;      /**< Of its body and its geom; needed, unique among bodies and geoms. */
  double size[3];        /**< Metres, by shape; unused entries are ignored. */
  double position[3];    /**< Metres, world frame. */
  double orientation[4]; /**< w x y z; need not be normalised. */
  double mass;           /**< Kilograms; 0: a density of 1000 kg/m^3. */
  double rgba[4];        /**< Colour, 0 to 1. */
  uint32_t fixed;        /**< 1: part of the world; 0: it moves freely. */
  uint32_t reserved;     /**< 0. */
} mimo_object_config;

/**
 * Fills a config with defaults: a red sphere of 4 cm radius and 0.1 kg at the origin, free to move, without name.
 * @param size sizeof(mimo_object_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_object_config_init(mimo_object_config *config, size_t size) MIMO_NOEXCEPT;

/** Adds an object. Errors: MIMO_E_INVALID_ARGUMENT for sizes, mass or colours out of range and for a name in use. */
MIMO_API mimo_status mimo_scene_add_object(mimo_scene *scene, const mimo_object_config *config) MIMO_NOEXCEPT;

/** An object that is described by an MJCF document of its own: a toy with parts, a piece of furniture, a robot. */
typedef struct mimo_model_config {
  uint32_t struct_size;  /**< sizeof(mimo_model_config), set by mimo_model_config_init. */
  uint32_t fixed;        /**< 1: it gets no free joint; 0: it moves freely, unless its body has joints of its own. */
  const char *name;      /**< Needed: letters, digits, '_', '-', '.'. Goes with '/' before all names in the document. */
  const char *file;      /**< Path of an MJCF file; what it includes and its meshes lie relative to its folder. */
  const char *xml;       /**< Or MJCF text; relative paths start from the working directory. */
  double position[3];    /**< Where its body is, metres, world frame; in place of what the document says. */
  double orientation[4]; /**< w x y z; need not be normalised. */
} mimo_model_config;

/**
 * Fills a config with defaults: at the origin, free to move, without name and document.
 * @param size sizeof(mimo_model_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_model_config_init(mimo_model_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Adds an MJCF document as an object. The one body in its worldbody becomes the object, with its assets, contacts,
 * equalities, tendons, actuators, sensors and custom elements. All their names get the object's name before them,
 * "cup/handle", so the same document may be added often; the free joint, and a body without a name, have the object's.
 * Its main defaults count for it alone, and it gets none of the scene's. Angles, euler angles and automatic limits are
 * converted to the scene's settings. What else stands in its worldbody (floor, lights) does not come along, nor do its
 * solver options, keyframes, sizes and visual settings: there the scene's count. Nor do keyframes of the scene stay:
 * they are positions of other joints.
 * Errors: MIMO_E_NOT_FOUND for a file that cannot be read; MIMO_E_MODEL for a document that is no MJCF or has not just
 * one body, or that does not compile where its compiler settings weigh all its bodies (settotalmass, ...);
 * MIMO_E_UNSUPPORTED for global coordinates, and for such settings where it has a composite; MIMO_E_INVALID_ARGUMENT
 * for a name in use, and for fixed = 1 where the body has a free joint.
 */
MIMO_API mimo_status mimo_scene_add_model(mimo_scene *scene, const mimo_model_config *config) MIMO_NOEXCEPT;

/**
 * Fastens a body to another one or to the world, softly, as the solver holds things.
 * @param body  name of a body in the scene, "anna/left_hand".
 * @param other name of the one to which it is fastened; NULL: the world.
 * @param pose  where the body is in the other's frame: position (m) and quaternion w x y z; NULL: as they are to each
 *              other where the scene starts, with all that is added and posed before an environment is made.
 * Errors: MIMO_E_NOT_FOUND for a body that the scene does not have; the message lists those that it has.
 */
MIMO_API mimo_status mimo_scene_weld(mimo_scene *scene, const char *body, const char *other,
                                     const double *pose) MIMO_NOEXCEPT;

/**
 * Holds a hinge or slide, softly, and starts it there. mimo_env_set (MIMO_JOINT_LOCK) lets it go. Position control
 * takes over the locks of the joints that it moves.
 * @param joint name of a joint in the scene, "anna/robot:left_knee".
 * @param value rad or m, within the joint's range.
 * Errors: MIMO_E_NOT_FOUND for a joint that the scene does not have; the message lists those that it has.
 */
MIMO_API mimo_status mimo_scene_lock(mimo_scene *scene, const char *joint, double value) MIMO_NOEXCEPT;

/**
 * Sets where a hinge or slide starts; resets lead there, before a task changes it.
 * @param joint name of a joint in the scene, of an infant, an object or a model of your own.
 * @param value rad or m, within the joint's range.
 * Errors: as mimo_scene_lock.
 */
MIMO_API mimo_status mimo_scene_set_pose(mimo_scene *scene, const char *joint, double value) MIMO_NOEXCEPT;

/** A camera whose pictures are fields: "vision/NAME", "vision/NAME_depth", "vision/NAME_segmentation". */
typedef struct mimo_camera_config {
  uint32_t struct_size; /**< sizeof(mimo_camera_config), set by mimo_camera_config_init. */
  uint32_t outputs;     /**< MIMO_VISION_ bits, at least one. Default MIMO_VISION_RGB. */
  const char *name;     /**< A camera of the scene's MJCF or of an infant, "anna/eye_left"; with placed = 1 the name of
                             a new one. */
  uint32_t width;       /**< Pixels, 1 to 4096. Default 256. */
  uint32_t height;      /**< Pixels, 1 to 4096. Default 256. */
  double fovy;          /**< Vertical field of view in degrees, 1 to 170; 0: the camera's own, 45 for a new one. */
  uint32_t placed;      /**< 1: make the camera, where the entries below say; 0: it is there already. */
  uint32_t reserved;    /**< 0. */
  const char *body;     /**< Body that carries it, by its name in the model; NULL: it stands still in the world. */
  double position[3];   /**< Where it is, metres, in the frame of the body. */
  double look_at[3];    /**< The point in the middle of its picture, metres, in the frame of the body, whose z axis
                             points up in the picture. */
} mimo_camera_config;

/**
 * Fills a config with defaults: a camera of the model, no name yet; a new one looks from (1.5, 0, 0.8) at (0, 0, 0.4).
 * @param size sizeof(mimo_camera_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_camera_config_init(mimo_camera_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Has a camera observed. Its fields come after those of all agents and belong to the scene.
 * Errors: MIMO_E_NOT_FOUND for a body that the scene does not have, and from mimo_env_create for a camera that the
 *         model does not have; MIMO_E_INVALID_ARGUMENT for a camera that is observed already, or a new one whose name
 *         is in use.
 */
MIMO_API mimo_status mimo_scene_add_camera(mimo_scene *scene, const mimo_camera_config *config) MIMO_NOEXCEPT;

/**
 * A further field of the observation, of MIMO_F32: a quantity of parts of the scene, where a world is asked for it with
 * mimo_env_get otherwise. Its shape is elements x values of each; elements alone where they have one value each; and
 * one axis of all values where they differ in that. Of the world it is its values.
 */
typedef struct mimo_field_config {
  uint32_t struct_size;        /**< sizeof(mimo_field_config), set by mimo_field_config_init. */
  int32_t quantity;            /**< A quantity of access.h that every world has as many of: not of contacts. Poses and
                                    velocities of bodies are those of the start of the last physics step, with MIMO_NOW
                                    those of the step's end. */
  const char *name;            /**< Of the field, "toys/position"; needed; no other field has it. */
  const char *const *elements; /**< Names of bodies, joints, sites, sensors...; of agents "" for a sole one. */
  size_t element_count;        /**< Length of elements, at least 1. Not for MIMO_WORLD_: 0. */
  const char *relative_to;     /**< Of positions, orientations, poses and velocities: the body in whose frame they are,
                                    moving along with it; NULL: in the world's. */
} mimo_field_config;

/**
 * Fills a config with defaults: MIMO_BODY_POSITION in the world's frame, without name and elements.
 * @param size sizeof(mimo_field_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_field_config_init(mimo_field_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Has something observed. Its field comes after those of all agents and cameras and belongs to the scene; limits of
 * senses do not concern it.
 * Errors: MIMO_E_INVALID_ARGUMENT for a name in use, a quantity that is not observed, relative_to where nothing has a
 *         frame; MIMO_E_UNSUPPORTED for an unknown quantity. From mimo_env_create and mimo_senses_attach:
 *         MIMO_E_NOT_FOUND for what the model does not have, with a list of what it has; MIMO_E_UNSUPPORTED for what
 *         attached senses cannot know, such as goals.
 */
MIMO_API mimo_status mimo_scene_add_field(mimo_scene *scene, const mimo_field_config *config) MIMO_NOEXCEPT;

/**
 * The scene as one MJCF document, as MuJoCo will compile it; for looking at it and for other tools. Files that it
 * names "mimo/..." are the built-in ones, installed as share/mimo/models.
 * Errors: MIMO_E_MODEL where bodies are fastened as they start (mimo_scene_weld) or an infant has no place, and the
 *         scene does not compile.
 * @param text   receives the document, zero-terminated; NULL with capacity 0 asks for the size only.
 * @param length receives the length without the terminating zero; may be NULL.
 */
MIMO_API mimo_status mimo_scene_xml(const mimo_scene *scene, char *text, size_t capacity,
                                    size_t *length) MIMO_NOEXCEPT;

/**
 * Writes the scene for tools that know nothing of libmimo: FOLDER/scene.xml, and in FOLDER/assets copies of all
 * textures, meshes and other files that it refers to. Any program with MuJoCo opens it, also elsewhere.
 * @param folder made where it is not there. A file that is there already must hold the same: nothing is overwritten.
 * Errors: MIMO_E_FILE for a file that is there with other content or cannot be written; MIMO_E_NOT_FOUND for one that
 *         cannot be read; MIMO_E_MODEL as from mimo_scene_xml. Nothing has been written then, no folder either.
 */
MIMO_API mimo_status mimo_scene_save(const mimo_scene *scene, const char *folder) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
