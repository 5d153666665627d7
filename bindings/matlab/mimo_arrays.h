/* Arrays in MATLAB's order, and structs. */
#ifndef MIMO_MATLAB_ARRAYS_H
#define MIMO_MATLAB_ARRAYS_H

#include "mimo_base.h"
#include "mimo_tables.h"

/* Blocks of bytes, one after the other, that contain a field. */
typedef struct stack {
  const void* data;
  size_t bytes, count;
} stack;

/* The field of all blocks, which are the last dimension of the array. Bytes stay bytes (pictures are for imshow); all
 * other types become double, or single. Vectors are columns. */
mxArray* mimo_array_of(const mimo_field* field, stack blocks, int single);

/* A picture with a number of channels, as an array of its type. */
mxArray* mimo_picture_of(const void* pixels, size_t height, size_t width, size_t channels, int32_t dtype);

/* The size of a field of one world as size() returns it, and empty cells or zeros of that size. */
mxArray* mimo_size_of(const mimo_field* field);
mxArray* mimo_cells_of(const mimo_field* field);
mxArray* mimo_zeros_of(const mimo_field* field);

/* The number of elements, and the index in MATLAB's order of the i-th element in C's order. */
size_t mimo_elements(const mimo_field* field);
size_t mimo_place_of(const mimo_field* field, size_t i);

/* Makes a column of structs with these members, which are empty at first; fills one of them from a struct of C. */
mxArray* mimo_structs(size_t count, const member* members);
void mimo_fill(mxArray* structs, size_t index, const void* from, const member* members);

/* Makes a single struct and fills it. */
mxArray* mimo_struct(const void* from, const member* members);

#endif
