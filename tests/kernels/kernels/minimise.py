"""A smaller kernel with the same fault: statements are left out as long as it stays and the original's behaviour is defined. The
candidates of a round are one batch."""
import copy
import os
import re
import tempfile

from .generator import Block
from .session import Session

MOST = 40  # candidates in a round


def paths(nodes, at=()):
    for k, node in enumerate(nodes):
        yield (*at, k)
        if isinstance(node, Block):
            yield from paths(node.children, (*at, k))


def parent(nodes, path):
    for k in path[:-1]:
        nodes = nodes[k].children
    return nodes


def size(node):
    return 1 if isinstance(node, str) else 1 + sum(map(size, node.children))


def without(kernel, path):
    """A copy with one statement less, or None where that is no statement: a pragma, the kernel itself."""
    node = parent(kernel.nodes, path)[path[-1]]
    if isinstance(node, str) and node.startswith("#") or len(path) == 1 and path[0] == len(kernel.nodes) - 1:
        return None
    made = copy.deepcopy(kernel)
    del parent(made.nodes, path)[path[-1]]
    return made


def renamed(kernel, name):
    """The kernel under another name, that of all that is its own as well."""
    old = kernel.name

    def of(text):
        text = re.sub(rf"\b{old}(?=_|\b)", name, text)
        return re.sub(rf"\b{old.upper()}_", name.upper() + "_", text)

    def tree(nodes):
        return [of(n) if isinstance(n, str) else Block(of(n.header), tree(n.children), n.footer and of(n.footer)) for n in nodes]
    made = copy.deepcopy(kernel)
    made.name, made.nodes = name, tree(made.nodes)
    interface = made.interface
    interface.result = of(interface.result)
    for field in ("parameters", "arguments", "clauses", "objects", "hidden"):
        setattr(interface, field, [of(text) for text in getattr(interface, field)])
    for plain in interface.plains:
        plain.element, plain.values = of(plain.element), [of(value) for value in plain.values]
    for field in ("inputs", "values", "outputs"):
        setattr(interface, field, [(of(text), [of(e) for e in elements]) for text, elements in getattr(interface, field)])
    return made


def is_defined(kernel, session, seed):
    session.execute([kernel], seed)
    return session.is_defined(seed)


def smaller(kernel, kind, session, seed, is_wanted):
    """The smallest of the candidates that have the fault and are wanted, or None."""
    candidates = [(size(parent(kernel.nodes, p)[p[-1]]), p) for p in paths(kernel.nodes)]
    candidates.sort(key=lambda c: -c[0])
    made = [without(kernel, path) for _, path in candidates[:4 * MOST]]
    made = [m for m in made if m is not None]
    for first in range(0, len(made), MOST):
        batch = [renamed(m, f"{kernel.name.split('v')[0]}v{k}") for k, m in enumerate(made[first:first + MOST])]
        outcome = session.execute(batch, seed)
        faulty = sorted((f.kernel for f in outcome.found if f.kind == kind), key=lambda k: sum(map(size, k.nodes)))
        wanted = next(filter(is_wanted, faulty), None)
        if wanted:
            return wanted
    return None


def minimised(found, make_session, seed, rounds=40):
    kernel = found.kernel
    with tempfile.TemporaryDirectory(prefix="kernels-") as directory:
        session = make_session(os.path.join(directory))
        checks = is_defined(kernel, session, seed)  # else a compiler warns of the whole kernel already
        for _ in range(rounds):
            made = smaller(kernel, found.kind, session, seed, lambda k: not checks or is_defined(k, session, seed))
            if made is None:
                break
            kernel = made
        outcome = session.execute([kernel], seed)
        return next((f for f in outcome.found if f.kind == found.kind), found)
