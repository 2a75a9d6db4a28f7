#!/usr/bin/env python3
"""Writes sources that are large for a compiler. sources.py flight STATEMENTS, or sources.py kinematics LINES.

flight: one function of 110 numbers that live through a loop, as in a model of an aircraft written by hand.
kinematics: a class of a few large functions as generators of inverse kinematics write them: joints by branches that
nest, each with arrays of candidates, conditions and many short-lived numbers."""
import random
import sys


def flight(statements):
    draw = random.Random(1)
    names = [f"v{k}" for k in range(110)]
    lines = ["#include <math.h>", "#include <stdio.h>", "",
             "void flight(double const *state, double const *control, double step, double *next) {"]
    lines += [f"  double {name} = {draw.uniform(0.1, 0.9):.3f} * state[{k % 12}] + control[{k % 4}];"
              for k, name in enumerate(names)]
    lines += ["  for (int turn = 0; turn < 2; turn++) {"]

    def term():
        a, b = draw.choice(names), draw.choice(names)
        kind = draw.randrange(12)
        if kind == 0:
            return f"sin({a})"
        if kind == 1:
            return f"{a} / (2.0 + {b} * {b})"
        if kind < 7:
            return f"{draw.uniform(-0.5, 0.5):.4f} * {a}"
        return f"{a} * {b}"

    for k in range(statements):
        name = draw.choice(names)
        value = " + ".join(term() for _ in range(draw.randrange(2, 6)))
        if k % 40 == 39:
            other = draw.choice(names)
            lines.append(f"    if (turn == {k % 2}) {{")
            lines.append(f"      {name} = 0.25 * ({value});")
            lines.append(f"      {other} = {other} * 0.5;")
            lines.append("    }")
        else:
            lines.append(f"    {name} = 0.25 * ({value});")
    lines += ["  }"]
    lines += [f"  next[{k}] = state[{k}] + step * ({' + '.join(names[k::12])});" for k in range(12)]
    lines += ["}", "", "int main(void) {", "  double state[12], control[4], step = 0.01, next[12];",
              "  for (int i = 0; i < 12; i++) state[i] = 0.1 * (i + 1);",
              "  for (int i = 0; i < 4; i++) control[i] = 0.05 * i;",
              "#pragma symreal input(state[0:12]) range(-1, 1) input(control[0:4]) range(-1, 1)",
              "  flight(state, control, step, next);",
              '#pragma symreal output(next[0:12]) generate("flight_code.c")',
              '  printf("%g\\n", next[0]);', "  return 0;", "}"]
    return lines


class Kinematics:
    """A tree of joints: each block tries what it finds, and within a valid candidate goes on to the next joint."""

    def __init__(self, lines):
        self.draw = random.Random(2)
        self.most = lines
        self.lines = []
        self.count = 0

    def number(self):
        self.count += 1
        return f"x{self.count}"

    def expression(self, known):
        parts = []
        for _ in range(self.draw.randrange(1, 4)):
            factors = self.draw.sample(known, self.draw.randrange(1, min(4, len(known))))
            parts.append(f"(({self.draw.uniform(-1, 1):.3f})*{'*'.join(factors)})")
        return "(" + "+".join(parts) + ")"

    def block(self, joint, depth, known, budget):
        pad = "  " * depth
        out = self.lines.append
        start = len(self.lines)
        own = list(known)
        out(f"{pad}{{")
        for _ in range(self.draw.randrange(20, 40)):
            name = self.number()
            out(f"{pad}IkReal {name} = {self.expression(own[-24:])};")
            own.append(name)
        value = self.expression(own[-8:])
        out(f"{pad}IkReal j{joint}eval[2];")
        out(f"{pad}j{joint}eval[0] = {value};")
        out(f"{pad}j{joint}eval[1] = {self.expression(own[-8:])};")
        out(f"{pad}if (fabs(j{joint}eval[0]) < 0.0000010000000000) {{")
        out(f"{pad}  count += 1;")
        if len(self.lines) - start < budget // 3 and joint < 6:
            self.block(joint + 1, depth + 1, own[-12:] + ["r00", "r01", "px"], budget // 3)
        out(f"{pad}}} else {{")
        out(f"{pad}  IkReal j{joint}array[2], cj{joint}array[2], sj{joint}array[2];")
        out(f"{pad}  bool j{joint}valid[2] = {{false}};")
        out(f"{pad}  j{joint}array[0] = atan2({self.expression(own[-8:])}, {self.expression(own[-8:])});")
        out(f"{pad}  j{joint}array[1] = ((-1.0)*j{joint}array[0])+(1.57079632679490);")
        out(f"{pad}  for (int i = 0; i < 2; ++i) {{")
        out(f"{pad}    sj{joint}array[i] = sin(j{joint}array[i]);")
        out(f"{pad}    cj{joint}array[i] = cos(j{joint}array[i]);")
        out(f"{pad}    if (j{joint}array[i] > 3.14159265358979) j{joint}array[i] -= 6.28318530717959;")
        out(f"{pad}    else if (j{joint}array[i] < -3.14159265358979) j{joint}array[i] += 6.28318530717959;")
        out(f"{pad}    j{joint}valid[i] = true;")
        out(f"{pad}  }}")
        out(f"{pad}  for (int i{joint} = 0; i{joint} < 2; ++i{joint}) {{")
        out(f"{pad}    if (!j{joint}valid[i{joint}]) continue;")
        out(f"{pad}    j{joint} = j{joint}array[i{joint}]; cj{joint} = cj{joint}array[i{joint}]; "
            f"sj{joint} = sj{joint}array[i{joint}];")
        out(f"{pad}    {{")
        out(f"{pad}      IkReal evalcond[6];")
        for k in range(6):
            out(f"{pad}      evalcond[{k}] = {self.expression(own[-10:] + [f'cj{joint}', f'sj{joint}'])};")
        tests = " || ".join(f"fabs(evalcond[{k}]) > 1000000.0" for k in range(6))
        out(f"{pad}      if ({tests}) continue;")
        out(f"{pad}    }}")
        own += [f"cj{joint}", f"sj{joint}"]
        while len(self.lines) - start < budget and joint < 6 and len(self.lines) < self.most:
            self.block(joint + 1, depth + 2, own[-14:] + ["r00", "r12", "py"],
                       min(budget // 2, budget - (len(self.lines) - start)))
        out(f"{pad}    result += j{joint} * 0.5;")
        out(f"{pad}  }}")
        out(f"{pad}}}")
        out(f"{pad}}}")

    def text(self):
        out = self.lines.append
        out("#include <math.h>")
        out("#include <stdio.h>")
        out("typedef double IkReal;")
        out("class Solver {")
        out("public:")
        joints = ", ".join(f"j{k}, cj{k}, sj{k}" for k in range(7))
        out(f"  IkReal {joints}, r00, r01, r02, r10, r11, r12, px, py, pz, result;")
        out("  int count;")
        known = ["r00", "r01", "r02", "r10", "r11", "r12", "px", "py", "pz"]
        functions = max(2, self.most // 5000)
        for k in range(functions):
            out(f"  void solve{k}() {{")
            goal = self.most * (k + 1) // functions
            while len(self.lines) < goal:
                self.block(0, 2, known, goal - len(self.lines))
            out("  }")
        out("  void solve() {")
        for k in range(functions):
            out(f"    solve{k}();")
        out("  }")
        out("};")
        out("int main() {")
        out("  Solver s;")
        out("  double pose[9], answer;")
        out("  for (int i = 0; i < 9; ++i) pose[i] = 0.1 * (i + 1);")
        out("#pragma symreal input(pose[0:9])")
        for k, name in enumerate(known):
            out(f"  s.{name} = pose[{k}];")
        zeros = " = ".join(f"s.j{k} = s.cj{k} = s.sj{k}" for k in range(7))
        out(f"  s.count = 0; s.result = {zeros} = 0;")
        out("  s.solve();")
        out("  answer = s.result;")
        out('#pragma symreal output(answer) generate("kinematics_code.c")')
        out('  printf("%g %d\\n", answer, s.count);')
        out("}")
        return self.lines


def main():
    kind, size = sys.argv[1], int(sys.argv[2])
    print("\n".join(flight(size) if kind == "flight" else Kinematics(size).text()))


main()
