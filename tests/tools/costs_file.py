#!/usr/bin/env python3
"""costs_file.py OPERATIONS.DEF NANOSECONDS REGION [CORES]: prints a file of costs, of a machine on which each operation takes so
long, on CORES cores (2), and a region of sections REGION; so that code for threads can be asked for whatever machine this is."""
import json
import re
import sys

operation, region, cores = float(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4]) if len(sys.argv) > 4 else 2
names = re.findall(r"^OPERATION\((\w+), ", open(sys.argv[1]).read(), re.MULTILINE)
threads = [{"threads": 2, "nanoseconds": region}, {"threads": 4, "nanoseconds": region}]
print(json.dumps({"symreal-costs": 1,
                  "nanoseconds": {name: {"latency": operation, "throughput": operation} for name in names},
                  "threads": {"processors": cores, "cores": cores, "hand_over": 1, "wake": 3000, "start": 3000,
                              "barriers": threads, "sections": threads}}))
