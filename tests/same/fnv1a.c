/* fnv1a FILE: prints the FNV-1a hash of a file, for languages in which it is no fun to compute. */
#include <inttypes.h>
#include <stdio.h>

int main(int count, char** arguments) {
  uint64_t hash = UINT64_C(14695981039346656037);
  FILE* file = count == 2 ? fopen(arguments[1], "rb") : NULL;
  int byte;
  if (file == NULL) return 1;
  while ((byte = getc(file)) != EOF) hash = (hash ^ (uint64_t)byte) * UINT64_C(1099511628211);
  printf("%016" PRIx64 "\n", hash);
  fclose(file);
  return 0;
}
