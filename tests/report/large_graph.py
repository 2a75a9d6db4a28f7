"""Writes a graph of many nodes and its source: large_graph.py NODES GRAPH SOURCE

A grid of 500 columns: each node takes two neighbours of the row above. Forty functions of five lines, row by row."""
import sys

nodes, graph, source = int(sys.argv[1]), sys.argv[2], sys.argv[3]
width, functions, lines = 500, 40, 5
with open(source, "w") as out:
    for function in range(functions):
        out.write(f"void stage{function}(double *x) {{\n" + "".join(f"  x[{line}] = x[{line}] * x[{line + 1}];\n" for line in range(lines)) + "}\n")
rows = nodes // width
with open(graph, "w") as out:
    out.write(f'symreal-graph 1\nkernel "grid"\ninput "x[0:{width}]" [{width}]\noutput "y[0:{width}]" [{width}]\n')
    for place in range(functions * lines):
        out.write(f'location {place} at "{source}" {place // lines * (lines + 2) + place % lines + 2} 8\n')
    for column in range(width):
        out.write(f"%{column} = input {column}\n")
    for row in range(1, rows):
        for column in range(width):
            above = (row - 1) * width
            place = row * functions // rows * lines + column % lines
            operation = "add" if (row + column) % 3 else "mul"
            out.write(f"%{row * width + column} = {operation} %{above + column} %{above + (column + 1) % width} @{place}\n")
    for column in range(width):
        out.write(f"result {column} %{(rows - 1) * width + column}\n")
