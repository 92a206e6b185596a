"""Check, run, test and compare applications in VAL 3, the language of Stäubli robots.

The functions start the command ``val3`` of this package and return its answers as data.

>>> import val3
>>> result = val3.run("examples/palletiser/usr/usrapp/palletiser", script="examples/palletiser/boxes.toml", until=6)
>>> result.reason, result.seconds, result.moves.count > 0
('limit', 6.0, True)
"""

from ._answers import (
    Comparison,
    ErrorEntry,
    Finding,
    IoChange,
    LineMoves,
    Moves,
    ProgramMoves,
    Report,
    Task,
    TestReport,
    TestResult,
    Wait,
)
from ._command import find_binary, version
from ._commands import check, diff, explain, test
from ._errors import Error, RefusedError, RunError, TimeoutError, UsageError
from ._run import RunResult, run
from ._trace import Trace

__all__ = [
    "Comparison",
    "Error",
    "ErrorEntry",
    "Finding",
    "IoChange",
    "LineMoves",
    "Moves",
    "ProgramMoves",
    "RefusedError",
    "Report",
    "RunError",
    "RunResult",
    "Task",
    "TestReport",
    "TestResult",
    "TimeoutError",
    "Trace",
    "UsageError",
    "Wait",
    "check",
    "diff",
    "explain",
    "find_binary",
    "run",
    "test",
    "version",
]
