/* Arrays, which C has row by row and MATLAB column by column; and structs. */
#include "mimo_arrays.h"

size_t mimo_elements(const mimo_field* field) {
  size_t count = 1, d;
  for (d = 0; d < field->ndim; ++d) count *= field->shape[d];
  return count;
}

size_t mimo_place_of(const mimo_field* field, size_t i) {
  size_t place = 0, stride = mimo_elements(field), d;
  for (d = field->ndim; d-- > 0;) {
    stride /= field->shape[d];
    place += i % field->shape[d] * stride;
    i /= field->shape[d];
  }
  return place;
}

/* MATLAB has at least two dimensions, and several worlds are one more. */
static size_t dimensions_of(const mimo_field* field, size_t worlds) {
  const size_t count = field->ndim + (worlds > 1);
  return count < 2 ? 2 : count;
}

static mwSize* shape_of(const mimo_field* field, size_t worlds) {
  const size_t dimensions = dimensions_of(field, worlds);
  mwSize* shape = mxCalloc(dimensions, sizeof *shape);
  size_t d;
  for (d = 0; d < dimensions; ++d) shape[d] = d < field->ndim ? field->shape[d] : 1;
  if (worlds > 1) shape[field->ndim] = worlds;
  return shape;
}

mxArray* mimo_size_of(const mimo_field* field) {
  const size_t dimensions = dimensions_of(field, 1);
  const mwSize* shape = shape_of(field, 1);
  mxArray* size = mxCreateDoubleMatrix(1, dimensions, mxREAL);
  size_t d;
  for (d = 0; d < dimensions; ++d) mxGetPr(size)[d] = (double)shape[d];
  return size;
}

mxArray* mimo_cells_of(const mimo_field* field) {
  return mxCreateCellArray(dimensions_of(field, 1), shape_of(field, 1));
}

mxArray* mimo_zeros_of(const mimo_field* field) {
  return mxCreateNumericArray(dimensions_of(field, 1), shape_of(field, 1), mxDOUBLE_CLASS, mxREAL);
}

static mxClassID class_of(const mimo_field* field, int single) {
  if (field->dtype == MIMO_U8) return mxUINT8_CLASS;
  return single ? mxSINGLE_CLASS : mxDOUBLE_CLASS;
}

static double element(const void* field, int32_t dtype, size_t i) {
  switch (dtype) {
    case MIMO_U8: return ((const uint8_t*)field)[i];
    case MIMO_I32: return ((const int32_t*)field)[i];
    case MIMO_F32: return ((const float*)field)[i];
    default: return ((const double*)field)[i];
  }
}

static void put(mxArray* array, size_t place, double value) {
  switch (mxGetClassID(array)) {
    case mxUINT8_CLASS: ((uint8_t*)mxGetData(array))[place] = (uint8_t)value; break;
    case mxSINGLE_CLASS: ((float*)mxGetData(array))[place] = (float)value; break;
    default: mxGetPr(array)[place] = value; break;
  }
}

/* Row by row: the elements of a row of C have a constant distance here. */
static void fill(mxArray* array, size_t first, const mimo_field* field, const void* data) {
  const size_t count = mimo_elements(field), row = field->shape[field->ndim - 1];
  size_t i, j;
  for (i = 0; i < count; i += row) {
    const size_t place = first + mimo_place_of(field, i), stride = count / row;
    for (j = 0; j < row; ++j) put(array, place + j * stride, element(data, field->dtype, i + j));
  }
}

mxArray* mimo_array_of(const mimo_field* field, stack blocks, int single) {
  mxArray* array = mxCreateNumericArray(dimensions_of(field, blocks.count), shape_of(field, blocks.count),
                                        class_of(field, single), mxREAL);
  size_t i;
  for (i = 0; i < blocks.count; ++i)
    fill(array, i * mimo_elements(field), field, (const char*)blocks.data + i * blocks.bytes + field->offset);
  return array;
}

mxArray* mimo_picture_of(const void* pixels, size_t height, size_t width, size_t channels, int32_t dtype) {
  const size_t shape[3] = {height, width, channels};
  const stack one = {pixels, 0, 1};
  mimo_field field = {0};
  field.dtype = dtype;
  field.shape = shape;
  field.ndim = channels > 1 ? 3 : 2;
  return mimo_array_of(&field, one, 0);
}

/* The i-th number of a member. */
static double number_of(const char* from, kind kind, size_t i) {
  switch (kind) {
    case kUnsigned: return ((const uint32_t*)from)[i];
    case kWide: return (double)((const uint64_t*)from)[i];
    case kSize: return (double)((const size_t*)from)[i];
    case kSigned: return ((const int32_t*)from)[i];
    case kFloats: return ((const float*)from)[i];
    default: return ((const double*)from)[i];
  }
}

static mxArray* value_of(const char* from, const member* one) {
  mxArray* numbers;
  size_t i;
  if (one->kind == kText) return mxCreateString(*(const char* const*)from);
  if (one->kind == kSwitch) return mxCreateLogicalScalar(*(const uint32_t*)from != 0);
  numbers = mxCreateDoubleMatrix(one->count, 1, mxREAL);
  for (i = 0; i < one->count; ++i) mxGetPr(numbers)[i] = number_of(from, one->kind, i);
  return numbers;
}

mxArray* mimo_structs(size_t count, const member* members) {
  mxArray* structs = mxCreateStructMatrix(count, 1, 0, NULL);
  for (; members->name != NULL; ++members) mxAddField(structs, members->name);
  return structs;
}

void mimo_fill(mxArray* structs, size_t index, const void* from, const member* members) {
  for (; members->name != NULL; ++members)
    mxSetField(structs, index, members->name, value_of((const char*)from + members->offset, members));
}

mxArray* mimo_struct(const void* from, const member* members) {
  mxArray* made = mimo_structs(1, members);
  mimo_fill(made, 0, from, members);
  return made;
}
