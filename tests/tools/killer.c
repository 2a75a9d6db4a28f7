/* Preloaded: ends the process, as kill -9 does, before the KILL_AT-th call that changes a file's name or makes it durable. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void count(void) {
  static int calls;
  char const *at = getenv("KILL_AT");
  if (at && ++calls == atoi(at)) kill(getpid(), SIGKILL);
}

#define WATCHED(name, parameters, arguments)                                                                           \
  int name parameters {                                                                                                \
    count();                                                                                                           \
    return ((int(*) parameters)dlsym(RTLD_NEXT, #name))arguments;                                                      \
  }
WATCHED(rename, (char const *from, char const *to), (from, to))
WATCHED(fsync, (int file), (file))
WATCHED(fchmod, (int file, mode_t mode), (file, mode))
WATCHED(unlink, (char const *path), (path))
WATCHED(mkdir, (char const *path, mode_t mode), (path, mode))
