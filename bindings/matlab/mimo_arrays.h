/* Arrays: out of C's order into MATLAB's. */
#ifndef MIMO_MATLAB_ARRAYS_H
#define MIMO_MATLAB_ARRAYS_H

#include "mimo_base.h"
#include "mimo_tables.h"

/* Blocks of bytes, one behind the other, that a field lies in. */
typedef struct stack {
  const void* data;
  size_t bytes, count;
} stack;

/* The field of all of them, which are the last dimension of the array. Bytes stay bytes (pictures are for imshow);
   everything else becomes double, or single. Vectors are columns. */
mxArray* mimo_array_of(const mimo_field* field, stack blocks, int single);

/* A picture of so many channels, as an array of its type. */
mxArray* mimo_picture_of(const void* pixels, size_t height, size_t width, size_t channels, int32_t dtype);

/* The size of a field of one world as MATLAB's size() would give it, and empty cells or zeros for its elements. */
mxArray* mimo_size_of(const mimo_field* field);
mxArray* mimo_cells_of(const mimo_field* field);
mxArray* mimo_zeros_of(const mimo_field* field);

/* How many elements it has, and where the i-th of them in C's order lies in an array of MATLAB's. */
size_t mimo_elements(const mimo_field* field);
size_t mimo_place_of(const mimo_field* field, size_t i);

/* A column of structs with these members, which are empty at first; fills one of them from a struct of the library. */
mxArray* mimo_structs(size_t count, const member* members);
void mimo_fill(mxArray* structs, size_t index, const void* from, const member* members);

/* A single one, filled. */
mxArray* mimo_struct(const void* from, const member* members);

#endif
