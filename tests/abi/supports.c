/* Prints the names among those of standard input that the library does not know. */
#include <stdio.h>
#include <string.h>

#include "mimo/mimo.h"

int main(void) {
  char name[256];
  while (fgets(name, sizeof name, stdin) != NULL) {
    name[strcspn(name, "\n")] = '\0';
    if (mimo_supports(name) != 1) puts(name);
  }
  return 0;
}
