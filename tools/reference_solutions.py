#!/usr/bin/env python3
"""High-precision reference solutions for the convergence tests.

Solves the spring pendulums of tests/support/spring_pendulum.h in 60-digit arithmetic with the
extrapolated midpoint rule (Gragg, Bulirsch, Stoer), which shares nothing with weft's integrators,
and prints the end states as C++ constants. Each is solved twice, with different steps and orders;
the digits on which both agree are counted, and 30 are required.

    python3 tools/reference_solutions.py
"""

from decimal import Decimal as D
from decimal import getcontext

getcontext().prec = 60

STIFFNESS = D(25)  # k / m [1/s2]
LENGTH = D(1)  # [m]
GRAVITY = (D(0), D("-9.81"), D(0))  # [m/s2]
START = [D("1.2"), D("0.1"), D("-0.2"), D(0), D("0.5"), D("0.3")]  # x, v
END_TIME = D("1.3")  # [s]


def norm(a):
    return sum(c * c for c in a).sqrt()


def anchor(t):
    """Where the forced pendulum hangs: smooth, with no vanishing derivative."""
    return (D("0.4") / (1 + t * t), D(0), D("0.3") * t / (1 + t))


def spring(d):
    r = norm(d)
    return [-STIFFNESS * (r - LENGTH) / r * c + g for c, g in zip(d, GRAVITY)]


def free(t, x, v):
    return spring(x)


def damped(t, x, v):
    """Dashpot along the spring, linear and quadratic drag."""
    r, speed = norm(x), norm(v)
    along = sum(a * b for a, b in zip(v, x)) / (r * r)
    return [
        a - D("0.8") * along * c - (D("0.3") + D("0.1") * speed) * w
        for a, c, w in zip(spring(x), x, v)
    ]


def forced(t, x, v):
    return spring([c - s for c, s in zip(x, anchor(t))])


def slope(acceleration, t, y):
    return list(y[3:]) + acceleration(t, y[:3], y[3:])


def midpoint_rule(acceleration, t, y, step, parts):
    """Gragg's midpoint rule: an error expansion in even powers of step / parts."""
    h = step / parts
    before, now = y, [a + h * b for a, b in zip(y, slope(acceleration, t, y))]
    for n in range(1, parts):
        after = [a + 2 * h * b for a, b in zip(before, slope(acceleration, t + n * h, now))]
        before, now = now, after
    last = slope(acceleration, t + step, now)
    return [(a + b + h * c) / 2 for a, b, c in zip(now, before, last)]


def extrapolated_step(acceleration, t, y, step, columns):
    rows = []
    for k in range(columns):
        row = [midpoint_rule(acceleration, t, y, step, 2 * (k + 1))]
        for j in range(1, k + 1):
            ratio = D(k + 1) / D(k + 1 - j)
            row.append(
                [a + (a - b) / (ratio * ratio - 1) for a, b in zip(row[j - 1], rows[-1][j - 1])]
            )
        rows.append(row)
    return rows[-1][-1]


def solve(acceleration, steps, columns):
    y, step = START, END_TIME / steps
    for n in range(steps):
        y = extrapolated_step(acceleration, n * step, y, step, columns)
    return y


def main():
    for name, acceleration in (("free", free), ("damped", damped), ("forced", forced)):
        y = solve(acceleration, 120, 14)
        check = solve(acceleration, 160, 13)
        difference = max(abs(a - b) for a, b in zip(y, check))
        assert difference < D("1e-30"), (name, difference)
        print(f"// {name}: two solutions differ by {difference:.0e}")
        for label, part in (("x", y[:3]), ("v", y[3:])):
            print(f"    {label} {{{', '.join(f'{c:.20f}' for c in part)}}}")


if __name__ == "__main__":
    main()
