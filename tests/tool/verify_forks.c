/* A fork of the original makes several runs, each from the state in which the kernel begins. Whatever a run leaves, verify
   says the same as with a fork for each sample. The program counts its forks, those that look for unnamed state included.
   RUN: %symreal generate %s -o %t.c
   RUN: %S/Inputs/both_ways.sh %tool %s %t.c %t.d PLAIN STATICS HEAP FREED STACK ERRNO ROUNDING | FileCheck %s --check-prefix=FEW
   RUN: %S/Inputs/both_ways.sh %tool %s %t.c %t.d OPENS DEEP CRASHES STOPS | FileCheck %s --check-prefix=MANY
   RUN: %if all %{ %S/Inputs/both_ways.sh %tool %s %t.c %t.d JUMPS ENVIRONMENT LOCALE BLOCKS PRINTS HANDLES MAPS THREAD HANGS | FileCheck %s --check-prefix=MORE %}
   FEW: PLAIN: status 0, few forks
   FEW: STATICS: status 3, few forks
   FEW: HEAP: status 3, few forks
   FEW: FREED: status 3, few forks
   FEW: STACK: status 3, few forks
   FEW: ERRNO: status 3, few forks
   FEW: ROUNDING: status 3, few forks
   MANY: OPENS: status 0, many forks
   MANY: DEEP: status 0, many forks
   MANY: CRASHES: status 1
   MANY: STOPS: status 1
   MORE: JUMPS: status 3, few forks
   MORE: ENVIRONMENT: status 3, few forks
   MORE: LOCALE: status 3, many forks
   MORE: BLOCKS: status 3, many forks
   MORE: PRINTS: status 0, many forks
   MORE: HANDLES: status 3, many forks
   MORE: MAPS: status 3, many forks
   MORE: THREAD: status 0, many forks
   MORE: HANGS: status 1
*/
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <fenv.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

static int forks = -1;
static void count_fork(void)
{
    if (write(forks, "f", 1) != 1) abort();
}

#if !defined(MBD_SYMBOLIC) && !defined(MBD_REPLAY)
static volatile int runs;
static char *volatile kept;
static volatile double third = 3;
static jmp_buf point;

static void handle(int number) { (void)number; }
static void *run(void *argument) { return argument; }

/* Not 0 where a run finds what another one has left. */
static __attribute__((noinline)) int found(double x)
{
#ifdef STATICS
    return runs++;
#elif defined HEAP
    int const is_found = kept && kept[7] == 'k';
    kept = malloc(40);
    if (!kept) abort();
    memset(kept, 'k', 40);
    return is_found;
#elif defined FREED
    char *volatile block = malloc(1000);
    if (!block) abort();
    int const is_found = block[500] == 'k';
    block[500] = 'k';
    free(block);
    return is_found;
#elif defined STACK
    volatile char junk[4000];
    int const is_found = junk[50] == 'k' && junk[51] == 'l';
    junk[50] = 'k', junk[51] = 'l';
    return is_found;
#elif defined ERRNO
    int const is_found = errno == ERANGE;
    errno = ERANGE;
    return is_found;
#elif defined ROUNDING
    int const is_found = 1 / third > 0.3333333333333333;
    __asm__ volatile("" ::: "memory");
    fesetround(FE_UPWARD);
    return is_found;
#elif defined BLOCKS
    sigset_t set, old;
    sigemptyset(&set);
    sigaddset(&set, SIGUSR1);
    sigprocmask(SIG_BLOCK, &set, &old);
    return sigismember(&old, SIGUSR1);
#elif defined OPENS
    int const file = open("/dev/null", O_RDONLY);
    return file > 60;
#elif defined PRINTS
    if (x > 1e300) return 1;
    if (write(1, "", 0) != 0) abort();
    return 0;
#elif defined HANDLES
    return signal(SIGUSR2, handle) == handle;
#elif defined MAPS
    char *at = mmap(NULL, 8192, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    int const is_found = kept && kept[0] == 'k';
    kept = at;
    *at = 'k';
    return is_found;
#elif defined DEEP
    volatile char junk[600000];
    int const is_found = junk[10] == 'k';
    junk[10] = 'k';
    return is_found && x > 1e300;
#elif defined THREAD
    pthread_t thread;
    if (pthread_create(&thread, NULL, run, NULL) != 0) abort();
    pthread_join(thread, NULL);
    return 0;
#elif defined CRASHES
    if (x > 1.2) *(volatile int *)16 = 0;
    return 0;
#elif defined STOPS
    if (x > 1.2) exit(3);
    return 0;
#elif defined HANGS
    while (x > 1.2) third = 3;
    return 0;
#elif defined JUMPS
    if (setjmp(point) == 0) longjmp(point, 1);
    return 0;
#elif defined LOCALE
    int const is_found = strcmp(setlocale(LC_ALL, NULL), "C") != 0;
    setlocale(LC_ALL, "C.UTF-8");
    return is_found;
#elif defined ENVIRONMENT
    int const is_found = getenv("SYMREAL_TEST_LEFT") != NULL;
    setenv("SYMREAL_TEST_LEFT", "1", 1);
    return is_found;
#else
    return x > 1e300;
#endif
}
#endif

#pragma symreal function input(x, p[0:3]) output(return)
double f(double x, double const *p)
{
    double y = x * p[0] + p[1] * p[2] - x * x;
#if !defined(MBD_SYMBOLIC) && !defined(MBD_REPLAY)
    y += found(x);
#endif
    return y;
}

int main(int count, char **arguments)
{
    double const p[3] = {1, 2, 3};
    (void)count;
    forks = open(arguments[1], O_WRONLY | O_CREAT | O_APPEND, 0644);
    pthread_atfork(NULL, NULL, count_fork);
    printf("%g\n", f(0.75, p));
    return 0;
}
