/* Runs a fuzz target on files, without a fuzzer: replay FILE... . Linked in place of libFuzzer's main. */
#include "fuzz/input.h"

static int run(const char* path) {
  FILE* file = fopen(path, "rb");
  uint8_t* data = NULL;
  long size;
  if (file == NULL || fseek(file, 0, SEEK_END) != 0 || (size = ftell(file)) < 0) {
    fprintf(stderr, "cannot read %s\n", path);
    return 1;
  }
  rewind(file);
  /* Of exactly this size, so that reading beyond it is noticed. */
  data = malloc((size_t)size > 0 ? (size_t)size : 1);
  if (data == NULL || fread(data, 1, (size_t)size, file) != (size_t)size) return 1;
  fclose(file);
  printf("%s\n", path);
  fflush(stdout);
  LLVMFuzzerTestOneInput(data, (size_t)size);
  free(data);
  return 0;
}

int main(int argc, char** argv) {
  int i, failed = 0;
  for (i = 1; i < argc; ++i) failed += run(argv[i]);
  printf("%d inputs\n", argc - 1);
  return failed > 0 || argc < 2;
}
