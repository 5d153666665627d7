/* The bytes of states by docs/state-format.md: which kinds of sections they have, and how to change them. */
#ifndef MIMO_TESTS_STATES_SECTIONS_H
#define MIMO_TESTS_STATES_SECTIONS_H

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { HEADER = 48, SECTION = 28 };

/* Kinds of sections, each once: "receptors/touch", "delay", "agent/task 1f2e...", by the kind's number. */
typedef struct kinds {
  char names[200][80];
  size_t count;
} kinds;

static inline uint64_t number_at(const uint8_t* at) {
  uint64_t number;
  memcpy(&number, at, sizeof number);
  return number;
}

static inline size_t state_length(const uint8_t* state) { return (size_t)number_at(state + 16); }

static inline int has_kind(const kinds* all, const char* name) {
  size_t i;
  for (i = 0; i < all->count; ++i) {
    if (strcmp(all->names[i], name) == 0) return 1;
  }
  return 0;
}

/* Without the names of agents and fields; of tasks and actuations with the number that tells them apart. */
static inline void add_kind(kinds* all, const char* name, uint64_t kind) {
  char text[80];
  const char* last = strrchr(name, '/');
  if (strncmp(name, "agent/", 6) == 0) {
    const int differ = strcmp(last, "/task") == 0 || strcmp(last, "/actuation") == 0;
    snprintf(text, sizeof text, differ ? "agent%s %016llx" : "agent%s", last, (unsigned long long)kind);
  } else if (strncmp(name, "receptors/", 10) == 0) {
    snprintf(text, sizeof text, "receptors%s", last);
  } else {
    snprintf(text, sizeof text, "%.*s", (int)strcspn(name, "/"), name);
  }
  if (has_kind(all, text) || all->count == sizeof all->names / sizeof *all->names) return;
  strcpy(all->names[all->count++], text);
}

/* Of one state, or several rows. */
static inline void add_kinds(kinds* all, const uint8_t* state, size_t bytes) {
  const uint8_t* at = state + HEADER;
  const uint8_t* const end = state + (state_length(state) < bytes ? state_length(state) : bytes);
  while (at < end) {
    char name[200] = "";
    uint32_t length;
    memcpy(&length, at, sizeof length);
    snprintf(name, sizeof name, "%.*s", (int)length, (const char*)at + SECTION);
    add_kind(all, name, number_at(at + 12));
    at += SECTION + length + number_at(at + 20);
  }
}

static inline uint64_t mixed(uint64_t value, uint64_t word) {
  value = (value ^ word) * 0x9e3779b97f4a7c15u;
  return value ^ (value >> 32);
}

static inline uint64_t add_to_hash(uint64_t value, const uint8_t* bytes, size_t length) {
  size_t i;
  for (i = 0; i < length; i += 8) {
    uint64_t word = 0;
    memcpy(&word, bytes + i, length - i < 8 ? length - i : 8);
    value = mixed(value, word);
  }
  return mixed(value, length);
}

static inline void seal(uint8_t* state) {
  uint64_t value = add_to_hash(0xcbf29ce484222325u, state, HEADER - 8);
  value = add_to_hash(value, state + HEADER, state_length(state) - HEADER);
  value = (value ^ (value >> 33)) * 0xff51afd7ed558ccdu;
  value = (value ^ (value >> 33)) * 0xc4ceb9fe1a85ec53u;
  value ^= value >> 33;
  memcpy(state + HEADER - 8, &value, sizeof value);
}

/* Changes the version of a section, and the checksum with it; returns the version before. */
static inline uint32_t raise_version(uint8_t* state, const char* wanted, int by) {
  uint8_t* at = state + HEADER;
  while (at < state + state_length(state)) {
    uint32_t length, version;
    memcpy(&length, at, sizeof length);
    memcpy(&version, at + 4, sizeof version);
    if (length == strlen(wanted) && memcmp(at + SECTION, wanted, length) == 0) {
      const uint32_t raised = version + (uint32_t)by;
      memcpy(at + 4, &raised, sizeof raised);
      seal(state);
      return version;
    }
    at += SECTION + length + number_at(at + 20);
  }
  return 0;
}

#endif
