// Emscripten's C library opens no file by its name in a module without Emscripten's JavaScript. Here it asks the
// module's host, as it does for the files of an open folder.
#include <fcntl.h>

long __syscall_openat(long folder, const char* path, long how, ...);

long __syscall_open(const char* path, long how, ...) { return __syscall_openat(AT_FDCWD, path, how, 0600); }
