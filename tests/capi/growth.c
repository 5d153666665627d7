/* Infants of other ages than 18 months. Lengths and weights are those of the WHO Child Growth Standards, 2006. */
#include "support/capi.h"

enum { STEPS = 20 };

static mimo_growth age_of(double months) {
  mimo_growth growth;
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.age = months;
  return growth;
}

static mimo_scene* scene_of(const char* name) {
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.name = name;
  CHECK_OK(mimo_scene_create(&config, &scene));
  return scene;
}

static mimo_status add(mimo_scene* scene, const char* body, const char* name, const mimo_growth* growth) {
  mimo_agent_config agent;
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.body = body;
  agent.name = name;
  agent.growth = growth;
  return mimo_scene_add_agent(scene, &agent, NULL);
}

static mimo_env* env_of(const char* scene_name, const char* body, const mimo_growth* growth) {
  mimo_scene* scene = scene_of(scene_name);
  mimo_env* env = NULL;
  CHECK_OK(add(scene, body, "", growth));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

static mimo_agent_info info_of(const mimo_env* env, size_t agent) {
  mimo_agent_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_OK(mimo_env_agent(env, agent, &info));
  return info;
}

static double value_of(const mimo_env* env, int32_t quantity, int32_t kind, const char* name, size_t which) {
  const int32_t id = find(env, kind, name);
  size_t count = 0;
  double values[8] = {0};
  CHECK_OK(mimo_env_width(env, quantity, &id, 1, &count));
  CHECK_OK(mimo_env_get(env, quantity, &id, 1, values, count));
  return values[which];
}

/* With all defaults it is the body that it was, to the last bit. */
static void at_18_months_nothing_changes(const char* body) {
  const mimo_growth usual = age_of(18);
  mimo_env* as_it_was = env_of("benchmark", body, NULL);
  mimo_env* grown = env_of("benchmark", body, &usual);
  const size_t bytes = sizes_of(as_it_was).block_bytes, actions = sizes_of(as_it_was).actions;
  unsigned char* one = calloc(1, bytes);
  unsigned char* other = calloc(1, bytes);
  float* action = calloc(actions, sizeof *action);
  size_t i;
  int step;
  CHECK(sizes_of(grown).block_bytes == bytes);
  CHECK_OK(mimo_env_reset(as_it_was, NULL, one, bytes));
  CHECK_OK(mimo_env_reset(grown, NULL, other, bytes));
  for (step = 0; step < STEPS; ++step) {
    for (i = 0; i < actions; ++i) action[i] = (float)((step + 3 * i) % 5) / 8 - 0.25F;
    CHECK_OK(mimo_env_step(as_it_was, action, actions, one, bytes, NULL));
    CHECK_OK(mimo_env_step(grown, action, actions, other, bytes, NULL));
    CHECK(memcmp(one, other, bytes) == 0);
  }
  free(one);
  free(other);
  free(action);
  mimo_env_destroy(as_it_was);
  mimo_env_destroy(grown);
}

/* Of the tables: L, M and S at this age; a value is M (1 + L S z)^(1/L). */
typedef struct lms {
  double l, m, s;
} lms;
static const struct standard {
  int32_t sex;
  double age;
  lms length, weight;
} standards[] = {
    {MIMO_SEX_MALE, 0, {1, 49.8842, 0.03795}, {0.3487, 3.3464, 0.14602}},
    {MIMO_SEX_MALE, 6, {1, 67.6236, 0.03165}, {0.1257, 7.934, 0.10958}},
    {MIMO_SEX_MALE, 24, {1, 87.8161, 0.03479}, {-0.0137, 12.1515, 0.11426}},
    {MIMO_SEX_FEMALE, 0, {1, 49.1477, 0.0379}, {0.3809, 3.2322, 0.14171}},
    {MIMO_SEX_FEMALE, 6, {1, 65.7311, 0.03448}, {-0.0756, 7.297, 0.12204}},
    {MIMO_SEX_FEMALE, 24, {1, 86.4153, 0.03734}, {-0.2941, 11.4775, 0.1239}},
};
/* Means of the medians of both sexes at 18 months, to which the body of 18 months is what it is. */
static const double length_18 = 81.4833, weight_18 = 10.585;

static double standard_value(lms it, double z) { return it.m * pow(1 + it.l * it.s * z, 1 / it.l); }

static void size_and_weight_are_the_standard_s(const char* body) {
  mimo_env* base = env_of("free", body, NULL);
  const mimo_agent_info was = info_of(base, 0);
  size_t i;
  int z;
  for (i = 0; i < sizeof standards / sizeof *standards; ++i) {
    for (z = -2; z <= 2; z += 2) {
      mimo_growth growth = age_of(standards[i].age);
      mimo_env* env;
      growth.sex = standards[i].sex;
      growth.z_length = growth.z_weight = z;
      env = env_of("free", body, &growth);
      CHECK_NEAR(standard_value(standards[i].length, z) / length_18, info_of(env, 0).height / was.height, 0.001);
      CHECK_NEAR(standard_value(standards[i].weight, z) / weight_18, info_of(env, 0).mass / was.mass, 0.005);
      mimo_env_destroy(env);
    }
  }
  mimo_env_destroy(base);
}

/* Of length 81.4833 cm and weight 10.585 kg at 18 months, the means of the sexes. */
static void absolute_is_the_standard_itself(void) {
  mimo_growth growth = age_of(18);
  mimo_env* env;
  growth.absolute = 1;
  env = env_of("free", "mitten", &growth);
  CHECK_NEAR(length_18 / 100, info_of(env, 0).height, 0.001);
  CHECK_NEAR(weight_18, info_of(env, 0).mass, 0.005);
  mimo_env_destroy(env);
}

/* One policy can live in all ages. */
static void the_layout_is_the_same_at_all_ages(const char* body) {
  static const double ages[] = {0, 1.5, 6, 24};
  mimo_env* base = env_of("free", body, NULL);
  const mimo_layout_info was = sizes_of(base);
  size_t i, field;
  for (i = 0; i < sizeof ages / sizeof *ages; ++i) {
    const mimo_growth growth = age_of(ages[i]);
    mimo_env* env = env_of("free", body, &growth);
    CHECK(sizes_of(env).block_bytes == was.block_bytes && sizes_of(env).fields == was.fields);
    for (field = 0; field < was.fields; ++field) {
      CHECK(field_at(layout_of(env), field).receptors == field_at(layout_of(base), field).receptors);
      CHECK(field_at(layout_of(env), field).offset == field_at(layout_of(base), field).offset);
    }
    mimo_env_destroy(env);
  }
  mimo_env_destroy(base);
}

/* Strength and range of motion follow the physiological age, size and mass do not. */
static void the_two_ages_are_apart(void) {
  mimo_growth growth = age_of(18);
  mimo_env *base = env_of("free", "mitten", NULL), *env;
  growth.matures_apart = 1;
  growth.physiological_age = 3;
  env = env_of("free", "mitten", &growth);
  CHECK_NEAR(info_of(base, 0).mass, info_of(env, 0).mass, 0);
  CHECK_NEAR(info_of(base, 0).height, info_of(env, 0).height, 0);
  /* Median length at 3 months over that at 18, means of the sexes of the WHO's tables: (61.4292 + 59.8029) / 2 cm. */
  CHECK_NEAR(pow((61.4292 + 59.8029) / 2 / length_18, 1.7),
             value_of(env, MIMO_ACTUATOR_GEAR, MIMO_ACTUATOR, "act:left_elbow", 0) /
                 value_of(base, MIMO_ACTUATOR_GEAR, MIMO_ACTUATOR, "act:left_elbow", 0),
             1e-4);
  /* Knees of infants of 3 months lack 10.7 degrees of extension: Broughton 1993. */
  CHECK_NEAR(-10.7 * acos(-1) / 180, value_of(env, MIMO_JOINT_RANGE, MIMO_JOINT, "robot:left_knee", 1), 1e-9);
  mimo_env_destroy(env);
  mimo_env_destroy(base);
}

static double gear_of(const mimo_growth* growth, const char* motor) {
  mimo_env* env = env_of("free", "mitten", growth);
  const double gear = value_of(env, MIMO_ACTUATOR_GEAR, MIMO_ACTUATOR, motor, 0);
  mimo_env_destroy(env);
  return gear;
}

/* Of the body of 18 months, whose muscles are as strong as those of 3. */
static void strength_follows_its_exponent(void) {
  const double length = (61.4292 + 59.8029) / 2 / length_18, whole = gear_of(NULL, "act:left_elbow");
  mimo_growth growth = age_of(18);
  growth.matures_apart = 1;
  growth.physiological_age = 3;
  growth.strength_exponent = 3;
  CHECK_NEAR(pow(length, 3), gear_of(&growth, "act:left_elbow") / whole, 1e-4);
  growth.strength_exponent = 0;
  CHECK_NEAR(1, gear_of(&growth, "act:left_elbow") / whole, 1e-12);
}

static void the_neck_has_a_strength_of_its_own(void) {
  mimo_growth growth = age_of(6);
  const double neck = gear_of(&growth, "act:head_tilt"), elbow = gear_of(&growth, "act:left_elbow");
  growth.neck_strength = 2.5;
  CHECK_NEAR(2.5, gear_of(&growth, "act:head_tilt") / neck, 1e-12);
  CHECK_NEAR(1, gear_of(&growth, "act:left_elbow") / elbow, 1e-12);
}

/* The stiffness of a joint by the document. */
static double stiffness_of(const mimo_growth* growth, const char* joint) {
  static char xml[1 << 20];
  mimo_scene* scene = scene_of("free");
  char name[100];
  const char *at, *end, *number;
  size_t length = 0;
  CHECK_OK(add(scene, "mitten", "", growth));
  CHECK_OK(mimo_scene_xml(scene, xml, sizeof xml, &length));
  mimo_scene_destroy(scene);
  snprintf(name, sizeof name, "name=\"%s\"", joint);
  at = strstr(xml, name);
  CHECK(at != NULL);
  if (at == NULL) return 0;
  while (*at != '<') --at;
  end = strchr(at, '>');
  number = strstr(at, "stiffness=\"");
  CHECK(number != NULL && number < end);
  return number == NULL ? 0 : strtod(number + strlen("stiffness=\""), NULL);
}

/* 1.5 by itself at birth, and nothing from six months on. */
static void a_newborn_s_tone_is_a_factor(void) {
  const mimo_growth half_a_year = age_of(6);
  mimo_growth growth = age_of(0);
  const double usual = stiffness_of(&growth, "robot:left_knee");
  growth.birth_tone = 3;
  CHECK_NEAR(2, stiffness_of(&growth, "robot:left_knee") / usual, 1e-6);
  growth = half_a_year;
  growth.birth_tone = 3;
  CHECK_NEAR(1, stiffness_of(&growth, "robot:left_knee") / stiffness_of(&half_a_year, "robot:left_knee"), 1e-6);
}

/* Knees lack 10.7 degrees at 3 months (Broughton 1993); a quarter of the way there from where they end at 18. */
static void contracture_is_a_share(void) {
  mimo_growth growth = age_of(3);
  mimo_env *base = env_of("free", "mitten", NULL), *env;
  const double end = value_of(base, MIMO_JOINT_RANGE, MIMO_JOINT, "robot:left_knee", 1);
  growth.contracture = 0.25;
  env = env_of("free", "mitten", &growth);
  CHECK_NEAR(0.75 * end - 0.25 * 10.7 * acos(-1) / 180,
             value_of(env, MIMO_JOINT_RANGE, MIMO_JOINT, "robot:left_knee", 1), 1e-9);
  mimo_env_destroy(env);
  mimo_env_destroy(base);
}

static double height_of(const mimo_growth* growth) {
  mimo_env* env = env_of("free", "mitten", growth);
  const double height = info_of(env, 0).height;
  mimo_env_destroy(env);
  return height;
}

static double head_of(const mimo_growth* growth) {
  mimo_env* env = env_of("free", "mitten", growth);
  const double size = value_of(env, MIMO_GEOM_SIZE, MIMO_GEOM, "head", 0);
  mimo_env_destroy(env);
  return size;
}

/* 97.725 of 100 are below two standard deviations. L of the standard for heads is 1: they are apart equally. */
static void percentiles_agree_with_z_scores(void) {
  mimo_growth growth = age_of(6), high = growth, low = growth;
  growth.z_length = growth.z_weight = growth.z_head = 2;
  high.percentile = 97.72498680518208;
  CHECK_NEAR(height_of(&growth), height_of(&high), 1e-9);
  high = age_of(6);
  high.z_head = 2;
  low.z_head = -2;
  growth = age_of(6);
  CHECK(head_of(&high) > 1.03 * head_of(&growth));
  CHECK_NEAR(head_of(&growth), (head_of(&high) + head_of(&low)) / 2, 1e-9);
}

/* Sensors by their number, which a smaller skin keeps, or by their spacing. */
static void sensors_keep_their_number_or_spacing(void) {
  mimo_growth growth = age_of(0);
  mimo_env *env = env_of("free", "mitten", NULL), *newborn = env_of("free", "mitten", &growth), *apart;
  const size_t sensors = field_of(env, "touch/force").receptors;
  CHECK(field_of(newborn, "touch/force").receptors == sensors);
  growth.keep_spacing = 1;
  apart = env_of("free", "mitten", &growth);
  CHECK((double)field_of(apart, "touch/force").receptors < 0.7 * (double)sensors);
  mimo_env_destroy(env);
  mimo_env_destroy(newborn);
  mimo_env_destroy(apart);
}

static void nerves_mature_where_they_are_asked_to(void) {
  mimo_growth growth = age_of(1);
  mimo_env *env = env_of("free", "mitten", &growth), *slow;
  CHECK(delay_of(env, "proprioception/position", 0) == 0);
  growth.maturity = MIMO_MATURITY_BODY | MIMO_MATURITY_DELAYS;
  slow = env_of("free", "mitten", &growth);
  CHECK(delay_of(slow, "proprioception/position", 0) > 0);
  mimo_env_destroy(env);
  mimo_env_destroy(slow);
}

/* By the original's rules another body, except at 18 months. */
static void who_and_original_differ(void) {
  mimo_growth growth = age_of(6);
  const double by_who = height_of(&growth);
  growth.model = MIMO_GROWTH_ORIGINAL;
  CHECK(fabs(height_of(&growth) - by_who) > 0.001);
}

static void siblings_have_different_ages(void) {
  const mimo_growth young = age_of(2), old = age_of(20);
  mimo_scene* scene = scene_of("playdate");
  mimo_env *env = NULL, *alone = env_of("free", "mitten", &young);
  CHECK_OK(add(scene, "mitten", "anna", &young));
  CHECK_OK(add(scene, "mitten", "ben", &old));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_NEAR(info_of(alone, 0).mass, info_of(env, 0).mass, 1e-12);
  CHECK(info_of(env, 1).mass > 1.5 * info_of(env, 0).mass);
  mimo_scene_destroy(scene);
  mimo_env_destroy(alone);
  mimo_env_destroy(env);
}

/* An infant that the document brings along grows as well. */
static void infants_of_the_document_grow(void) {
  mimo_growth growth = age_of(3);
  mimo_env *alone = env_of("free", "mitten", &growth), *env = NULL;
  mimo_scene_config config;
  mimo_scene* scene = NULL;
  CHECK_OK(mimo_scene_config_init(&config, sizeof config));
  config.xml = "<mujoco><compiler angle='radian'/><include file='mimo/mitten.xml'/></mujoco>";
  CHECK_OK(mimo_scene_create(&config, &scene));
  CHECK_OK(add(scene, "scene", "", &growth));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_NEAR(info_of(alone, 0).mass, info_of(env, 0).mass, 1e-12);
  CHECK_NEAR(value_of(alone, MIMO_JOINT_RANGE, MIMO_JOINT, "robot:left_knee", 1),
             value_of(env, MIMO_JOINT_RANGE, MIMO_JOINT, "robot:left_knee", 1), 1e-12);
  mimo_scene_destroy(scene);
  mimo_env_destroy(alone);
  mimo_env_destroy(env);
}

static void growth_out_of_range_is_refused(void) {
  mimo_growth growth = age_of(0);
  mimo_scene* scene = scene_of("free");
  growth.z_length = -3;
  growth.z_weight = 3;
  growth.z_head = -3;
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "do not go together", add(scene, "mitten", "", &growth));
  growth = age_of(24.5);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "age is 24.5, expected 0 to 24 months", add(scene, "mitten", "", &growth));
  growth = age_of(6);
  growth.percentile = 0.5; /* of those who mean the median */
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "percentile is 0.5, expected percent, 1 to 99.865, of which 50 is the median",
              add(scene, "mitten", "", &growth));
  CHECK_OK(add(scene, "mitten", "", NULL)); /* nothing has been added so far */
  mimo_scene_destroy(scene);
}

int main(void) {
  at_18_months_nothing_changes("mitten");
  at_18_months_nothing_changes("fingers");
  size_and_weight_are_the_standard_s("mitten");
  size_and_weight_are_the_standard_s("fingers");
  absolute_is_the_standard_itself();
  the_layout_is_the_same_at_all_ages("mitten");
  the_layout_is_the_same_at_all_ages("fingers");
  the_two_ages_are_apart();
  strength_follows_its_exponent();
  the_neck_has_a_strength_of_its_own();
  a_newborn_s_tone_is_a_factor();
  contracture_is_a_share();
  percentiles_agree_with_z_scores();
  sensors_keep_their_number_or_spacing();
  nerves_mature_where_they_are_asked_to();
  who_and_original_differ();
  siblings_have_different_ages();
  infants_of_the_document_grow();
  growth_out_of_range_is_refused();
  return failures();
}
