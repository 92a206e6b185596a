"""Durations of the paths that `cargo test -p val3-motion --test toppra -- --ignored` has written, by toppra.

Usage: python durations.py FOLDER; writes durations.csv next to this file. Needs `pip install toppra`.
"""

import sys
from multiprocessing import Pool
from pathlib import Path

import numpy as np
import toppra
from scipy.interpolate import CubicSpline
from toppra.constraint import ConstraintType, LinearConstraint

toppra.setup_logging("ERROR")

GRID = 2000


class Limits(LinearConstraint):
    """Speeds of the axes and of the tool, accelerations and decelerations of the axes."""

    def __init__(self, axes, place, limits):
        super().__init__()
        self.dof = axes
        self.place, self.limits = place, limits
        self.identical = False
        self._format_string = ""

    def compute_constraint_params(self, path, grid, *_):
        axes, limits = self.dof, self.limits(grid)
        speed, up, down = (limits[:, axes * k : axes * (k + 1)] for k in range(3))
        tool_speed = limits[:, 3 * axes :]
        tangent, curvature = path(grid, 1), path(grid, 2)
        with np.errstate(divide="ignore"):
            tops = [speed / np.abs(tangent), tool_speed / tool_speeds(self.place, grid)]
        top = np.min(np.hstack(tops), axis=1) ** 2
        sign = np.sign(tangent)
        # Where an axis does not move the smaller of the two limits counts.
        weaker = np.minimum(up, down)
        up, down = np.where(sign == 0, weaker, up), np.where(sign == 0, weaker, down)
        sign = np.where(sign == 0, 1, sign)
        identity = np.eye(axes)
        F = np.array([np.vstack((np.diag(row), -np.diag(row))) for row in sign])
        g = np.hstack((up, down))
        c = np.zeros_like(tangent)
        xbound = np.column_stack((np.zeros_like(top), np.minimum(top, 1e8)))
        return tangent, curvature, c, F, g, None, xbound


def tool_speeds(place, grid):
    """Speed in mm and in degrees for each unit of the parameter."""
    near = place.end * 1e-4
    before, after = np.maximum(grid - near, 0), np.minimum(grid + near, place.end)
    one, other = place(before), place(after)
    way = np.linalg.norm(other[:, :3] - one[:, :3], axis=1)
    turn = np.linalg.norm(other[:, 3:] - one[:, 3:], axis=1) / np.sqrt(2)
    angle = np.degrees(2 * np.arcsin(np.minimum(turn / 2, 1)))
    speeds = np.column_stack((way, angle)) / (after - before)[:, None]
    return np.maximum(speeds, 1e-12)


class Pieces(toppra.interpolator.AbstractGeometricPath):
    """A path whose second derivative jumps from one piece to the next."""

    def __init__(self, starts, splines, end):
        self.starts, self.splines, self.end = starts, splines, end

    dof = property(lambda self: self.splines[0].c.shape[2])
    path_interval = property(lambda self: np.array([0.0, self.end]))
    waypoints = None

    def __call__(self, s, order=0):
        s = np.atleast_1d(s)
        which = np.clip(np.searchsorted(self.starts, s, side="right") - 1, 0, len(self.starts) - 1)
        return np.array([self.splines[k](value, order) for k, value in zip(which, s)])


def thinned(s, least):
    """Indices of samples that are not too close for second derivatives."""
    kept = [0]
    for index in range(1, len(s) - 1):
        if s[index] - s[kept[-1]] > least and s[-1] - s[index] > least:
            kept.append(index)
    return kept + [len(s) - 1]


def duration(file):
    rows = np.loadtxt(file, delimiter=",")
    rows, piece = rows[:, 1:], rows[:, 0]
    axes = (rows.shape[1] - 14) // 4
    joints, place, limits = rows[:, :axes], rows[:, axes : axes + 12], rows[:, axes + 12 :]
    chords = np.linalg.norm(np.diff(joints, axis=0) / limits[:, :axes].max(axis=0), axis=1)
    s = np.concatenate(([0], np.cumsum(chords)))
    end = s[-1]
    starts, paths, places = [], [], []
    for number in np.unique(piece):
        rows = np.flatnonzero(piece == number)
        rows = rows[thinned(s[rows], end / GRID)]
        starts.append(s[rows[0]])
        paths.append(CubicSpline(s[rows], joints[rows]))
        places.append(CubicSpline(s[rows], place[rows]))
    here = lambda grid: limits[np.minimum(np.searchsorted(s, grid, side="left"), len(s) - 1)]
    grid = np.unique(np.concatenate((np.linspace(0, end, GRID + 1), starts)))
    constraint = Limits(axes, Pieces(starts, places, end), here)
    path = Pieces(starts, paths, end)
    algorithm = toppra.algorithm.TOPPRA([constraint], path, gridpoints=grid, solver_wrapper="seidel")
    _, speed, _ = algorithm.compute_parameterization(0, 0)
    if speed is None:
        return file.stem, float("nan")
    return file.stem, float(np.sum(2 * np.diff(grid) / (speed[1:] + speed[:-1])))


def main():
    files = sorted(Path(sys.argv[1]).glob("*.csv"))
    with Pool(2) as pool:
        results = pool.map(duration, files, chunksize=4)
    text = "".join(f"{name},{seconds:.6f}\n" for name, seconds in results)
    Path(__file__).with_name("durations.csv").write_text(text)


if __name__ == "__main__":
    main()
