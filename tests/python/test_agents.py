"""Tests of the tasks for agents: each judge rejects the start and accepts the reference solution."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import val3

AGENTS = Path(__file__).parents[1] / "agents"
TASKS = sorted(path.parent for path in AGENTS.glob("*/judge.py"))

#: Commands of a reference solution that precede its files.
COMMANDS = "commands.txt"


class TaskTest(unittest.TestCase):
    """The tasks in `tests/agents`."""

    def judged(self, task: Path, folder: Path) -> tuple[int, str]:
        """Return the exit code of the judge and its output."""
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(AGENTS), os.environ.get("PYTHONPATH", "")])}
        judge = [sys.executable, str(task / "judge.py"), str(folder)]
        done = subprocess.run(judge, capture_output=True, text=True, timeout=300, env=environment)
        return done.returncode, done.stdout + done.stderr

    def test_the_start_fails_and_the_solution_passes(self) -> None:
        self.assertEqual(len(TASKS), 10)
        for task in TASKS:
            with self.subTest(task.name), tempfile.TemporaryDirectory() as folder:
                work = Path(folder) / "work"
                shutil.copytree(task / "start", work)
                code, output = self.judged(task, work)
                self.assertEqual((code, "missing: " in output), (1, True), output)
                commands = task / "solution" / COMMANDS
                for command in commands.read_text().splitlines() if commands.exists() else ():
                    subprocess.run([val3.find_binary(), *command.split()], cwd=work, check=True, capture_output=True)
                shutil.copytree(task / "solution", work, dirs_exist_ok=True)
                code, output = self.judged(task, work)
                self.assertEqual((code, output.strip()), (0, "passed"))

    def test_each_task_has_its_words(self) -> None:
        for task in TASKS:
            self.assertTrue((task / "task.md").read_text(encoding="utf-8").startswith("# "), task.name)


if __name__ == "__main__":
    unittest.main()
