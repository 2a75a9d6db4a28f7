"""The facts do not depend on the order in which the nodes of a syntax tree are visited: order_of_visits.py DUMP --every N SOURCE...

Every N-th source is read twice, with the flags that its own tests name, parents first and children first.
"""
import re
import subprocess
import sys


def flags_of(source):
    with open(source) as text:
        found = re.search(r"RUN:[^\n|&>]* -- (-[^\n|&>]*)", text.read())
    return [word for word in found.group(1).split() if "%" not in word] if found else []


def main():
    dump, _, every, *sources = sys.argv[1:]
    sources = sources[:: int(every)]
    read = different = 0
    for source in sources:
        words = [source, "--", *flags_of(source)]
        facts = [
            subprocess.run([dump, "--facts", *order, *words], capture_output=True, text=True).stdout
            for order in ([], ["--children-first"])
        ]
        read += bool(facts[0])
        if facts[0] != facts[1]:
            different += 1
            print(source)
    print(f"{read} of {len(sources)} sources read, {different} with other facts")


main()
