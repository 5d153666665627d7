/* States of worlds, batches and attached senses that go on with versions to come.
 *   kept_states write FOLDER             saves them, with the numbers that follow from them (./dev freeze does it for a
 *                                        version)
 *   kept_states check FOLDER             loads those that are there, and finds these numbers again: at once exactly,
 *                                        later to rounding; refuses them where they are damaged or of a newer library
 *   kept_states go FROM N TO [N TO...]   loads them, goes on for N steps, and saves them; tools/elsewhere.py moves them
 *                                        so
 *   kept_states scene FOLDER             saves the scene of a recording that is kept as well
 *   kept_states sections FOLDER...       fails where the library has a kind of section that none of them has
 *
 * NAME.txt has the sizes of the model, the number of steps that follow, and the numbers before and after these.
 */
#include "sections.h"
#include "worlds.h"

enum { STEPS = 30, MOST = 1 << 20, NUMBERS = 1024 };

static uint8_t state[MOST];

/* Steps in which worlds go on. Fewer where hands and feet hold on to things: there differences of rounding, which other
 * systems have, become visible within ten steps. */
static int further_of(const char* name) { return strcmp(name, "standup") == 0 ? 3 : 30; }

static FILE* open_file(const char* folder, const char* name, const char* end, const char* how) {
  char path[500];
  FILE* file;
  snprintf(path, sizeof path, "%s/%s.%s", folder, name, end);
  file = fopen(path, how);
  if (file == NULL && how[0] == 'w') {
    fprintf(stderr, "%s cannot be opened\n", path);
    exit(1);
  }
  return file;
}

static size_t read_state(const char* folder, const char* name) {
  FILE* file = open_file(folder, name, "state", "rb");
  size_t bytes;
  if (file == NULL) return 0;
  bytes = fread(state, 1, sizeof state, file);
  fclose(file);
  return bytes;
}

static void write_numbers(FILE* file, owner* it) {
  double numbers[NUMBERS];
  const size_t count = look(it, numbers, NUMBERS);
  size_t i;
  for (i = 0; i < count; ++i) fprintf(file, "%.17g\n", numbers[i]);
}

static void save(owner* it, const char* folder, const char* name) {
  const size_t bytes = state_size(it);
  FILE* file = open_file(folder, name, "state", "wb");
  CHECK(bytes <= sizeof state);
  save_state(it, state, bytes);
  CHECK(fwrite(state, 1, bytes, file) == bytes);
  fclose(file);
}

static void write_state(const char* folder, const char* name) {
  owner it = make_owner(name);
  FILE* file;
  int i;
  go_on(&it, STEPS);
  save(&it, folder, name);
  file = open_file(folder, name, "txt", "w");
  for (i = 0; i < SIZES; ++i) fprintf(file, "%d ", model_sizes[i]);
  fprintf(file, "\n%d\n", further_of(name));
  write_numbers(file, &it);
  go_on(&it, further_of(name));
  write_numbers(file, &it);
  fclose(file);
  free_owner(&it);
}

static void check_numbers(const char* name, FILE* file, owner* it, double tolerance) {
  double numbers[NUMBERS], expected = 0;
  const size_t count = look(it, numbers, NUMBERS);
  const int before = failed_checks;
  size_t i;
  for (i = 0; i < count; ++i) {
    CHECK(fscanf(file, "%lf", &expected) == 1);
    CHECK_NEAR(expected, numbers[i], tolerance * (1 + fabs(expected)));
  }
  if (failed_checks > before) fprintf(stderr, "%s goes on with other numbers\n", name);
}

/* Skips the sizes; returns the number of steps that follow. */
static int first_lines(FILE* file) {
  int number = 0, further = 0, i;
  for (i = 0; i < SIZES; ++i) CHECK(fscanf(file, "%d", &number) == 1);
  CHECK(fscanf(file, "%d", &further) == 1);
  return further;
}

static void check_refusals(owner* it, size_t bytes) {
  const size_t middle = state_length(state) / 2;
  uint32_t version;
  state[middle] ^= 4;
  CHECK_FAILS(MIMO_E_FILE, "checksum", load_state(it, state, bytes, NULL));
  state[middle] ^= 4;
  CHECK_FAILS(MIMO_E_FILE, "", load_state(it, state, 40, NULL));
  state[8] += 1; /* the version of the header */
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "its version 3 needs a newer library", load_state(it, state, bytes, NULL));
  state[8] -= 1;
  version = raise_version(state, "episode", 1);
  CHECK_FAILS(MIMO_E_UNSUPPORTED, "episode", load_state(it, state, bytes, NULL));
  CHECK(raise_version(state, "episode", -1) == version + 1);
}

static void check_state(const char* folder, const char* name) {
  mimo_load_report report = {.struct_size = sizeof report};
  const size_t bytes = read_state(folder, name);
  owner it;
  FILE* file;
  int further;
  if (bytes == 0) return;
  it = make_owner(strcmp(name, "overrides") == 0 ? "free" : name); /* where nothing has been set */
  check_refusals(&it, bytes);
  if (it.senses != NULL) { /* the host's data come from the same steps; its senses forget them */
    go_on(&it, STEPS);
    CHECK_OK(mimo_senses_reset(it.senses, it.data, SEED(99)));
  }
  CHECK_OK(load_state(&it, state, bytes, &report));
  CHECK_TEXT("", report.fresh_names);
  CHECK_TEXT("", report.ignored_names);
  file = open_file(folder, name, "txt", "r");
  further = first_lines(file);
  check_numbers(name, file, &it, 1e-12);
  go_on(&it, further);
  check_numbers(name, file, &it, 1e-6);
  fclose(file);
  free_owner(&it);
}

static void go(const char* name, char** from, int count) {
  const size_t bytes = read_state(from[0], name);
  owner it;
  int i;
  if (strcmp(name, "attached") == 0) return; /* a host's data are not in the state */
  it = make_owner(name);
  CHECK_OK(load_state(&it, state, bytes, NULL));
  for (i = 1; i + 1 < count; i += 2) {
    go_on(&it, atoi(from[i]));
    save(&it, from[i + 1], name);
  }
  free_owner(&it);
}

/* ---- Sections --------------------------------------------------------------------------------------------- */

static void add_world(kinds* known, mimo_env* env) {
  size_t bytes = 0;
  if (env == NULL) return;
  CHECK_OK(mimo_env_state_size(env, &bytes));
  CHECK(bytes <= sizeof state);
  CHECK_OK(mimo_env_state_save(env, state, sizeof state < bytes ? 0 : bytes));
  add_kinds(known, state, bytes);
  mimo_env_destroy(env);
}

static void check_sections(int folders, char** folder) {
  static kinds kept, known;
  const char* name;
  size_t i, bytes;
  int32_t actuation;
  for (; folders > 0; --folders, ++folder) {
    for (i = 0; (name = kept_names[i]) != NULL; ++i) {
      if ((bytes = read_state(*folder, name)) > 0) add_kinds(&kept, state, bytes);
    }
  }
  add_world(&known, everything());
  for (i = 0; (name = mimo_task_name(i)) != NULL; ++i) add_world(&known, world_of_task(name));
  add_world(&known, world_of_task("custom"));
  for (actuation = 0; actuation < 100; ++actuation) add_world(&known, world_of_actuation(actuation));
  CHECK(known.count >= 25);
  for (i = 0; i < known.count; ++i) {
    if (has_kind(&kept, known.names[i])) continue;
    fprintf(stderr, "no kept state has a section of the kind \"%s\"\n", known.names[i]);
    ++failed_checks;
  }
}

static void save_scene(const char* folder) {
  mimo_scene* scene = blind_scene("free");
  CHECK_OK(mimo_scene_save(scene, folder));
  mimo_scene_destroy(scene);
}

int main(int argc, char** argv) {
  size_t i;
  if (argc < 3) {
    fprintf(stderr, "usage: %s write|check|scene FOLDER, go FROM STEPS TO..., or sections FOLDER...\n", argv[0]);
    return 2;
  }
  wants_sizes = strcmp(argv[1], "write") == 0;
  if (strcmp(argv[1], "scene") == 0) save_scene(argv[2]);
  if (strcmp(argv[1], "sections") == 0) check_sections(argc - 2, argv + 2);
  for (i = 0; kept_names[i] != NULL; ++i) {
    if (wants_sizes) write_state(argv[2], kept_names[i]);
    if (strcmp(argv[1], "go") == 0) go(kept_names[i], argv + 2, argc - 2);
    if (strcmp(argv[1], "check") == 0) check_state(argv[2], kept_names[i]);
  }
  return failures();
}
