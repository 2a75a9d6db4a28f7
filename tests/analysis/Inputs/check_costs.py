"""Each operation of the table has costs, and what costs something in the table costs time.  check_costs.py COSTS OPERATIONS"""
import json
import re
import sys

costs = json.load(open(sys.argv[1]))["nanoseconds"]
rows = re.findall(r"^OPERATION\((\w+), \d, \w+, \"[^\"]*\", \d+, .*, (\d+), [A-Z_0-9| ]+, \w+, \".*\"\)$", open(sys.argv[2]).read(), re.MULTILINE)
wrong = [name for name, cost in rows
         if name not in costs or any((costs[name][which] > 0) != (int(cost) > 0) for which in ("latency", "throughput"))]
print(*wrong, f"{len(rows)} operations, {len(wrong)} wrong", sep="\n")
sys.exit(1 if wrong or len(rows) != len(costs) else 0)
