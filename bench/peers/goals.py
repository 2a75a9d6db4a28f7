"""What the benchmark must show, and whether it does: the page says so by itself."""
import contenders
import figures

FACTORS = {"rnea": 1.2, "aba": 1.4, "crba": 1.8}  # over the best peer at six joints


def spread(ratio, digits=2):
    return f"{ratio['median']:.{digits}f} ({ratio['low']:.{digits}f} to {ratio['high']:.{digits}f})"


def verdict(met):
    return "met" if met else "**missed**"


def least(title, ratio, goal):
    return [title, f"at least {goal:g}", spread(ratio), verdict(ratio["median"] >= goal)]


def operations(rows):
    """Where mode finite leaves more operations than a peer that reads the same source: the peers with fewer, the fewest first."""
    peers = [name for name in contenders.PEERS if name in contenders.PYTHON or name == "CppADCodeGen"]
    more, count = [], 0
    for row in rows:
        own = row.operations("Symreal finite")
        known = [name for name in peers if row.operations(name) is not None]
        if own is None or not known:
            continue
        count += 1
        fewer = sorted((name for name in known if row.operations(name) < own), key=row.operations)
        if fewer:
            more.append((row, own, fewer))
    return more, count


def operations_with_same_results(rows):
    """Those of them in which a peer with fewer operations gives the original's results, or was not compared: what mode finite could do."""
    more, count = operations(rows)
    return [(row, own, fewer) for row, own, fewer in more if any(not row.difference(name) for name in fewer)], count


def slower(rows, other, level=None):
    """Rows in which Symreal's best is slower than `other(row)`, a contender's name."""
    found, count = [], 0
    for row in rows:
        name, own = other(row), figures.ours(row)
        if not name or not own:
            continue
        count += 1
        ratio = row.ratio(name, own, level)
        if ratio["median"] < 1:
            found.append((row, own, name, ratio))
    return found, count


def of_six(rows):
    """The goals at six joints as rows of a table."""
    table = []
    for row in (row for row in rows if row.joints == 6):
        best = figures.peer(row)
        if row.kernel in FACTORS and best and row.there("Symreal fast"):
            table.append(least(f"{figures.TITLES[row.kernel]}: times as fast as the best peer, {best}", row.ratio(best, "Symreal fast"),
                               FACTORS[row.kernel]))
        if row.kernel == "rnea" and row.there("Symreal fast"):
            for level, goal in (("gcc -O3 -march=native", 4), ("gcc -O2", 9)):
                table.append(least(f"{figures.TITLES[row.kernel]}: times as fast as the original at {level}",
                                   row.ratio("original", "Symreal fast", level), goal))
    return table


def everywhere(rows):
    table = []
    for title, found, count in (("mode finite leaves no more operations than any peer that gives the original's results",
                                 *operations_with_same_results(rows)),
                                ("Symreal is at least as fast as the original at gcc -O3 -march=native",
                                 *slower(rows, lambda row: "original", figures.ORIGINAL)),
                                ("Symreal is at least as fast as the best peer", *slower(rows, figures.peer))):
        table.append([title, f"all {count} rows", f"{count - len(found)} of {count}", verdict(not found)])
    return table


def losses(rows):
    lines = []
    for other, level in ((lambda row: "original", figures.ORIGINAL), (figures.peer, None)):
        for row, own, name, ratio in slower(rows, other, level)[0]:
            lines.append([row.title, own, f"{name}, {level or row.best_level(name)}", f"{row.median(own):.0f}", f"{row.median(name, level):.0f}",
                          spread(ratio)])
    return lines
