/* Uses the function that only the next minor version has. */
#include "mimo/mimo.h"

int main(void) { return mimo_grown() == 77 ? 0 : 1; }
