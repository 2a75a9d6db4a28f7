"""every_rule.py SYMREAL RULES: for each row of rules.def the graph of its pattern, and what the pass of its topic alone makes of it; of a
row that is for truth values also what it makes of numbers."""
import re
import subprocess
import sys
import tempfile

ROW = re.compile(r'^RULE\((\w+), (\w+), "([^"]*)", "[^"]*", (\w+), ".*"\)$')
CONSTANT = {"k_negative": "-3", "k_zero": "0", "k_nonzero": "2", "k_has_exact_inverse": "4"}
HEAD = 'symreal-graph 1\nkernel "k"\ninput "i" [8]\nparameter "p"\noutput "y"\n'


def parsed(text):
    """Nested lists of words."""
    stack = [[]]
    for word in re.findall(r"[()]|[^\s()]+", text):
        if word == "(":
            stack.append([])
        elif word == ")":
            stack[-2].append(stack.pop())
        else:
            stack[-1].append(word)
    return stack[0][0]


def graph_of(pattern, condition):
    names, lines = {"k": CONSTANT.get(condition, "3")}, []

    def line(text):
        lines.append(f"%{len(lines)} = {text}")
        return f"%{len(lines) - 1}"

    # The earlier a letter, the younger its node.
    for number, letter in enumerate(sorted(set(re.findall(r"\b[a-z]\b", pattern)) - {"k"}, reverse=True)):
        if letter == "x" and condition == "x_truth":
            names[letter] = line(f"lt {line('input 6')} {line('input 7')}")
        else:
            names[letter] = line("parameter 0" if letter == "p" else f"input {number}")

    def node(term):
        if isinstance(term, str):
            return names.get(term, term)
        return line(" ".join([term[0], *map(node, term[1:])]))

    root = node(parsed(pattern))
    return HEAD + "\n".join([*lines, f"result 0 {root}"]) + "\n", {value: key for key, value in names.items() if key != "k"}


def expression(text, names):
    """The result, with the letters of the pattern."""
    nodes = {name: words.split(" ") for name, words in re.findall(r"^(%\d+) = ([^@;\n]*?) *$", text, re.MULTILINE)}
    leaves = {}
    for name, words in nodes.items():
        leaves[name] = " ".join(words) if words[0] in ("input", "parameter") else None

    def spelled(word):
        if word not in nodes:
            return word
        if leaves[word]:
            return names.get(leaves[word], leaves[word])
        inside = f"({' '.join([nodes[word][0], *map(spelled, nodes[word][1:])])})"
        return names.get(inside, inside)

    return spelled(re.search(r"^result 0 (\S+)", text, re.MULTILINE).group(1))


def simplified(symreal, topic, mode, pattern, condition):
    text, letters = graph_of(pattern, condition)
    nodes = dict(re.findall(r"^(%\d+) = (.*)$", text, re.MULTILINE))
    names = {re.sub(r"%\d+", lambda name: nodes[name.group()], f"({nodes[place]})" if " %" in nodes[place] else nodes[place]): letter
             for place, letter in letters.items()}
    with tempfile.NamedTemporaryFile("w", suffix=".graph") as file:
        file.write(text)
        file.flush()
        passes = topic if topic in ("identities", "signs") else "simplify"
        done = subprocess.run([symreal, "opt", file.name, f"--passes={passes}", f"--fp={mode}"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{pattern}: {done.stderr}\n{text}")
    return expression(done.stdout, names)


def main():
    symreal, rules = sys.argv[1:]
    for line in open(rules):
        row = ROW.match(line)
        if not row:
            continue
        topic, mode, pattern, condition = row.groups()
        print(f"{topic} {mode}: {pattern} -> {simplified(symreal, topic, mode, pattern, condition)}")
        if condition == "x_truth":
            print(f"    of a number -> {simplified(symreal, topic, mode, pattern, 'x_number')}")


main()
