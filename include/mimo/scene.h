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

/** A description of a simulation. It may be changed or destroyed once environments exist: they are not affected. */
typedef struct mimo_scene mimo_scene;

/** The document that a scene starts from. Set at most one of name, file and xml; without any the world is empty. */
typedef struct mimo_scene_config {
  uint32_t struct_size;  /**< sizeof(mimo_scene_config), set by mimo_scene_config_init. */
  uint32_t reserved;     /**< 0. */
  const char *name;      /**< A built-in scene: "reach", "benchmark", ...; see mimo_scene_name. */
  const char *file;      /**< Path of an MJCF file. Its includes may name built-in files as "mimo/mitten.xml". */
  const char *xml;       /**< MJCF text; its relative paths start from the working directory. */
  const char *model_dir; /**< A folder with built-in models to use in place of the library's own, or NULL. */
  mimo_log_fn log;       /**< Receives messages about the scene, or NULL. */
  void *log_user;        /**< Passed to log. */
  /* Limits of documents; 0 means the default. A document that exceeds one is refused with MIMO_E_MODEL. */
  uint64_t max_file_bytes;  /**< Bytes of each file that is read. Default 268435456. */
  uint64_t max_pixels;      /**< Pixels of a texture, height field or shadow map. Default 67108864. */
  uint64_t max_vertices;    /**< Vertices of a mesh or skin, and its faces. Default 1000000. */
  uint64_t max_elements;    /**< Elements of the document, including those of composites. Default 40000. */
  uint64_t max_keyframes;   /**< Default 10000. */
  uint64_t max_iterations;  /**< Iterations of each solver in a physics step. Default 10000. */
  uint64_t max_world_bytes; /**< Estimated bytes of one world and its model (textures, meshes, ...). Default 4294967296;
                                 MuJoCo 2.2 itself allows a model of 2147483647 bytes. */
  uint32_t confined;        /**< 1: includes and assets must lie in the folder of the document that names them, or
                                 below; 0: anywhere. */
  uint32_t limits_reserved; /**< 0. */
  uint64_t max_compile_ms;  /**< Estimated milliseconds of MuJoCo's compiler, on one core of a processor of 2022. While
                                 it runs, the process makes no other world. Above 1000 a message is logged. Default
                                 10000. */
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
 * Gives a room to a scene without one: floor, sky, light, and a place for an infant. The scene's own settings of
 * solver, statistics and pictures stay.
 * Errors: MIMO_E_NOT_FOUND for an unknown room; MIMO_E_INVALID_ARGUMENT for a scene that already has a room or a floor.
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
  const char *name;      /**< Name of its body and its geom; required, unique among bodies and geoms. */
  double size[3];        /**< Metres, by shape; entries that the shape does not use have no effect. */
  double position[3];    /**< Metres, world frame. */
  double orientation[4]; /**< w x y z; need not be normalised. */
  double mass;           /**< Kilograms; 0: a density of 1000 kg/m^3. */
  double rgba[4];        /**< Colour, 0 to 1. */
  uint32_t fixed;        /**< 1: part of the world; 0: it moves freely. */
  uint32_t reserved;     /**< 0. */
} mimo_object_config;

/**
 * Fills a config with defaults: a red sphere of 4 cm radius and 0.1 kg at the origin, free to move, without a name.
 * @param size sizeof(mimo_object_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_object_config_init(mimo_object_config *config, size_t size) MIMO_NOEXCEPT;

/** Adds an object. Errors: MIMO_E_INVALID_ARGUMENT for sizes, mass or colours out of range and for a name in use. */
MIMO_API mimo_status mimo_scene_add_object(mimo_scene *scene, const mimo_object_config *config) MIMO_NOEXCEPT;

/** An object described by its own MJCF document: a toy with parts, a piece of furniture, a robot. */
typedef struct mimo_model_config {
  uint32_t struct_size;  /**< sizeof(mimo_model_config), set by mimo_model_config_init. */
  uint32_t fixed;        /**< 1: it gets no free joint; 0: it moves freely, unless its body has joints of its own. */
  const char *name;      /**< Required: letters, digits, '_', '-', '.'. With a '/' it precedes all names of the
                              document. */
  const char *file;      /**< Path of an MJCF file; its includes and meshes are relative to its folder. */
  const char *xml;       /**< Or MJCF text; relative paths start from the working directory. */
  double position[3];    /**< Position of its body, metres, world frame; replaces the document's. */
  double orientation[4]; /**< w x y z; need not be normalised. */
} mimo_model_config;

/**
 * Fills a config with defaults: at the origin, free to move, without a name and a document.
 * @param size sizeof(mimo_model_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_model_config_init(mimo_model_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Adds an MJCF document as an object. The single body in its worldbody becomes the object, with its assets, contacts,
 * equalities, tendons, actuators, sensors and custom elements. The object's name precedes all their names
 * ("cup/handle"), so the same document can be added several times. A free joint, and a body without a name, get the
 * object's name. The document's main defaults apply to the object alone; the scene's do not apply to it. Angles, euler
 * angles and automatic limits are converted to the scene's settings. Everything else in its worldbody (floor, lights)
 * is left out, and so are its solver options, keyframes, sizes and visual settings: the scene's apply. The scene's
 * keyframes are removed, because they hold positions of fewer joints.
 * Errors: MIMO_E_NOT_FOUND for a file that cannot be read; MIMO_E_MODEL for a document that is not MJCF, does not have
 * exactly one body, or does not compile where its compiler settings weigh all its bodies (settotalmass, ...);
 * MIMO_E_UNSUPPORTED for global coordinates, and for such settings in a document with a composite;
 * MIMO_E_INVALID_ARGUMENT for a name in use, and for fixed = 1 where the body has a free joint.
 */
MIMO_API mimo_status mimo_scene_add_model(mimo_scene *scene, const mimo_model_config *config) MIMO_NOEXCEPT;

/**
 * Welds a body to another one or to the world, by a soft constraint of the solver.
 * @param body  name of a body in the scene, "anna/left_hand".
 * @param other name of the body that it is welded to; NULL: the world.
 * @param pose  pose of the body in the other's frame: position (m) and quaternion w x y z; NULL: their relative pose
 *              at the scene's start, with everything that is added and posed before an environment is made.
 * Errors: MIMO_E_NOT_FOUND for an unknown body; the message lists the scene's bodies.
 */
MIMO_API mimo_status mimo_scene_weld(mimo_scene *scene, const char *body, const char *other,
                                     const double *pose) MIMO_NOEXCEPT;

/**
 * Locks a hinge or slide at a value by a soft constraint, and starts it there. mimo_env_set (MIMO_JOINT_LOCK) releases
 * it. Position control takes over the locks of the joints that it moves.
 * @param joint name of a joint in the scene, "anna/robot:left_knee".
 * @param value rad or m, within the joint's range.
 * Errors: MIMO_E_NOT_FOUND for an unknown joint; the message lists the scene's joints.
 */
MIMO_API mimo_status mimo_scene_lock(mimo_scene *scene, const char *joint, double value) MIMO_NOEXCEPT;

/**
 * Sets the start value of a hinge or slide. Resets restore it before a task changes it.
 * @param joint name of a joint in the scene, of an infant, an object or an added model.
 * @param value rad or m, within the joint's range.
 * Errors: as mimo_scene_lock.
 */
MIMO_API mimo_status mimo_scene_set_pose(mimo_scene *scene, const char *joint, double value) MIMO_NOEXCEPT;

/** A camera whose pictures are fields: "vision/NAME", "vision/NAME_depth", "vision/NAME_segmentation". */
typedef struct mimo_camera_config {
  uint32_t struct_size; /**< sizeof(mimo_camera_config), set by mimo_camera_config_init. */
  uint32_t outputs;     /**< MIMO_VISION_ bits, at least one. Default MIMO_VISION_RGB. */
  const char *name;     /**< A camera of the scene's MJCF or of an infant, "anna/eye_left"; with placed = 1 the name
                             of a new one. */
  uint32_t width;       /**< Pixels, 1 to 4096. Default 256. */
  uint32_t height;      /**< Pixels, 1 to 4096. Default 256. */
  double fovy;          /**< Vertical field of view in degrees, 1 to 170; 0: the camera's own, 45 for a new one. */
  uint32_t placed;      /**< 1: make the camera, placed by the members below; 0: it is in the model. */
  uint32_t reserved;    /**< 0. */
  const char *body;     /**< Name in the model of the body that carries it; NULL: it is fixed in the world. */
  double position[3];   /**< Its position, metres, in the frame of the body. */
  double look_at[3];    /**< The point in the middle of its picture, metres, in the frame of the body, whose z axis
                             points up in the picture. */
} mimo_camera_config;

/**
 * Fills a config with defaults: a camera of the model, without a name; a new one looks from (1.5, 0, 0.8) at (0, 0,
 * 0.4).
 * @param size sizeof(mimo_camera_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_camera_config_init(mimo_camera_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Adds a camera's pictures to the observation. Its fields follow the fields of all agents and belong to the scene.
 * Errors: MIMO_E_NOT_FOUND for an unknown body, and from mimo_env_create for a camera that the model does not have;
 *         MIMO_E_INVALID_ARGUMENT for a camera that is already observed, or a new one whose name is in use.
 */
MIMO_API mimo_status mimo_scene_add_camera(mimo_scene *scene, const mimo_camera_config *config) MIMO_NOEXCEPT;

/**
 * A further field of the observation, of type MIMO_F32: a quantity of chosen elements of the scene, which mimo_env_get
 * would read otherwise. Its shape is elements x values of each; (elements) where each has one value; one axis of all
 * values where their numbers differ; for a MIMO_WORLD_ quantity its values.
 */
typedef struct mimo_field_config {
  uint32_t struct_size;        /**< sizeof(mimo_field_config), set by mimo_field_config_init. */
  mimo_quantity quantity;      /**< A quantity of access.h, except of contacts, whose number varies. Poses and
                                    velocities of bodies belong to the start of the last physics step, with MIMO_NOW to
                                    the end of the step. */
  const char *name;            /**< Name of the field, "toys/position"; required, unique among fields. */
  const char *const *elements; /**< Names of bodies, joints, sites, sensors...; "" for the agent of a scene with one. */
  size_t element_count;        /**< Length of elements, at least 1; 0 for a MIMO_WORLD_ quantity. */
  const char *relative_to;     /**< For positions, orientations, poses and velocities: the body whose moving frame they
                                    are expressed in; NULL: the world frame. */
} mimo_field_config;

/**
 * Fills a config with defaults: MIMO_BODY_POSITION in the world frame, without a name and elements.
 * @param size sizeof(mimo_field_config) as the caller knows it.
 */
MIMO_API mimo_status mimo_field_config_init(mimo_field_config *config, size_t size) MIMO_NOEXCEPT;

/**
 * Adds a quantity to the observation. Its field follows the fields of all agents and cameras and belongs to the scene;
 * limits of senses do not apply to it.
 * Errors: MIMO_E_INVALID_ARGUMENT for a name in use, a quantity that cannot be observed, relative_to for a quantity
 *         without a frame; MIMO_E_UNSUPPORTED for an unknown quantity. From mimo_env_create and mimo_senses_attach:
 *         MIMO_E_NOT_FOUND for an element that the model does not have, with a list of its elements;
 *         MIMO_E_UNSUPPORTED for quantities that attached senses do not have, such as goals.
 */
MIMO_API mimo_status mimo_scene_add_field(mimo_scene *scene, const mimo_field_config *config) MIMO_NOEXCEPT;

/**
 * Writes the scene as one MJCF document, as MuJoCo will compile it. Files that it names "mimo/..." are built in and
 * installed as share/mimo/models.
 * Errors: MIMO_E_MODEL for a scene that does not compile, where a relative pose (mimo_scene_weld) or an infant's place
 *         has to be computed.
 * @param text   receives the document, zero-terminated; NULL with capacity 0 asks only for the size.
 * @param length receives the length without the terminating zero; may be NULL.
 */
MIMO_API mimo_status mimo_scene_xml(const mimo_scene *scene, char *text, size_t capacity,
                                    size_t *length) MIMO_NOEXCEPT;

/**
 * Writes the scene for programs without libmimo: FOLDER/scene.xml, and copies of all textures, meshes and other files
 * that it refers to in FOLDER/assets. Any program with MuJoCo can open it, on any machine.
 * @param folder is made if it does not exist. A file that exists must have the same content: nothing is overwritten.
 * Errors: MIMO_E_FILE for an existing file with other content, or one that cannot be written; MIMO_E_NOT_FOUND for a
 *         file that cannot be read; MIMO_E_MODEL as from mimo_scene_xml. Nothing, not even the folder, is then left
 *         behind.
 */
MIMO_API mimo_status mimo_scene_save(const mimo_scene *scene, const char *folder) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
