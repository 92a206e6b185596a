"""The command: where it is, and how it is started."""

import json
import os
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ._errors import Error, TimeoutError, UsageError

#: A path as text or as an object.
PathLike = str | os.PathLike[str]

#: Wall time in seconds after which a command is ended.
TIMEOUT = 60.0

#: Exit code for wrong arguments and unreadable files.
_USAGE = 2


@dataclass(frozen=True, slots=True)
class Output:
    """Output of a command that has ended."""

    exit_code: int
    text: str
    messages: str


@dataclass(frozen=True, slots=True)
class Report:
    """JSON document that a command has printed."""

    document: dict[str, Any]
    is_complete: bool
    """Whether the command has read and executed everything that its arguments name."""
    messages: str


def find_binary() -> str:
    """Return the path of the command: ``VAL3_BINARY``, the command of this package, or the first one on the ``PATH``.

    >>> Path(find_binary()).stem
    'val3'
    """
    chosen = os.environ.get("VAL3_BINARY")
    if chosen:
        return chosen
    name = "val3.exe" if sys.platform == "win32" else "val3"
    schemes = {sysconfig.get_default_scheme(), sysconfig.get_preferred_scheme("user")}
    for scheme in schemes:
        installed = Path(sysconfig.get_path("scripts", scheme)) / name
        if installed.is_file():
            return str(installed)
    found = shutil.which("val3")
    if found is None:
        raise Error("there is no command `val3`: install this package as a wheel, or set VAL3_BINARY to its path")
    return found


def version() -> str:
    """Return the version of the command.

    >>> version().startswith("val3 ")
    True
    """
    return start(["--version"]).text.strip()


def start(arguments: Sequence[str], timeout: float | None = TIMEOUT, cwd: PathLike | None = None) -> Output:
    """Start the command, and wait for its end.

    :raises UsageError: the command rejects the arguments
    :raises TimeoutError: the command has not ended in time
    :raises Error: the command cannot be started, or has crashed
    """
    output = _finished(arguments, timeout, cwd)
    if output.exit_code == _USAGE:
        raise UsageError(output.messages.strip())
    return output


def report(arguments: Sequence[str], timeout: float | None = TIMEOUT, cwd: PathLike | None = None) -> Report:
    """Start a command that prints its report as a JSON document, and wait for its end.

    The report of a command that could not read some of its files describes these files, and is returned as well.

    :raises UsageError: the command rejects the arguments, or prints no report
    :raises TimeoutError: the command has not ended in time
    :raises Error: the command cannot be started, or has crashed
    """
    output = _finished(arguments, timeout, cwd)
    is_complete = output.exit_code != _USAGE
    try:
        return Report(json.loads(output.text), is_complete, output.messages.strip())
    except json.JSONDecodeError as error:
        if not is_complete and not output.text.strip():
            raise UsageError(output.messages.strip()) from None
        raise UsageError(f"`val3 {arguments[0]}` did not print JSON: {output.text[:200]!r}") from error


def _finished(arguments: Sequence[str], timeout: float | None, cwd: PathLike | None) -> Output:
    command = [find_binary(), "--color", "never", *arguments]
    try:
        done = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", timeout=timeout, cwd=cwd)
    except subprocess.TimeoutExpired as error:
        raise TimeoutError(f"`val3 {arguments[0]}` was ended after {timeout} s; `timeout` permits more") from error
    except OSError as error:
        raise Error(f"`{command[0]}` cannot be started: {error}; set VAL3_BINARY to the path of the command") from error
    if done.returncode < 0:
        raise Error(f"`val3 {arguments[0]}` was ended by signal {-done.returncode}")
    return Output(done.returncode, done.stdout, done.stderr)
