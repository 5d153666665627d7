/* Commands for gaze, and for pictures for people. */
#include "mimo_sight.h"

#include <math.h>

#include "mimo_arrays.h"
#include "mimo_options.h"
#include "mimo_words.h"

/* struct = gaze(number, index, agent) */
static void gaze(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  worlds* all;
  mimo_gaze now = {0};
  (void)nout;
  mimo_need(nin >= 1 && nin <= 3, "expected a world, its index, and an agent");
  all = mimo_worlds_of(in[0]);
  now.struct_size = sizeof now;
  mimo_check(mimo_env_gaze(mimo_world_at(all, nin, in, 1), mimo_agent_at(all, nin, in, 2), &now));
  out[0] = mxCreateStructMatrix(1, 1, 0, NULL);
  mimo_add_numbers(out[0], "left_position", now.left_position, 3, 1);
  mimo_add_numbers(out[0], "left_direction", now.left_direction, 3, 1);
  mimo_add_numbers(out[0], "right_position", now.right_position, 3, 1);
  mimo_add_numbers(out[0], "right_direction", now.right_direction, 3, 1);
  mimo_add_number(out[0], "vergence", now.vergence);
  mimo_add_numbers(out[0], "point", now.point, now.meets ? 3 : 0, 1);
  mimo_add_number(out[0], "miss", now.miss);
}

/* The arguments (number, point, 'eyes' or 'head', index, agent). */
typedef struct look {
  mimo_env* env;
  size_t agent;
  const double* point;
  int32_t how;
} look;

static look read_look(int nin, const mxArray* in[]) {
  worlds* all;
  look wanted;
  mimo_need(nin >= 3, "expected a world, a point of three numbers, and 'eyes' or 'head'");
  all = mimo_worlds_of(in[0]);
  wanted.how = (int32_t)mimo_value_of(in[2], "how", &mimo_look_words);
  wanted.env = mimo_world_at(all, nin, in, 3);
  wanted.agent = mimo_agent_at(all, nin, in, 4);
  wanted.point = mimo_vector(in[1], "point", 3);
  return wanted;
}

/* errors = look_at(number, point, how, index, agent) */
static void look_at(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const look wanted = read_look(nin, in);
  (void)nout;
  out[0] = mxCreateDoubleMatrix(2, 1, mxREAL);
  mimo_check(mimo_env_look_at(wanted.env, wanted.agent, wanted.point, wanted.how, mxGetPr(out[0])));
}

/* [joints, angles, errors] = look_angles(number, point, how, index, agent) */
static void look_angles(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  const look wanted = read_look(nin, in);
  worlds* all = mimo_worlds_of(in[0]);
  mxArray *angles, *errors = mxCreateDoubleMatrix(2, 1, mxREAL);
  size_t count = 0, i;
  int32_t* joints;
  mimo_check(mimo_env_look_angles(wanted.env, wanted.agent, wanted.point, wanted.how, NULL, NULL, 0, &count, NULL));
  joints = mxCalloc(count + 1, sizeof *joints);
  angles = mxCreateDoubleMatrix(count, 1, mxREAL);
  mimo_check(mimo_env_look_angles(wanted.env, wanted.agent, wanted.point, wanted.how, joints, mxGetPr(angles), count,
                                  &count, mxGetPr(errors)));
  out[0] = mxCreateCellMatrix(count, 1);
  for (i = 0; i < count; ++i) mxSetCell(out[0], i, mimo_name_of(all, MIMO_JOINT, joints[i]));
  if (nout > 1) out[1] = angles;
  if (nout > 2) out[2] = errors;
}

/* Checked before memory for the pixels is allocated. */
static uint32_t read_size(const mxArray* number, const char* what) {
  const double pixels = mimo_number(number, what);
  mimo_need(pixels >= 1 && pixels <= 4096 && pixels == floor(pixels),
            "height, width: expected whole numbers from 1 to 4096");
  return (uint32_t)pixels;
}

/* The arguments height, width, and camera: the name of a camera, '' for the default free camera, or a struct that
 * describes it. */
static mimo_picture_config read_picture(const mxArray* in[]) {
  mimo_picture_config config;
  mimo_check(mimo_picture_config_init(&config, sizeof config));
  config.height = read_size(in[0], "height");
  config.width = read_size(in[1], "width");
  if (mxIsStruct(in[2])) {
    properties given;
    mimo_need(mxGetNumberOfElements(in[2]) == 1, "camera: expected one struct");
    given = mimo_members(in[2], 0);
    mimo_set_all(&config, mimo_picture_options, &given, "a picture");
  } else {
    const char* camera = mimo_text(in[2], "camera");
    if (camera[0] != '\0') config.camera = camera;
  }
  return config;
}

/* [rgb, depth, segmentation] = picture(number, height, width, camera, index): only used outputs are drawn */
static void picture(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_picture_config config;
  mimo_picture buffers = {0};
  size_t pixels;
  mimo_need(nin >= 4, "expected a world, height, width, and a camera or ''");
  config = read_picture(in + 1);
  pixels = (size_t)config.height * config.width;
  buffers.struct_size = sizeof buffers;
  buffers.rgb_bytes = 3 * pixels;
  buffers.rgb = mxCalloc(buffers.rgb_bytes, sizeof *buffers.rgb);
  buffers.depth_count = nout > 1 ? pixels : 0;
  if (nout > 1) buffers.depth = mxCalloc(pixels, sizeof *buffers.depth);
  buffers.segmentation_count = nout > 2 ? pixels : 0;
  if (nout > 2) buffers.segmentation = mxCalloc(pixels, sizeof *buffers.segmentation);
  mimo_check(mimo_env_render(mimo_world_at(mimo_worlds_of(in[0]), nin, in, 4), &config, &buffers));
  out[0] = mimo_picture_of(buffers.rgb, config.height, config.width, 3, MIMO_U8);
  if (nout > 1) out[1] = mimo_picture_of(buffers.depth, config.height, config.width, 1, MIMO_F32);
  if (nout > 2) out[2] = mimo_picture_of(buffers.segmentation, config.height, config.width, 1, MIMO_I32);
}

/* pixels = project(number, points, height, width, camera, index): 3 x n for 3 x n points */
static void project(int nout, mxArray* out[], int nin, const mxArray* in[]) {
  mimo_picture_config config;
  const double* points;
  size_t count;
  (void)nout;
  mimo_need(nin >= 5, "expected a world, points (three rows), height, width, and a camera or ''");
  count = mxGetN(in[1]);
  points = mimo_matrix(in[1], "points", 3, count, "three rows, a column for each point");
  config = read_picture(in + 2);
  out[0] = mxCreateDoubleMatrix(3, count, mxREAL);
  mimo_check(
      mimo_env_project(mimo_world_at(mimo_worlds_of(in[0]), nin, in, 5), &config, points, count, mxGetPr(out[0])));
}

const mimo_command mimo_sight_commands[] = {{"gaze", gaze},       {"look_at", look_at}, {"look_angles", look_angles},
                                            {"picture", picture}, {"project", project}, {NULL, NULL}};
