/* What of a world can be read and set, by names in place of mimo.h's numbers. */
#ifndef MIMO_MATLAB_QUANTITIES_H
#define MIMO_MATLAB_QUANTITIES_H

#include "mimo_base.h"

typedef struct quantity {
  const char* name;
  int32_t kind, number;
  size_t each; /* of contacts, which have no names: how many values each has; 0: they are named */
} quantity;

/* By its name, which may end in "_now": then its number has MIMO_NOW. Raises mimo:NOT_FOUND. */
quantity mimo_quantity_of(const mxArray* name);

/* "body": MIMO_BODY */
int32_t mimo_kind_of(const mxArray* name);

#endif
