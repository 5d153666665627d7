/*
 * What all parts of the gateway stand on: errors, arguments, and the tables of scenes and worlds. It calls none of
 * them.
 *
 *   mimo_mex.c       takes a command to one of
 *   mimo_worlds.c    making, stepping, observing worlds, which has
 *   mimo_scenes.c    make what they are made of, and that mimo_options.c read names and values;
 *   mimo_access.c    names and values of a world's things, states, sight;
 *   mimo_report.c    what is to be known of a world, and of the library.
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
  char* blocks;
  float* actions; /* of all worlds */
  int sent;       /* whether a step was sent, which then has blocks, actions and these three: */
  double* reward;
  uint8_t *terminated, *truncated;
  size_t count, bytes, fields, action_count, agents;
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

/* The same without an error: a message that counts from 1 (lost by the next one), and "NOT_FOUND", or "OK". */
const char* mimo_counted(const char* message);
const char* mimo_status_word(mimo_status status);

/* Whatever is being made and would be lost if an error were raised now; NULL: nothing. */
void mimo_making(mimo_scene* scene);

/* A place in the table that is free; raises an error if there is none. */
worlds* mimo_new_worlds(void);

/* Fills it, as soon as its batch is made; frees it if that fails. The number is what MATLAB holds. */
double mimo_keep_worlds(worlds* all);
void mimo_close_all(void);

/* The worlds of a number; raises mimo:BAD_HANDLE, or an error if they are still at work on a step that was sent. The
   second gives them, at work or not. */
worlds* mimo_worlds_of(const mxArray* number);
worlds* mimo_any_worlds_of(const mxArray* number);

/* The same for scenes, whose numbers are others than those of worlds. What is kept is being made no more. */
double mimo_keep_scene(mimo_scene* scene);
mimo_scene* mimo_scene_of(const mxArray* number);

/* Frees the scene or the worlds of a number. */
void mimo_close_number(const mxArray* number);

/* One of them, or one of their agents: `at` is an entry of the arguments; without it the first. */
mimo_env* mimo_world_at(worlds* all, int nin, const mxArray* in[], int at);
size_t mimo_agent_at(const worlds* all, int nin, const mxArray* in[], int at);

/* A text or a number out of an argument; `what` is for the message. */
char* mimo_text(const mxArray* text, const char* what);
double mimo_number(const mxArray* number, const char* what);

/* A member of a struct of MATLAB's, a text or an array of numbers. */
void mimo_add_text(mxArray* to, const char* name, const char* text);
void mimo_add_numbers(mxArray* to, const char* name, const double* values, size_t rows, size_t columns);

#endif
