"""The figures as tables in Markdown and as CSV."""
import csv

import contenders
import figures
import goals


def table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|---" + "|---:" * (len(heading) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def nanoseconds(time):
    digits = 0 if time["median"] >= 100 else 1
    return goals.spread(time, digits)


def six(row):
    """All contenders of a row with each compiler."""
    own = "Symreal fast"
    lines = []
    for name in contenders.ALL:
        if not row.there(name):
            if name in row.contenders:
                lines.append([name, "", row.missing(name), "", ""])
            continue
        for level in sorted(row.levels(name), key=lambda level: row.median(name, level)):
            best = level == row.best_level(name)
            lines.append([name if best else "", row.operations(name) or "" if best else "", level, nanoseconds(row.time(name, level)),
                          goals.spread(row.ratio(name, own, level))])
    return table(["Contender", "Operations", "Compiler", "ns per call", "times as long as Symreal fast"], lines)


def growth(rows, kernel, names, value):
    """A line for each number of joints, a column for each contender. value(row, name) is text; else why it is missing."""
    lines, notes = [], {}
    for row in (row for row in rows if row.kernel == kernel):
        line = [row.joints]
        for name in names:
            text = value(row, name) if name in row.contenders else None
            if text is None and name in row.contenders and "missing" in row.contenders[name]:
                notes.setdefault(name, f"{name}, from N = {row.joints} on: {row.missing(name)}")
            line.append("" if text is None else text)
        lines.append(line)
    said = table(["N", *names], lines)
    return said + ("\n\nMissing: " + "; ".join(notes.values()) + "." if notes else "")


def time_of(row, name):
    return f"{row.median(name):.4g}" if row.there(name) else None


def count_of(row, name):
    return row.operations(name)


def compile_of(row, name):
    return f"{row.variant(name)['compile']:.2f}" if row.there(name) else None


def error_of(row, name):
    error = row.variant(name)["error"] if row.there(name) else None
    return None if error is None else f"{error:.1e}"


def rate_of(key, work):
    """Millions of the original's operations in a second of the step `key`."""
    def value(row, name):
        contender = row.contenders.get(name, {})
        executed = row.contenders.get("Symreal finite", {}).get("executed")
        if key not in contender or not executed or contender[key] <= 0:
            return None
        return executed / contender[key] / 1e6
    return value


def as_text(value):
    return lambda row, name: None if value(row, name) is None else f"{value(row, name):.3g}"


def write_csv(rows, path):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["kernel", "joints", "contender", "compiler", "operations", "record s", "write s", "compile s", "code bytes", "ns median",
                         "ns lower quartile", "ns upper quartile", "error", "difference from reference build", "missing"])
        for row in rows:
            for name, contender in row.contenders.items():
                made = [contender.get("operations", ""), *(f"{contender[key]:.4g}" if key in contender else "" for key in ("record", "write"))]
                if not row.there(name):
                    writer.writerow([row.kernel, row.joints, name, "", *made, *[""] * 7, contender.get("missing", "")])
                    continue
                for level, variant in row.levels(name).items():
                    time = figures.quartiles(variant["times"])
                    error = variant["error"]
                    writer.writerow([row.kernel, row.joints, name, level, *made, f"{variant['compile']:.3g}", variant["text"],
                                     *(f"{time[part]:.4g}" for part in ("median", "low", "high")), "" if error is None else f"{error:.2g}",
                                     f"{variant['difference']:.2g}", ""])
