/* Memory that runs out at each single allocation of a call: the call says so, nothing of it is lost, and the next call
 * works. Where a call allocates more often than its budget allows, allocations are picked at equal distances.
 *   faults_allocations [name of a scenario] */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <execinfo.h>

#include "faults/failing.h"
#include "faults/scenarios.h"
#include "support/capi.h"

/* What MuJoCo itself loses when memory runs out: its loader of XML keeps plain pointers, and mj_makeData forgets the
 * first of its three blocks. Such a loss is known by the library that allocated, and by these functions further up. */
static const char* const kLosers[] = {"mj_loadXML", "mj_makeData"};
static const char* const kTheirs[] = {"libmujoco", "libtinyxml", "liblodepng", "libqhull", "libccd"};
static const char* const kCarriers[] = {"libc.so", "libstdc++", "faults_allocations"};

enum { LARGEST_CONTROL_BLOCK = 128 };

static int is_one_of(const char* text, const char* const* list, size_t count) {
  size_t i;
  for (i = 0; text != NULL && i < count; ++i) {
    if (strstr(text, list[i]) != NULL) return 1;
  }
  return 0;
}

enum { CARRIER = 1, MUJOCOS = 2, LOSER = 4, SEEN = 8, PLACES = 1 << 14 };

/* Whose code an address belongs to. Asked for the same few addresses again and again. */
static int owner_of(void* address) {
  static struct {
    void* address;
    int owner;
  } places[PLACES];
  const size_t at = (size_t)((uintptr_t)address * 0x9e3779b97f4a7c15u >> 50);
  Dl_info info;
  int owner = SEEN;
  if (places[at].address == address) return places[at].owner;
  if (dladdr(address, &info) != 0) {
    if (is_one_of(info.dli_fname, kCarriers, 3)) owner |= CARRIER;
    if (is_one_of(info.dli_fname, kTheirs, 5)) owner |= MUJOCOS;
    if (is_one_of(info.dli_sname, kLosers, 2)) owner |= LOSER;
  }
  places[at].address = address;
  places[at].owner = owner;
  return owner;
}

/* Whether one of these functions of MuJoCo made an allocation, by its stack. */
static int is_mujocos(const allocation* lost) {
  int i = 0;
  while (i < lost->frame_count && owner_of(lost->frames[i]) & CARRIER) ++i;
  if (i == lost->frame_count || !(owner_of(lost->frames[i]) & MUJOCOS)) return 0;
  for (; i < lost->frame_count; ++i) {
    if (owner_of(lost->frames[i]) & LOSER) return 1;
  }
  return 0;
}

typedef struct losses {
  const scenario* of;
  long fail_at;
  int handles; /* whose control blocks have not been met yet */
} losses;

/* After all is cleaned up, only control blocks of handles may be left. */
static void judge_loss(const allocation* lost, void* user) {
  losses* all = user;
  if (is_mujocos(lost)) return;
  if (lost->size <= LARGEST_CONTROL_BLOCK && all->handles-- > 0) return;
  ++failed_checks;
  fprintf(stderr, "%s, allocation %ld fails: %zu bytes of allocation %ld are lost\n", all->of->name, all->fail_at,
          lost->size, lost->number);
  backtrace_symbols_fd(lost->frames, lost->frame_count, 2);
}

static void run_once(const scenario* s, long fail_at, int forever, mimo_status* status) {
  s->prepare();
  watch_begin(fail_at, forever);
  *status = s->call();
  watch_end();
}

static void check_one(const scenario* s, long fail_at, int forever) {
  mimo_status status;
  losses lost;
  int hit;
  run_once(s, fail_at, forever, &status);
  hit = watch_failed();
  if (status != MIMO_OK && status != MIMO_E_OUT_OF_MEMORY) {
    ++failed_checks;
    fprintf(stderr, "%s, allocation %ld fails: gave %s, \"%s\"\n", s->name, fail_at, mimo_status_name(status),
            mimo_last_error());
  }
  if (hit && status == MIMO_OK && !s->tolerates) {
    ++failed_checks;
    fprintf(stderr, "%s, allocation %ld fails: nobody noticed\n", s->name, fail_at);
  }
  if (status != MIMO_OK) {
    const mimo_status again = s->call();
    if (again != MIMO_OK) {
      ++failed_checks;
      fprintf(stderr, "%s, after allocation %ld failed: gave %s, \"%s\"\n", s->name, fail_at, mimo_status_name(again),
              mimo_last_error());
    }
  }
  s->clean();
  lost.of = s;
  lost.fail_at = fail_at;
  lost.handles = s->handles;
  watch_lost(judge_loss, &lost);
}

static long allocations_of(const scenario* s) {
  mimo_status status;
  run_once(s, 0, 0, &status); /* what is made once in a process */
  s->clean();
  run_once(s, 0, 0, &status);
  s->clean();
  if (status != MIMO_OK) {
    ++failed_checks;
    fprintf(stderr, "%s: gave %s, \"%s\"\n", s->name, mimo_status_name(status), mimo_last_error());
  }
  return watch_count();
}

static void check_scenario(const scenario* s) {
  const long all = allocations_of(s);
  const long stride = s->budget > 0 ? all / s->budget + 1 : 1;
  long at, tried = 0;
  if ((all > 0) != (s->budget > 0)) {
    ++failed_checks;
    fprintf(stderr, "%s makes %ld allocations, expected %s\n", s->name, all, s->budget > 0 ? "some" : "none");
  }
  for (at = 1; at <= all && failed_checks < 20; at += stride, ++tried) {
    check_one(s, at, 0);
    if (tried % 8 == 0) check_one(s, at, 1);
  }
  printf("%-22s %6ld allocations, %5ld made to fail\n", s->name, all, tried);
  fflush(stdout);
}

int main(int argc, char** argv) {
  const scenario* s;
  scenarios_begin();
  for (s = all_scenarios; s->name != NULL; ++s) {
    if (argc < 2 || strcmp(argv[1], s->name) == 0) check_scenario(s);
  }
  scenarios_end();
  return failures() | scenario_failures();
}
