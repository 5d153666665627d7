/*
 * What all parts of the gateway stand on: errors, arguments, and the tables of scenes and worlds. It calls none of
 * them.
 *
 *   mimo_mex.c         takes a command to one of
 *   mimo_worlds.c      making and stepping worlds, which has
 *   mimo_scenes.c      make what they are made of, and that mimo_options.c read names and values;
 *   mimo_layout.c      what worlds observe, act with and are rewarded for;
 *   mimo_access.c      names and values of a world's things, states;
 *   mimo_recordings.c  runs in files;
 *   mimo_sight.c       where infants look, and pictures;
 *   mimo_engines.c     shapes, materials, textures, lights and poses for programs that draw themselves;
 *   mimo_report.c      what is to be known of a world, and of the library.
 *
 * Several of them need mimo_arrays.c (arrays in MATLAB's order), mimo_quantities.c (what can be read and set, by its
 * name) and mimo_messages.c (what the library has to say, until somebody asks).
 */
#ifndef MIMO_MATLAB_BASE_H
#define MIMO_MATLAB_BASE_H

#include <mex.h>
#include <mimo/mimo.h>
#include <stddef.h>

/* What a number of MATLAB's stands for: a batch, most often of a single world. */
typedef struct worlds {
  mimo_batch* batch; /* NULL: free for another */
  mimo_env* first;   /* its world 0, which knows the names */
  const mimo_layout* layout;
  mimo_layout_info sizes; /* of one world */
  mimo_growth usual;      /* what infants are beside their age */
  size_t count;
  int sent;              /* whether a step was sent, which then has all that follows */
  char *blocks, *finals; /* the last observations; those of episodes that ended, where steps start the next one */
  float* actions;
  mimo_recorder* recorder;    /* of one of them; NULL: none is recorded */
  mimo_batch_results results; /* of the last step */
} worlds;

/* A command: what it gives, and what it was given. A list of them ends with NULL. */
typedef struct mimo_command {
  const char* name;
  void (*run)(int nout, mxArray* out[], int nin, const mxArray* in[]);
} mimo_command;

/* Raise an error with the identifier mimo:NAME of the status and the library's message, or with our own. Worlds,
   joints, values... in the library's messages are counted from 0, in those that are raised from 1. */
void mimo_check(mimo_status status);
void mimo_need(int good, const char* message);
void mimo_refuse(const char* format, ...);

/* Raises mimo:BUSY, MATLAB's MIMO_E_BUSY, unless another call that has to come first was made. */
void mimo_need_first(int done, const char* message);

/* The same without an error: a message that counts from 1 (lost by the next one), and "NOT_FOUND", or "OK". */
const char* mimo_counted(const char* message);
const char* mimo_status_word(mimo_status status);

/* Whatever is being made and would be lost if an error were raised now; NULL: nothing. */
void mimo_making(mimo_scene* scene);

/* A place in the table that is free, and its number, which is what MATLAB will hold; raises an error if there is
   none. */
worlds* mimo_new_worlds(void);
double mimo_number_of(const worlds* all);

/* Fills it, as soon as its batch is made; frees it if that fails. Final blocks are for steps that start episodes. */
void mimo_keep_worlds(worlds* all, int final_blocks);
void mimo_close_all(void);

/* The worlds of a number; raises mimo:BAD_HANDLE, or an error if they are still at work on a step that was sent. The
   second gives them, at work or not. */
worlds* mimo_worlds_of(const mxArray* number);
worlds* mimo_any_worlds_of(const mxArray* number);

/* The same for scenes, whose numbers are others than those of worlds. What is kept is being made no more. */
double mimo_new_scene(void);
void mimo_keep_scene(double number, mimo_scene* scene);
mimo_scene* mimo_scene_of(const mxArray* number);

/* Frees worlds, or the scene or the worlds of a number. */
void mimo_close_worlds(worlds* all);
void mimo_close_number(const mxArray* number);

/* One of them, or one of their agents: `at` is an entry of the arguments; without it the first. */
mimo_env* mimo_world_at(worlds* all, int nin, const mxArray* in[], int at);
size_t mimo_agent_at(const worlds* all, int nin, const mxArray* in[], int at);

/* What something is called in the model; "" where it has no name. */
mxArray* mimo_name_of(const worlds* all, int32_t kind, int32_t id);

/* A text or a number out of an argument; `what` is for the message. */
char* mimo_text(const mxArray* text, const char* what);
const char** mimo_texts(const mxArray* texts, size_t* count, const char* what); /* a cell array, or one; NULL for [] */
double mimo_number(const mxArray* number, const char* what);
double mimo_whole(const mxArray* number, const char* what, double low, double high);

/* The array itself, or of a sparse one, which has its numbers otherwise, a full copy that lasts as long as the call. */
const mxArray* mimo_full(const mxArray* values);

/* Real numbers, double or single, of a full or a sparse array, as doubles in MATLAB's order; they last as long as the
   call. `vector` has so many in a row or a column; `matrix` has that shape, or is a vector where that does not matter:
   `rows` and `columns` say what they are, "a row for each action". */
const double* mimo_numbers(const mxArray* values, const char* what);
const double* mimo_vector(const mxArray* values, const char* what, size_t count);
const double* mimo_matrix(const mxArray* values, const char* what, size_t rows, size_t columns, const char* meaning);
int mimo_is_vector(const mxArray* values);

/* A member of a struct of MATLAB's: anything, a text, a number, or an array of numbers. */
void mimo_add(mxArray* to, const char* name, mxArray* value);
void mimo_add_text(mxArray* to, const char* name, const char* text);
void mimo_add_number(mxArray* to, const char* name, double value);
void mimo_add_numbers(mxArray* to, const char* name, const double* values, size_t rows, size_t columns);

#endif
