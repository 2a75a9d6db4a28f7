/* A contender is a shared object with one function. bench/peers/turns.c opens all contenders of a row and lets them
 * take turns. */
#ifndef BENCH_PEERS_CONTENDER_H
#define BENCH_PEERS_CONTENDER_H

#ifdef __cplusplus
extern "C" {
#endif

/* Input: joint positions, then, where the kernel takes them, velocities, then accelerations or torques. */
typedef void (*Evaluate)(double const *input, double *output);

/* Makes ready what a user makes ready once, such as the model, and returns what is timed.
   kernel: fk, rnea, crba or aba; model: a table as inputs/chain/data/chain-model.csv. */
__attribute__((visibility("default"))) Evaluate contender(char const *kernel, int joints, char const *model);

#ifdef __cplusplus
}
#endif

#endif
