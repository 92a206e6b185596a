"""Test of the page about sweeps: its programs, with a smaller grid."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).parents[2]
#: Values of the page, and fewer values with the same best run.
GRID, SMALL = "(10, 30, 60, 100, 150), (1, 30, 60, 90, 120), (20, 40, 60, 80, 100)", "(10, 60), (1, 120), (40, 100)"
BEST = "height 60 mm, leave 1 mm, vel 100 %: 3.74 s, clearance 58 mm"

#: Python with the packages of `sweep.txt`, from `tests/python/run`.
PYTHON = os.environ.get("VAL3_SWEEP_PYTHON")


class SweepTest(unittest.TestCase):
    """Each engine finds the same run, and the picture is drawn."""

    def test_every_program_of_the_page(self) -> None:
        self.assertIsNotNone(PYTHON, "VAL3_SWEEP_PYTHON names no Python with the packages of sweep.txt")
        page = (ROOT / "docs/src/sweep.md").read_text(encoding="utf-8")
        files = dict(re.findall(r"```python file=(\S+)[^\n]*\n(.*?)```", page, re.DOTALL))
        self.assertIn(GRID, files["sweep.py"])
        with tempfile.TemporaryDirectory() as folder:
            example = Path(folder) / "palletiser"
            shutil.copytree(ROOT / "examples/palletiser", example)
            for name, code in files.items():
                (Path(folder) / name).write_text(code.replace(GRID, SMALL), encoding="utf-8")
            # Ray would write a token, and report its use.
            settings = {"RAY_AUTH_MODE": "disabled", "RAY_USAGE_STATS_ENABLED": "0"}
            path = os.pathsep.join([folder, os.environ.get("PYTHONPATH", "")])
            environment = {**os.environ, **settings, "PYTHONPATH": path}
            for name in ("sweep.py", "with_ray.py", "with_dask.py", "heat_map.py"):
                with self.subTest(name):
                    done = subprocess.run(
                        [str(PYTHON), str(Path(folder) / name)],
                        cwd=example,
                        env=environment,
                        capture_output=True,
                        text=True,
                        timeout=600,
                    )
                    self.assertEqual(done.returncode, 0, done.stderr)
                    if name != "heat_map.py":
                        self.assertEqual(done.stdout.splitlines()[-1], BEST)
            self.assertIn("clearance of the gripper", (example / "sweep.svg").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
