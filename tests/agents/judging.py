"""Helpers of the judges: a judge examines the folder that an agent has worked in."""

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NoReturn

sys.path.insert(0, str(Path(__file__).parents[2] / "python"))

import val3


class Judge:
    """Examines a copy of the folder in the first argument, and prints what is missing."""

    def __init__(self) -> None:
        if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
            sys.exit(f"usage: {sys.argv[0]} FOLDER")
        self.task = Path(sys.argv[0]).resolve().parent
        self.start = self.task / "start"
        self._copy = tempfile.TemporaryDirectory(prefix="val3-judge-")
        self.folder = Path(self._copy.name) / "work"
        shutil.copytree(sys.argv[1], self.folder)
        self.faults: list[str] = []

    def expect(self, holds: bool, what: str) -> None:
        """Note a fault unless the sentence holds."""
        if not holds:
            self.faults.append(what)

    def end(self) -> NoReturn:
        """Print the faults, and end with 1 if there are any."""
        for fault in self.faults:
            print(f"missing: {fault}")
        print("failed" if self.faults else "passed")
        sys.exit(1 if self.faults else 0)

    def read(self, path: str) -> str:
        """Return the text of a file; an empty text if it does not exist."""
        file = self.folder / path
        return file.read_text(encoding="utf-8-sig", errors="replace") if file.is_file() else ""

    def programs(self) -> Iterator[str]:
        """Return the texts of all programs."""
        return (path.read_text(encoding="utf-8-sig", errors="replace") for path in sorted(self.folder.rglob("*.pgx")))

    def answer(self, *accepted: str) -> None:
        """Expect one of these first lines in `answer.txt`."""
        lines = self.read("answer.txt").splitlines() or [""]
        self.expect(lines[0].strip() in accepted, f"answer.txt names the line: {lines[0]!r}")

    def unchanged(self, *paths: str) -> None:
        """Expect files of the start to be unchanged."""
        for path in paths:
            file, start = self.folder / path, self.start / path
            self.expect(file.is_file() and file.read_bytes() == start.read_bytes(), f"`{path}` is unchanged")

    def findings(self, path: str, folder: Path | None = None) -> Sequence[Any]:
        """Return the findings of a project."""
        project = (folder or self.folder) / path
        if not project.is_dir():
            return ["the project does not exist"]
        return val3.check(project).findings

    def findings_at_start(self, path: str) -> Sequence[Any]:
        """Return the findings that a project has at the start."""
        return self.findings(path, self.start)

    def no_findings(self, path: str) -> None:
        """Expect a project without findings."""
        found = self.findings(path)
        self.expect(not found, f"`{path}` has no findings: {list(found)[:3]}")

    def no_errors(self, path: str) -> None:
        """Expect a project without errors."""
        found = [finding for finding in self.findings(path) if isinstance(finding, str) or finding.severity == "error"]
        self.expect(not found, f"`{path}` has no errors: {found[:3]}")

    def no_suppressions(self) -> None:
        """Expect no comments and no settings that silence findings."""
        silenced = [text for text in self.programs() if "//val3:" in text.replace(" ", "")]
        self.expect(not silenced, "no comment silences findings")
        for file in [*self.folder.rglob("val3.toml"), *self.folder.rglob("*baseline*")]:
            start = self.start / file.relative_to(self.folder)
            self.expect(start.is_file() and start.read_bytes() == file.read_bytes(), f"`{file.name}` is unchanged")

    def copy(self, path: str) -> None:
        """Copy a folder of the judge into the work."""
        shutil.copytree(self.task / "judge" / path, self.folder / path)

    def scenarios(self, *names: str) -> None:
        """Expect the judge's scenarios to pass."""
        for name in names:
            (self.folder / "judgement").mkdir(exist_ok=True)
            shutil.copy(self.task / "judge" / f"{name}.toml", self.folder / "judgement" / f"{name}.toml")
            done = self.command("test", f"judgement/{name}.toml")
            self.expect(done.exit_code == 0, f"the scenario `{name}` passes: {done.text.strip()[:800]}")

    def tests(self, at_least: int = 1) -> None:
        """Expect the tests of the work to pass."""
        done = self.command("test", ".", "--format", "tap")
        passed = sum(line.startswith("ok ") for line in done.text.splitlines())
        self.expect(done.exit_code == 0 and passed >= at_least, f"{at_least} or more tests pass: {done.text.strip()[:800]}")

    def run(self, path: str, **arguments: Any) -> Any:
        """Run an application with power."""
        try:
            return val3.run(self.folder / path, power=True, **arguments)
        except val3.Error as error:
            self.expect(False, f"`{path}` runs: {str(error)[:800]}")
            self.end()

    def command(self, *arguments: str) -> "Output":
        """Start a command in the work."""
        command = [val3.find_binary(), "--color", "never", *arguments]
        done = subprocess.run(
            command, cwd=self.folder, capture_output=True, encoding="utf-8", errors="replace", timeout=300
        )
        return Output(done.returncode, done.stdout + done.stderr)


class Output:
    """Output of a command."""

    def __init__(self, exit_code: int, text: str) -> None:
        self.exit_code, self.text = exit_code, text
