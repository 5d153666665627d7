/* Every function with every wrong argument: the documented status, a message that names the argument, and nothing
 * written. A function of exports.map without a row in the table fails.
 *   misuse_arguments exports.map */
#include "misuse/world.h"
#include "support/capi.h"

static const char* current_row;
static const char* current_fault;

static void complain(const char* what) {
  ++failed_checks;
  fprintf(stderr, "%s, %s: %s; last error \"%s\"\n", current_row, current_fault, what, mimo_last_error());
}

/* ---- The list of functions ---- */

static void see(const char* function, char* seen) {
  size_t i;
  current_row = function;
  for (i = 0; i < row_count && strcmp(function, all_rows[i].name) != 0; ++i) continue;
  if (i == row_count)
    complain("has no row");
  else if (seen[i]++)
    complain("has two rows");
}

/* Functions stand alone in their lines: "    mimo_version;". */
static void check_symbols(const char* path) {
  char line[256], function[128], end, *seen = calloc(row_count, 1);
  FILE* file = fopen(path, "r");
  size_t i;
  current_fault = "exports.map";
  if (file == NULL || seen == NULL) exit(1);
  while (fgets(line, sizeof line, file) != NULL) {
    if (sscanf(line, " mimo_%100[a-z0-9_]%c", function + 5, &end) == 2 && end == ';') {
      memcpy(function, "mimo_", 5);
      see(function, seen);
    }
  }
  for (i = 0; i < row_count; ++i) {
    current_row = all_rows[i].name;
    if (!seen[i]) complain("is no function");
  }
  fclose(file);
  free(seen);
}

/* ---- Changing arguments ---- */

static void put(void* to, const void* value, size_t size) { memcpy(to, value, size); }

static void put_size(unsigned char* at, int64_t whole) {
  const size_t value = (size_t)whole;
  put(at, &value, sizeof value);
}

static void put_less(unsigned char* at, int64_t by) {
  size_t value;
  memcpy(&value, at, sizeof value);
  put_size(at, (int64_t)(value - (size_t)by));
}

static void put_i32(unsigned char* at, int64_t whole) {
  const int32_t value = (int32_t)(uint32_t)whole;
  put(at, &value, sizeof value);
}

static unsigned char* pointed(unsigned char* member) {
  unsigned char* target;
  memcpy(&target, member, sizeof target);
  return target;
}

static void apply(const fault* f, args* a) {
  unsigned char* at = (unsigned char*)a + f->at;
  void* const nothing = NULL;
  switch (f->kind) {
    case FAULT_NULL: put(at, &nothing, sizeof nothing); break;
    case FAULT_SIZE: put_size(at, f->whole); break;
    case FAULT_LESS: put_less(at, f->whole); break;
    case FAULT_I32: put_i32(at, f->whole); break;
    case FAULT_F64: put(at, &f->real, sizeof f->real); break;
    case FAULT_FIELD_I32: put_i32(pointed(at) + f->field, f->whole); break;
    case FAULT_FIELD_SIZE: put_size(pointed(at) + f->field, f->whole); break;
    case FAULT_FIELD_LESS: put_less(pointed(at) + f->field, f->whole); break;
    case FAULT_FIELD_F64: put(pointed(at) + f->field, &f->real, sizeof f->real); break;
    case FAULT_FIELD_NULL: put(pointed(at) + f->field, &nothing, sizeof nothing); break;
    case FAULT_STRUCT_SIZE: put_i32(pointed(at), f->whole); break;
    case FAULT_STRUCT_TAIL:
      put_i32(pointed(at), f->whole + 16);
      memset(pointed(at) + f->whole, (int)f->field, 16);
      break;
    case FAULT_DO: f->change(a); break;
    case FAULT_END: break;
  }
}

/* ---- Calls ---- */

static void judge(mimo_status expected, const char* names, mimo_status actual) {
  char text[256];
  const char* message = mimo_last_error();
  if (actual != expected) {
    snprintf(text, sizeof text, "gave %s, expected %s", mimo_status_name(actual), mimo_status_name(expected));
    complain(text);
  }
  if (expected == MIMO_OK || actual == MIMO_OK) return;
  if (names != NULL && strstr(message, names) == NULL) complain("the message does not name it");
  if (strchr(message, '\n') != NULL) complain("the message has several lines");
  if (memory_changed()) complain("something was written");
}

static void good_call(const row* r, const char* when) {
  args a = good_args(r->uses);
  current_fault = when;
  judge(MIMO_OK, NULL, r->call(&a));
  destroy_made(&a);
}

static void faulty_call(const row* r, const fault* f) {
  args a = good_args(r->uses);
  int made;
  current_fault = f->what;
  apply(f, &a);
  remember_memory();
  judge(f->status, f->names, r->call(&a));
  made = destroy_made(&a);
  if (made && f->status != MIMO_OK) complain("made something all the same");
}

/* ---- Handles ---- */

static void bad_handle(const row* r, size_t at, const char* what, void* handle, mimo_status status) {
  args a = good_args(r->uses);
  const args before = a;
  current_fault = what;
  put((unsigned char*)&a + at, &handle, sizeof handle);
  remember_memory();
  judge(status, handle == NULL ? "is NULL, expected a mimo_" : "is ", r->call(&a));
  a = before;
  destroy_made(&a);
}

static void bad_handles(const row* r, size_t at, void* retired, void* other, void* another) {
  if (r->uses & DESTROYS) return;
  bad_handle(r, at, "the handle is NULL", NULL, MIMO_E_INVALID_ARGUMENT);
  bad_handle(r, at, "the handle is destroyed", retired, MIMO_E_BAD_HANDLE);
  bad_handle(r, at, "the handle is of another kind", other, MIMO_E_BAD_HANDLE);
  bad_handle(r, at, "the handle is of a third kind", another, MIMO_E_BAD_HANDLE);
  bad_handle(r, at, "the handle is none", no_handle(), MIMO_E_BAD_HANDLE);
}

static void check_handles(const row* r) {
  const args a = good_args(0);
  if (r->uses & (ON_SCENE | ON_CART)) bad_handles(r, offsetof(args, scene), retired_scene(), a.env, a.batch);
  if (r->uses & (ON_ROOM | ON_EMPTY | ON_BEHAVIOUR))
    bad_handles(r, offsetof(args, room), retired_scene(), a.env, a.batch);
  if (r->uses & ON_ENV) bad_handles(r, offsetof(args, env), retired_env(), a.batch, retired_scene());
  if (r->uses & ON_BATCH) bad_handles(r, offsetof(args, batch), retired_batch(), a.env, retired_scene());
  if (r->uses & ON_SENSES) bad_handles(r, offsetof(args, senses), retired_senses(), a.env, retired_scene());
  if (r->uses & ON_RECORDER) bad_handles(r, offsetof(args, recorder), retired_recorder(), a.env, a.batch);
  if (r->uses & ON_RECORDING) bad_handles(r, offsetof(args, recording), retired_recording(), a.env, a.batch);
  if (r->uses & ON_STAGE) bad_handles(r, offsetof(args, stage), retired_stage(), a.env, a.batch);
  if (r->uses & ON_LAYOUT) bad_handles(r, offsetof(args, layout), retired_layout(), a.env, a.batch);
}

int main(int argc, char** argv) {
  size_t i, faults = 0;
  const fault* f;
  if (argc != 2) return 2;
  check_symbols(argv[1]);
  make_everything();
  for (i = 0; i < row_count; ++i) {
    const row* r = &all_rows[i];
    current_row = r->name;
    if (r->uses & DESTROYS) continue;
    good_call(r, "good arguments");
    for (f = r->faults; f->kind != FAULT_END; ++f, ++faults) faulty_call(r, f);
    check_handles(r);
    good_call(r, "good arguments after bad ones");
  }
  for (i = 0; i < row_count; ++i) {
    current_row = all_rows[i].name;
    if (all_rows[i].uses & DESTROYS) good_call(&all_rows[i], "destroying what is not to be");
  }
  destroy_everything();
  printf("%zu functions, %zu faults\n", row_count, faults);
  return failures() | rows_failures() | world_failures();
}
