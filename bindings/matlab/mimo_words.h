/* Words that stand for the constants of mimo.h: 'force' for MIMO_TOUCH_FORCE. mimo_tables.h has all of them. */
#ifndef MIMO_MATLAB_WORDS_H
#define MIMO_MATLAB_WORDS_H

#include <stdint.h>

#include "mimo_base.h"

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
typedef enum kind { kSwitch, kUnsigned, kWide, kSize, kSigned, kFloats, kNumbers, kText } kind;
typedef struct member {
  const char* name;
  kind kind;
  size_t count; /* of numbers: how many */
  size_t offset;
  const enumeration* words; /* NULL: it takes none */
} member;

typedef struct quantity {
  const char* name;
  int32_t kind, number;
  size_t each; /* of contacts, which have no names: how many values each has; 0: the others have names */
} quantity;

/* The value of a word, of several, or of a number, which stands for itself. */
int64_t mimo_value_of(const mxArray* given, const char* what, const enumeration* from);

/* The word for a value; "" where it has none. */
const char* mimo_word_for(int64_t value, const enumeration* from);

/* A quantity by its name, which may end in "_now": its number then includes MIMO_NOW. Raises mimo:NOT_FOUND. */
quantity mimo_quantity_of(const mxArray* name);

#endif
