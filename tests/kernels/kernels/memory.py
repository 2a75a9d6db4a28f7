"""Memory of the caller that functions of the library change: an output, scratch, or a diagnostic.

A memory has a parameter, an object of the caller and its items in clauses; an operation changes what the caller left there.
"""
from dataclasses import dataclass

from .arithmetic import DOUBLE
from .expression import ADD
from .generator import Variable
from .interface import section
from .numbers import tame_number
from .plain import read_by_library, tables

LEFT = {"SYM053", "SYM017", "SYM136"}
SIZE = 3
# Numbers as the caller has left them. A function of the library that writes the same value over it cannot be told from one that
# leaves it, so no expression has these values.
FOUND = ["1.015625", "3.046875", "2.078125"]


@dataclass
class Memory:
    name: str
    item: str        # of the clauses
    first: str = ""  # its range, if it has one
    last: str = ""


def of_array(g, made, type, values, is_declared):
    """In a variable of the calling function, of the file, or on the heap."""
    name, size = g.local("w"), len(values)
    braces = f"{{{', '.join(map(str, values))}}}"
    how = g.whole(0, 3)
    if how == 0 and (not is_declared or g.has("whole_objects")):
        outer = g.outer("memory")
        g.define(f"static {type} {outer}[{size}] = {braces};")
        return Memory(outer, f"{outer}[0:{size}]", outer, f"{outer} + {size}")
    made.parameters.append(f"{type} *{name}")
    if how == 1:
        block = g.outer("block")
        cast = f"({type} *)"
        fills = " ".join(f"kept[{k}] = {v};" for k, v in enumerate(values))
        g.define(f"static {type} *{block}(void) {{ static {type} *kept; if (!kept) {{ kept = {cast}malloc({size} * sizeof *kept); {fills} }} "
                 "return kept; }")
        made.objects.append(f"{type} *{name}; {name} = {block}();")
        made.arguments.append(name)
    else:
        made.objects.append(f"{type} {name}[{size}] = {braces};")
        made.arguments.append(name)
    return Memory(name, f"{name}[0:{size}]", name, f"{name} + {size}")


def of_container(g, made, type, initial, ends=True):
    name = g.local("list")
    made.parameters.append(f"{type} &{name}")
    made.objects.append(f"{type} {name}{initial};")
    made.arguments.append(name)
    return Memory(name, name, f"{name}.begin()" if ends else "", f"{name}.end()" if ends else "")


def value(g):
    return tame_number(g, 1, 50).text


def comparator(g, type):
    name = g.outer("before")
    g.define(f"static int {name}(const void *a, const void *b) {{ {type} p = *(const {type} *)a, q = *(const {type} *)b; "
             "return (p > q) - (p < q); }")
    return name


def fill_numbers(g, w):
    """Operations that read nothing of what was there; the whole is written."""
    choices = [lambda: g.line(f"memset({w.name}, 0, {SIZE} * sizeof *{w.name});"),
               lambda: (g.line(f"double {w.name}_from[{SIZE}] = {{{value(g)}, {value(g)}, {value(g)}}};"),
                        g.line(f"memcpy({w.name}, {w.name}_from, sizeof {w.name}_from);")),
               lambda: (g.line(f"double {w.name}_from[{SIZE}] = {{{value(g)}, 4.5, {value(g)}}};"),
                        g.line(f"memmove({w.name}, {w.name}_from, {SIZE} * sizeof(double));"))]
    if g.language == "cxx":
        choices = choices[:1] if "begin" not in w.first else []
        choices += [lambda: g.line(f"std::fill({w.first}, {w.last}, {value(g)});"),
                    lambda: g.line(f"std::fill_n({w.first}, {SIZE}, {value(g)});"),
                    lambda: g.line(f"std::iota({w.first}, {w.last}, {g.among('5.0', value(g))});"),
                    lambda: (g.line(f"double const {w.name}_from[{SIZE}] = {{{value(g)}, 4.5, {value(g)}}};"),
                             g.line(f"std::copy({w.name}_from, {w.name}_from + {SIZE}, {w.first});")),
                    lambda: (g.line(f"std::array<double, {SIZE}> {w.name}_from = {{4.5, {value(g)}, {value(g)}}};"),
                             g.line(f"std::transform({w.name}_from.begin(), {w.name}_from.end(), {w.first}, [](double z) {{ return -z; }});")),
                    lambda: g.line(f"std::generate({w.first}, {w.last}, [&] {{ return {value(g)}; }});")]
    g.random.choice(choices)()


def change_numbers(g, w, plain):
    """Operations on what is there; a sort decides where that is symbolic."""
    choices = [lambda: g.line(f"memmove(&{w.name}[1], &{w.name}[0], 2 * sizeof(double));")]
    if plain:
        choices.append(lambda: g.line(f"qsort(&{w.name}[0], {SIZE}, sizeof(double), {comparator(g, 'double')});"))
    if g.language == "cxx":
        choices += [lambda: g.line(f"std::swap({w.name}[0], {w.name}[2]);"),
                    lambda: g.line(f"std::rotate({w.first}, {w.first} + 1, {w.last});"),
                    lambda: g.line(f"std::reverse({w.first}, {w.last});"),
                    lambda: g.line(f"std::partial_sum({w.first}, {w.last}, {w.first});"),
                    lambda: g.line(f"std::swap_ranges({w.first}, {w.first} + 1, {w.first} + 2);"),
                    lambda: g.line(f"std::iter_swap({w.first}, {w.first} + 2);")]
        if plain:
            choices.append(lambda: g.line(f"std::sort({w.first}, {w.last});"))
            choices.append(lambda: g.line(f"std::stable_sort({w.first}, {w.last}, std::greater<double>());"))
    g.random.choice(choices)()


def numbers(g, made, is_declared):
    use_container = g.language == "cxx" and g.chance(0.4) and (not is_declared or g.has("whole_objects"))
    if use_container:
        w = g.among(lambda: of_container(g, made, "std::vector<double>", f"{{{', '.join(FOUND)}}}"),
                    lambda: of_container(g, made, f"std::array<double, {SIZE}>", f"{{{', '.join(FOUND)}}}"))()
    else:
        w = of_array(g, made, "double", FOUND, is_declared)
    if not is_declared:
        if g.chance(0.5):
            fill_numbers(g, w)
        else:
            change_numbers(g, w, True)
        return
    fill_numbers(g, w)
    if g.chance(0.6):
        change_numbers(g, w, False)
    if g.chance(0.5):
        for k in range(SIZE):
            g.line(f"{w.name}[{k}] += {g.random.choice(g.inputs).text};")
        made.outputs.append((w.item, [f"{w.name}[{k}]" for k in range(SIZE)]))
    else:
        made.clauses.append(f"scratch({w.item})")
    if g.language == "cxx" and g.chance(0.4):
        total = g.local("total")
        g.line(f"double {total} = std::accumulate({w.first}, {w.last}, 0.5);")
        g.declare(Variable(total, DOUBLE, None, None, True, False))
    else:
        g.declare(Variable(f"{w.name}[{g.whole(0, SIZE - 1)}]", DOUBLE, None, None, True, False))


def integers(g, made, is_declared):
    type = g.among("int", "int", "short", "unsigned char", "long")
    w = of_array(g, made, type, [5, 3, 4], is_declared)
    choices = [lambda: g.line(f"memset({w.name}, 0, {SIZE} * sizeof *{w.name});"),
               lambda: (g.line(f"{type} {w.name}_from[{SIZE}] = {{7, 1, 2}};"), g.line(f"memcpy({w.name}, {w.name}_from, sizeof {w.name}_from);"))]
    if g.language == "cxx":
        choices += [lambda: g.line(f"std::fill({w.first}, {w.last}, 9);"), lambda: g.line(f"std::iota({w.first}, {w.last}, 6);")]
    if is_declared or g.chance(0.5):
        g.random.choice(choices)()
    else:
        choices = [lambda: g.line(f"qsort({w.name}, {SIZE}, sizeof *{w.name}, {comparator(g, type)});")]
        if g.language == "cxx":
            choices += [lambda: g.line(f"std::sort({w.first}, {w.last});"), lambda: g.line(f"std::swap({w.name}[0], {w.name}[1]);"),
                        lambda: g.line(f"std::rotate({w.first}, {w.first} + 1, {w.last});"), lambda: g.line(f"std::reverse({w.first}, {w.last});")]
        g.random.choice(choices)()
    if is_declared:
        made.clauses.append(f"scratch({w.item})")


def integers_read(g, made, is_declared):
    """No clause names them; those that one names are plain arguments (plain.py)."""
    w = of_array(g, made, "int", [5, 3, 4], False)
    kept = g.local("read")
    g.line(f"double {kept} = {read_by_library(g, w.name)};")
    g.shown.append(kept)


def table_read(g, made, is_declared):
    """The same of constants."""
    name, first = g.local("table"), tables(g)[0]
    made.parameters.append(f"double const *{name}")
    made.arguments.append(name)
    made.objects.append(f"double const *{name} = {first};")
    kept = g.local("read")
    g.line(f"double {kept} = {name}[{g.whole(0, 2)}];")
    g.shown.append(kept)


def text(g, made, is_declared):
    name = g.local("line")
    made.parameters.append(f"char *{name}")
    made.objects.append(f'char {name}[64] = "none";')
    made.arguments.append(name)
    g.line(g.among(f'strcpy({name}, "on");', f'sprintf({name}, "%d", 42);', f'snprintf({name}, 64, "%g", 2.5);',
                   f'strncpy({name}, "automatic", 8);', f"memset({name}, 'x', 5);"))
    if is_declared:
        made.clauses.append(f"scratch({name}[0:64])")


def owned(g, made, is_declared):
    """Containers and pointers of C++ that grow, shrink and change hands."""
    usable = [one for one in OWNED if not is_declared or "map" not in one[0] and (g.has("whole_objects") or "double" not in one[0])]
    type, initial, change = g.random.choice(usable)  # an insertion into a map reads its keys
    w = of_container(g, made, type, initial, False)
    g.line(change.replace("NAME", w.name).replace("INPUT", f"{g.random.choice(g.inputs).at(ADD)} + 1"))
    if is_declared:
        made.clauses.append(f"scratch({w.item})")


OWNED = [
    ("std::vector<int>", "{5, 3, 4}", "NAME.push_back(3);"), ("std::vector<int>", "{5, 3, 4}", "NAME.resize(7);"),
    ("std::vector<int>", "{5, 3, 4}", "NAME.assign(2, 8);"), ("std::vector<int>", "{5, 3, 4}", "NAME.insert(NAME.begin(), 2);"),
    ("std::vector<int>", "{5, 3, 4}", "NAME.push_back(8); NAME.erase(NAME.begin());"), ("std::vector<int>", "{5, 3, 4}", "NAME.clear();"),
    ("std::vector<double>", "{1.0, 2.0}", "NAME.push_back(2.5);"), ("std::vector<double>", "{1.0, 2.0}", "NAME.assign(4, INPUT);"),
    ("std::vector<double>", "{1.0, 2.0}", "NAME.resize(5);"), ("std::vector<double>", "{1.0, 2.0}", "NAME.push_back(8); NAME.erase(NAME.begin());"),
    ("std::vector<double>", "{1.0, 2.0}", "NAME.insert(NAME.end(), INPUT);"),
    ("std::vector<bool>", "{true, false}", "NAME.flip();"), ("std::vector<bool>", "{true, false}", "NAME.push_back(true);"),
    ("std::vector<bool>", "{true, false}", "NAME[1] = true;"),
    ("std::string", "{\"none\"}", "NAME = \"automatic\";"), ("std::string", "{\"none\"}", "NAME += \"x\";"),
    ("std::string", "{\"none\"}", "NAME.clear();"), ("std::string", "{\"none\"}", "NAME.assign(40, 'y');"),
    ("std::unique_ptr<int>", "", "NAME.reset(new int(4));"), ("std::unique_ptr<double>", "", "NAME = std::make_unique<double>(INPUT);"),
    ("std::shared_ptr<int>", "", "NAME = std::make_shared<int>(4);"),
    ("std::unique_ptr<double>", "{new double(2.5)}", "NAME.reset();"), ("std::map<int, int>", "{{1, 2}}", "NAME[3] = 4;"),
    ("std::map<int, double>", "{{1, 2.0}}", "NAME[1] = 4.5;"), ("std::optional<int>", "", "NAME = 3;")]


def declare_memory(g, made):
    """Declared memory is right; what is not declared must be refused, since the change surely happens."""
    kinds = [numbers, numbers, integers, text] + ([owned, owned] if g.language == "cxx" else [])
    if g.has("library_memory") and g.chance(0.7):
        g.random.choice(kinds)(g, made, True)
    if g.has("undeclared_memory") and g.chance(0.7):
        g.random.choice([*kinds, integers_read, table_read])(g, made, False)
        g.expected |= LEFT
