/* What the program around the originals gives to the harness. */
struct kernel {
  char const *name;
  int inputs, outputs, hidden;
  int is_tame; /* the inputs stay within low and high */
  double low, high;
  double const *recorded;
  void (*original)(double const *in, double *out); /* out has what the caller left there */
  int (*generated)(double const *in, double *out); /* 0, or the number of a guard: nothing is written then */
  void (*hidden_values)(double *out);              /* what outlives a call and is named by no annotation */
  int state[64];                                   /* for each output the input that it is in the next call, or -1 */
};
#ifdef __cplusplus
extern "C" {
#endif
extern struct kernel const kernels[];
extern int const kernel_count;
extern int chosen[8]; /* which value each thing that is baked in has in a call: 0 is the recorded one */
#ifdef __cplusplus
}
#endif
