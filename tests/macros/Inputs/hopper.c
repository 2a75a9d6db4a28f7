/* Arrays, a structure, state, integers made of numbers, decisions, a loop with an exit, a jump past an initialisation,
   a table, text, bytes: a bit of everything that the rewriter has a macro for, without a header of its own. */
#ifdef __cplusplus
extern "C" {
#endif
int sprintf(char *to, char const *format, ...);
#ifdef __cplusplus
}
#endif

struct hopper {
  double mass, speed[3];
  int legs;
};
enum gait { STAND, HOP };
static double gain[2] = {0.5, 0.25};
static double const curve[5] = {0, 1, 4, 9, 16};
static double scratched;
static char shown[40];
static double doubled(double a) { return 2 * a; }
static double (*const law)(double) = doubled;

static double limited(double a, double most) {
  if (a > most) return most;
  return a;
}

#pragma symreal function input(*h, q[0:4]) range(-2, 2) parameter(p[0:2]) constant(gain) scratch(scratched, shown) output(*h, f[0:4], return) decisions(select)
double hop(struct hopper *h, double const *q, double const *p, double *f) {
  enum gait g = HOP;
  double copy[4], sum = 0;
  __builtin_memcpy(copy, q, sizeof copy);
  scratched = copy[0] * gain[1];
  int at = (int)(q[2] + 2);
  sprintf(shown, "%.3f", q[0]);
  for (int j = 0; j < 4; ++j) {
    double force = limited(p[0] * q[j] + gain[0], 1.5);
    if (force < 0) force = -force, sum += 1;
    f[j] = force > 1 ? force : 2 * force;
    sum += law(f[j]);
  }
#pragma symreal loop(5)
  for (int turn = 0; sum > 2; ++turn) {
    sum *= 0.5;
    if (sum < p[1]) break;
  }
  switch (g) {
#ifdef __cplusplus
    double shift;
#else
    double shift = 1;
#endif
  case HOP: shift = 0.125; sum += shift; break;
  case STAND: break;
  }
  h->speed[1] += scratched + curve[at] * at;
  h->mass *= 1 + (h->legs >> 1);
  f[0] -= __builtin_fabs(copy[3]);
  return sum;
}

int main(void) {
  struct hopper one = {1.5, {0.5, 0.25, 0.125}, 2};
  double q[4] = {0.25, 0.5, 0.75, 1}, p[2] = {1.5, 0.125}, f[4];
  return hop(&one, q, p, f) < 0;
}
