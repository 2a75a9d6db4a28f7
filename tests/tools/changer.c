/* Preloaded: writes to the file named by CHANGE before the first directory is made, as an editor would meanwhile. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

int mkdir(char const *path, mode_t mode) {
  char const *name = getenv("CHANGE");
  FILE *file = name ? fopen(name, "a") : NULL;
  if (file) {
    fputs("/* changed */\n", file);
    fclose(file);
    unsetenv("CHANGE");
  }
  return ((int (*)(char const *, mode_t))dlsym(RTLD_NEXT, "mkdir"))(path, mode);
}
