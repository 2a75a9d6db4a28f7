"""A graph in which everything has a name that no language has: strange_names.py FILE."""
import sys

NAMES = [b"int", b"1x", b"", b"_Bool", b"__x", b"unix", b"linux", b"typeof", b"NAN", b"M_PI", b"INT32_MAX", b"t1", b"r1", b"compute_1", b"load_4",
         b"*/ evil /*", b"a\\\\", b"a\\\"; evil(); \\\"", b"a??/", b"%s%n${x}`", b"a\revil = 1", b"a\x0bevil", b"a\x00evil", b"\xff\xfe", b"caf\xc3\xa9",
         b"\xe2\x80\xa8evil", b"\xe2\x80\xaeevil", b"\\\\u000a evil", b"x[0]", b"count", b"values", b"input", b"output"]


def quoted(name):
    return b'"' + name + b'"'


lines = [b"symreal-graph 1", b"kernel " + quoted(b"k*/ evil /*\\\\")]
for k, name in enumerate(NAMES):
    lines.append(b"input " + quoted(name) + b" at " + quoted(name + b".c") + b" 3 1 = 1")
lines.append(b"input \"s\" { " + b" ".join(quoted(name) for name in NAMES) + b" }")
lines.append(b"output \"y\" [%d]" % len(NAMES))
lines += [b"frozen " + quoted(name) + b" at " + quoted(name) + b" 1 1 = 2" for name in NAMES]
lines += [b"table %d " % k + quoted(name) + b" [2] = 1 2" for k, name in enumerate(NAMES)]
lines += [b"location %d at " % k + quoted(name) + b" 5 1" for k, name in enumerate(NAMES)]
lines += [b"%%%d = input %d" % (k, k) for k in range(len(NAMES))]
node = len(NAMES)
for k, name in enumerate(NAMES):
    lines.append(b"%%%d = sin %%%d @%d " % (node, k, k) + quoted(name))
    lines.append(b"%%%d = lookup %d %%%d" % (node + 1, k, node))
    lines.append(b"%%%d = add %%%d %%%d @%d" % (node + 2, node, node + 1, k))
    node += 3
lines += [b"result %d %%%d" % (k, len(NAMES) + 3 * k + 2) for k in range(len(NAMES))]
lines += [b"guard %d %%%d @%d " % (k, k, k) + quoted(name) for k, name in enumerate(NAMES)]
open(sys.argv[1], "wb").write(b"\n".join(lines) + b"\n")
