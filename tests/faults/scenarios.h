/* The calls that are made with too little memory. */
#ifndef MIMO_TESTS_FAULTS_SCENARIOS_H
#define MIMO_TESTS_FAULTS_SCENARIOS_H

#include "mimo/experimental.h"

typedef struct scenario {
  const char* name;
  void (*prepare)(void);
  mimo_status (*call)(void);
  void (*clean)(void); /* undoes what prepare and call made */
  int handles;         /* whose control blocks stay */
  int tolerates;       /* the call can do without some of its allocations */
  long budget;         /* about how many allocations are made to fail; 0: the call must make none */
} scenario;

extern const scenario all_scenarios[]; /* ends with a nameless one */

void scenarios_begin(void);
void scenarios_end(void);
int scenario_failures(void);

#endif
