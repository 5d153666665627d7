/* What the parts of the gateway share. */
#ifndef MIMO_GATEWAY_H
#define MIMO_GATEWAY_H

#include <mex.h>
#include <mimo/mimo.h>
#include <stddef.h>

/* What a number of MATLAB's stands for: a batch, most often of a single world. */
typedef struct worlds {
  mimo_batch* batch; /* NULL: free for another */
  mimo_env* first;   /* its world 0, which knows the names */
  char* blocks;
  float* actions; /* of all worlds */
  size_t count, bytes, fields, action_count, agents;
} worlds;

/* Raise an error with the identifier mimo:NAME of the status and the library's message, or with our own. */
void mimo_check(mimo_status status);
void mimo_need(int good, const char* message);

/* Whatever is being made and would be lost if an error were raised now; NULL: nothing. */
void mimo_making(mimo_scene* scene);

/* The worlds of a number; raises mimo:BAD_HANDLE. */
worlds* mimo_worlds_of(const mxArray* number);

/* One of them: `at` is an entry of the arguments, counted from 1; without it the first. */
mimo_env* mimo_world_at(worlds* all, int nin, const mxArray* in[], int at);

/* A text or a number out of an argument; `what` is for the message. */
char* mimo_text(const mxArray* text, const char* what);
double mimo_number(const mxArray* number, const char* what);

/* create(scene, name, value, ...): the batch that the options ask for. */
mimo_batch* mimo_create_batch(int nin, const mxArray* in[]);

/* A command: what it gives, and what it was given. */
typedef void (*mimo_command)(int nout, mxArray* out[], int nin, const mxArray* in[]);
mimo_command mimo_access_command(const char* name);

#endif
