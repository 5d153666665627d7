/* What the tables in mimo_tables.h consist of: words that stand for constants, and members of structs. */
#ifndef MIMO_MATLAB_MEMBERS_H
#define MIMO_MATLAB_MEMBERS_H

#include <mimo/experimental.h>
#include <stddef.h>
#include <stdint.h>

typedef struct word {
  const char* text;
  int64_t value;
} word;

/* A list of words, which ends with a text that is NULL. */
typedef struct enumeration {
  int combine; /* whether several may be given */
  const word* words;
} enumeration;

/* A member of a struct of mimo.h. A list of them ends with a name that is NULL. */
typedef enum kind { kSwitch, kUnsigned, kWide, kSize, kSigned, kFloats, kNumbers, kText, kBytes } kind;
typedef struct member {
  const char* name;
  kind kind;
  size_t count; /* of numbers: how many */
  size_t offset;
  const enumeration* words; /* NULL: it takes none */
} member;

/* An array of a part of a stage. A list of them ends with a name that is NULL. */
typedef struct stage_array {
  const char* name;
  kind kind;
  size_t width; /* numbers of an element */
  size_t offset, length;
  int places; /* whether it holds places in another array */
  const enumeration* words;
} stage_array;

/* A struct of a stage: its arrays, and further numbers. */
typedef struct stage_part {
  size_t size;
  const stage_array* arrays;
  const member* numbers;
} stage_part;

typedef struct quantity {
  const char* name;
  int32_t kind, number;
  size_t each; /* of contacts, which have no names: how many values each has; 0: the others have names */
} quantity;

/* What converts columns of so many rows to an engine's frame. A list of them ends with a `what` that is NULL. */
typedef struct conversion {
  const char* what;
  mimo_status (*function)(int32_t axes, float* values, size_t count);
  size_t rows;
} conversion;
extern const conversion mimo_conversions[];

#endif
