"""Tests of the package: its examples, and its agreement with the command."""

import doctest
import importlib
import importlib.util
import multiprocessing
import os
import pickle
import pkgutil
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock
from pathlib import Path

import val3

ROOT = Path(__file__).parents[2]
PALLETISER = ROOT / "examples/palletiser/usr/usrapp/palletiser"
SCRIPT = ROOT / "examples/palletiser/boxes.toml"


def load_tests(loader: unittest.TestLoader, tests: unittest.TestSuite, pattern: str | None) -> unittest.TestSuite:
    """Add the examples in the documentation of every module."""
    os.chdir(ROOT)
    names = [module.name for module in pkgutil.iter_modules(val3.__path__) if module.name != "__main__"]
    for name in ["val3", *(f"val3.{name}" for name in names)]:
        tests.addTests(doctest.DocTestSuite(importlib.import_module(name)))
    return tests


def first_grip(velocity: float) -> tuple[float, float]:
    """Time at which the gripper closes first, with a velocity of the fast moves in per cent."""
    result = val3.run(PALLETISER, script=SCRIPT, until=20, until_ok=True, set={"mFast.vel": velocity})
    return velocity, result.events("io", link="valve1", value=0.0)[0]["t"]


class Project:
    """A project with the program `start` in a temporary folder."""

    def __init__(self, code: str) -> None:
        self.folder = tempfile.TemporaryDirectory()
        subprocess.run([val3.find_binary(), "new", "demo"], cwd=self.folder.name, check=True, capture_output=True)
        self.path = Path(self.folder.name) / "demo/usr/usrapp/demo"
        program = self.path / "start.pgx"
        before, rest = program.read_text(encoding="utf-8").split("begin\n", 1)
        after = rest[rest.rindex("\nend") :]
        program.write_text(f"{before}begin\n{code}{after}", encoding="utf-8")

    def __enter__(self) -> Path:
        return self.path

    def __exit__(self, *_: object) -> None:
        self.folder.cleanup()


class RunTest(unittest.TestCase):
    """`run` and the command give the same answers."""

    def test_events_are_those_of_the_command(self) -> None:
        result = val3.run(PALLETISER, script=SCRIPT, until=6, until_ok=True)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "events.jsonl"
            command = ["run", str(PALLETISER), "--script", str(SCRIPT), "--until", "6", "--until-ok"]
            subprocess.run([val3.find_binary(), *command, "--events", str(file)], check=True, capture_output=True)
            self.assertEqual(result.record.encode(), file.read_bytes())
        self.assertEqual(result, val3.run(PALLETISER, script=SCRIPT, until=6, until_ok=True))

    def test_a_dictionary_is_a_script(self) -> None:
        with Project("  wait(nHeight==7)\n  putln(\"seven\")\n") as application:
            result = val3.run(application, script={"at": [{"t": 0.5, "set": {"nHeight": 7}}]}, until=2)
        self.assertEqual((result.reason, result.ok), ("finished", True))
        self.assertAlmostEqual(result.seconds, 0.5, delta=0.02)
        self.assertIn("seven", result.screen)

    def test_a_run_that_waits_says_what_to_do(self) -> None:
        with Project("  wait(nHeight==7)\n") as application:
            result = val3.run(application, until=2)
        self.assertEqual((result.reason, result.exit_code), ("limit", 3))
        self.assertIn("set = { nHeight =", result.next or "")
        with self.assertRaises(val3.RunError):
            result.raise_for_errors()

    def test_a_run_time_error_has_its_line(self) -> None:
        with Project("  nHeight=1/(nHeight-nHeight)\n") as application:
            result = val3.run(application)
        [error] = result.errors
        self.assertEqual((error.code, error.program, error.handled), (10, "start", False))
        self.assertIn("nHeight=1/", error.code_line or "")
        with self.assertRaisesRegex(val3.RunError, "division"):
            result.raise_for_errors()

    def test_errors_refuse_an_application(self) -> None:
        with Project("  nMissing=1\n") as application:
            with self.assertRaises(val3.RefusedError) as caught:
                val3.run(application)
        self.assertEqual([finding.code for finding in caught.exception.findings], ["V0101"])

    def test_wrong_arguments_have_the_help_of_the_command(self) -> None:
        with self.assertRaisesRegex(val3.UsageError, "there is no such file or folder"):
            val3.run("nowhere")
        with self.assertRaisesRegex(val3.UsageError, "no variable `mFats.leave`"):
            val3.run(PALLETISER, set={"mFats.leave": 1})

    def test_a_trace_has_columns(self) -> None:
        result = val3.run(PALLETISER, script=SCRIPT, until=3, until_ok=True, trace=True)
        assert result.trace is not None
        self.assertGreater(len(result.trace), 100)
        self.assertEqual(result.trace["t"], sorted(result.trace["t"]))
        if importlib.util.find_spec("numpy"):
            self.assertEqual(len(result.trace.numpy()), len(result.trace))

    def test_results_can_be_pickled_and_swept(self) -> None:
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            times = dict(pool.map(first_grip, [20.0, 100.0]))
        self.assertLess(times[100.0], times[20.0] - 0.5)
        result = val3.run(PALLETISER, until=1)
        self.assertEqual(pickle.loads(pickle.dumps(result)), result)


class IncompleteTest(unittest.TestCase):
    """Commands that cannot read or execute a part of what they are started for."""

    def test_a_test_that_cannot_be_executed_is_in_the_report(self) -> None:
        with Project("") as application:
            tests = application / "tests"
            tests.mkdir()
            scenario = 'application = ".."\n[expect]\n'
            (tests / "good.toml").write_text(scenario + "errors = []\n", encoding="utf-8")
            (tests / "misspelt.toml").write_text(scenario + "xyz = 1\n", encoding="utf-8")
            report = val3.test(application)
        self.assertEqual((report.ok, report.passed, report.failed), (False, 1, 1))
        [failed] = [test for test in report.tests if not test.passed]
        assert failed.failure is not None
        self.assertIn("unknown field `xyz`", failed.failure["message"])

    def test_an_application_that_is_rejected_is_in_the_report(self) -> None:
        with Project("  nMissing=1\n") as application:
            tests = application / "tests"
            tests.mkdir()
            (tests / "good.toml").write_text('application = ".."\n[expect]\nerrors = []\n', encoding="utf-8")
            report = val3.test(application)
        self.assertEqual((report.ok, report.failed), (False, 1))

    def test_a_file_that_cannot_be_read_is_in_the_report(self) -> None:
        with Project("") as application:
            program = application / "start.pgx"
            program.unlink()
            os.mkfifo(program)
            report = val3.check(application)
            with self.assertRaisesRegex(val3.UsageError, "start.pgx"):
                val3.run(application)
        self.assertFalse(report.ok)
        self.assertIn("V0502", [finding.code for finding in report.findings])
        with self.assertRaisesRegex(val3.UsageError, "there is no such file or folder"):
            val3.check("nowhere")

    def test_every_failure_of_the_command_is_an_error_of_the_package(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            failing = Path(folder) / "failing"
            failing.write_text("#!/bin/sh\necho broken >&2\nexit 3\n", encoding="utf-8")
            failing.chmod(0o755)
            for binary, message in ((failing, "broken"), (Path(folder) / "missing", "cannot be started")):
                with unittest.mock.patch.dict(os.environ, VAL3_BINARY=str(binary)):
                    with self.assertRaisesRegex(val3.Error, message):
                        val3.run(PALLETISER)
                    for command in (val3.check, val3.test):
                        with self.assertRaises(val3.Error):
                            command(PALLETISER)


class PageTest(unittest.TestCase):
    """The examples of the page about this package."""

    def test_every_example_runs(self) -> None:
        page = (ROOT / "docs/src/python.md").read_text(encoding="utf-8")
        examples = [block.split("```")[0] for block in page.split("```python\n")[1:]]
        self.assertEqual(len(examples), 2)
        for example in examples:
            with tempfile.TemporaryDirectory() as folder:
                file = Path(folder) / "example.py"
                file.write_text(example, encoding="utf-8")
                done = subprocess.run(
                    [sys.executable, str(file)], cwd=ROOT / "examples/palletiser", capture_output=True, text=True
                )
                self.assertEqual((done.returncode, done.stderr), (0, ""))


class EndTest(unittest.TestCase):
    """Commands that do not end, and many commands."""

    ENDLESS = "  while true\n    nHeight=nHeight+1\n  endWhile\n"

    def test_a_command_ends_after_its_time(self) -> None:
        with Project(self.ENDLESS) as application, self.assertRaisesRegex(TimeoutError, "after 0.5 s"):
            val3.run(application, timeout=0.5)

    def test_ctrl_c_ends_the_command(self) -> None:
        with Project(self.ENDLESS) as application:
            # A job in the background of a shell ignores the signal.
            code = (
                "import signal, val3; signal.signal(signal.SIGINT, signal.default_int_handler); print(flush=True);"
                f"val3.run({str(application)!r}, timeout=60)"
            )
            command, pipe = [sys.executable, "-c", code], subprocess.PIPE
            python = subprocess.Popen(command, stdout=pipe, stderr=pipe, start_new_session=True)
            assert python.stdout is not None
            python.stdout.readline()
            time.sleep(0.5)
            os.killpg(python.pid, signal.SIGINT)
            _, messages = python.communicate(timeout=30)
        self.assertIn(b"KeyboardInterrupt", messages)

    def test_many_runs_keep_nothing(self) -> None:
        runs = int(os.environ.get("VAL3_RUNS", "100"))
        with Project("  putln(\"done\")\n") as application:
            for _ in range(10):
                val3.run(application)
            files, memory = len(os.listdir("/proc/self/fd")), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            for _ in range(runs):
                val3.run(application)
            self.assertEqual(len(os.listdir("/proc/self/fd")), files)
            self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - memory, 4096, "in KiB")


class FindTest(unittest.TestCase):
    """The command is found."""

    def test_python_m_val3_is_the_command(self) -> None:
        done = subprocess.run([sys.executable, "-m", "val3", "--version"], capture_output=True, text=True)
        self.assertEqual(done.stdout.strip(), val3.version())
        done = subprocess.run([sys.executable, "-m", "val3", "run", "nowhere"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
