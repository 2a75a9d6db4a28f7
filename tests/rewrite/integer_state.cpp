// Integers that outlive a function and that the program could change are looked at where they are used.
// RUN: cd %S && %rewrite integer_state.cpp | FileCheck integer_state.cpp
// RUN: %same %s
#include <cerrno>
#include <vector>

static int changed = 1, never = 2, list[2] = {1, 2}, lent = 3;
int global = 4;
constexpr int size = 3;
void change(int *p) { *p = 5; }
int look(int const *p, int const &q);

// CHECK: struct Table { REAL_MEMBERS(public, n, x, kinds)
struct Table {
  int n;
  double x;
  char name[8];
  int *p;
  unsigned flag : 1;
  std::vector<short> kinds;
};
// CHECK: Packed {{[{]$}}
struct __attribute__((packed)) Packed {
  char c;
  int n;
};

double use(Table &table, Packed &packed, int k, double x) {
  static int count, unseen = sizeof(list) / sizeof *list;
  // CHECK: REAL_WRITTEN("changed", {{.*}}, REAL_STATE(changed, "integer_state.cpp:{{[0-9]+}}:12")) = k + never + unseen + list[k];
  changed = k + never + unseen + list[k];
  // CHECK: look(list, never);
  look(list, never);
  // CHECK: change(&REAL_STATE(lent, {{.*}}));
  change(&lent);
  // CHECK: for (int i = 0; i < REAL_READ("table.n", {{.*}}, table.n) && i < size; ++i) x += i;
  for (int i = 0; i < table.n && i < size; ++i) x += i;
  // CHECK: REAL_READ("count", {{.*}}, REAL_STATE(count, {{.*}})) += REAL_READ("global", {{.*}}, REAL_STATE(global, {{.*}}))++ + REAL_READ("table.p[k]", {{.*}}, REAL_READ("table.p", {{.*}}, table.p)[k]) + sizeof global;
  count += global++ + table.p[k] + sizeof global;
  // CHECK: for (short kind : REAL_READ("table.kinds", {{.*}}, REAL_DECIDES("table.kinds", {{.*}}, table.kinds))) x += kind;
  for (short kind : table.kinds) x += kind;
  // CHECK: if (REAL_ENVIRONMENT(error_read, "errno", {{.*}}, errno)) x = 0;
  if (errno) x = 0;
  // CHECK: auto const local = [k] { return REAL_READ("k", {{.*}}, k); };
  auto const local = [k] { return k; };
  // CHECK: return x + table.flag + packed.n + local();
  return x + table.flag + packed.n + local();
}
