/* Commands for engines: shapes, materials, textures, lights, poses, frames. */
#include "mimo_engines.h"

#include <string.h>

#include "mimo_arrays.h"
#include "mimo_words.h"

static int32_t read_axes(const mxArray* name) { return (int32_t)mimo_value_of(name, "axes", &mimo_axes_words); }

/* A geom, texture or light, counted from 1. */
static int32_t read_id(const mxArray* number, const char* what) {
  return (int32_t)mimo_whole(number, what, 0, 2147483647.0) - 1;
}

/* An array of doubles with `count` columns of `rows` numbers. */
static mxArray* rows_of(const float* values, size_t rows, size_t count) {
  mxArray* array = mxCreateDoubleMatrix(rows, count, mxREAL);
  size_t i;
  for (i = 0; i < rows * count; ++i) mxGetPr(array)[i] = (double)values[i];
  return array;
}

/* struct = mesh(number, geom, axes, segments, plane, index) */
static void mesh(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_mesh wanted;
  mimo_env* env;
  mxArray* triangles;
  int32_t geom;
  size_t i;
  (void)nout;
  mimo_need(nin >= 5, "expected a world, a geom, axes, segments, and the size of planes");
  env = mimo_world_at(mimo_worlds_of(in[0]), nin, in, 5);
  geom = read_id(in[1], "geom");
  mimo_check(mimo_mesh_init(&wanted, sizeof wanted));
  wanted.axes = read_axes(in[2]);
  wanted.segments = (uint32_t)mimo_whole(in[3], "segments", 4, 256);
  wanted.plane = mimo_number(in[4], "plane");
  mimo_check(mimo_env_mesh(env, geom, &wanted));
  wanted.vertex_capacity = wanted.vertex_count;
  wanted.index_capacity = wanted.index_count;
  wanted.positions = mxCalloc(3 * wanted.vertex_count + 1, sizeof(float));
  wanted.normals = mxCalloc(3 * wanted.vertex_count + 1, sizeof(float));
  wanted.texcoords = mxCalloc(2 * wanted.vertex_count + 1, sizeof(float));
  wanted.indices = mxCalloc(wanted.index_count + 1, sizeof(uint32_t));
  mimo_check(mimo_env_mesh(env, geom, &wanted));
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add(out[0], "positions", rows_of(wanted.positions, 3, wanted.vertex_count));
  mimo_add(out[0], "normals", rows_of(wanted.normals, 3, wanted.vertex_count));
  mimo_add(out[0], "texcoords", rows_of(wanted.texcoords, 2, wanted.vertex_count));
  triangles = mxCreateDoubleMatrix(3, wanted.index_count / 3, mxREAL);
  for (i = 0; i < wanted.index_count; ++i) mxGetPr(triangles)[i] = 1.0 + wanted.indices[i];
  mimo_add(out[0], "triangles", triangles);
}

/* struct = appearance(number, geom, index) */
static void appearance(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_appearance look = {0};
  (void)nout;
  mimo_need(nin >= 2, "expected a world, and a geom");
  look.struct_size = sizeof look;
  mimo_check(mimo_env_appearance(mimo_world_at(mimo_worlds_of(in[0]), nin, in, 2), read_id(in[1], "geom"), &look));
  out[0] = mimo_struct(&look, mimo_appearance_members);
  mxSetField(out[0], 0, "texture", mxCreateDoubleScalar(look.texture + 1));
}

/* [pixels, type] = texture(number, id, index); for the id 0 the number of textures */
static void texture(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_texture wanted = {0};
  size_t count = 0;
  mimo_env* env;
  int32_t id;
  mimo_need(nin >= 2, "expected a world, and a texture");
  env = mimo_world_at(mimo_worlds_of(in[0]), nin, in, 2);
  id = read_id(in[1], "texture");
  if (id < 0) {
    mimo_check(mimo_env_texture_count(env, &count));
    out[0] = mxCreateDoubleScalar((double)count);
    return;
  }
  wanted.struct_size = sizeof wanted;
  mimo_check(mimo_env_texture(env, id, &wanted));
  wanted.pixel_bytes = (size_t)4 * wanted.width * wanted.height;
  wanted.pixels = mxCalloc(wanted.pixel_bytes, 1);
  mimo_check(mimo_env_texture(env, id, &wanted));
  out[0] = mimo_picture_of(wanted.pixels, wanted.height, wanted.width, 4, MIMO_U8);
  if (nout > 1) out[1] = mxCreateString(mimo_word_for(wanted.type, &mimo_texture_type_words));
}

/* struct = light(number, id, axes, index); the id 0 is the headlight */
static void light(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_light now = {0};
  (void)nout;
  mimo_need(nin >= 3, "expected a world, a light, and axes");
  now.struct_size = sizeof now;
  now.axes = read_axes(in[2]);
  mimo_check(mimo_env_light(mimo_world_at(mimo_worlds_of(in[0]), nin, in, 3), read_id(in[1], "light"), &now));
  out[0] = mimo_struct(&now, mimo_light_members);
}

/* poses = poses(number, kind, axes, index): seven rows */
static void poses(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  int32_t kind;
  mimo_env* env;
  size_t count = 0;
  float* values;
  (void)nout;
  mimo_need(nin >= 3, "expected a world, a kind, and axes");
  env = mimo_world_at(mimo_worlds_of(in[0]), nin, in, 3);
  kind = (int32_t)mimo_value_of(in[1], "kind", &mimo_kind_words);
  mimo_check(mimo_env_count(env, kind, &count));
  values = mxCalloc(7 * count + 1, sizeof *values);
  mimo_check(mimo_env_poses(env, kind, read_axes(in[2]), values, 7 * count));
  out[0] = rows_of(values, 7, count);
}

static const conversion* conversion_of(const char* what) {
  const conversion* one = mimo_conversions;
  while (one->what != NULL && strcmp(one->what, what) != 0) ++one;
  if (one->what == NULL) mimo_refuse("what is \"%s\", which mimo_convert does not convert: help mimo_convert", what);
  return one;
}

/* converted = convert(what, values, axes): a column for each */
static void convert(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const conversion* one;
  size_t count, i;
  const double* numbers;
  float* values;
  (void)nout;
  mimo_need(nin == 3, "expected what, columns of numbers, and axes");
  one = conversion_of(mimo_text(in[0], "what"));
  count = mxGetN(in[1]);
  numbers = mimo_matrix(in[1], "values", one->rows, count, "a column for each");
  values = mxCalloc(one->rows * count + 1, sizeof *values);
  for (i = 0; i < one->rows * count; ++i) values[i] = (float)numbers[i];
  mimo_check(one->function(read_axes(in[2]), values, count));
  out[0] = rows_of(values, one->rows, count);
}

const mimo_command mimo_engine_commands[] = {{"mesh", mesh},   {"appearance", appearance}, {"texture", texture},
                                             {"light", light}, {"poses", poses},           {"convert", convert},
                                             {NULL, NULL}};
