"""The updates of every method, each written out as its formula stands in the literature.

A method is a class with step(cloth, t, h, x, v) -> (x, v) at t + h. Pinned particles are put in place, and
get the velocity they have there, at the time of every evaluation of the forces.
"""

import math

from reference_cloth import Cloth


class ForwardEuler:
    def step(self, cloth, t, h, x, v):
        return x + h * v, v + h * cloth.acceleration(t, x, v)


class SymplecticEuler:
    def step(self, cloth, t, h, x, v):
        v = v + h * cloth.acceleration(t, x, v)
        return x + h * v, v


class Verlet:
    """x+ = x + (x - x_prev) + a h^2. Forces take the one-sided velocity of second order; the velocity
    put out is the central difference, which the acceleration at the new place makes known."""

    def __init__(self):
        self.previous = self.a = None

    def next_place(self, x, h):
        return x + (x - self.previous) + self.a * h**2

    def step(self, cloth, t, h, x, v):
        if self.previous is None:
            self.a = cloth.acceleration(t, x, v)
            self.previous = x - h * v + h**2 * self.a / 2
        new, _ = cloth.constrained(t + h, self.next_place(x, h), v)
        one_sided = (3 * new - 4 * x + self.previous) / (2 * h)
        _, one_sided = cloth.constrained(t + h, new, one_sided)
        self.a = cloth.acceleration(t + h, new, one_sided)
        self.previous = x
        following = self.next_place(new, h)
        return new, (following - x) / (2 * h)


class TimeCorrectedVerlet(Verlet):
    """The same with the ratio of steps, which is 1 here."""

    def next_place(self, x, h):
        h_previous = h
        return (x + (x - self.previous) * h / h_previous
                + self.a * h * (h + h_previous) / 2)


class VelocityVerlet:
    """Forces that depend on velocity take v + h a at the new place; that a serves the next step."""

    def __init__(self):
        self.a = None

    def step(self, cloth, t, h, x, v):
        a = cloth.acceleration(t, x, v) if self.a is None else self.a
        new, predicted = cloth.constrained(t + h, x + h * v + h**2 / 2 * a, v + h * a)
        self.a = cloth.acceleration(t + h, new, predicted)
        return new, v + h * (a + self.a) / 2


def slope(cloth, t, x, v):
    x, v = cloth.constrained(t, x, v)
    return v, cloth.acceleration(t, x, v)


class Midpoint:
    def step(self, cloth, t, h, x, v):
        x1, v1 = slope(cloth, t, x, v)
        x2, v2 = slope(cloth, t + h / 2, x + h / 2 * x1, v + h / 2 * v1)
        return x + h * x2, v + h * v2


class Kutta3:
    def step(self, cloth, t, h, x, v):
        x1, v1 = slope(cloth, t, x, v)
        x2, v2 = slope(cloth, t + h / 2, x + h / 2 * x1, v + h / 2 * v1)
        x3, v3 = slope(cloth, t + h, x - h * x1 + 2 * h * x2, v - h * v1 + 2 * h * v2)
        return x + h / 6 * (x1 + 4 * x2 + x3), v + h / 6 * (v1 + 4 * v2 + v3)


class ClassicalRungeKutta:
    def step(self, cloth, t, h, x, v):
        x1, v1 = slope(cloth, t, x, v)
        x2, v2 = slope(cloth, t + h / 2, x + h / 2 * x1, v + h / 2 * v1)
        x3, v3 = slope(cloth, t + h / 2, x + h / 2 * x2, v + h / 2 * v2)
        x4, v4 = slope(cloth, t + h, x + h * x3, v + h * v3)
        return (x + h / 6 * (x1 + 2 * x2 + 2 * x3 + x4),
                v + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4))


class Composed:
    """Drifts and kicks in turn, as fractions of the step; forces take the velocity before the kick."""

    drifts = kicks = ()

    def step(self, cloth, t, h, x, v):
        for drift, kick in zip(self.drifts, self.kicks):
            t = t + drift * h
            x, v = cloth.constrained(t, x + drift * h * v, v)
            v = v + kick * h * cloth.acceleration(t, x, v)
        return x + self.drifts[-1] * h * v, v


class Yoshida4(Composed):
    w1 = 1 / (2 - 2 ** (1 / 3))
    w0 = -(2 ** (1 / 3)) / (2 - 2 ** (1 / 3))
    drifts = (w1 / 2, (w0 + w1) / 2, (w0 + w1) / 2, w1 / 2)
    kicks = (w1, w0, w1)


class ForestRuth(Composed):
    theta = (2 + 2 ** (1 / 3) + 2 ** (-1 / 3)) / 3
    drifts = (theta / 2, (1 - theta) / 2, (1 - theta) / 2, theta / 2)
    kicks = (theta, 1 - 2 * theta, theta)


METHODS = {
    "forward-euler": ForwardEuler,
    "symplectic-euler": SymplecticEuler,
    "verlet": Verlet,
    "time-corrected-verlet": TimeCorrectedVerlet,
    "velocity-verlet": VelocityVerlet,
    "rk2": Midpoint,
    "rk3": Kutta3,
    "rk4": ClassicalRungeKutta,
    "yoshida4": Yoshida4,
    "forest-ruth": ForestRuth,
}


def steps_a_frame(frame_length, time_step):
    """The smallest whole number of steps, none longer than time_step; a hair of rounding is forgiven."""
    return max(1, math.ceil(frame_length / time_step * (1 - 1e-12)))


def simulate(scene, frames):
    """Times, positions and velocities of frames 0 to `frames`, as lists."""
    cloth = Cloth(scene)
    method = METHODS[scene["integrator"]["method"]]()
    frame_length = 1 / scene["output"]["frames_per_second"]
    steps = steps_a_frame(frame_length, scene["integrator"]["time_step"])
    h = frame_length / steps
    x, v = cloth.start()
    times, positions, velocities = [0.0], [x], [v]
    for step in range(1, frames * steps + 1):
        t = (step - 1) * h
        x, v = method.step(cloth, t, h, x, v)
        x, v = cloth.constrained(t + h, x, v)
        if step % steps == 0:
            times.append(t + h)
            positions.append(x)
            velocities.append(v)
    return times, positions, velocities
