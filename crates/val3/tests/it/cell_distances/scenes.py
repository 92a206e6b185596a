#!/usr/bin/env python3
"""Writes scenes.jsonl: random cells with the distances that coal 3.0.3 computes.

    python -m venv v && v/bin/pip install numpy scipy coal && v/bin/python scenes.py

Lengths are in mm, angles in degrees. A pose is [x, y, z, rx, ry, rz] with the rotation Rx.Ry.Rz of VAL 3. An arm is the
chain Rz(theta + joint) Tz(d) Tx(a) Rx(alpha) with the lengths and capsules of its file. No code of the project is used.
"""
import json
import math
import pathlib
import tomllib

import coal
import numpy as np
from scipy.spatial import ConvexHull

RNG = np.random.default_rng(44)
HERE = pathlib.Path(__file__).resolve().parent
ARMS = HERE.parents[3] / "val3-kinematics" / "arms"
SCENES = 14
DISTANCES = 4
NEAREST, FARTHEST = 2, 1500
WORLD = np.eye(4)


def turn(axis, angle):
    matrix = np.eye(4)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    matrix[i, i] = matrix[j, j] = math.cos(math.radians(angle))
    matrix[j, i] = math.sin(math.radians(angle))
    matrix[i, j] = -matrix[j, i]
    return matrix


def shift(x, y, z):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def matrix(pose):
    x, y, z, rx, ry, rz = [*pose, 0, 0, 0][:6]
    return shift(x, y, z) @ turn("x", rx) @ turn("y", ry) @ turn("z", rz)


def number(least, most):
    return round(float(RNG.uniform(least, most)), 1)


# Arms ----------------------------------------------------------------------------------------------------------------
def link_frames(arm, joints):
    """Frames of the base and the links, and of the flange."""
    lengths = arm["geometry"]
    if arm["kind"] == "scara":
        first = turn("z", joints[0])
        second = first @ shift(lengths["l1"], 0, 0) @ turn("z", joints[1])
        third = second @ shift(lengths["l2"], 0, lengths["z0"] + joints[2])
        fourth = third @ turn("x", 180) @ turn("z", joints[3])
        return [WORLD, first, second, third, fourth], fourth
    theta, alpha = [0, -90, 90, 0, 0, 0], [-90, 0, 90, -90, 90, 0]
    d, a = [0, 0, lengths["b"], lengths["c3"], 0, 0], [lengths["a1"], lengths["c2"], 0, 0, 0, 0]
    frames, here = [WORLD], WORLD
    for axis, joint in enumerate(joints):
        frames.append(here @ turn("z", joint))
        here = here @ turn("z", joint + theta[axis]) @ shift(a[axis], 0, d[axis]) @ turn("x", alpha[axis])
    return frames, here @ shift(0, 0, lengths["c4"])


def joint_position(arm):
    axes = arm["axes"]
    return [number(0.6 * low, 0.6 * high) for low, high in zip(axes["min"], axes["max"])]


# Shapes: the text of cell.toml, and bodies of coal with their poses ----------------------------------------------------
def segment(ends, radius):
    start, end = (np.array(point, float) for point in ends)
    length = np.linalg.norm(end - start)
    z = (end - start) / length if length > 1e-9 else np.array([0, 0, 1.0])
    x = np.cross([0, 1, 0] if abs(z[1]) < 0.9 else [1, 0, 0], z)
    x /= np.linalg.norm(x)
    pose = np.eye(4)
    pose[:3, 0], pose[:3, 1], pose[:3, 2], pose[:3, 3] = x, np.cross(z, x), z, (start + end) / 2
    return coal.Capsule(radius, length), pose


def outward(points):
    """Triangles of the convex hull of points, with their corners counter-clockwise."""
    hull = ConvexHull(points)
    triangles = []
    for corners, plane in zip(hull.simplices, hull.equations):
        a, b, c = points[corners]
        triangles.append(list(corners) if np.cross(b - a, c - a) @ plane[:3] > 0 else [corners[0], corners[2], corners[1]])
    return np.array(triangles)


def convex(points):
    corners = coal.StdVec_Vec3s()
    for point in points:
        corners.append(point)
    triangles = coal.StdVec_Triangle()
    for triangle in outward(points):
        triangles.append(coal.Triangle(*map(int, triangle)))
    return coal.Convex(corners, triangles)


def surface(points, triangles):
    body = coal.BVHModelOBBRSS()
    body.beginModel(len(triangles), len(points))
    for triangle in triangles:
        body.addTriangle(*points[triangle])
    body.endModel()
    return body


def box():
    size = [number(40, 300) for _ in range(3)]
    return f"box = {size}", [(coal.Box(*size), WORLD)], {}


def corners():
    low = [number(-200, 100) for _ in range(3)]
    high = [round(value + number(20, 250), 1) for value in low]
    middle = [(one + other) / 2 for one, other in zip(low, high)]
    size = [other - one for one, other in zip(low, high)]
    return f"box = {{ min = {low}, max = {high} }}", [(coal.Box(*size), shift(*middle))], {}


def sphere():
    radius = number(20, 120)
    return f"sphere = {{ radius = {radius} }}", [(coal.Sphere(radius), WORLD)], {}


def cylinder():
    radius, length = number(20, 120), number(50, 400)
    return f"cylinder = {{ radius = {radius}, length = {length} }}", [(coal.Cylinder(radius, length), WORLD)], {}


def capsule():
    ends = [[number(-150, 150) for _ in range(3)] for _ in range(2)]
    radius = number(10, 80)
    text = f"capsule = {{ from = {ends[0]}, to = {ends[1]}, radius = {radius} }}"
    return text, [segment(ends, radius)], {}


def hull():
    points = np.round(RNG.normal(size=(14, 3)) * [110, 70, 60], 1)
    points = points[sorted(ConvexHull(points).vertices)]
    name = f"hull{RNG.integers(10**6)}.stl"
    return f'mesh = "{name}"\nhull = true', [(convex(points), WORLD)], {name: {"points": points.tolist()}}


def relief():
    """A surface of 32 triangles over a square, in metres."""
    heights = np.round(RNG.uniform(0, 0.08, size=(5, 5)), 4)
    points = np.array([[column * 0.1, row * 0.1, heights[row, column]] for row in range(5) for column in range(5)])
    points = np.round(points, 4)
    cells = [(row * 5 + column) for row in range(4) for column in range(4)]
    triangles = np.array([half for at in cells for half in ([at, at + 1, at + 6], [at, at + 6, at + 5])])
    name = f"relief{RNG.integers(10**6)}.stl"
    mesh = {"points": points.tolist(), "triangles": triangles.tolist()}
    return f'mesh = "{name}"\nunit = "m"\nhull = false', [(surface(points * 1000, triangles), WORLD)], {name: mesh}


SHAPES = [box, corners, sphere, cylinder, capsule, hull, relief]


def several():
    """Two shapes with their own poses."""
    texts, bodies = [], []
    for make in RNG.choice([box, sphere, cylinder, capsule], size=2):
        text, own, _ = make()
        at = random_pose(150)
        texts.append(f"{{ {text}, at = {at} }}")
        bodies += [(body, matrix(at) @ pose) for body, pose in own]
    return f"shapes = [{', '.join(texts)}]", bodies, {}


def random_pose(reach):
    lengths = [number(-reach, reach) for _ in range(3)]
    return lengths + [number(-170, 170), number(-85, 85), number(-170, 170)]


# Scenes --------------------------------------------------------------------------------------------------------------
def distance(first, second):
    request = coal.DistanceRequest()
    request.gjk_max_iterations, request.gjk_tolerance = 1000, 1e-10
    request.epa_max_iterations, request.epa_tolerance = 1000, 1e-8

    def of(body, other, pose, other_pose):
        ends = [coal.Transform3s(one[:3, :3].copy(), one[:3, 3].copy()) for one in (pose, other_pose)]
        return coal.distance(body, ends[0], other, ends[1], request, coal.DistanceResult())

    return min(of(a, b, pose, other) for a, pose in first for b, other in second)


def datum(kind, name, pose, father):
    values = " ".join(f'{key}="{value}"' for key, value in zip(("x", "y", "z", "rx", "ry", "rz"), pose))
    return (f'    <Data name="{name}" access="private" xsi:type="array" type="{kind}" size="1">\n'
            f'      <Value key="0" {values} fatherId="{father}[0]" />\n    </Data>\n')


def scene(index):
    arm_name = ["tx2-60l", "tx2-90", "ts2-60", "rx160"][index % 4]
    arm = tomllib.loads((ARMS / f"{arm_name}.toml").read_text())
    joints = joint_position(arm)
    links, flange = link_frames(arm, joints)
    outer, inner, tool = random_pose(500), random_pose(400), random_pose(60)
    places = {"world": WORLD, "base": shift(0, 0, -arm["geometry"]["height"]), "flange": flange, "link2": links[2]}
    places["fOuter"] = matrix(outer)
    places["fInner"] = places["fOuter"] @ matrix(inner)
    places["tHand"] = flange @ matrix(tool)
    bodies = {f"link{link}": [(body, frame @ pose) for body, pose in (
        segment((one["from"], one["to"]), one["radius"]) for one in arm["shapes"][f"link{link}"])]
        for link, frame in enumerate(links) if link > 0}
    standing, moving, text, meshes = [], list(bodies), "clearance = 5000\n", {}
    things = [("pillar", "world"), ("tray", "fInner"), ("lamp", "tray"), ("floor", "base"), ("rail", "fOuter"),
              ("hand", "tHand"), ("camera", "flange"), ("box", "hand"), ("hose", "link2")]
    for number_of, (name, carrier) in enumerate(things):
        make = several if name in ("rail", "hand") else SHAPES[(index + number_of) % len(SHAPES)]
        shape, own, files = make()
        at = random_pose(900 if name in ("pillar", "floor") else 120)
        if name == "floor":
            at = at[:3]
        text += f'[[object]]\nname = "{name}"\nin = "{carrier}"\nat = {at}\n{shape}\n'
        places[name] = places[carrier] @ matrix(at)
        bodies[name] = [(body, places[name] @ pose) for body, pose in own]
        meshes |= files
        (moving if name in ("hand", "camera", "box", "hose") else standing).append(name)
    found = {f"{one} {other}": distance(bodies[one], bodies[other]) for one in moving for other in standing}
    found = {pair: round(value, 5) for pair, value in found.items() if NEAREST < value < FARTHEST}
    of_links, of_things = [], []
    for pair in RNG.permutation(sorted(found)):
        (of_links if pair.startswith("link") else of_things).append(str(pair))
    # Things have more forms than links.
    pairs = of_links[:1] + of_things[:DISTANCES - 1]
    data = datum("frame", "fInner", inner, "fOuter") + datum("frame", "fOuter", outer, "world")
    data += datum("tool", "tHand", tool, "flange")
    return {"name": f"{arm_name}-{index}", "arm": arm_name, "start": joints, "data": data, "cell": text,
            "meshes": meshes, "distances": {pair: found[pair] for pair in pairs}}


def main():
    scenes = [scene(index) for index in range(SCENES)]
    lines = (json.dumps(one, separators=(",", ":")) for one in scenes)
    (HERE / "scenes.jsonl").write_text("".join(f"{line}\n" for line in lines))
    print(sum(len(one["distances"]) for one in scenes), "distances")


if __name__ == "__main__":
    main()
