/* Names with values, and the members of mimo.h's structs that they set. */
#ifndef MIMO_MATLAB_OPTIONS_H
#define MIMO_MATLAB_OPTIONS_H

#include "mimo_base.h"
#include "mimo_tables.h"

/* What was given by name: the end of a call, create('free', 'touch', 0), or an element of a struct array. */
typedef struct properties {
  size_t count;
  const char** names;
  const mxArray** values;
} properties;

properties mimo_pairs(int count, const mxArray* in[]);
/* Empty members count as left out. */
properties mimo_members(const mxArray* things, size_t index);

/* Takes one out of them: its value, or NULL; or raises an error if it is not there or something else. */
int mimo_has(const properties* given, const char* name);
const mxArray* mimo_take(properties* given, const char* name);
const char* mimo_take_text(properties* given, const char* name);
double mimo_take_number(properties* given, const char* name);

/* An array of just so many numbers. */
void mimo_read_numbers(double* to, size_t count, const char* name, const mxArray* value);

extern const member mimo_no_options[];

/* Growths of ages in months, NULL for NaN; NULL for an empty array. Otherwise they are as the usual one, and belong to
   the call. */
const mimo_growth* const* mimo_ages(const mxArray* months, const mimo_growth* usual, size_t* count);

/* Whether anything of the list is given. */
int mimo_has_any(const properties* given, const member* options);

/* Takes out what the list has and sets it; the second raises an error if anything is left: "no option X of a lock". */
void mimo_set_known(void* config, const member* options, properties* given);
void mimo_set_all(void* config, const member* options, properties* given, const char* of);

#endif
