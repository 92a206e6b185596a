"""The answers of the command as data. Positions count from 1, times are in seconds of the controller's clock."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any, TypeVar

T = TypeVar("T")


def of(kind: type[T], answer: Mapping[str, Any]) -> T:
    """Convert a JSON object. Unknown keys are left out, so that newer commands suit this package."""
    names = {entry.name for entry in fields(kind)}  # type: ignore[arg-type]
    return kind(**{name: value for name, value in answer.items() if name in names})


@dataclass(frozen=True, slots=True)
class Finding:
    """A finding of a check."""

    code: str
    severity: str
    """``error``, ``warning`` or ``info``."""
    message: str
    help: str
    """The remedy; empty if the message says it."""
    file: str
    line: int
    column: int
    program: str | None
    """Program of the line; ``None`` outside of programs."""


@dataclass(frozen=True, slots=True)
class Report:
    """Answer of a check."""

    ok: bool
    """Whether there are no errors, and everything was read."""
    findings: tuple[Finding, ...]
    errors: int
    warnings: int
    infos: int
    code_lines: int
    """Number of code lines, without blank lines and comments."""
    messages: str = field(repr=False)
    """Messages of the command, for example about files that it could not read."""


@dataclass(frozen=True, slots=True)
class TestResult:
    """Result of a test."""

    id: str
    passed: bool
    file: str
    line: int
    seconds: float
    prints: list[str]
    failure: dict[str, Any] | None
    """Why the test has failed, as in ``val3 test --format json``."""


@dataclass(frozen=True, slots=True)
class TestReport:
    """Answer of a test run."""

    ok: bool
    """Whether no test has failed, and every test could be executed."""
    passed: int
    failed: int
    """Number of failed tests, with those that could not be executed."""
    tests: tuple[TestResult, ...]
    messages: str = field(repr=False)
    """Messages of the command."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """Answer of a comparison."""

    different: bool
    summary: dict[str, int]
    """Number of differences by kind."""
    document: dict[str, Any]
    """All differences, as in ``val3 diff --format json``."""


@dataclass(frozen=True, slots=True)
class ErrorEntry:
    """A run-time error, or a path that the arm cannot follow."""

    t: float
    message: str
    program: str
    line: int
    file: str
    handled: bool
    """Whether another task has resumed or killed the task."""
    help: str
    code: int | None = None
    task: str = ""
    code_line: str | None = None


@dataclass(frozen=True, slots=True)
class Task:
    """A task at the end of a run."""

    name: str
    activity: str
    program: str
    line: int
    file: str
    code_line: str | None = None


@dataclass(frozen=True, slots=True)
class ProgramMoves:
    """Moves of a program."""

    program: str
    count: int
    seconds: float


@dataclass(frozen=True, slots=True)
class LineMoves:
    """Moves of a line."""

    program: str
    line: int
    instruction: str
    count: int
    seconds: float


@dataclass(frozen=True, slots=True)
class Moves:
    """Moves of a run."""

    count: int
    seconds: float
    """Time in motion."""
    programs: tuple[ProgramMoves, ...]
    lines: tuple[LineMoves, ...]


@dataclass(frozen=True, slots=True)
class Wait:
    """Time that a task has waited at a line."""

    task: str
    program: str
    line: int
    what: str
    seconds: float


@dataclass(frozen=True, slots=True)
class IoChange:
    """Change of an input or output."""

    t: float
    link: str
    value: float
