/* A program that was built with 1.0.0-rc1, whose numbers of quantities and kinds are others: the loader refuses it. */
#include <stdio.h>

const char* mimo_version(void);

int main(void) { return puts(mimo_version()) < 0; }
