#!/usr/bin/env python3
"""long_table.py COUNT: prints a graph that reads a table of so many numbers."""
import sys

values = " ".join(str(k * 0.1) for k in range(int(sys.argv[1])))
print(f'''symreal-graph 1
kernel "k"
input "x" = 2
output "y"
table 0 "t" [{sys.argv[1]}] = {values}
%0 = input 0
%1 = lookup 0 %0
result 0 %1''')
