/**
 * @file mimo/experimental/sense.h
 * Senses of your own: a table of C functions that a world runs at each physics step and in each observation. It comes
 * from your program, or from a shared library with the function mimo_sense_entry. docs/guide/write-a-sense.md writes
 * one.
 */
#ifndef MIMO_EXPERIMENTAL_SENSE_H
#define MIMO_EXPERIMENTAL_SENSE_H

#include "../access.h"
#include "../agent.h"
#include "../task.h"
#include "recording.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Version of the rules between the library and a sense. A library refuses senses of other versions. */
#define MIMO_SENSE_INTERFACE 1

/** The context of a call of a sense's function. Valid until the function returns. */
typedef struct mimo_sense_moment {
  uint32_t struct_size;     /**< Size in the library. 256 bytes are readable, zero beyond it. */
  uint32_t reserved;        /**< 0. */
  size_t world;             /**< Number of the world in its batch; 0 for a single environment. */
  size_t agent;             /**< Number of the agent. */
  const char *prefix;       /**< What the agent's fields, and an infant's names in the model, begin with: "anna/"; ""
                                 for a sole agent. */
  uint64_t tick;            /**< Physics steps since the start of the episode. 0 in open, reset and the first write. */
  double timestep;          /**< Seconds of a physics step. */
  size_t step_ticks;        /**< Physics steps of an environment step. */
  uint64_t seed;            /**< For mimo_sense_noise: follows from the world's seed, the episode, the agent and the
                                 sense's name. */
  const double *parameters; /**< Values of the sense's parameters, in the order of the table. */
  void *own;                /**< As open left it. */
  void *memory;             /**< The bytes that open asked for, 16-byte aligned, zero at the start of an episode; part of
                                 the world's state. write may only read them. NULL for none, and in open. */
  void *const *fields;      /**< In write: where the values of each field go, in the order of declaration; 64-byte
                                 aligned, all zero. NULL in the other functions. */
  size_t field_count;       /**< Length of fields; 0 where it is NULL. */
} mimo_sense_moment;

/** What a sense asks for in open. All members start as zero. */
typedef struct mimo_sense_needs {
  uint32_t struct_size; /**< Size in the library. 256 bytes are there, zero beyond it. */
  uint32_t sensors;     /**< 1: advance looks at MuJoCo's sensors, MIMO_SENSOR_VALUE or fields made of them (vestibular,
                             torques of joints): each physics step computes them then, which costs a few percent. 0: in
                             advance they may be those of the step before. */
  size_t memory_bytes;  /**< Memory for this world and agent, up to 16777216. */
  void *own;            /**< What the sense keeps for this world and agent beside its memory, such as ids that it has
                             looked up: never changed after open, and not part of the state. */
} mimo_sense_needs;

/**
 * Prepares the sense of one agent for a world that is being made: looks up ids, declares the fields
 * (mimo_sense_add_field), and says how much memory they need. Called once for each world and agent, also for clones and
 * for worlds of another age; each time it declares fields of the same names and shapes.
 * @param user   as in mimo_sense.
 * @param env    the world, for functions that take a const mimo_env and for those of its layout, which has all fields
 *               that come before the sense's own. Everything else is MIMO_E_BUSY: senses change nothing. Valid until
 *               the function returns.
 * @param moment what it is told; memory and fields are NULL.
 * @param needs  what it asks for.
 * @return MIMO_OK, or any MIMO_E_ constant: the world is then not made (MIMO_E_TASK), and the message quotes the
 *         constant and the message of mimo_fail or of the failed call. For all functions of a sense: they must not end
 *         their thread and must not longjmp out. On Linux and macOS, where program and library share an unwinder, an
 *         exception that leaves one counts as a failure. On other systems no exception may leave it; mimo.hpp catches
 *         all on every system.
 */
typedef mimo_status (*mimo_sense_open_fn)(void *user, const mimo_env *env, const mimo_sense_moment *moment,
                                          mimo_sense_needs *needs);

/**
 * Frees what open has made. Called once for each open that returned MIMO_OK.
 * @param user as in mimo_sense.
 * @param own  as open left it.
 */
typedef void (*mimo_sense_close_fn)(void *user, void *own);

/**
 * Does something at a moment of a world: at the start of an episode (reset), after a physics step (advance), or for an
 * observation (write).
 * The three see the world as it is then: positions of joints at the end of the physics step; contacts, forces and poses
 * as that step has computed them, so at its start. What they do must depend on nothing but the world, the parameters
 * and the memory: then results depend on neither frame_skip nor threads, and states and replays are exact. reset and
 * advance may change the memory. write only fills the fields: it runs as often as somebody looks, which may be never.
 * @param user   as in mimo_sense.
 * @param env    as in mimo_sense_open_fn.
 * @param moment what it is told.
 * @return as in mimo_sense_open_fn. Where one fails, the call that runs it does everything else, fills the sense's
 *         fields with 0, and then returns MIMO_E_TASK: the step has happened. The world can go on.
 */
typedef mimo_status (*mimo_sense_fn)(void *user, const mimo_env *env, const mimo_sense_moment *moment);

/**
 * Called when neither a scene nor a world has the sense any more, on any thread.
 * @param user as in mimo_sense.
 */
typedef void (*mimo_sense_release_fn)(void *user);

/**
 * A sense of your own. Worlds of a batch call its functions at the same time on several threads. The table, and all that
 * it points to except `user`, is copied.
 */
typedef struct mimo_sense {
  uint32_t struct_size;             /**< sizeof(mimo_sense), set by mimo_sense_init. */
  uint32_t interface_version;       /**< MIMO_SENSE_INTERFACE, as you compile it. */
  const char *name;                 /**< "ct": lower-case letters, digits and _, up to 63; unique among the agent's
                                         own senses. */
  const char *description;          /**< One line; NULL: none. */
  uint32_t version;                 /**< Of what the memory means: states of another version leave it fresh. */
  uint32_t host_fills;              /**< 1: the program fills the fields in the block after each call that observes;
                                         the library leaves 0 there. Then only open and close may be set. */
  const mimo_parameter *parameters; /**< Parameters, each of the size that it says, named without the sense: "rate".
                                         NULL: none. */
  size_t parameter_count;           /**< Length of parameters, up to 1000. */
  void *user;                       /**< Passed to the functions. */
  mimo_sense_open_fn open;          /**< Required. */
  mimo_sense_close_fn close;        /**< May be NULL. */
  mimo_sense_fn reset;              /**< An episode starts; may be NULL. */
  mimo_sense_fn advance;            /**< After each physics step; may be NULL. */
  mimo_sense_fn write;              /**< Required, unless the host fills the fields. */
  mimo_sense_release_fn release;    /**< May be NULL. */
} mimo_sense;

/**
 * Fills a table with defaults: no name, no functions, no parameters. Then set interface_version.
 * @param size sizeof(mimo_sense) as the caller knows it.
 */
MIMO_API mimo_status mimo_sense_init(mimo_sense *sense, size_t size) MIMO_NOEXCEPT;

/**
 * What a shared library exports under the name mimo_sense_entry.
 * @param sense the table to fill, as mimo_sense_init leaves it; of the library's size, which may differ from yours:
 *              members beyond struct_size are not there.
 * @return MIMO_OK, or a MIMO_E_ constant with the reason by mimo_fail.
 */
typedef mimo_status (*mimo_sense_entry_fn)(mimo_sense *sense);

/** A field of a sense of your own. Each agent has its own, with its prefix ("anna/ct/rate"). Limits apply to it. */
typedef struct mimo_sense_field {
  uint32_t struct_size;      /**< sizeof(mimo_sense_field), set by mimo_sense_field_init. */
  int32_t dtype;             /**< MIMO_F32 (default), MIMO_U8, MIMO_I32 or MIMO_F64. */
  const char *name;          /**< "rate" for "ct/rate"; NULL: the field has the sense's name. */
  const char *unit;          /**< "Hz"; NULL: none. */
  const char *frame;         /**< Frame of reference: "world"; NULL: none. */
  const size_t *shape;       /**< ndim sizes, each at least 1, the last one changes fastest. */
  size_t ndim;               /**< Length of shape, up to 4. 0: the field is one number. */
  double low;                /**< Smallest value. Default -infinity. */
  double high;               /**< Largest value. Default infinity. */
  const char *const *labels; /**< A name for each number; NULL: none. */
  size_t label_count;        /**< Length of labels: the product of shape. */
  const char *skin;          /**< A field of touch, "touch/force": the first axis counts receptors of it. NULL: none. */
  const int32_t *receptors;  /**< Which ones, as that field counts them; NULL: all. */
  size_t receptor_count;     /**< Length of receptors, the first size of the shape. */
  double nerve_speed;        /**< Of a skin field: how fast its nerves conduct, m/s, where the infant's delays are those
                                  of its age; 0: as fast as large fibres at that age. */
} mimo_sense_field;

/**
 * Fills a field with defaults: one float without bounds and without a name.
 * @param size sizeof(mimo_sense_field) as the caller knows it.
 */
MIMO_API mimo_status mimo_sense_field_init(mimo_sense_field *field, size_t size) MIMO_NOEXCEPT;

/**
 * Declares a field, in the function open of a sense. All that the struct points to is copied.
 * @param env   the world that open was given.
 * @param field the field.
 * Errors: MIMO_E_INVALID_ARGUMENT for a field that no observation can have, and outside of open; MIMO_E_NOT_FOUND for
 *         skin that the agent does not sense, with the names of its fields. A field of a name that exists is refused
 *         when open returns.
 */
MIMO_API mimo_status mimo_sense_add_field(const mimo_env *env, const mimo_sense_field *field) MIMO_NOEXCEPT;

/**
 * Gives a field as its own sense has it at this moment, without limits, delays and the eyes of an infant's age, in any
 * function of a sense. The field is made for the first one who asks in a call, which costs what sensing it costs:
 * pictures are drawn.
 * @param env    the world that the function was given.
 * @param field  index of a field in the world's layout (mimo_layout_find).
 * @param values receives its first value; valid until the function returns.
 * Errors: MIMO_E_INVALID_ARGUMENT outside of a sense's functions, and for fields that the sense does not come after.
 */
MIMO_API mimo_status mimo_sense_feel(const mimo_env *env, size_t field, const void **values) MIMO_NOEXCEPT;

/**
 * A number of the standard normal distribution that follows from its arguments alone. Senses take their noise from here
 * and never from mimo_env_random, whose stream belongs to the world. Never fails.
 * @param seed   of mimo_sense_moment.
 * @param tick   of mimo_sense_moment; 0 for what is the same in the whole episode.
 * @param number which one of that tick, 0, 1, ...
 */
MIMO_API double mimo_sense_noise(uint64_t seed, uint64_t tick, uint64_t number) MIMO_NOEXCEPT;

/**
 * Gives an agent a sense of your own, for worlds made from now on. Its fields follow the fields of all agents and
 * cameras. Its parameters are set by mimo_scene_set_parameter, "anna/ct/rate".
 * With the environment variable MIMO_CHECK_PLUGINS=1 every call of its functions is checked: writing past memory or
 * fields, changing the memory in write, values that are not finite or outside their bounds fail it, each by name.
 * @param agent index of the agent.
 * @param sense the table.
 * Errors: MIMO_E_UNSUPPORTED for another interface_version; MIMO_E_INVALID_ARGUMENT for a table that lacks something,
 *         names that are in use, and parameters without a range; release is not called then. mimo_senses_attach refuses
 *         agents with senses of your own with MIMO_E_UNSUPPORTED.
 */
MIMO_API mimo_status mimo_scene_add_sense(mimo_scene *scene, size_t agent, const mimo_sense *sense) MIMO_NOEXCEPT;

/**
 * The same for a sense in a shared library, which is loaded, and unloaded after the last world that has the sense.
 * Loading a library runs its code: load only what you trust.
 * @param agent index of the agent.
 * @param path  of the library.
 * Errors: as mimo_scene_add_sense, naming the path; MIMO_E_FILE for what cannot be loaded, with the system's reason,
 *         and for a library without mimo_sense_entry; MIMO_E_TASK where that fails.
 */
MIMO_API mimo_status mimo_scene_load_sense(mimo_scene *scene, size_t agent, const char *path) MIMO_NOEXCEPT;

/**
 * Describes the index-th parameter of the senses of a scene's agents that are your own, of all together:
 * "anna/ct/rate". Set parameter->struct_size first. The strings are valid until the scene changes.
 * Errors: MIMO_E_NOT_FOUND past the last.
 */
MIMO_API mimo_status mimo_scene_sense_parameter(const mimo_scene *scene, size_t index,
                                                mimo_parameter *parameter) MIMO_NOEXCEPT;

/**
 * Gives a recording a sense that it names. Worlds made of a recording (mimo_recording_env) have the senses that its
 * world had; a file never loads code, so that the program brings them along.
 * @param sense the table, of the name that the recorded one had.
 * Errors: as mimo_scene_add_sense; MIMO_E_NOT_FOUND for a sense that the recording does not have.
 *         mimo_recording_env answers MIMO_E_UNSUPPORTED where a sense is missing, with its name.
 */
MIMO_API mimo_status mimo_recording_add_sense(mimo_recording *recording, const mimo_sense *sense) MIMO_NOEXCEPT;

/**
 * The same for a sense in a shared library.
 * @param path of the library.
 * Errors: as mimo_recording_add_sense and mimo_scene_load_sense.
 */
MIMO_API mimo_status mimo_recording_load_sense(mimo_recording *recording, const char *path) MIMO_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
