"""The graph of a sum of products of a parameter and an input each:   many_parameters.py N"""
import sys

count = int(sys.argv[1])
print('symreal-graph 1\nkernel "k"')
print(f'input "x" [{count}] =' + " 1" * count)
print(f'parameter "p" [{count}] =' + " 1" * count)
print('output "y" [1]')
for i in range(count):
    print(f"%{2 * i} = input {i}\n%{2 * i + 1} = parameter {i}")
node, total = 2 * count, None
for i in range(count):
    print(f"%{node} = mul %{2 * i} %{2 * i + 1}")
    if total is not None:
        node += 1
        print(f"%{node} = add %{total} %{node - 1}")
    total, node = node, node + 1
print(f"result 0 %{total}")
