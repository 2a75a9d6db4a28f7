/* A kernel that starts a process has an effect outside of the program, and what it does before it starts a thread counts.
   RUN: rm -f %t.c
   RUN: not %symreal generate %s -o %t.c -- -DFORK 2>&1 | FileCheck %s
   RUN: not %symreal generate %s -o %t.c -- -DSYSTEM 2>&1 | FileCheck %s
   CHECK: error: the kernel starts a process, and the generated code would not do so [SYM215]
   RUN: not %symreal generate %s -o %t.c -- -DREMOVED 2>&1 | FileCheck %s --check-prefix=REMOVED
   REMOVED: error: the kernel makes the directory {{.*}}, and the generated code would not do so [SYM215]
   RUN: not ls %t.c
   RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=20
*/
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(FORK)
static void act(void)
{
    pid_t const child = fork();
    if (child == 0) _exit(0);
    waitpid(child, NULL, 0);
}
#elif defined(SYSTEM)
static void act(void)
{
    if (system("true") != 0) abort();
}
#else
static void *run(void *argument) { return argument; }
static void act(void)
{
    pthread_t thread;
#ifdef REMOVED
    char name[] = "/tmp/directory_XXXXXX";
    if (!mkdtemp(name)) abort();
#endif
    if (pthread_create(&thread, NULL, run, NULL) == 0) pthread_join(thread, NULL);
}
#endif

#pragma symreal function input(x) output(return)
double scaled(double x)
{
    act();
    return 2 * x;
}

int main(void)
{
    printf("%g\n", scaled(0.5));
    return 0;
}
