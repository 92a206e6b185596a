"""``run``: an application in virtual time."""

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from . import _toml
from ._answers import ErrorEntry, IoChange, LineMoves, Moves, ProgramMoves, Task, Wait, of
from ._command import TIMEOUT, Output, PathLike, start
from ._commands import check
from ._errors import Error, RefusedError, RunError
from ._trace import Trace


@dataclass(frozen=True, slots=True)
class RunResult:
    """What has happened in a run. Lists have at most the last 1,000 entries."""

    ok: bool
    """Whether the command has ended with exit code 0."""
    reason: str
    """``finished``, ``stopped``, ``limit``, ``stuck`` or ``error``."""
    exit_code: int
    seconds: float
    """Time at the end on the controller's clock."""
    prints: tuple[str, ...]
    log: tuple[str, ...]
    notes: tuple[str, ...]
    screen: tuple[str, ...]
    errors: tuple[ErrorEntry, ...]
    contacts: tuple[str, ...]
    tasks: tuple[Task, ...]
    moves: Moves
    waits: tuple[Wait, ...]
    io: tuple[IoChange, ...]
    next: str | None
    """What to do next, if the run is not ok."""
    messages: str = field(repr=False)
    """Messages of the command."""
    times: dict[str, Any] = field(repr=False)
    """Times of the arm and of tasks by line, as in ``val3 run --times``."""
    trace: Trace | None = field(repr=False)
    """Samples of the motion, if requested."""
    record: str = field(repr=False)
    """Events of the run, a JSON object a line, as in ``val3 run --events``."""

    def events(self, kind: str | None = None, /, **values: Any) -> list[dict[str, Any]]:
        """Return the events of a kind whose keys have these values; all events without arguments.

        >>> result = run("examples/palletiser/usr/usrapp/palletiser", until=1, power=True)
        >>> result.events("power")[0]["on"]
        True
        """
        return [event for event in self._all_events() if _suits(event, kind, values)]

    def raise_for_errors(self) -> "RunResult":
        """Return the result, or raise :class:`RunError` if it is not ok."""
        if not self.ok:
            raise RunError(self.messages.strip() or f"the run has ended: {self.reason}; {self.next or ''}")
        return self

    def _all_events(self) -> Iterator[dict[str, Any]]:
        return (json.loads(line) for line in self.record.splitlines())

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{escape(row.program)}:{row.line}</td><td>{escape(row.instruction)}</td>"
            f"<td>{row.count}</td><td>{row.seconds:.3f}</td></tr>"
            for row in self.moves.lines
        )
        head = "<tr><th>line</th><th>move</th><th>count</th><th>seconds</th></tr>"
        return f"<p>{escape(self.reason)} after {self.seconds:.3f} s</p><table>{head}{rows}</table>"


def run(
    application: PathLike = ".",
    *,
    program: str | None = None,
    until: float | None = None,
    until_ok: bool = False,
    script: PathLike | Mapping[str, _toml.Value] | None = None,
    set: Mapping[str, bool | float | str] | None = None,
    arm: str | None = None,
    power: bool = False,
    trace: bool = False,
    arguments: Sequence[str] = (),
    timeout: float | None = TIMEOUT,
    cwd: PathLike | None = None,
) -> RunResult:
    """Run an application in virtual time.

    :param application: folder or ``.pjx``
    :param program: program to start with, instead of ``start``
    :param until: seconds of the controller's clock after which the run ends
    :param until_ok: whether a run that reaches ``until`` is ok
    :param script: TOML file or dictionary with the events outside of the application
    :param set: values of global variables and their fields before the run
    :param arm: name or file of the arm
    :param power: whether the arm has power from the start
    :param trace: whether the motion is recorded
    :param arguments: further arguments of ``val3 run``
    :param timeout: seconds of wall time after which the run is ended
    :raises RefusedError: the application has errors
    :raises UsageError: the arguments are wrong, or a file cannot be read

    >>> result = run("examples/palletiser/usr/usrapp/palletiser", until=1, set={"mFast.vel": 50})
    >>> result.reason, result.ok
    ('limit', False)
    """
    with TemporaryDirectory(prefix="val3-") as folder:
        files = Path(folder)
        command = ["run", str(application), "--result", str(files / "result.json")]
        command += ["--events", str(files / "events.jsonl"), f"--times={files / 'times.json'}"]
        command += _option("--program", program) + _option("--arm", arm) + _option("--until", until)
        command += ["--until-ok"] * until_ok + ["--power"] * power
        command += _option("--trace", files / "trace.csv" if trace else None)
        command += _option("--script", _script(script, files))
        for name, value in (set or {}).items():
            command += ["--set", f"{name}={_literal(value)}"]
        output = start([*command, *arguments], timeout, cwd)
        document = _document(files / "result.json", output)
        if document["reason"] == "refused":
            where = application if cwd is None else Path(cwd) / application
            found = [finding for finding in check(where).findings if finding.severity == "error"]
            raise RefusedError(output.messages.strip(), found)
        return RunResult(
            ok=document["ok"],
            reason=document["reason"],
            exit_code=document["exit_code"],
            seconds=document["seconds"],
            prints=tuple(document["prints"]["last"]),
            log=tuple(document["log"]["last"]),
            notes=tuple(document["notes"]["last"]),
            screen=tuple(document.get("screen", ())),
            errors=tuple(of(ErrorEntry, entry) for entry in document["errors"]["last"]),
            contacts=tuple(document["contacts"]),
            tasks=tuple(of(Task, entry) for entry in document["tasks"]),
            moves=_moves(document["moves"]),
            waits=tuple(of(Wait, entry) for entry in document["waits"]),
            io=tuple(of(IoChange, entry) for entry in document["io"]["last"]),
            next=document.get("next"),
            messages=output.messages,
            times=json.loads((files / "times.json").read_text(encoding="utf-8")),
            trace=Trace.read(files / "trace.csv") if trace else None,
            record=(files / "events.jsonl").read_text(encoding="utf-8"),
        )


def _document(path: Path, output: Output) -> dict[str, Any]:
    try:
        document: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        messages = output.messages.strip() or "it has no message"
        raise Error(f"`val3 run` has written no result (exit code {output.exit_code}): {messages}") from error
    return document


def _option(name: str, value: object) -> list[str]:
    return [] if value is None else [name, str(value)]


def _script(script: PathLike | Mapping[str, _toml.Value] | None, files: Path) -> PathLike | None:
    if script is None or isinstance(script, (str, os.PathLike)):
        return script
    path = files / "script.toml"
    path.write_text(_toml.document(script), encoding="utf-8")
    return path


def _literal(value: bool | float | str) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return f'"{value}"' if isinstance(value, str) else repr(value)


def _moves(document: Mapping[str, Any]) -> Moves:
    programs = tuple(of(ProgramMoves, entry) for entry in document["programs"])
    lines = tuple(of(LineMoves, entry) for entry in document["lines"])
    return Moves(document["count"], document["seconds"], programs, lines)


def _suits(event: Mapping[str, Any], kind: str | None, values: Mapping[str, Any]) -> bool:
    return kind in (None, event["kind"]) and all(event.get(key) == value for key, value in values.items())
