"""A second implementation of weft's cloth, in numpy, for the tests to hold against the engine.

It is written from the stated physics and from docs/scene-format.md alone, and as plainly as possible: a
list of springs built by loops over (i, j), forces added up particle by particle, everything in double
precision.
Its integrators stand in reference_integrators.py. SI units; arrays of vectors have the shape [particle, 3].
"""

import math
import tomllib

import numpy as np

GRAVITY = (0.0, -9.81, 0.0)  # [m/s2], where a scene has no [forces]


def read_scene(path, settings=None):
    """The scene file as nested dictionaries; `settings` maps dotted keys to values."""
    with open(path, "rb") as file:
        scene = tomllib.load(file)
    for key, value in (settings or {}).items():
        *tables, last = key.split(".")
        table = scene
        for name in tables:
            table = table.setdefault(name, {})
        table[last] = value
    return scene


class Grid:
    """Places, numbers and selections of the particles of a sheet."""

    def __init__(self, cloth):
        self.columns, self.rows = cloth["resolution"]
        self.width, self.height = cloth["size"]
        self.dx = self.width / (self.columns - 1)
        self.dy = self.height / (self.rows - 1)
        self.count = self.columns * self.rows
        down = np.array([0.0, -1.0, 0.0] if cloth.get("plane", "xy") == "xy" else [0.0, 0.0, 1.0])
        self.rest = np.zeros((self.count, 3))
        for i, j in self.cells(self.columns, self.rows):
            place = np.array(cloth["origin"], float)
            self.rest[self.index(i, j)] = place + [i * self.dx, 0.0, 0.0] + j * self.dy * down

    @staticmethod
    def cells(columns, rows):
        return [(i, j) for j in range(rows) for i in range(columns)]

    def index(self, i, j):
        return j * self.columns + i

    def areas(self):
        """The area nearest to each particle: half a spacing to either side, where there is cloth."""
        areas = np.zeros(self.count)
        for i, j in self.cells(self.columns, self.rows):
            width = sum(self.dx / 2 for side in (i - 1, i + 1) if 0 <= side < self.columns)
            height = sum(self.dy / 2 for side in (j - 1, j + 1) if 0 <= side < self.rows)
            areas[self.index(i, j)] = width * height
        return areas

    def triangles(self):
        """Two a cell, along the diagonal from its top left corner."""
        found = []
        for i, j in self.cells(self.columns - 1, self.rows - 1):
            a, b = self.index(i, j), self.index(i + 1, j)
            c, d = self.index(i, j + 1), self.index(i + 1, j + 1)
            found += [(a, c, d), (a, d, b)]
        return np.array(found)

    def named(self, name):
        """Particles of "top-left", "left-edge" and so on, in the order of their numbers."""
        last_i, last_j = self.columns - 1, self.rows - 1
        wanted = {
            "top-left": lambda i, j: (i, j) == (0, 0),
            "top-right": lambda i, j: (i, j) == (last_i, 0),
            "bottom-left": lambda i, j: (i, j) == (0, last_j),
            "bottom-right": lambda i, j: (i, j) == (last_i, last_j),
            "left-edge": lambda i, j: i == 0,
            "right-edge": lambda i, j: i == last_i,
            "top-edge": lambda i, j: j == 0,
            "bottom-edge": lambda i, j: j == last_j,
        }[name]
        return [self.index(i, j) for i, j in self.cells(self.columns, self.rows) if wanted(i, j)]

    def selected(self, select):
        if isinstance(select, str):
            return self.named(select)
        if "particles" in select:
            return list(select["particles"])
        if "every" in select:
            return self.named(select["of"])[:: select["every"]]
        low, high = np.array(select["box"], float)
        return [p for p in range(self.count) if np.all(self.rest[p] >= low) and
                np.all(self.rest[p] <= high)]


def grid_springs(grid, material):
    """Lists p, q, stiffness [N/m], damping [N s/m] and rest length [m] of all springs."""
    per_width = material.get("stiffness_per", "width") == "width"
    border_only = material["bend"].get("layout", "interior") == "border"
    dx, dy, columns, rows = grid.dx, grid.dy, grid.columns, grid.rows
    springs = []

    def add(kind, i, j, to_i, to_j, factor):
        p, q = grid.index(i, j), grid.index(to_i, to_j)
        factor = factor if per_width else 1.0
        values = material[kind]
        springs.append((p, q, factor * values.get("stiffness", 0.0),
                        factor * values.get("damping", 0.0),
                        math.dist(grid.rest[p], grid.rest[q])))

    def half_on_border(line, lines):
        return 0.5 if line in (0, lines - 1) else 1.0

    diagonal_factor = (dx * dx + dy * dy) / (2 * dx * dy)
    for i, j in grid.cells(columns, rows):
        in_row, in_column = half_on_border(j, rows), half_on_border(i, columns)
        if i + 1 < columns:
            add("structural", i, j, i + 1, j, in_row * dy / dx)
        if j + 1 < rows:
            add("structural", i, j, i, j + 1, in_column * dx / dy)
        if i + 1 < columns and j + 1 < rows:
            add("shear", i, j, i + 1, j + 1, diagonal_factor)
            add("shear", i + 1, j, i, j + 1, diagonal_factor)
        if i + 2 < columns and (not border_only or j in (0, rows - 1)):
            add("bend", i, j, i + 2, j, in_row * dy / (4 * dx))
        if j + 2 < rows and (not border_only or i in (0, columns - 1)):
            add("bend", i, j, i, j + 2, in_column * dx / (4 * dy))
    return [np.array(column) for column in zip(*springs)]


class Pin:
    """Particles that are where their keyframes say, with a cubic between two of them."""

    def __init__(self, grid, description):
        self.particles = grid.selected(description["select"])
        self.frames = [(frame["time"], np.array(frame["offset"], float))
                       for frame in description.get("motion", [])]

    def offset_and_velocity(self, t):
        none = np.zeros(3)
        if not self.frames:
            return none, none
        if t <= self.frames[0][0]:
            return self.frames[0][1], none
        for (t0, from_), (t1, to) in zip(self.frames, self.frames[1:]):
            if t0 <= t <= t1:
                s = (t - t0) / (t1 - t0)
                return (from_ + (to - from_) * (3 * s**2 - 2 * s**3),
                        (to - from_) * (6 * s - 6 * s**2) / (t1 - t0))
        return self.frames[-1][1], none


MASK = (1 << 64) - 1


def mixed(z):
    """SplitMix64: the state advanced by its constant, then mixed. z is an integer of 64 bits."""
    z = (z + 0x9E3779B97F4A7C15) & MASK
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return z ^ (z >> 31)


def drawn(seed, stream, counter):
    """Uniform in [0, 1): the upper 53 of the 64 mixed bits."""
    return (mixed(mixed(mixed(seed) ^ stream) ^ counter) >> 11) / 2**53


class Wind:
    """Mean wind, gusts, and the force on a triangle: Hoerner's flat plate and skin friction."""

    def __init__(self, description):
        self.mean = np.array(description["velocity"], float)
        self.density = description["air_density"]
        self.drag = description["drag"]
        self.friction = description["skin_friction"]
        self.gust = description["gust"]

    def factor(self, component, draw):
        uniform = drawn(self.gust["seed"], component, draw)
        return 1 - self.gust["spread"] + 2 * self.gust["spread"] * uniform

    def velocity(self, t):
        if self.gust == "none" or self.gust["model"] == "none":
            return self.mean
        draw = math.floor(t / self.gust["period"])
        s = t / self.gust["period"] - draw
        blend = 3 * s**2 - 2 * s**3
        factors = [(1 - blend) * self.factor(component, draw)
                   + blend * self.factor(component, draw + 1) for component in range(3)]
        return self.mean * factors

    def triangle_forces(self, t, corners, corner_velocities):
        """Forces [triangle, 3] from corners and their velocities [triangle, corner, 3]."""
        area_vector = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
        area = np.linalg.norm(area_vector, axis=1)
        relative = self.velocity(t) - corner_velocities.mean(axis=1)
        speed = np.linalg.norm(relative, axis=1)
        force = np.zeros_like(relative)
        blown = (area > 0) & (speed > 0)
        area, speed, relative = area[blown, None], speed[blown, None], relative[blown]
        normal = area_vector[blown] / area
        v_n = np.sum(relative * normal, axis=1, keepdims=True)
        v_t = relative - v_n * normal
        face_on = v_n * speed**2 / (0.222 * abs(v_n) + 0.283 * speed) * normal
        along = np.linalg.norm(v_t, axis=1, keepdims=True) * v_t
        force[blown] = (self.drag * self.density / 2 * area * face_on
                        + self.friction * self.density / 2 * (2 * area) * along)
        return force


def summed(count, owners, vectors):
    """Sums [count, 3] of the vectors by owner."""
    return np.stack([np.bincount(owners, vectors[:, n], count) for n in range(3)], axis=1)


class Cloth:
    """The ordinary differential equation M x'' = f(t, x, v) of a scene, with its constraints."""

    def __init__(self, scene):
        self.grid = grid = Grid(scene["cloth"])
        material = scene["material"]
        if "particle_mass" in material:
            self.mass = np.full(grid.count, float(material["particle_mass"]))
        else:
            self.mass = material["mass_per_area"] * grid.areas()
        self.p, self.q, self.stiffness, self.damping, self.length = grid_springs(grid, material)
        self.pins = [Pin(grid, description) for description in scene.get("pins", [])]
        self.pinned = sorted({p for pin in self.pins for p in pin.particles})
        forces = scene.get("forces", {})
        self.gravity = np.array(forces.get("gravity", GRAVITY), float)
        self.drag = forces.get("damping", 0.0)
        self.wind = Wind(scene["wind"]) if "wind" in scene else None
        self.triangles = grid.triangles()

    def force(self, t, x, v):
        force = self.mass[:, None] * self.gravity - self.drag * v
        d = x[self.q] - x[self.p]
        length = np.linalg.norm(d, axis=1)
        u = d / np.where(length > 0, length, 1)[:, None]  # no direction, no force
        rate = np.sum((v[self.q] - v[self.p]) * u, axis=1)
        tension = self.stiffness * (length - self.length) + self.damping * rate
        force += summed(len(x), self.p, tension[:, None] * u)
        force -= summed(len(x), self.q, tension[:, None] * u)
        if self.wind is not None:
            on_triangle = self.wind.triangle_forces(t, x[self.triangles], v[self.triangles])
            for corner in range(3):
                force += summed(len(x), self.triangles[:, corner], on_triangle / 3)
        return force

    def acceleration(self, t, x, v):
        a = self.force(t, x, v) / self.mass[:, None]
        a[self.pinned] = 0.0
        return a

    def constrained(self, t, x, v):
        """x and v with the pinned particles where they are at time t."""
        x, v = x.copy(), v.copy()
        for pin in self.pins:
            offset, velocity = pin.offset_and_velocity(t)
            x[pin.particles] = self.grid.rest[pin.particles] + offset
            v[pin.particles] = velocity
        return x, v

    def start(self):
        return self.constrained(0.0, self.grid.rest, np.zeros_like(self.grid.rest))
