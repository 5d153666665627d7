/* Commands for stages: pictures of plain arrays, which C has row by row and MATLAB column by column. */
#include "mimo_stages.h"

#include <math.h>
#include <stdio.h>

#include "mimo_arrays.h"
#include "mimo_messages.h"
#include "mimo_options.h"
#include "mimo_words.h"

enum { kName = 64, kLargest = 16384 };

/* "geoms.sizes" */
static const char* name_of(const char* part, const char* member) {
  static char name[kName];
  snprintf(name, sizeof name, "%s.%s", part, member);
  return name;
}

/* Numbers of any class as doubles; words of an array that takes them as their values. */
static const mxArray* as_doubles(const mxArray* given, const char* name, const stage_array* to) {
  mxArray* doubles = NULL;
  size_t i;
  if (to->words != NULL && (mxIsCell(given) || mxIsChar(given))) {
    const size_t count = mxIsCell(given) ? mxGetNumberOfElements(given) : 1;
    doubles = mxCreateDoubleMatrix(count, 1, mxREAL);
    for (i = 0; i < count; ++i)
      mxGetPr(doubles)[i] = (double)mimo_value_of(mxIsCell(given) ? mxGetCell(given, i) : given, name, to->words);
    return doubles;
  }
  if (mxIsDouble(given) || mxIsSingle(given)) return given;
  if (!mxIsNumeric(given) && !mxIsLogical(given)) mimo_refuse("%s: expected numbers", name);
  if (mexCallMATLAB(1, &doubles, 1, (mxArray**)&given, "double") != 0) mimo_refuse("%s: expected numbers", name);
  return doubles;
}

static size_t bytes_of(kind kind) {
  switch (kind) {
    case kBytes: return sizeof(uint8_t);
    case kSigned: return sizeof(int32_t);
    case kFloats: return sizeof(float);
    default: return sizeof(double);
  }
}

/* The i-th number of an array, checked where it has to be whole. */
static void put(void* to, kind kind, size_t i, double value, const char* name) {
  const double low = kind == kBytes ? 0 : -2147483648.0, high = kind == kBytes ? 255 : 2147483647.0;
  if ((kind == kBytes || kind == kSigned) && !(value >= low && value <= high && value == floor(value)))
    mimo_refuse("%s has %g, expected whole numbers from %.0f to %.0f", name, value, low, high);
  switch (kind) {
    case kBytes: ((uint8_t*)to)[i] = (uint8_t)value; break;
    case kSigned: ((int32_t*)to)[i] = (int32_t)value; break;
    case kFloats: ((float*)to)[i] = (float)value; break;
    default: ((double*)to)[i] = value; break;
  }
}

/* An array in C's order, which lasts as long as the call, and how many elements it has. */
static void* array_from(const mxArray* given, const char* name, const stage_array* from, size_t* count) {
  const mxArray* values = as_doubles(given, name, from);
  const size_t width = from->width, total = mxGetNumberOfElements(values);
  const size_t rows = width == 1 ? total : mimo_is_vector(values) && total == width ? 1 : mxGetM(values);
  const double* numbers =
      width == 1 ? mimo_vector(values, name, total) : mimo_matrix(values, name, rows, width, "a row for each element");
  void* made = mxCalloc(total + 1, bytes_of(from->kind)); /* MATLAB frees it at the end of the call */
  size_t row, column;
  for (row = 0; row < rows; ++row)
    for (column = 0; column < width; ++column)
      put(made, from->kind, row * width + column, numbers[column * rows + row] - from->places, name);
  *count = rows;
  return made;
}

/* The name of an array before this one that has the same length in the struct, or NULL. */
static const char* counted_before(const char* to, const stage_part* part, const stage_array* one) {
  const stage_array* other;
  for (other = part->arrays; other != one; ++other)
    if (other->length == one->length && *(const void* const*)(to + other->offset) != NULL) return other->name;
  return NULL;
}

/* Fills a zeroed struct of a stage from the members of a struct of MATLAB. */
static void read_part(char* to, const stage_part* part, const char* name, properties given) {
  const stage_array* one;
  const member* number;
  *(uint32_t*)to = (uint32_t)part->size;
  for (number = part->numbers; number->name != NULL; ++number) /* objects have no type until they are given one */
    if (number->kind == kSigned) *(int32_t*)(to + number->offset) = -1;
  for (one = part->arrays; one->name != NULL; ++one) {
    const mxArray* value = mimo_take(&given, one->name);
    const char* before = counted_before(to, part, one);
    size_t count, *length = (size_t*)(to + one->length);
    void* made;
    if (value == NULL) continue;
    made = array_from(value, name_of(name, one->name), one, &count);
    if (before != NULL && count != *length)
      mimo_refuse("%s has %.0f elements, expected %.0f, as %s", name_of(name, one->name), (double)count,
                  (double)*length, before);
    *length = count;
    *(void**)(to + one->offset) = made;
  }
  mimo_set_all(to, part->numbers, &given, name);
}

static const struct {
  const char* name;
  const stage_part* part;
  size_t offset;
} parts[] = {
    {"geoms", &mimo_stage_shapes_part, offsetof(mimo_stage_config, geoms)},
    {"sites", &mimo_stage_shapes_part, offsetof(mimo_stage_config, sites)},
    {"meshes", &mimo_stage_meshes_part, offsetof(mimo_stage_config, meshes)},
    {"fields", &mimo_stage_fields_part, offsetof(mimo_stage_config, fields)},
    {"textures", &mimo_stage_textures_part, offsetof(mimo_stage_config, textures)},
    {"materials", &mimo_stage_materials_part, offsetof(mimo_stage_config, materials)},
    {"surfaces", &mimo_stage_surfaces_part, offsetof(mimo_stage_config, surfaces)},
    {"tendons", &mimo_stage_tendons_part, offsetof(mimo_stage_config, tendons)},
    {"lights", &mimo_stage_lights_part, offsetof(mimo_stage_config, lights)},
};

static properties members_of(const mxArray* given, const char* name) {
  if (!mxIsStruct(given) || mxGetNumberOfElements(given) != 1) mimo_refuse("%s: expected one struct", name);
  return mimo_members(given, 0);
}

/* The config of named parts: 'geoms', struct(...), 'air', struct(...). */
static mimo_stage_config config_from(properties* given) {
  mimo_stage_config config = {0};
  const mxArray* air = mimo_take(given, "air");
  size_t i;
  config.struct_size = sizeof config;
  for (i = 0; i < sizeof parts / sizeof *parts; ++i) {
    const mxArray* value = mimo_take(given, parts[i].name);
    char* part;
    if (value == NULL) continue;
    part = mxCalloc(1, parts[i].part->size);
    read_part(part, parts[i].part, parts[i].name, members_of(value, parts[i].name));
    *(void**)((char*)&config + parts[i].offset) = part;
  }
  if (air != NULL) {
    properties numbers = members_of(air, "air");
    mimo_stage_air* filled = mxCalloc(1, sizeof *filled);
    mimo_check(mimo_stage_air_init(filled, sizeof *filled));
    mimo_set_all(filled, mimo_stage_air_options, &numbers, "air");
    config.air = filled;
  }
  return config;
}

/* number = stage('geoms', struct, ..., 'threads', 2) */
static void stage(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  properties given = mimo_pairs(nin, in);
  const double threads = mimo_has(&given, "threads") ? mimo_whole(mimo_take(&given, "threads"), "threads", 1, 256) : 1;
  mimo_stage_config config = config_from(&given);
  const double number = mimo_new_stage();
  mimo_stage* made = NULL;
  (void)nout;
  mimo_no_more(&given, "a stage");
  config.threads = (uint32_t)threads;
  config.log = mimo_keep_message;
  config.log_user = mimo_teller(number);
  mimo_check(mimo_stage_create(&config, &made));
  mimo_keep_stage(number, made);
  out[0] = mxCreateDoubleScalar(number);
}

/* stage_update(number, 'lights', struct, ...) */
static void stage_update(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_stage* one;
  mimo_stage_config config;
  properties given;
  (void)nout;
  (void)out;
  mimo_need(nin >= 1, "expected a stage, and names and structs of parts");
  one = mimo_stage_of(in[0]);
  given = mimo_pairs(nin - 1, in + 1);
  config = config_from(&given);
  mimo_no_more(&given, "a stage that is there");
  mimo_check(mimo_stage_update(one, &config));
}

static void* take_numbers(properties* given, const char* name, size_t rows, size_t columns) {
  const mxArray* value = mimo_take(given, name);
  if (value == NULL) mimo_refuse("%s: expected that of the camera", name);
  return (void*)mimo_matrix(value, name, rows, columns, "of the camera");
}

/* A view with buffers for so many parts of the picture: colour, depth, segmentation. */
static void read_view(mimo_stage_view* view, properties given, size_t poses, int wanted) {
  const mxArray* pose = mimo_take(&given, "pose");
  const double* columns;
  double* rows = mxCalloc(9, sizeof *rows);
  size_t pixels, i;
  mimo_check(mimo_stage_view_init(view, sizeof *view));
  view->position = take_numbers(&given, "position", 3, 1);
  columns = take_numbers(&given, "rotation", 3, 3);
  for (i = 0; i < 9; ++i) rows[i] = columns[i % 3 * 3 + i / 3];
  view->rotation = rows;
  view->pose = pose == NULL ? 0 : (uint32_t)mimo_whole(pose, "pose", 1, (double)poses) - 1;
  mimo_set_all(view, mimo_stage_view_options, &given, "a view");
  mimo_need(view->height >= 1 && view->height <= kLargest && view->width >= 1 && view->width <= kLargest,
            "height, width: expected whole numbers from 1 to 16384");
  pixels = (size_t)view->height * view->width;
  view->rgb_bytes = 3 * pixels;
  view->rgb = mxCalloc(view->rgb_bytes, sizeof *view->rgb);
  view->depth_count = wanted > 1 ? pixels : 0;
  if (wanted > 1) view->depth = mxCalloc(pixels, sizeof *view->depth);
  view->segmentation_count = wanted > 2 ? 2 * pixels : 0;
  if (wanted > 2) view->segmentation = mxCalloc(2 * pixels, sizeof *view->segmentation);
}

static mxArray* part_of(const mimo_stage_view* view, int part) {
  switch (part) {
    case 0: return mimo_picture_of(view->rgb, view->height, view->width, 3, MIMO_U8);
    case 1: return mimo_picture_of(view->depth, view->height, view->width, 1, MIMO_F32);
    default: return mimo_picture_of(view->segmentation, view->height, view->width, 2, MIMO_I32);
  }
}

/* [rgb, depth, segmentation] = stage_draw(number, poses, views): only used outputs are drawn; cells of several views */
static void stage_draw(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const mimo_stage_poses** poses;
  const mimo_stage_view** views;
  size_t pose_count, view_count, i;
  mimo_stage* one;
  int part = 0;
  mimo_need(nin == 3 && mxIsStruct(in[1]) && mxIsStruct(in[2]),
            "expected a stage, a struct of poses, and one of a view");
  one = mimo_stage_of(in[0]);
  pose_count = mxGetNumberOfElements(in[1]);
  view_count = mxGetNumberOfElements(in[2]);
  poses = mxCalloc(pose_count + 1, sizeof *poses);
  views = mxCalloc(view_count + 1, sizeof *views);
  for (i = 0; i < pose_count; ++i) {
    mimo_stage_poses* pose = mxCalloc(1, sizeof *pose);
    read_part((char*)pose, &mimo_stage_poses_part, "poses", mimo_members(in[1], i));
    poses[i] = pose;
  }
  for (i = 0; i < view_count; ++i) {
    mimo_stage_view* view = mxCalloc(1, sizeof *view);
    read_view(view, mimo_members(in[2], i), pose_count, nout);
    views[i] = view;
  }
  mimo_check(mimo_stage_draw(one, poses, pose_count, views, view_count));
  do {
    out[part] = view_count == 1 ? part_of(views[0], part) : mxCreateCellMatrix(1, view_count);
    for (i = 0; view_count != 1 && i < view_count; ++i) mxSetCell(out[part], i, part_of(views[i], part));
  } while (++part < nout);
}

const mimo_command mimo_stage_commands[] = {
    {"stage", stage}, {"stage_update", stage_update}, {"stage_draw", stage_draw}, {NULL, NULL}};
