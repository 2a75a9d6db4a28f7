#!/usr/bin/env python3
"""balanced_span.py GRAPH: prints the work and the critical path of a graph in unit operations, as it stands and with sums of several
terms balanced: of the terms of a sum the two that are there first are added first. Changes of sign cost nothing. Balancing
regroups sums, which the mode finite does not: this only tells what it would give."""
import heapq
import re
import sys

nodes, results, uses = {}, [], {}
for line in open(sys.argv[1]):
    if node := re.match(r"%(\d+) = (\w+) ?([^@;\n]*)", line):
        name, op, words = node.groups()
        operands = [] if op in ("input", "parameter") else [word.lstrip("%") if word[0] == "%" else None for word in words.split()]
        nodes[name] = op, operands
        for operand in operands:
            uses[operand] = uses.get(operand, 0) + 1
    elif result := re.match(r"result \d+ %(\d+)", line):
        results.append(result.group(1))
for name in results:
    uses[name] = uses.get(name, 0) + 1

live = set(results)
for name in reversed(nodes):
    if name in live:
        live.update(operand for operand in nodes[name][1] if operand)
SUMS, FREE = ("add", "sub"), ("input", "parameter", "neg")
work = sum(nodes[name][0] not in FREE for name in live)


def terms(name):
    """Of the sum that a node ends: what it adds that is no sum of its own."""
    rest, found = list(nodes[name][1]), []
    while rest:
        one = rest.pop()
        if one and uses[one] == 1 and nodes[one][0] in (*SUMS, "neg"):
            rest += nodes[one][1]
        else:
            found.append(one)
    return found


def span(balances):
    end = {None: 0}  # a constant is there from the beginning
    for name, (op, operands) in nodes.items():
        if balances and op in SUMS:
            times = [end[term] for term in terms(name)]
            heapq.heapify(times)
            while len(times) > 1:
                heapq.heappush(times, max(heapq.heappop(times), heapq.heappop(times)) + 1)
            end[name] = times[0]
        else:
            end[name] = max((end[operand] for operand in operands), default=0) + (op not in FREE)
    return max(end[name] for name in live)


print(f"operations {work}")
for words, balances in (("as it stands", False), ("with sums balanced", True)):
    print(f"critical path {span(balances)} {words}, mean parallelism {work/span(balances):.1f}")
