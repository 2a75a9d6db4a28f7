// The report of a scan: files, obstacles, what will depend on values; nothing is written.
// RUN: %symreal scan %s %S/Inputs/other.cpp 2>&1 | FileCheck %s
// CHECK: 2 sources, 3 files within the roots
// CHECK: file {{ *}}double {{ *}}converted {{ *}}passive {{ *}}diagnosed {{ *}}inactive {{ *}}share
// CHECK: other.cpp {{ *}}2 {{ *}}2 {{ *}}0 {{ *}}0 {{ *}}0 {{ *}}100%
// CHECK: shared.h {{ *}}2 {{ *}}2 {{ *}}0 {{ *}}0 {{ *}}0 {{ *}}100%
// CHECK: report.cpp {{ *}}9 {{ *}}9 {{ *}}0 {{ *}}0 {{ *}}0 {{ *}}100%
// CHECK: 1  SYM030 a function that uses double is not defined in the sources; first at {{.*}}report.cpp
// CHECK: decisions on REAL: 2, of which 1 can be a select
// CHECK-NEXT: 1  if, because of 'return' before a call of 'puts'
// CHECK: comparisons of REAL: 2; conversions of REAL: 1 to an integer, 0 to float or long double
// A source that does not compile is left out, and said to be.
// RUN: python3 %tools/expect_status.py 2 %symreal scan %S/Inputs/other.cpp %S/Inputs/broken.cpp | FileCheck --check-prefix=BROKEN %s
// BROKEN: left out, does not compile: {{.*}}broken.cpp
// BROKEN: total {{ *}}4
// BROKEN: 1  SYM020 a source does not compile; first at {{.*}}broken.cpp:1:34
// RUN: %symreal scan --json %s %S/Inputs/other.cpp > %t.json
// RUN: FileCheck --check-prefix=JSON %s < %t.json
// RUN: python3 -c "import json,sys; r = json.load(open(sys.argv[1])); f = r['files']; assert sum(len(x['tokens']) for x in f) == r['total']['doubles'] + r['total']['floats'] + r['total']['long_doubles'], r" %t.json
// RUN: %symreal scan --sarif %s > %t.sarif
// RUN: FileCheck --check-prefix=SARIF %s < %t.sarif
// RUN: python3 -c "import json,sys; r = json.load(open(sys.argv[1]))['runs'][0]; ids = {x['id'] for x in r['tool']['driver']['rules']}; assert ids == {x['ruleId'] for x in r['results']} and ids, r" %t.sarif
#include "Inputs/shared.h"
// SARIF-DAG: "text": "'if' decides on a REAL; it cannot be a select because of 'return' before
// SARIF-DAG: "text": "'?:' decides on a REAL; it can be a select"
// SARIF-DAG: "text": "a REAL is converted to int"
// SARIF-DAG: "ruleId": "SYM030"
// JSON: "doubles": 13,
// JSON: "fate": "converted"
// JSON: "selectable": false,
double solve(double x);
extern "C" int puts(char const *);
double late(double x) {
  if (x > 1) return 1;
  puts("not a select");
  return x;
}
double clamped(double x) { return x > 1 ? 1 : x; }
int index_of(double x) { return (int)half(x); }
double use(double x) { return solve(x) + late(x) + clamped(x) + index_of(x); }
