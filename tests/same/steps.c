/* steps COUNT [fields] [SCENE...]: steps worlds in which infants have every sense, and prints the SHA-256 of all blocks
 * so far after 100, 1000, 2000, ... and COUNT steps of each scene. docs/guide/reproducibility.md says where these are
 * the same; ./dev test --same compares. With "fields" it also prints a hash for each field, which shows what differs.
 */
#include "support/capi.h"

/* ---- SHA-256 (FIPS 180-4) --------------------------------------------------------------------------------- */

typedef struct {
  uint32_t words[8];
  uint8_t rest[64];
  uint64_t bytes;
} sha256;

static const uint32_t round_constants[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

static sha256 sha256_start(void) {
  const sha256 start = {
      {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19}, {0}, 0};
  return start;
}

static uint32_t turned(uint32_t x, int by) { return x >> by | x << (32 - by); }

static void sha256_chunk(sha256* it, const uint8_t* bytes) {
  uint32_t w[64], s[8];
  int i;
  for (i = 0; i < 16; ++i)
    w[i] = (uint32_t)bytes[4 * i] << 24 | (uint32_t)bytes[4 * i + 1] << 16 | (uint32_t)bytes[4 * i + 2] << 8 |
           bytes[4 * i + 3];
  for (; i < 64; ++i)
    w[i] = w[i - 16] + w[i - 7] + (turned(w[i - 15], 7) ^ turned(w[i - 15], 18) ^ w[i - 15] >> 3) +
           (turned(w[i - 2], 17) ^ turned(w[i - 2], 19) ^ w[i - 2] >> 10);
  memcpy(s, it->words, sizeof s);
  for (i = 0; i < 64; ++i) {
    const uint32_t e = turned(s[4], 6) ^ turned(s[4], 11) ^ turned(s[4], 25);
    const uint32_t a = turned(s[0], 2) ^ turned(s[0], 13) ^ turned(s[0], 22);
    const uint32_t one = s[7] + e + (((s[5] ^ s[6]) & s[4]) ^ s[6]) + round_constants[i] + w[i];
    const uint32_t two = a + ((s[0] & s[1]) | (s[2] & (s[0] | s[1])));
    memmove(s + 1, s, 7 * sizeof *s);
    s[4] += one;
    s[0] = one + two;
  }
  for (i = 0; i < 8; ++i) it->words[i] += s[i];
}

static void sha256_add(sha256* it, const void* from, size_t count) {
  const uint8_t* bytes = from;
  while (count > 0) {
    const size_t used = it->bytes % 64, taken = 64 - used < count ? 64 - used : count;
    memcpy(it->rest + used, bytes, taken);
    it->bytes += taken;
    bytes += taken;
    count -= taken;
    if (used + taken == 64) sha256_chunk(it, it->rest);
  }
}

/* Of what was added so far. */
static void sha256_print(const sha256* so_far) {
  static const uint8_t padding[64] = {0x80};
  const uint64_t bits = 8 * so_far->bytes;
  sha256 all = *so_far, *it = &all;
  uint8_t length[8];
  int i;
  for (i = 0; i < 8; ++i) length[i] = (uint8_t)(bits >> (56 - 8 * i));
  sha256_add(it, padding, 64 - (it->bytes + 8) % 64);
  sha256_add(it, length, 8);
  for (i = 0; i < 8; ++i) printf("%08lx", (unsigned long)it->words[i]);
}

/* ---- Worlds ----------------------------------------------------------------------------------------------- */

enum { SIDE = 32, MOST_FIELDS = 200 };

/* The bits of a member that the scene takes for its infant. */
static void accept(const char* name, mimo_agent_config* infant, uint32_t* member) {
  int bit;
  for (bit = 0; bit < 30; ++bit) {
    const uint32_t before = *member;
    mimo_scene* scene = NULL;
    *member |= (uint32_t)1 << bit;
    CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = name), &scene));
    if (mimo_scene_add_agents(scene, infant, NULL) != MIMO_OK) *member = before;
    mimo_scene_destroy(scene);
  }
}

/* In "reach" the infant has six months: its body has grown from that of 18 months, which the other scenes have. */
static mimo_env* make(const char* name) {
  mimo_scene* scene = NULL;
  mimo_agent_config infant;
  mimo_growth growth;
  mimo_env* env = NULL;
  CHECK_OK(mimo_scene_create(SIZED(mimo_scene_config, .name = name), &scene));
  CHECK_OK(mimo_scene_default_agent(scene, &infant, sizeof infant));
  CHECK_OK(mimo_growth_init(&growth, sizeof growth));
  growth.age = 6;
  if (strcmp(name, "reach") == 0) infant.growth = &growth;
  infant.vision_width = infant.vision_height = SIDE;
  infant.voice = 1;
  accept(name, &infant, &infant.proprioception);
  accept(name, &infant, &infant.vestibular);
  accept(name, &infant, &infant.touch);
  accept(name, &infant, &infant.vision);
  accept(name, &infant, &infant.hearing);
  infant.reflexes = MIMO_REFLEX_ALL;
  CHECK_OK(mimo_scene_add_agents(scene, &infant, NULL));
  CHECK_OK(mimo_env_create(scene, NULL, &env));
  mimo_scene_destroy(scene);
  if (env == NULL) exit(failures());
  return env;
}

/* Tenths from -1 to 1, the same in single precision everywhere (J. L. Lehmer's generator, which needs 64 bits). */
static float next_action(uint64_t* random) {
  *random = *random * 48271 % 2147483647;
  return (float)((int)(*random % 21) - 10) / 10.0f;
}

typedef struct {
  size_t offset, bytes;
  const char* name;
  sha256 hash;
} part;

static size_t parts_of(const mimo_env* env, part* parts) {
  const size_t count = sizes_of(env).fields;
  size_t i;
  CHECK(count <= MOST_FIELDS);
  for (i = 0; i < count && i < MOST_FIELDS; ++i) {
    const mimo_field field = field_at(layout_of(env), i);
    parts[i].offset = field.offset;
    parts[i].bytes = field.bytes;
    parts[i].name = field.name;
    parts[i].hash = sha256_start();
  }
  return i;
}

static void play(const char* name, long steps, int with_fields) {
  static part parts[MOST_FIELDS];
  mimo_env* env = make(name);
  const size_t bytes = sizes_of(env).block_bytes, count = sizes_of(env).actions, fields = parts_of(env, parts);
  uint8_t* block = calloc(bytes, 1);
  float* actions = malloc(count * sizeof *actions);
  uint64_t random = 7;
  sha256 all = sha256_start();
  long step;
  size_t i;
  CHECK_OK(mimo_env_reset(env, SEED(7), block, bytes));
  for (step = 0; step <= steps; ++step) {
    uint8_t terminated[2] = {0}, truncated[2] = {0};
    sha256_add(&all, block, bytes);
    for (i = 0; i < fields && with_fields; ++i) sha256_add(&parts[i].hash, block + parts[i].offset, parts[i].bytes);
    if (step == 100 || (step > 0 && step % 1000 == 0) || step == steps) {
      printf("%s %ld ", name, step);
      sha256_print(&all);
      printf("\n");
      fflush(stdout);
    }
    if (step == steps) break;
    for (i = 0; i < count; ++i) actions[i] = next_action(&random);
    CHECK_OK(
        mimo_env_step(env, actions, count, block, bytes,
                      RESULTS(.terminated = terminated, .truncated = truncated, .agent_count = sizes_of(env).agents)));
    if (terminated[0] || terminated[1] || truncated[0] || truncated[1])
      CHECK_OK(mimo_env_reset(env, NULL, block, bytes));
  }
  for (i = 0; i < fields && with_fields; ++i) {
    printf("  ");
    sha256_print(&parts[i].hash);
    printf(" %s\n", parts[i].name);
  }
  free(actions);
  free(block);
  mimo_env_destroy(env);
}

int main(int argc, char** argv) {
  static char* usual[] = {"benchmark", "reach", "playdate"};
  const long steps = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
  const int with_fields = argc > 2 && strcmp(argv[2], "fields") == 0, first = 2 + with_fields;
  char** scenes = argc > first ? argv + first : usual;
  int i, count = argc > first ? argc - first : 3;
  if (steps < 1) {
    fprintf(stderr, "usage: %s STEPS [fields] [SCENE...]\n", argv[0]);
    return 2;
  }
  for (i = 0; i < count; ++i) play(scenes[i], steps, with_fields);
  return failures();
}
