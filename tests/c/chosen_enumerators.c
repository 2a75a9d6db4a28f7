/* gcc folds a choice of enumerators in another way behind a cast: numeric mode has none. */
// RUN: %rewrite %s -- | FileCheck %s
// RUN: %symreal verify --numeric %s -- -O1 | FileCheck %s --check-prefix=SAME
// SAME: 1 of 1 translation units have identical object code
typedef enum { fixed = -1, asleep = 0, awake = 1 } State;
typedef struct { int kind[4], flag[8], number; int const *ids; } Data;
double weight;
State state(Data const *d, int i);
static State both(Data const *d, int i)
{
    State a = state(d, i), b = state(d, i + 1);
    // CHECK: return REAL_FIT({{.*}}(a == awake || b == awake) ? awake : asleep);
    return (a == awake || b == awake) ? awake : asleep;
}
State state(Data const *d, int i)
{
    if (d->kind[i & 3] == 2) return both(d, i);
    for (int j = 0; j < d->number; j++)
        if (d->flag[d->ids[j]] > 0) return (State)d->flag[d->ids[i + j]];
    return fixed;
}
