/* The table of misuse: for each function of the API a call that succeeds, and what is done to its arguments so that it
 * must fail. A fault changes one member of the arguments; the row says which status follows. */
#ifndef MIMO_TESTS_MISUSE_TABLE_H
#define MIMO_TESTS_MISUSE_TABLE_H

#include "mimo/experimental.h"

/* Everything that calls are made of. Members are named as the parameters of mimo.h where one name does for all. */
typedef struct args {
  /* handles; `room` is a scene without infant, or without anything; the others have one, but for calls ON_CART a cart
   * instead */
  mimo_scene *scene, *room;
  mimo_env* env;
  mimo_batch* batch;
  mimo_senses* senses;
  mimo_recorder* recorder;
  mimo_recording* recording; /* of the environment */
  mimo_stage* stage;         /* with one geom */
  const mimo_layout* layout;
  /* structs, each in memory with room for a later version's tail */
  mimo_scene_config* scene_config;
  mimo_agent_config* agent_config;
  mimo_object_config* object_config;
  mimo_env_config* env_config;
  mimo_batch_config* batch_config;
  mimo_picture_config* picture_config;
  mimo_task* task;
  mimo_task_field* task_field;
  mimo_sense* sense;
  mimo_sense_field* sense_field;
  mimo_batch_results* results;
  mimo_env_results* env_results;
  mimo_movement* movement;
  mimo_reset_config* reset_config;
  mimo_batch_reset_config* batch_reset;
  mimo_picture* picture;
  mimo_parameter* parameter;
  mimo_agent_info* info;
  mimo_layout_info* layout_info;
  mimo_field* field;
  mimo_action* described_action;
  mimo_term* term;
  mimo_timing* timing;
  mimo_camera_config* camera_config;
  mimo_field_config* field_config;
  mimo_model_config* model_config;
  mimo_gaze* gaze;
  mimo_behaviour* behaviour;
  mimo_mesh* mesh;
  mimo_appearance* appearance;
  mimo_texture* texture;
  mimo_light* light;
  mimo_growth* growth;
  mimo_limits* limits;
  mimo_maturity* maturity;
  mimo_senses_config* senses_config;
  mimo_load_report* report;
  mimo_stage_config* stage_config; /* of the two below */
  mimo_stage_shapes* shapes;
  mimo_stage_air* air;
  mimo_stage_poses* stage_poses;
  mimo_stage_view* stage_view;
  size_t stage_pose_count;
  mimo_recorder_config* recorder_config;
  mimo_recording_info* recording_info;
  mimo_replay_report* replay_report;
  size_t more_bytes;
  /* numbers */
  int32_t kind, id, quantity, receptor_quantity, body_id, how, version, axes, geom, compare;
  size_t index, field_index, element, agent_index, world, steps;
  double angle, value, spacing, rate;
  /* strings */
  const char *name, *scene_name, *part, *parameter_name, *path, *room_name, *motor_path, *joint_name, *other, *folder,
      *field_name, *cart, *run, *new_run, *dataset;
  /* arrays that are read */
  const uint64_t* seeds;
  const uint8_t* mask;
  const float *action, *actions;
  const int32_t* ids;
  const double *points, *to_write, *all_to_write, *pose;
  const void *state, *states, *memory, *model, *data;
  size_t action_count, actions_count, id_count, point_count, worlds, state_bytes, states_bytes, memory_bytes,
      value_count, values_count;
  /* arrays that are written */
  void *block, *blocks, *state_out, *states_out, *memory_out;
  char* text;
  double *reward, *values, *all_values, *numbers, *pixels, *receptors, *look_angles, *delays;
  uint8_t *terminated, *truncated, *rgb, *texels;
  mimo_status* statuses;
  float *depth, *directions, *poses, *positions, *own_moves, *all_moves;
  uint32_t* corners;
  int32_t *outcome, *segmentation, *stage_objects, *look_joints;
  size_t block_bytes, blocks_bytes, capacity, agents, rgb_bytes, depth_count, segmentation_count;
  size_t receptor_count, look_capacity, number_count, term_count, delay_count, direction_count, picture_index,
      pose_count, texture_bytes, row_index, row_count, rows_bytes;
  /* single results */
  size_t *count, *count2;
  int32_t* id_out;
  uint32_t* u32_out;
  uint8_t *flag, *flag2;
  double* number;
  const char** string;
  mimo_status* status_out;
  /* handles that calls make */
  mimo_scene** made_scene;
  mimo_env** made_env;
  mimo_batch** made_batch;
  mimo_senses** made_senses;
  mimo_recorder** made_recorder;
  mimo_recording** made_recording;
  mimo_stage** made_stage;
  /* which its owner keeps */
  const mimo_layout** layout_out;
} args;

enum fault_kind {
  FAULT_END,
  FAULT_NULL,      /* a pointer becomes NULL */
  FAULT_SIZE,      /* a size_t becomes `whole` */
  FAULT_LESS,      /* a size_t becomes smaller by `whole` */
  FAULT_I32,       /* an int32_t becomes `whole` */
  FAULT_F64,       /* a double becomes `real` */
  FAULT_FIELD_I32, /* the same, for a field of a struct that the member points to */
  FAULT_FIELD_SIZE,
  FAULT_FIELD_LESS,
  FAULT_FIELD_F64,
  FAULT_FIELD_NULL,
  FAULT_STRUCT_SIZE, /* the struct's first field becomes `whole` */
  FAULT_STRUCT_TAIL, /* ... the struct's size and 16 bytes more, which are `field` each */
  FAULT_DO           /* whatever `change` does */
};

typedef struct fault {
  enum fault_kind kind;
  const char* what; /* for people */
  size_t at, field; /* offsets */
  int64_t whole;
  double real;
  void (*change)(args* a);
  mimo_status status; /* what the call then answers */
  const char* names;  /* what the message must name, NULL if the call succeeds */
} fault;

/* What a row's call works on; whether a world that has failed refuses it or is healed by it; whether it may come
 * between mimo_batch_send and mimo_batch_receive; whether it destroys. */
enum {
  ON_SCENE = 1,
  ON_ROOM = 2,
  ON_ENV = 4,
  ON_BATCH = 8,
  SIMULATES = 16,
  HEALS = 32,
  ANYTIME = 64,
  DESTROYS = 128,
  ON_SENSES = 256,
  ON_CART = 512,
  ON_EMPTY = 1024, /* a room that is none */
  ON_LAYOUT = 2048,
  ON_RECORDER = 4096,
  ON_RECORDING = 8192,
  ON_STAGE = 16384,
  ON_BEHAVIOUR = 32768 /* a room that has one */
};

typedef struct row {
  const char* name;
  int uses;
  mimo_status (*call)(args* a);
  const fault* faults;
} row;

extern const row all_rows[];
extern const size_t row_count;

/* Failed checks of rows.c; each file counts its own. */
int rows_failures(void);

/* Faults of members. Those whose name ends with _OK are none: the call succeeds. */
#define MEMBER(m) offsetof(args, m)
#define E_ARG MIMO_E_INVALID_ARGUMENT
#define NO_NULL(m, names) \
  { FAULT_NULL, #m " is NULL", MEMBER(m), 0, 0, 0, NULL, E_ARG, names }
#define NULL_OK(m) \
  { FAULT_NULL, #m " is NULL", MEMBER(m), 0, 0, 0, NULL, MIMO_OK, NULL }
#define BAD_SIZE(m, n, names) \
  { FAULT_SIZE, #m " is " #n, MEMBER(m), 0, (int64_t)(n), 0, NULL, E_ARG, names }
#define SIZE_IS(m, n, status, names) \
  { FAULT_SIZE, #m " is " #n, MEMBER(m), 0, (int64_t)(n), 0, NULL, status, names }
/* One element too few, none at all, and as many as no memory has room for. */
#define SHORT(m, names)                                                                           \
  {FAULT_LESS, #m " is one too small", MEMBER(m), 0, 1, 0, NULL, MIMO_E_BUFFER_TOO_SMALL, names}, \
      {FAULT_SIZE, #m " is 0", MEMBER(m), 0, 0, 0, NULL, MIMO_E_BUFFER_TOO_SMALL, names}, {       \
    FAULT_SIZE, #m " is huge", MEMBER(m), 0, -1, 0, NULL, E_ARG, names                            \
  }
/* A length that must be met exactly. */
#define EXACT(m, names)                                                                \
  {FAULT_LESS, #m " is one too small", MEMBER(m), 0, 1, 0, NULL, E_ARG, names},        \
      {FAULT_LESS, #m " is one too large", MEMBER(m), 0, -1, 0, NULL, E_ARG, names}, { \
    FAULT_SIZE, #m " is huge", MEMBER(m), 0, -1, 0, NULL, E_ARG, names                 \
  }
/* A state that was cut, or has something behind it. */
#define WHOLE_STATE(m)                                                                       \
  {FAULT_LESS, #m " is one too small", MEMBER(m), 0, 1, 0, NULL, MIMO_E_FILE, "state"},      \
      {FAULT_LESS, #m " is one too large", MEMBER(m), 0, -1, 0, NULL, MIMO_E_FILE, "state"}, \
      {FAULT_SIZE, #m " is huge", MEMBER(m), 0, -1, 0, NULL, MIMO_E_FILE, "state"}, {        \
    FAULT_SIZE, #m " is 0", MEMBER(m), 0, 0, 0, NULL, MIMO_E_FILE, "state"                   \
  }
#define BAD_I32(m, n, names) \
  { FAULT_I32, #m " is " #n, MEMBER(m), 0, n, 0, NULL, E_ARG, names }
#define BAD_IDS(m, names) BAD_I32(m, -1, names), BAD_I32(m, INT32_MIN, names), BAD_I32(m, INT32_MAX, names)
/* Constants that the library does not know. */
#define UNKNOWN(m, n, names) \
  { FAULT_I32, #m " is " #n, MEMBER(m), 0, n, 0, NULL, MIMO_E_UNSUPPORTED, names }
#define UNKNOWNS(m, first, names) \
  UNKNOWN(m, first, names), UNKNOWN(m, -1, names), UNKNOWN(m, INT32_MIN, names), UNKNOWN(m, INT32_MAX, names)
#define BAD_INDEX(m, names) BAD_SIZE(m, 1000000, names), BAD_SIZE(m, -1, names)
#define BAD_F64(m, n, names) \
  { FAULT_F64, #m " is " #n, MEMBER(m), 0, 0, n, NULL, E_ARG, names }
#define NOT_FINITE(m, names) BAD_F64(m, NAN, names), BAD_F64(m, INFINITY, names), BAD_F64(m, -INFINITY, names)
#define DO(function, status, names) \
  { FAULT_DO, #function, 0, 0, 0, 0, function, status, names }

/* Faults of structs. */
#define FIELD(t, f) offsetof(t, f)
#define BAD_FIELD(m, t, f, n, names) \
  { FAULT_FIELD_I32, #f " is " #n, MEMBER(m), FIELD(t, f), (int64_t)(n), 0, NULL, E_ARG, names }
#define UNKNOWN_FIELD(m, t, f, n, names) \
  { FAULT_FIELD_I32, #f " is " #n, MEMBER(m), FIELD(t, f), (int64_t)(n), 0, NULL, MIMO_E_UNSUPPORTED, names }
#define BAD_REAL(m, t, f, n, names) \
  { FAULT_FIELD_F64, #f " is " #n, MEMBER(m), FIELD(t, f), 0, n, NULL, E_ARG, names }
#define UNREAL(m, t, f, names) BAD_REAL(m, t, f, NAN, names), BAD_REAL(m, t, f, INFINITY, names)
#define SHORT_FIELD(m, t, f, names)                                                                                 \
  {FAULT_FIELD_LESS, #f " is one too small", MEMBER(m), FIELD(t, f), 1, 0, NULL, MIMO_E_BUFFER_TOO_SMALL, names}, { \
    FAULT_FIELD_SIZE, #f " is huge", MEMBER(m), FIELD(t, f), -1, 0, NULL, E_ARG, names                              \
  }
#define STRUCT_IS(m, n, names) \
  { FAULT_STRUCT_SIZE, #m "'s struct_size is " #n, MEMBER(m), 0, (int64_t)(n), 0, NULL, MIMO_E_STRUCT_SIZE, names }
#define STRUCT_LATER(m, t, tail, status, names) \
  { FAULT_STRUCT_TAIL, #m " is of a later version, tail " #tail, MEMBER(m), tail, sizeof(t), 0, NULL, status, names }
#define BAD_SIZES(m, t, names) \
  STRUCT_IS(m, 0, names), STRUCT_IS(m, 8, names), STRUCT_IS(m, 1000000, names), STRUCT_IS(m, -1, names)
/* A struct that is read, and one that is filled. */
#define CONFIG(m, t, names) \
  BAD_SIZES(m, t, names), STRUCT_LATER(m, t, 0, MIMO_OK, NULL), STRUCT_LATER(m, t, 1, MIMO_E_UNSUPPORTED, names)
#define DESCRIPTION(m, t, names) NO_NULL(m, names), BAD_SIZES(m, t, names), STRUCT_LATER(m, t, 1, MIMO_OK, NULL)
#define LOAD_REPORT                                               \
  NULL_OK(report), BAD_SIZES(report, mimo_load_report, "report"), \
      STRUCT_LATER(report, mimo_load_report, 1, MIMO_OK, NULL)
/* A function that is told the struct's size: sizeof(t) + more_bytes. */
#define INIT(m, t, names)                                                                 \
  NO_NULL(m, names), SIZE_IS(more_bytes, -(int64_t)sizeof(t), MIMO_E_STRUCT_SIZE, names), \
      SIZE_IS(more_bytes, 8 - (int64_t)sizeof(t), MIMO_E_STRUCT_SIZE, names),             \
      SIZE_IS(more_bytes, 1000000, MIMO_E_STRUCT_SIZE, names),                            \
      SIZE_IS(more_bytes, -1 - (int64_t)sizeof(t), MIMO_E_STRUCT_SIZE, names), SIZE_IS(more_bytes, 16, MIMO_OK, NULL)

#endif
