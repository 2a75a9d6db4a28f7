#!/usr/bin/env python3
"""Prints the text of a graph whose operations each need the one before: long_chain.py COUNT"""
import sys

print('symreal-graph 1\nkernel "chain"\ninput "x" = 0.5\noutput "y"\n%0 = input 0')
print("".join(f"%{k} = sin %{k - 1}\n" for k in range(1, int(sys.argv[1]) + 1)) + f"result 0 %{sys.argv[1]}")
