/*
 * The base of all parts of the gateway: errors, arguments, and the tables of worlds, scenes and stages. The parts
 * with commands are
 *
 *   mimo_mex.c         the gateway itself, which finds a command in the others;
 *   mimo_worlds.c      making, stepping and observing worlds;
 *   mimo_scenes.c      scenes, and worlds made from them;
 *   mimo_layout.c      descriptions of observations, actions and rewards, and observations;
 *   mimo_access.c      names and values, states;
 *   mimo_recordings.c  recordings;
 *   mimo_sight.c       gaze and pictures;
 *   mimo_engines.c     shapes, materials, textures, lights and poses for engines;
 *   mimo_stages.c      pictures of plain arrays;
 *   mimo_report.c      descriptions of worlds and of the library.
 *
 * They use mimo_arrays.c (arrays and structs), mimo_options.c (names and values), mimo_words.c (words for constants)
 * and mimo_messages.c (messages until MATLAB asks for them). mimo_tables.c is generated.
 */
#ifndef MIMO_MATLAB_BASE_H
#define MIMO_MATLAB_BASE_H

#include <mex.h>
#include <mimo/experimental.h>
#include <stddef.h>

/* The worlds that a number in MATLAB stands for: a batch, usually of a single world. */
typedef struct worlds {
  mimo_batch* batch; /* NULL: this place is free */
  mimo_env* first;   /* world 0, which knows the names */
  const mimo_layout* layout;
  mimo_layout_info sizes; /* of one world */
  mimo_growth usual;      /* growth of the infants, except their age */
  size_t count;
  int sent;              /* whether a step was sent; until it is received the library uses the members below */
  char *blocks, *finals; /* last observations, and last observations of ended episodes if steps start the next ones */
  float* actions;
  mimo_recorder* recorder;    /* of one world; NULL: none is recorded */
  mimo_batch_results results; /* of the last step */
} worlds;

/* A command, with its outputs and inputs. A list of commands ends with NULL. */
typedef struct mimo_command {
  const char* name;
  void (*run)(int nout, mxArray* out[], int nin, const mxArray* in[]);
} mimo_command;

/* Raise an error with the identifier mimo:NAME of the status and the library's message, or with a message of the
 * gateway. The library counts worlds, joints, values... from 0, MATLAB from 1. */
void mimo_check(mimo_status status);
void mimo_need(int good, const char* message);
void mimo_refuse(const char* format, ...);

/* Raises mimo:BUSY (MIMO_E_BUSY) if another call has to come first. */
void mimo_need_first(int done, const char* message);

/* The same without an error: a message that counts from 1 (valid until the next call), and "NOT_FOUND", or "OK". */
const char* mimo_counted(const char* message);
const char* mimo_status_word(mimo_status status);

/* The scene that is being made, which an error would destroy; NULL: none. */
void mimo_making(mimo_scene* scene);

/* A free place in the table, and its number for MATLAB; raises an error if there is none. */
worlds* mimo_new_worlds(void);
double mimo_number_of(const worlds* all);

/* Fills it after its batch was made; frees it if that fails. Final blocks are for steps that start episodes. */
void mimo_keep_worlds(worlds* all, int final_blocks);
void mimo_close_all(void);

/* The worlds of a number; raises mimo:BAD_HANDLE, or mimo:BUSY while a step that was sent runs. The second also returns
 * busy worlds. */
worlds* mimo_worlds_of(const mxArray* number);
worlds* mimo_any_worlds_of(const mxArray* number);

/* The same for scenes, which are numbered separately from worlds. A kept scene is no longer being made. */
double mimo_new_scene(void);
void mimo_keep_scene(double number, mimo_scene* scene);
mimo_scene* mimo_scene_of(const mxArray* number);

/* The same for stages. */
double mimo_new_stage(void);
void mimo_keep_stage(double number, mimo_stage* stage);
mimo_stage* mimo_stage_of(const mxArray* number);

/* Frees worlds, or what a number stands for: worlds, a scene or a stage. */
void mimo_close_worlds(worlds* all);
void mimo_close_number(const mxArray* number);

/* One of the worlds, or one of their agents: `at` is the index of an argument; without that argument the first. */
mimo_env* mimo_world_at(worlds* all, int nin, const mxArray* in[], int at);
size_t mimo_agent_at(const worlds* all, int nin, const mxArray* in[], int at);

/* The name of an element in the model; "" if it has none. */
mxArray* mimo_name_of(const worlds* all, int32_t kind, int32_t id);

/* A text or a number from an argument; `what` names the argument in messages. */
char* mimo_text(const mxArray* text, const char* what);
const char** mimo_texts(const mxArray* texts, size_t* count, const char* what); /* a cell array, or one; NULL for [] */
double mimo_number(const mxArray* number, const char* what);
double mimo_whole(const mxArray* number, const char* what, double low, double high);

/* The array itself, or a full copy of a sparse one, which lasts as long as the call. */
const mxArray* mimo_full(const mxArray* values);

/* Real numbers, double or single, of a full or a sparse array, as doubles in MATLAB's order; they last as long as the
   call. `vector` has so many in a row or a column; `matrix` has that shape, or is a vector where that does not matter:
   `rows` and `columns` say what they are, "a row for each action". */
const double* mimo_numbers(const mxArray* values, const char* what);
const double* mimo_vector(const mxArray* values, const char* what, size_t count);
const double* mimo_matrix(const mxArray* values, const char* what, size_t rows, size_t columns, const char* meaning);
int mimo_is_vector(const mxArray* values);

/* Adds a member to a struct: any value, a text, a number, or an array of numbers. */
void mimo_add(mxArray* to, const char* name, mxArray* value);
void mimo_add_text(mxArray* to, const char* name, const char* text);
void mimo_add_number(mxArray* to, const char* name, double value);
void mimo_add_numbers(mxArray* to, const char* name, const double* values, size_t rows, size_t columns);

#endif
