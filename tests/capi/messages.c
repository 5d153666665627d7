/* Messages of errors: by tasks, by handle, of one line, in UTF-8. */
#include <pthread.h>

#include "support/capi.h"

/* ---- Of tasks ---- */

typedef struct plan {
  int says, mistakes;
  mimo_status status;
  double reward;
  char at_start[64]; /* mimo_last_error() when the task was asked */
} plan;

static mimo_status judge(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  plan* it = user;
  int32_t id;
  (void)moment;
  snprintf(it->at_start, sizeof it->at_start, "%s", mimo_last_error());
  verdict->reward = it->reward;
  if (it->mistakes && mimo_env_find(env, MIMO_BODY, "unicorn", &id) != MIMO_E_NOT_FOUND) return MIMO_E_INTERNAL;
  return it->says ? mimo_fail(it->status, "the ball left the table") : it->status;
}

static mimo_scene* scene_with(plan* it) {
  mimo_scene* scene = blind_scene("free");
  mimo_task task;
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = judge;
  task.user = it;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  return scene;
}

static mimo_status step(mimo_env* env) { return mimo_env_step(env, NULL, 0, NULL, 0, NULL); }

static void check_messages_of_tasks(void) {
  plan it = {0};
  mimo_scene* scene = scene_with(&it);
  mimo_env* env = NULL;
  CHECK_OK(mimo_env_create(scene, NULL, &env));

  it.status = MIMO_E_RENDER; /* it says nothing: what failed before is not its reason, and nothing grows */
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "count is NULL", mimo_env_count(env, MIMO_AGENT, NULL));
  CHECK(step(env) == MIMO_E_TASK);
  CHECK_TEXT("the task's function evaluate returned -8 (MIMO_E_RENDER)", mimo_last_error());
  CHECK(step(env) == MIMO_E_TASK);
  CHECK_TEXT("the task's function evaluate returned -8 (MIMO_E_RENDER)", mimo_last_error());
  CHECK_TEXT("", it.at_start);

  it.says = 1;
  CHECK(step(env) == MIMO_E_TASK);
  CHECK_TEXT("the task's function evaluate returned -8 (MIMO_E_RENDER): the ball left the table", mimo_last_error());
  it.says = 0;

  it.mistakes = 1; /* it looked for something that is not there and lived with it */
  CHECK(step(env) == MIMO_E_TASK);
  CHECK_TEXT("the task's function evaluate returned -8 (MIMO_E_RENDER)", mimo_last_error());
  it.status = MIMO_E_NOT_FOUND; /* it hands on what failed */
  CHECK_FAILS(MIMO_E_TASK, "(MIMO_E_NOT_FOUND): no body named \"unicorn\"", step(env));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "count is NULL", mimo_env_count(env, MIMO_AGENT, NULL));
  it.status = MIMO_OK; /* what failed inside is nothing to the outside */
  CHECK_OK(step(env));
  CHECK_TEXT("count is NULL", mimo_last_error());
  it.mistakes = 0;

  it.reward = NAN;
  CHECK_FAILS(MIMO_E_TASK, "evaluate gave agent 0 the reward nan, expected a finite number", step(env));
  it.reward = -INFINITY;
  CHECK_FAILS(MIMO_E_TASK, "the reward -inf", step(env));
  it.reward = 1;
  CHECK_OK(step(env));
  CHECK(sizes_of(env).agents == 1); /* it is none the worse for it */
  mimo_env_destroy(env);
  mimo_scene_destroy(scene);
}

static void check_messages_of_worlds_in_batches(void) {
  plan it = {1, 0, MIMO_E_RENDER, 0, ""};
  mimo_scene* scene = scene_with(&it);
  mimo_batch* batch = NULL;
  const char* message = NULL;
  mimo_status status = MIMO_OK;
  CHECK_OK(mimo_batch_create(scene, NULL, NULL, &batch));
  CHECK_FAILS(MIMO_E_TASK, "world 0: the task's function evaluate returned -8 (MIMO_E_RENDER): the ball left",
              mimo_batch_step(batch, NULL, 0, NULL, 0, NULL));
  CHECK_OK(mimo_batch_world_error(batch, 0, &status, &message));
  CHECK_TEXT("the task's function evaluate returned -8 (MIMO_E_RENDER): the ball left the table", message);
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

static void check_mimo_fail(void) {
  mimo_status status = -1;
  for (; strcmp(mimo_status_name(status), "MIMO_E_UNKNOWN") != 0; --status) CHECK(mimo_fail(status, "") == status);
  CHECK(status == MIMO_E_END - 1);
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "status is 0, expected a MIMO_E_ constant, -17 to -1", mimo_fail(MIMO_OK, ""));
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "status is -18, which needs an interface newer", mimo_fail(status, ""));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "message is NULL", mimo_fail(MIMO_E_INTERNAL, NULL));
  CHECK(mimo_fail(MIMO_E_FORKED, "split") == MIMO_E_FORKED);
  CHECK_TEXT("split", mimo_last_error());
}

/* ---- By handle ---- */

static const char* message_of(const void* handle) {
  static char text[1024];
  size_t length = 0;
  memset(text, 'x', sizeof text);
  CHECK_OK(mimo_last_error_of(handle, NULL, 0, &length));
  CHECK_OK(mimo_last_error_of(handle, text, length + 1, NULL));
  CHECK(text[length] == '\0' && strlen(text) == length);
  return text;
}

static void* fail_elsewhere(void* env) {
  int32_t id;
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no body named \"griffin\"", mimo_env_find(env, MIMO_BODY, "griffin", &id));
  return NULL;
}

static void check_messages_by_handle(void) {
  mimo_scene* scene = blind_scene("free");
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  mimo_env_config config;
  pthread_t thread;
  char text[8] = "as it";
  size_t count;
  static int no_handle[64];
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK_OK(mimo_batch_create(scene, NULL, NULL, &batch));
  CHECK_TEXT("", message_of(scene));
  CHECK_TEXT("", message_of(env));
  CHECK(pthread_create(&thread, NULL, fail_elsewhere, env) == 0);
  pthread_join(thread, NULL);
  CHECK(strncmp("no body named \"griffin\"", message_of(env), 23) == 0);
  CHECK_FAILS(MIMO_E_BUSY, "receive without", mimo_batch_receive(batch));
  CHECK_TEXT("mimo_batch_receive without mimo_batch_send", message_of(batch));
  CHECK_OK(mimo_env_config_init(&config, sizeof config)); /* what fails to be made: its scene tells */
  config.frame_skip = 1001;
  CHECK(mimo_env_create(scene, &config, &env) == MIMO_E_INVALID_ARGUMENT);
  CHECK(strncmp("frame_skip is 1001", message_of(scene), 18) == 0);
  CHECK_TEXT(mimo_last_error(), message_of(scene));

  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "handle is NULL", mimo_last_error_of(NULL, text, sizeof text, NULL));
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "handle is not a handle", mimo_last_error_of(no_handle, text, sizeof text, NULL));
  CHECK_FAILS(MIMO_E_BUFFER_TOO_SMALL, "text has a length of 8 bytes", mimo_last_error_of(scene, text, 8, NULL));
  CHECK_FAILS(MIMO_E_INVALID_ARGUMENT, "text is NULL", mimo_last_error_of(scene, NULL, 8, NULL));
  CHECK_TEXT("as it", text);
  CHECK(strncmp("frame_skip is 1001", message_of(scene), 18) == 0);

  mimo_env_destroy(env);
  CHECK(mimo_env_count(env, MIMO_AGENT, &count) == MIMO_E_BAD_HANDLE);
  CHECK_FAILS(MIMO_E_BAD_HANDLE, "handle is a mimo_env that has been destroyed",
              mimo_last_error_of(env, text, sizeof text, NULL));
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

/* Threads that fail on one handle while others ask: one message or another, but a whole one. */
static void* fail_often(void* env) {
  char name[32], text[1024];
  int32_t id;
  int i;
  snprintf(name, sizeof name, "ghost%d", (int)(pthread_self() % 1000));
  for (i = 0; i < 300; ++i) {
    CHECK(mimo_env_find(env, MIMO_BODY, name, &id) == MIMO_E_NOT_FOUND);
    CHECK(strstr(mimo_last_error(), name) != NULL);
    CHECK(mimo_last_error_of(env, text, sizeof text, NULL) == MIMO_OK);
    CHECK(strncmp(text, "no body named \"ghost", 20) == 0 && strstr(text, "there are: ") != NULL);
  }
  return NULL;
}

static void check_four_failing_threads(void) {
  mimo_env* env = blind_env("free", NULL);
  pthread_t threads[4];
  int i;
  for (i = 0; i < 4; ++i) CHECK(pthread_create(&threads[i], NULL, fail_often, env) == 0);
  for (i = 0; i < 4; ++i) pthread_join(threads[i], NULL);
  mimo_env_destroy(env);
}

/* ---- In one line ---- */

#define CONTROLS "a\nb\r\t\x1b[31mred\x7f \xc2\x9b \xc2\xa0\xe2\x80\xa8 \xe2\x82\xac\\n"
#define QUOTED "a\\nb\\r\\t\\x1b[31mred\\x7f \\x9b \xc2\xa0\\u2028 \xe2\x82\xac\\n"

static mimo_status judge_oddly(void* user, mimo_env* env, const mimo_task_moment* moment, mimo_task_verdict* verdict) {
  (void)user, (void)env, (void)moment, (void)verdict;
  return mimo_fail(MIMO_E_NOT_FOUND, CONTROLS);
}

static void keep_text(void* user, const mimo_log_record* record) {
  const unsigned char* bytes = (const unsigned char*)record;
  size_t i;
  CHECK(record->struct_size == sizeof *record);
  for (i = sizeof *record; i < 256; ++i) CHECK(bytes[i] == 0); /* room for a later version */
  strncat(user, record->text, 1000 - strlen(user));
}

static void check_that_messages_are_one_line(void) {
  const char* expected = "the task's function evaluate returned -5 (MIMO_E_NOT_FOUND): " QUOTED;
  char said[1024] = "";
  mimo_scene_config room;
  mimo_object_config object;
  mimo_agent_config agent;
  mimo_task task;
  mimo_scene* scene = NULL;
  mimo_env* env = NULL;
  mimo_batch* batch = NULL;
  const char* message = NULL;
  int32_t id;
  CHECK(mimo_fail(MIMO_E_NOT_FOUND, CONTROLS) == MIMO_E_NOT_FOUND);
  CHECK_TEXT(QUOTED, mimo_last_error());

  CHECK_OK(mimo_scene_config_init(&room, sizeof room));
  room.name = "free";
  room.log = keep_text;
  room.log_user = said;
  CHECK_OK(mimo_scene_create(&room, &scene));
  CHECK_OK(mimo_object_config_init(&object, sizeof object));
  object.name = "odd\ntoy";
  object.size[0] = 0.5;
  object.position[2] = 1;
  object.fixed = 1;
  CHECK_OK(mimo_scene_add_object(scene, &object));
  CHECK_OK(mimo_agent_config_init(&agent, sizeof agent));
  agent.vision = 0;
  agent.place = MIMO_PLACE_ROOT;
  agent.position[2] = 1;
  CHECK_OK(mimo_scene_add_agent(scene, &agent, NULL));
  CHECK_OK(mimo_task_init(&task, sizeof task));
  task.evaluate = judge_oddly;
  CHECK_OK(mimo_scene_set_task(scene, &task));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  CHECK(strstr(said, "odd\\ntoy") != NULL && strchr(said, '\n') == NULL);
  CHECK(step(env) == MIMO_E_TASK);
  CHECK_TEXT(expected, mimo_last_error());
  CHECK_TEXT(expected, message_of(env));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "no body named \"gr\\niffin\"", mimo_env_find(env, MIMO_BODY, "gr\niffin", &id));
  mimo_env_destroy(env);
  CHECK_OK(mimo_batch_create(scene, NULL, NULL, &batch));
  CHECK(mimo_batch_step(batch, NULL, 0, NULL, 0, NULL) == MIMO_E_TASK);
  CHECK_OK(mimo_batch_world_error(batch, 0, NULL, &message));
  CHECK_TEXT(expected, message);
  mimo_batch_destroy(batch);
  mimo_scene_destroy(scene);
}

/* ---- In UTF-8 ---- */

/* Whether all of a text is letters of UTF-8; those that this test uses have one or two bytes. */
static int is_utf8(const char* text) {
  for (; *text != '\0'; ++text) {
    const unsigned char byte = (unsigned char)*text;
    if (byte < 0x80) continue;
    if ((byte & 0xE0) != 0xC0 || ((unsigned char)*++text & 0xC0) != 0x80) return 0;
  }
  return 1;
}

/* MuJoCo cuts what it says at 500 or 1000 bytes, wherever that is. The names end up there at even and at odd places. */
static void check_that_letters_are_not_cut(void) {
  char name[1400], xml[2000];
  size_t length, i, shift;
  for (length = 460; length < 1200; length += 20) {
    for (shift = 0; shift < 2; ++shift) {
      mimo_scene_config config;
      mimo_scene* scene = NULL;
      mimo_env* env = NULL;
      memset(name, 'n', sizeof name);
      for (i = shift; i + 1 < length; i += 2) memcpy(name + i, "\xC3\xA9", 2);
      name[i] = '\0';
      snprintf(xml, sizeof xml, "<mujoco><worldbody><body name='%s'><joint/></body></worldbody></mujoco>", name);
      CHECK_OK(mimo_scene_config_init(&config, sizeof config));
      config.xml = xml;
      CHECK_OK(mimo_scene_create(&config, &scene));
      CHECK(mimo_env_create(scene, NULL, &env) == MIMO_E_MODEL);
      CHECK(is_utf8(mimo_last_error()));
      CHECK(strstr(mimo_last_error(), "\xC3\xA9\xC3\xA9") != NULL || length > 900);
      mimo_scene_destroy(scene);
    }
  }
}

/* Bytes of the caller's that are no letters are quoted as '?': a lone end, half a pair of UTF-16, beyond U+10FFFF, two
 * bytes for one ASCII letter, a letter cut short. */
static void check_that_broken_letters_become_question_marks(void) {
  mimo_env* env = blind_env("free", NULL);
  int32_t id;
  CHECK_FAILS(MIMO_E_NOT_FOUND, "\"a?b?c\xC3\xBC\"",
              mimo_env_find(env, MIMO_BODY,
                            "a\x80"
                            "b\xFF"
                            "c\xC3\xBC",
                            &id));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "\"???\"", mimo_env_find(env, MIMO_BODY, "\xED\xA0\x80", &id));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "\"????\"", mimo_env_find(env, MIMO_BODY, "\xF4\x90\x80\x80", &id));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "\"??\"", mimo_env_find(env, MIMO_BODY, "\xC0\xAF", &id));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "\"??\"", mimo_env_find(env, MIMO_BODY, "\xE2\x82", &id));
  CHECK_FAILS(MIMO_E_NOT_FOUND, "\"\xE2\x82\xAC\xF0\x9F\x91\xB6\"",
              mimo_env_find(env, MIMO_BODY, "\xE2\x82\xAC\xF0\x9F\x91\xB6", &id));
  mimo_env_destroy(env);
}

int main(void) {
  check_messages_of_tasks();
  check_messages_of_worlds_in_batches();
  check_mimo_fail();
  check_messages_by_handle();
  check_four_failing_threads();
  check_that_letters_are_not_cut();
  check_that_broken_letters_become_question_marks();
  check_that_messages_are_one_line();
  return failures();
}
