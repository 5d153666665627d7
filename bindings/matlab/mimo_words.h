/* Words that stand for the constants of mimo.h: 'force' for MIMO_TOUCH_FORCE. mimo_tables.h has all of them. */
#ifndef MIMO_MATLAB_WORDS_H
#define MIMO_MATLAB_WORDS_H

#include "mimo_base.h"
#include "mimo_tables.h"

/* The value of a word, of several, or of a number, which stands for itself. */
int64_t mimo_value_of(const mxArray* given, const char* what, const enumeration* from);

/* The word for a value; "" where it has none. */
const char* mimo_word_for(int64_t value, const enumeration* from);

/* A quantity by its name, which may end in "_now": its number then includes MIMO_NOW. Raises mimo:NOT_FOUND. */
quantity mimo_quantity_of(const mxArray* name);

#endif
