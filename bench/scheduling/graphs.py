"""Random task graphs, made as those of the Standard Task Graph set are: four ways to draw the dependencies.

same_probability and same_predecessors draw from all earlier tasks; layered_probability and layered_predecessors first
give each task a layer, and draw from the layer before its own. `width` is the tasks of a layer, or, without layers, about
how many tasks could run at once."""
import random

WAYS = ["same_probability", "same_predecessors", "layered_probability", "layered_predecessors"]


def predecessors(way, tasks, width, draw):
    if way == "same_probability":
        # The longest path of such a graph has about e * tasks * probability tasks.
        probability = min(1, 1 / (2.7 * width))
        return [[j for j in range(i) if draw.random() < probability] if tasks <= 1000 else
                sorted({draw.randrange(i) for _ in range(count(i * probability, draw))}) if i else []
                for i in range(tasks)]
    if way == "same_predecessors":
        return [sorted({draw.randrange(max(0, i - 3 * width), i) for _ in range(draw.randint(1, 3))}) if i else [] for i in range(tasks)]
    layers = [range(k, min(k + width, tasks)) for k in range(0, tasks, width)]
    result = [[] for _ in layers[0]]
    for before, layer in zip(layers, layers[1:]):
        for _ in layer:
            if way == "layered_probability":
                result.append([j for j in before if draw.random() < 2 / width] or [draw.choice(before)])
            else:
                result.append(sorted(draw.sample(before, min(width, draw.randint(1, 4)))))
    return result


def count(mean, draw):
    """A number with this mean, with the spread of many rare events."""
    return max(0, round(draw.gauss(mean, mean**0.5)))


def durations(tasks, longest, draw):
    return [draw.randint(1, longest) for _ in range(tasks)]


def task_graph(way, tasks, width, longest):
    """The text of a file of the Standard Task Graph set."""
    draw = random.Random(f"{way} {tasks} {width} {longest}")
    before = predecessors(way, tasks, width, draw)
    times = durations(tasks, longest, draw)
    has_successor = {j for row in before for j in row}
    last = [i + 1 for i in range(tasks) if i not in has_successor]
    lines = [str(tasks), "0 0 0"]
    for i, row in enumerate(before):
        row = [j + 1 for j in row] or [0]
        lines.append(f"{i + 1} {times[i]} {len(row)} {' '.join(map(str, row))}")
    lines.append(f"{tasks + 1} 0 {len(last)} {' '.join(map(str, last))}")
    return "\n".join(lines) + "\n"
