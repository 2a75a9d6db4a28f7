/* Calls originals and generated code on the same inputs and compares what they leave.
   usage: harness finite|strict SEED SAMPLES. One line a kernel:
   NAME ok|different|lost COMPARED GUARDED OUTSIDE, and for a difference the inputs and both values.
   usage: harness finite|strict SEED SAMPLES KERNEL PLAINS. Calls what the program has under the kernel's name, the original or a
   wrapper, also with PLAINS values that are baked in changed, and prints a line a call: SAMPLE CALL OUTSIDE, what was changed, the
   outputs. The last line says how often generated code computed them. */
#include "harness.h"

#include <fenv.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { most = 64, calls_in_a_row = 4 };
static uint64_t chance;

static uint64_t next(void) {
  chance += 0x9e3779b97f4a7c15u;
  uint64_t z = chance;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

static double unit(void) { return (double)(next() >> 11) * 0x1p-53; }

static double within(struct kernel const *k, double value) {
  return k->is_tame ? fmax(k->low, fmin(k->high, value)) : value;
}

static double corner(void) {
  static double const corners[] = {0, -0.0, 1, -1, 0.5, -0.5, 2, -2, 3, 1e-9, -1e-9, 0.1, 5e-324, 1e6, -1e6, 7, -7};
  return corners[next() % (sizeof corners / sizeof *corners)];
}

/* One input by the way that a sample is drawn. */
static double draw(struct kernel const *k, int way, int index) {
  double low = k->low, high = k->high;
  switch (way) {
  case 0: return k->recorded[index];
  case 1: return k->recorded[index] * (1 + (unit() - 0.5) * 1e-3);
  case 2: return k->recorded[index] + (unit() - 0.5) * 0.2 * (high - low);
  case 3: return floor(low + unit() * (high - low));
  case 4: return floor(2 * (low + unit() * (high - low))) / 2;
  case 5: return corner();
  case 6: return next() % 2 ? low : high;
  case 7: return k->is_tame ? low + unit() * (high - low) : (next() % 2 ? -1 : 1) * exp((unit() - 0.5) * 80);
  default: return low + unit() * (high - low);
  }
}

static int same(double a, double b, int is_strict) {
  if (a != a || b != b) return a != a && b != b;
  return is_strict ? memcmp(&a, &b, sizeof a) == 0 : a == b;
}

static void show(char const *word, double const *values, int count) {
  printf("  %s", word);
  for (int i = 0; i < count; i++) printf(" %.17g", values[i]);
  printf("\n");
}

/* The inputs of a call, and what the caller left in the outputs; state goes on from call to call. */
static void prepare(struct kernel const *k, int way, int is_first, int is_mixed, double const *last, double *in, double *before) {
  for (int i = 0; i < k->inputs; i++) in[i] = within(k, draw(k, is_mixed ? (int)(next() % 9) : way, i));
  for (int o = 0; o < k->outputs && !is_first; o++)
    if (k->state[o] >= 0) in[k->state[o]] = within(k, last[o]);
  for (int o = 0; o < k->outputs; o++) before[o] = 4.0 + o + (double)(next() % 8) / 4;
  for (int o = 0; o < k->outputs; o++)
    if (k->state[o] >= 0) before[o] = in[k->state[o]];
}

/* Exceptions that the original raises, or that a call before has raised, are outside of the promise. */
static int is_outside_of_promise(struct kernel const *k, int is_strict, double const *in) {
  int is_outside = !is_strict && fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  for (int i = 0; i < k->inputs && !is_strict; i++) is_outside |= !isfinite(in[i]);
  return is_outside;
}

int chosen[8];
int computed; /* by generated code, which counts them */

static void trace(struct kernel const *k, int is_strict, int samples, int plains) {
  double in[most], out[most], last[most] = {0};
  for (int sample = 0; sample < samples; sample++) {
    int way = sample == 0 ? 0 : 1 + (int)(next() % 9);
    for (int call = 0; call < calls_in_a_row; call++) {
      int is_mixed = next() % 4 == 0 && sample != 0;
      prepare(k, way, call == 0, is_mixed, last, in, out);
      int changed = plains > 0 && next() % 2 ? (int)(next() % (uint64_t)plains) : -1;
      int value = (int)(next() % 4);
      for (int p = 0; p < 8; p++) chosen[p] = p == changed ? value : 0;
      feclearexcept(FE_ALL_EXCEPT);
      k->original(in, out);
      printf("%d %d %d %d=%d", sample, call, is_outside_of_promise(k, is_strict, in), changed, changed < 0 ? 0 : value);
      for (int o = 0; o < k->outputs; o++) printf(" %a", out[o]);
      printf("\n");
      memcpy(last, out, sizeof last);
    }
  }
  printf("computed %d\n", computed);
}

/* 0, or that a difference was printed. */
static int compare(struct kernel const *k, int is_strict, int samples) {
  int compared = 0, guarded = 0, outside = 0;
  double in[most], before[most], original[most], generated[most], kept_before[most], kept_after[most];
  for (int sample = 0; sample < samples; sample++) {
    int way = sample == 0 ? 0 : 1 + (int)(next() % 9);
    for (int call = 0; call < calls_in_a_row; call++) {
      int is_mixed = next() % 4 == 0 && sample != 0;
      double last[most];
      if (call > 0) memcpy(last, original, sizeof last);
      prepare(k, way, call == 0, is_mixed, last, in, before);
      memcpy(original, before, sizeof before);
      memcpy(generated, before, sizeof before);
      k->hidden_values(kept_before);
      feclearexcept(FE_ALL_EXCEPT);
      k->original(in, original);
      int is_outside = is_outside_of_promise(k, is_strict, in);
      k->hidden_values(kept_after);
      int guard = k->generated(in, generated);
      for (int h = 0; h < k->hidden; h++)
        if (!same(kept_before[h], kept_after[h], is_strict)) {
          printf("%s lost %d %d %d\n", k->name, compared, guarded, outside);
          show("input", in, k->inputs);
          show("kept before", kept_before, k->hidden);
          show("kept after", kept_after, k->hidden);
          return 1;
        }
      if (guard != 0) {
        guarded++;
        if (memcmp(generated, before, (size_t)k->outputs * sizeof *before) == 0) continue;
        printf("%s written-under-guard %d %d %d\n", k->name, compared, guarded, outside);
        show("input", in, k->inputs);
        return 1;
      }
      if (is_outside) {
        outside++;
        continue;
      }
      compared++;
      for (int o = 0; o < k->outputs; o++)
        if (!same(original[o], generated[o], is_strict)) {
          printf("%s different %d %d %d\n", k->name, compared, guarded, outside);
          printf("  call %d in a row\n", call);
          show("input", in, k->inputs);
          show("original", original, k->outputs);
          show("generated", generated, k->outputs);
          return 1;
        }
    }
  }
  printf("%s ok %d %d %d\n", k->name, compared, guarded, outside);
  return 0;
}

/* Each kernel in a process of its own, so that one that crashes does not take the others along. */
static int compare_apart(struct kernel const *k, int is_strict, int samples) {
  fflush(stdout);
  pid_t child = fork();
  if (child == 0) {
    alarm(20);
    int result = compare(k, is_strict, samples);
    fflush(stdout);
    _exit(result);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFSIGNALED(status)) return WEXITSTATUS(status);
  printf("%s crashed 0 0 0\n  signal %d\n", k->name, WTERMSIG(status));
  return 1;
}

int main(int argc, char **argv) {
  if (argc != 4 && argc != 6) return 2;
  int is_strict = strcmp(argv[1], "strict") == 0, failed = 0;
  for (int k = 0; k < kernel_count && argc == 6; k++) {
    chance = strtoull(argv[2], 0, 10) + (uint64_t)k;
    if (strcmp(kernels[k].name, argv[4]) == 0) trace(&kernels[k], is_strict, atoi(argv[3]), atoi(argv[5]));
  }
  if (argc == 6) return 0;
  for (int k = 0; k < kernel_count; k++) {
    chance = strtoull(argv[2], 0, 10) + (uint64_t)k;
    failed |= compare_apart(&kernels[k], is_strict, atoi(argv[3]));
  }
  return failed;
}
