/* Options: names with values, which set members of mimo.h's structs. */
#ifndef MIMO_MATLAB_OPTIONS_H
#define MIMO_MATLAB_OPTIONS_H

#include "mimo_base.h"
#include "mimo_tables.h"

/* Options of a call, create('free', 'touch', {}), or the members of an element of a struct array. */
typedef struct properties {
  size_t count;
  const char** names;
  const mxArray** values;
} properties;

properties mimo_pairs(int count, const mxArray* in[]);
/* Empty members count as left out. */
properties mimo_members(const mxArray* things, size_t index);

/* Removes an option and returns its value, or NULL. The last two raise an error if it is missing or has another type.
 */
int mimo_has(const properties* given, const char* name);
const mxArray* mimo_take(properties* given, const char* name);
const char* mimo_take_text(properties* given, const char* name);
double mimo_take_number(properties* given, const char* name);

/* Reads a fixed number of numbers. */
void mimo_read_numbers(double* to, size_t count, const char* name, const mxArray* value);

/* Growths of ages in months, NULL for NaN; NULL for an empty array. Except for the age they equal `usual`. They last as
 * long as the call. */
const mimo_growth* const* mimo_ages(const mxArray* months, const mimo_growth* usual, size_t* count);

/* Whether any option of the list is given. */
int mimo_has_any(const properties* given, const member* options);

/* Removes the options of the list and sets their members; raises an error if any option is left: "no option X of a
   lock"; or does both. */
void mimo_set_known(void* config, const member* options, properties* given);
void mimo_no_more(const properties* given, const char* of);
void mimo_set_all(void* config, const member* options, properties* given, const char* of);

#endif
