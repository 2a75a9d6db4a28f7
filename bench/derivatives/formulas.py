"""The models of bench/derivatives/models once more, for number types of Python: x, z and the peer's functions give y.

A user of the peers writes this instead of the C++ sources: they take no program.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "peers"))
import chain  # noqa: E402
from chain import add, dot, multiply, scale, transpose  # noqa: E402


def of_chain(method, joints):
    def model(x, z, module):
        return getattr(chain.Chain(joints, module.sin, module.cos), method)(x[:joints], x[joints:], z)
    return model


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turn(A, v):
    return [dot(row, v) for row in A]


# cos alpha, sin alpha, d, r: Denavit's and Hartenberg's modified parameters
RX90 = [(1, 0, 0, 0), (0, 1, 0, 0), (1, 0, .45, 0), (0, -1, 0, .45), (0, 1, 0, 0), (0, -1, 0, 0)]


def rx90_links():
    """Of each link mass, first moment, and the inertia about the origin of its frame."""
    links = []
    for i in range(1, 7):
        m, c = 1.1 + .3 * i, [.11 + .01 * i, .07 - .02 * i, .05 + .03 * i]
        xx, xy, xz, yy, yz, zz = .5 + .05 * i, .02 + .003 * i, -.03 + .002 * i, .6 + .04 * i, .015 + .001 * i, .7 + .03 * i
        xy, xz, yz = xy - m * c[0] * c[1], xz - m * c[0] * c[2], yz - m * c[1] * c[2]
        tensor = [[xx + m * (c[1] ** 2 + c[2] ** 2), xy, xz], [xy, yy + m * (c[0] ** 2 + c[2] ** 2), yz],
                  [xz, yz, zz + m * (c[0] ** 2 + c[1] ** 2)]]
        links.append((m, scale(c, m), tensor))
    return links


def rx90_poses(q, module):
    poses = []
    for angle, (ca, sa, d, r) in zip(q, RX90):
        c, s = module.cos(angle), module.sin(angle)
        poses.append(([[c, -s, 0], [ca * s, ca * c, -sa], [sa * s, sa * c, ca]], [d, -sa * r, ca * r]))
    return poses


def newton_euler(poses, qd, qdd):
    w, wd, a, links, forces, moments = [0, 0, 0], [0, 0, 0], [0, 0, 9.81], rx90_links(), [], []
    for i, ((rotation, p), (mass, moment, tensor)) in enumerate(zip(poses, links)):
        to_link = transpose(rotation)
        a = turn(to_link, add(a, cross(wd, p), cross(w, cross(w, p))))
        w = turn(to_link, w)
        wd = add(turn(to_link, wd), [w[1] * qd[i], -w[0] * qd[i], qdd[i]])
        w = [w[0], w[1], w[2] + qd[i]]
        forces.append(add(scale(a, mass), cross(wd, moment), cross(w, cross(w, moment))))
        moments.append(add(turn(tensor, wd), cross(w, turn(tensor, w)), cross(moment, a)))
    tau = []
    for i in range(5, -1, -1):
        tau.insert(0, moments[i][2])
        if i > 0:
            rotation, p = poses[i]
            force = turn(rotation, forces[i])
            forces[i - 1] = add(forces[i - 1], force)
            moments[i - 1] = add(moments[i - 1], turn(rotation, moments[i]), cross(p, force))
    return tau


def rx90(x, z, module):
    return newton_euler(rx90_poses(x[:6], module), x[6:], z)


def rx90_mass(poses):
    body = rx90_links()
    for i in range(5, 0, -1):
        R, p = poses[i]
        mass, moment, tensor = body[i]
        turned = turn(R, moment)
        shifted = add(turned, scale(p, mass))
        own, round_trip = body[i - 1], multiply(multiply(R, tensor), transpose(R))
        diagonal = dot(p, turned) + dot(p, shifted)
        tensor = [[own[2][j][k] + round_trip[j][k] + ((diagonal if j == k else 0) - shifted[j] * p[k] - p[j] * turned[k]) for k in range(3)]
                  for j in range(3)]
        body[i - 1] = (own[0] + mass, add(own[1], shifted), tensor)
    M = [[0] * 6 for _ in range(6)]
    for i, (_, moment, tensor) in enumerate(body):
        force, moment = cross([0, 0, 1], moment), turn(tensor, [0, 0, 1])
        M[i][i] = moment[2]
        for j in range(i, 0, -1):
            R, p = poses[j]
            force = turn(R, force)
            moment = add(turn(R, moment), cross(p, force))
            M[i][j - 1] = M[j - 1][i] = moment[2]
    return M


def rx90_forward(x, z, module):
    poses = rx90_poses(x[:6], module)
    M, bias = rx90_mass(poses), newton_euler(poses, x[6:], [0] * 6)
    L, d, y, qdd = [[0] * 6 for _ in range(6)], [0] * 6, [0] * 6, [0] * 6
    for i in range(6):
        for j in range(i + 1):
            total = M[i][j]
            for k in range(j):
                total = total - L[i][k] * d[k] * L[j][k]
            if j < i:
                L[i][j] = total / d[j]
            else:
                d[i] = total
    for i in range(6):
        y[i] = z[i] - bias[i]
        for k in range(i):
            y[i] = y[i] - L[i][k] * y[k]
    for i in range(5, -1, -1):
        qdd[i] = y[i] / d[i]
        for k in range(i + 1, 6):
            qdd[i] = qdd[i] - L[k][i] * qdd[k]
    return qdd


def kalman(x, z, module):
    dt, acceleration, yaw, drift, sigma_range, sigma_bearing, bx, by = 0.1, 0.8 ** 2, 0.3 ** 2, 0.05 ** 2 * 0.1, 0.25, 0.02, 20.0, -5.0
    P, (distance, bearing) = [z[5 * i:5 * i + 5] for i in range(5)], z[25:]
    middle, step = x[2] + x[4] * dt / 2, x[3] * dt
    c, s = module.cos(middle), module.sin(middle)
    F = [[1 if i == j else 0 for j in range(5)] for i in range(5)]
    F[0][2:] = -step * s, dt * c, -step * s * dt / 2
    F[1][2:] = step * c, dt * s, step * c * dt / 2
    F[2][4] = dt
    x = [x[0] + step * c, x[1] + step * s, x[2] + x[4] * dt, x[3], x[4]]
    P = multiply(multiply(F, P), transpose(F))
    for i, j, noise in ((0, 0, drift + acceleration * dt ** 4 / 4), (1, 1, drift + acceleration * dt ** 4 / 4), (2, 2, yaw * dt ** 4 / 4),
                        (2, 4, yaw * dt ** 3 / 2), (4, 2, yaw * dt ** 3 / 2), (3, 3, acceleration * dt * dt), (4, 4, yaw * dt * dt)):
        P[i][j] = P[i][j] + noise
    dx, dy = bx - x[0], by - x[1]
    squared = dx * dx + dy * dy
    reach = module.sqrt(squared)
    H = [[-dx / reach, -dy / reach, 0, 0, 0], [dy / squared, -dx / squared, -1, 0, 0]]
    turned = bearing - (module.atan2(dy, dx) - x[2])
    innovation = [distance - reach, module.atan2(module.sin(turned), module.cos(turned))]
    PHt = multiply(P, transpose(H))
    S = multiply(H, PHt)
    S[0][0], S[1][1] = S[0][0] + sigma_range ** 2, S[1][1] + sigma_bearing ** 2
    determinant = S[0][0] * S[1][1] - S[0][1] * S[1][0]
    inverse = [[S[1][1] / determinant, -S[0][1] / determinant], [-S[1][0] / determinant, S[0][0] / determinant]]
    K = multiply(PHt, inverse)
    x = [x[i] + K[i][0] * innovation[0] + K[i][1] * innovation[1] for i in range(5)]
    KH = multiply(K, H)
    return x + sum(multiply([[(1 if i == j else 0) - KH[i][j] for j in range(5)] for i in range(5)], P), [])


def quadrotor(x, z, module):
    arm, g, lift, torque, rotor = 0.17, 9.80665, 6.1e-6, 1.1e-7, 6e-5
    inertia, linear, quadratic = [0.0052, 0.0049, 0.0091], [0.11, 0.12, 0.19], 0.021
    q, v, w, speed = x[3:7], x[7:10], x[10:13], x[13:17]
    thrust = [lift * each * each for each in speed]
    spin = -speed[0] + speed[1] - speed[2] + speed[3]
    drag = torque * (speed[0] * speed[0] - speed[1] * speed[1] + speed[2] * speed[2] - speed[3] * speed[3])
    size = module.sqrt(dot(q, q))
    a, b, c, d = (each / size for each in q)
    R = [[1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)], [2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)],
         [2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)]]
    wind, turning = module.sqrt(dot(v, v) + 1e-6), cross(v, w)
    push = [0, 0, thrust[0] + thrust[1] + thrust[2] + thrust[3]]
    rates = [(push[i] - linear[i] * v[i] - quadratic * wind * v[i]) / z[0] - g * R[2][i] + turning[i] for i in range(3)]
    quaternion = [0.5 * (-b * w[0] - c * w[1] - d * w[2]), 0.5 * (a * w[0] + c * w[2] - d * w[1]), 0.5 * (a * w[1] + d * w[0] - b * w[2]),
                  0.5 * (a * w[2] + b * w[1] - c * w[0])]
    moment = [arm * (thrust[1] - thrust[3]) - rotor * spin * w[1], arm * (thrust[2] - thrust[0]) + rotor * spin * w[0], drag]
    turns = [(moment[i] - (inertia[k] - inertia[j]) * w[j] * w[k]) / inertia[i] for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1))]
    return turn(R, v) + quaternion + rates + turns


LIFT = [-0.77, -0.24, 0.25, 0.70, 1.10, 1.42, 1.66, 1.82, 1.90, 1.88, 1.80, 1.68]
DRAG = [0.067, 0.029, 0.022, 0.042, 0.092, 0.170, 0.275, 0.401, 0.546, 0.708, 0.880, 1.052]
THRUST = [[56.4, 41.0, 27.8, 18.0, 10.5, 5.6], [57.1, 41.5, 28.4, 18.6, 11.0, 6.0], [58.7, 43.6, 30.1, 20.2, 12.1, 6.8],
          [60.5, 46.1, 33.0, 22.5, 13.9, 8.0], [62.3, 48.9, 36.5, 25.7, 16.2, 9.6], [63.8, 51.5, 39.8, 29.4, 19.1, 11.7]]


def vehicle(x, z, module):
    """Wants conditions and tables: if_else and pw_lin, piecewise linear."""
    def limit(value, low, high):
        return module.fmin(module.fmax(value, low), high)
    area, chord, g, pi = 27.9, 3.45, 9.80665, math.pi
    speed, alpha, q, theta, altitude, throttle, elevator = x
    low, air = altitude < 11000, 288.15 - 0.0065 * altitude
    temperature = module.if_else(low, air, 216.65)
    density = module.if_else(low, 1.225 * (air / 288.15) ** 4.2559, 0.36391 * module.exp(-(altitude - 11000) / 6341.6))
    mach = speed / module.sqrt(1.4 * 287.05 * temperature)
    pressure = 0.5 * density * speed * speed
    deflection, power = limit(elevator, -25 * pi / 180, 25 * pi / 180), limit(throttle, 0, 1)
    angles, degrees = [5 * k - 10 for k in range(12)], limit(alpha * 180 / pi, -10, 44.9)
    lift = pressure * area * (module.pw_lin(degrees, angles, LIFT) + 0.43 * deflection)
    drag = pressure * area * (module.pw_lin(degrees, angles, DRAG) + module.if_else(mach > 0.9, 0.1 * (mach - 0.9), 0))
    moment = pressure * area * chord * (-0.02 - 0.18 * alpha - 0.6 * deflection - 5 * q * chord / (2 * speed))
    s, t = limit(mach / 0.2, 0, 4.999), limit(altitude / 3000, 0, 4.999)
    columns = [module.pw_lin(s, list(range(6)), [row[k] for row in THRUST]) for k in range(6)]
    push, path = power * 1000 * module.pw_lin(t, list(range(6)), module.vertcat(*columns)), theta - alpha
    return [(push * module.cos(alpha) - drag) / z[0] - g * module.sin(path),
            q - (push * module.sin(alpha) + lift) / (z[0] * speed) + g * module.cos(path) / speed, moment / z[1], q, speed * module.sin(path)]


def bundle(x, z, module):
    rotation, centre, focal, principal, distortion, point, weight = x[:3], x[3:6], x[6], x[7:9], x[9:11], x[11:14], x[14]
    p = [a - b for a, b in zip(point, centre)]
    angle = module.sqrt(dot(rotation, rotation))
    c, s, axis = module.cos(angle), module.sin(angle), [each / angle for each in rotation]
    turned = add(scale(p, c), scale(cross(axis, p), s), scale(axis, dot(axis, p) * (1 - c)))
    u, v = turned[0] / turned[2], turned[1] / turned[2]
    square = u * u + v * v
    radial = 1 + distortion[0] * square + distortion[1] * square * square
    return [weight * (u * radial * focal + principal[0] - z[0]), weight * (v * radial * focal + principal[1] - z[1]), 1 - weight * weight]


def log_sum_exp(x, module):
    largest = x[0]
    for each in x[1:]:
        largest = module.fmax(largest, each)
    return module.log(sum(module.exp(each - largest) for each in x[1:]) + module.exp(x[0] - largest)) + largest


def mixture(components, points):
    def model(x, z, module):
        alpha, means, factors = x[:components], x[components:3 * components], x[3 * components:]
        fit, prior, parts = 0, 0, []
        for k in range(components):
            first, second, below = factors[3 * k:3 * k + 3]
            a, b = module.exp(first), module.exp(second)
            prior = prior + 0.5 * (a * a + b * b + below * below)
            parts.append((alpha[k] + (first + second), means[2 * k:2 * k + 2], a, b, below))
        for n in range(points):
            terms = []
            for level, mean, a, b, below in parts:
                u, v = z[2 * n] - mean[0], z[2 * n + 1] - mean[1]
                row = b * v + below * u
                terms.append(level - 0.5 * (a * u * (a * u) + row * row))
            fit = fit + log_sum_exp(terms, module)
        of_gamma = 0.5 * math.log(math.pi) + math.lgamma(1.5) + math.lgamma(1.0)
        normal = 6 * (-0.5 * math.log(2)) - of_gamma
        return [-points * math.log(2 * math.pi) + fit - points * log_sum_exp(alpha, module) + prior - components * normal]
    return model
