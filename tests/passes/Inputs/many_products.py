"""The graph of the sum of all products of two of N inputs, and of a difference that is 0:   many_products.py N"""
import itertools
import sys

count = int(sys.argv[1])
print('symreal-graph 1\nkernel "k"')
print(f'input "x" [{count}] =' + " 1" * count)
print('output "y" [2]')
for i in range(count):
    print(f"%{i} = input {i}")
node, total = count, None
for i, j in itertools.combinations_with_replacement(range(count), 2):
    print(f"%{node} = mul %{i} %{j}")
    if total is not None:
        node += 1
        print(f"%{node} = add %{total} %{node - 1}")
    total, node = node, node + 1
print(f"""%{node} = add %1 %2
%{node + 1} = mul %0 %{node}
%{node + 2} = mul %0 %1
%{node + 3} = mul %0 %2
%{node + 4} = add %{node + 2} %{node + 3}
%{node + 5} = sub %{node + 1} %{node + 4}
result 0 %{total}
result 1 %{node + 5}""")
