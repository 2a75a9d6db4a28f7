// Decisions that cannot be a select for the same reason are told together, the commonest reason first.
// RUN: %symreal scan %s 2>&1 | FileCheck %s
// CHECK: decisions on REAL: 7, of which 0 can be a select
// CHECK-NEXT: 3  if, because of an assignment to '...', which is not a REAL; first at {{.*}}:15:3
// CHECK-NEXT: 2  if, because of 'return' before a call of '...', whose body is not seen here; first at {{.*}}:12:3
// CHECK-NEXT: 2  if, because of a call of '...', which has a call of '...', whose body is not seen here; first at {{.*}}:18:3
void unseen();
int first, second;
static void deep() { unseen(); }
static void deeper() { deep(); }
double late(double x) {
  if (x > 1) return 1;
  if (x > 6) return 2;
  unseen();
  if (x > 2) first = 1;
  if (x > 2) first = 1;
  if (x > 3) second = 1;
  if (x > 4) deep();
  if (x > 5) deeper();
  return x;
}
