"""The multibody library of inputs/chain once more, operation by operation, for number types of Python.

A user of the peers writes this instead of the C++ sources: they take no program. `sin` and `cos` are those of the peer.
"""
import csv
import pathlib

DATA = pathlib.Path(__file__).resolve().parents[2] / "inputs/chain/data"
GRAVITY = [0, 0, 0, 0, 0, 9.80665]


class Link:
    """A row of chain-model.csv; what is computed from it is of the type `number`."""

    def __init__(self, row, number):
        values = [number(float(row[name])) for name in "rx ry rz m cx cy cz Ixx Ixy Ixz Iyy Iyz Izz".split()]
        self.joint, self.offset = "xyz".index(row["axis"]), values[:3]
        mass, c, (xx, xy, xz, yy, yz, zz) = values[3], values[4:7], values[7:]
        cross, about = [[0, -c[2], c[1]], [c[2], 0, -c[0]], [-c[1], c[0], 0]], [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
        self.inertia = zeros(6)
        for i in range(3):
            for j in range(3):
                self.inertia[i][j] = about[i][j] + mass * sum(cross[i][k] * cross[j][k] for k in range(3))
                self.inertia[i][3 + j], self.inertia[3 + i][j] = mass * cross[i][j], mass * cross[j][i]
            self.inertia[3 + i][3 + i] = mass
        self.axis = [1 if i == self.joint else 0 for i in range(6)]
        r, self.tree = self.offset, identity(6)
        self.tree[3][1], self.tree[3][2], self.tree[4][0] = r[2], -r[1], -r[2]
        self.tree[4][2], self.tree[5][0], self.tree[5][1] = r[0], r[1], -r[0]


def model_rows(count):
    """The table's 64 rows; a longer chain repeats the first 63, whose axes are x, y, z in turn."""
    with open(DATA / "chain-model.csv") as file:
        rows = list(csv.DictReader(file))
    return [{**rows[i if i < len(rows) else i % 63], "link": i + 1} for i in range(count)]


def read_links(count, number):
    return [Link(row, number) for row in model_rows(count)]


def zeros(n):
    return [[0] * n for _ in range(n)]


def identity(n):
    return [[1 if i == j else 0 for j in range(n)] for i in range(n)]


def dot(a, b):
    total = a[0] * b[0]
    for x, y in zip(a[1:], b[1:]):
        total = total + x * y
    return total


def transpose(A):
    return [list(row) for row in zip(*A)]


def apply(A, x):
    return [dot(row, x) for row in A]


def multiply(A, B):
    columns = transpose(B)
    return [[dot(row, column) for column in columns] for row in A]


def add(*vectors):
    total = vectors[0]
    for vector in vectors[1:]:
        total = [x + y for x, y in zip(total, vector)]
    return total


def add_matrix(A, B):
    return [add(a, b) for a, b in zip(A, B)]


def scale(x, factor):
    return [each * factor for each in x]


def turn(block_count, axis, c, s):
    y, z, X = (axis + 1) % 3, (axis + 2) % 3, zeros(3 * block_count)
    for block in range(0, 3 * block_count, 3):
        X[block + axis][block + axis] = 1
        X[block + y][block + y], X[block + y][block + z] = c, s
        X[block + z][block + y], X[block + z][block + z] = -s, c
    return X


def cross_motion(v):
    result = zeros(6)
    for at, (x, y, z) in (((0, 0), v[:3]), ((3, 3), v[:3]), ((3, 0), v[3:])):
        block = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
        for i in range(3):
            for j in range(3):
                result[at[0] + i][at[1] + j] = block[i][j]
    return result


def cross_force(v):
    return [[-x for x in row] for row in transpose(cross_motion(v))]


class Chain:
    def __init__(self, count, sin, cos, number=float):
        self.links, self.sin, self.cos = read_links(count, number), sin, cos

    def transforms(self, q):
        return [multiply(turn(2, link.joint, self.cos(angle), self.sin(angle)), link.tree)
                for link, angle in zip(self.links, q)]

    def forward_kinematics(self, q):
        T = identity(4)
        for link, angle in zip(self.links, q):
            shift, rotation = identity(4), identity(4)
            for i, row in enumerate(transpose(turn(1, link.joint, self.cos(angle), self.sin(angle)))):
                shift[i][3] = link.offset[i]
                rotation[i][:3] = row
            T = multiply(multiply(T, shift), rotation)
        return [T[i][j] for i in range(3) for j in range(3)] + [T[i][3] for i in range(3)]

    def inverse_dynamics(self, q, qd, qdd):
        X, v, a, f = self.transforms(q), [], [], []
        for i, link in enumerate(self.links):
            velocity, acceleration = scale(link.axis, qd[i]), scale(link.axis, qdd[i])
            if i == 0:
                v.append(velocity)
                a.append(add(apply(X[i], GRAVITY), acceleration))
            else:
                v.append(add(apply(X[i], v[-1]), velocity))
                a.append(add(apply(X[i], a[-1]), acceleration, apply(cross_motion(v[i]), velocity)))
            f.append(add(apply(link.inertia, a[i]), apply(cross_force(v[i]), apply(link.inertia, v[i]))))
        tau = []
        for i in reversed(range(len(self.links))):
            tau.insert(0, dot(self.links[i].axis, f[i]))
            if i > 0:
                f[i - 1] = add(f[i - 1], apply(transpose(X[i]), f[i]))
        return tau

    def mass_matrix(self, q):
        X, n = self.transforms(q), len(self.links)
        composite, H = [link.inertia for link in self.links], zeros(n)
        for i in range(n - 1, 0, -1):
            composite[i - 1] = add_matrix(composite[i - 1], multiply(multiply(transpose(X[i]), composite[i]), X[i]))
        for i in range(n):
            force = apply(composite[i], self.links[i].axis)
            H[i][i] = dot(self.links[i].axis, force)
            for j in range(i, 0, -1):
                force = apply(transpose(X[j]), force)
                H[i][j - 1] = H[j - 1][i] = dot(self.links[j - 1].axis, force)
        return [x for row in H for x in row]

    def forward_dynamics(self, q, qd, tau):
        X, n = self.transforms(q), len(self.links)
        v, c, inertia, bias = [], [], [], []
        for i, link in enumerate(self.links):
            velocity = scale(link.axis, qd[i])
            v.append(add(apply(X[i], v[-1]), velocity) if i else velocity)
            c.append(apply(cross_motion(v[i]), velocity) if i else [0] * 6)
            inertia.append(link.inertia)
            bias.append(apply(cross_force(v[i]), apply(link.inertia, v[i])))
        U, d, u = [None] * n, [None] * n, [None] * n
        for i in reversed(range(n)):
            axis = self.links[i].axis
            U[i] = apply(inertia[i], axis)
            d[i] = dot(axis, U[i])
            u[i] = tau[i] - dot(axis, bias[i])
            if i > 0:
                k = [x / d[i] for x in U[i]]
                apparent = [[inertia[i][row][j] - k[row] * U[i][j] for j in range(6)] for row in range(6)]
                apparent_bias = add(bias[i], apply(apparent, c[i]), scale(k, u[i]))
                inertia[i - 1] = add_matrix(inertia[i - 1], multiply(multiply(transpose(X[i]), apparent), X[i]))
                bias[i - 1] = add(bias[i - 1], apply(transpose(X[i]), apparent_bias))
        a, qdd = GRAVITY, []
        for i in range(n):
            a = apply(X[i], a)
            if i > 0:
                a = add(a, c[i])
            qdd.append((u[i] - dot(U[i], a)) / d[i])
            a = add(a, scale(self.links[i].axis, qdd[i]))
        return qdd
