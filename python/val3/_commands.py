"""Commands that read: check, test, diff, explain."""

import json
from collections.abc import Iterable, Sequence
from typing import Any

from ._answers import Comparison, Finding, Report, TestReport, TestResult, of
from ._command import TIMEOUT, PathLike, start
from ._errors import UsageError


def check(
    *paths: PathLike,
    motion: bool = False,
    arguments: Sequence[str] = (),
    timeout: float | None = TIMEOUT,
    cwd: PathLike | None = None,
) -> Report:
    """Check applications, cells or files.

    :param paths: what is checked; the working folder without a path
    :param motion: whether points and moves are compared with the arm
    :param arguments: further arguments of ``val3 check``

    >>> report = check("examples/faulty")
    >>> report.ok, report.findings[0].code, report.findings[0].line
    (False, 'V0322', 6)
    """
    options = ["--motion"] if motion else []
    command = ["check", "--format", "json", *options, *arguments, *map(str, paths)]
    document = _json("check", start(command, timeout, cwd).text)
    summary = document["summary"]
    findings = tuple(_finding(entry) for entry in document["diagnostics"])
    counts = {name: summary[name] for name in ("errors", "warnings", "infos", "code_lines")}
    return Report(ok=summary["errors"] == 0, findings=findings, **counts)


def test(
    *paths: PathLike,
    filter: str | Iterable[str] = (),
    arguments: Sequence[str] = (),
    timeout: float | None = TIMEOUT,
    cwd: PathLike | None = None,
) -> TestReport:
    """Execute the tests of applications.

    :param filter: texts; tests whose names contain one of them are executed, all tests without a text
    :param arguments: further arguments of ``val3 test``

    >>> report = test("examples/palletiser", filter="boxes")
    >>> report.ok, [test.id for test in report.tests]
    (True, ['palletiser:boxes'])
    """
    texts = [filter] if isinstance(filter, str) else list(filter)
    filters = [part for text in texts for part in ("--filter", text)]
    command = ["test", "--format", "json", *filters, *arguments, *map(str, paths)]
    document = _json("test", start(command, timeout, cwd).text)
    tests = tuple(of(TestResult, entry) for entry in document["tests"])
    return TestReport(document["failed"] == 0, document["passed"], document["failed"], tests)


def diff(
    old: PathLike,
    new: PathLike,
    *,
    arguments: Sequence[str] = (),
    timeout: float | None = TIMEOUT,
    cwd: PathLike | None = None,
) -> Comparison:
    """Compare applications or cells by their content.

    >>> diff("examples/palletiser", "examples/palletiser").different
    False
    """
    command = ["diff", "--format", "json", *arguments, str(old), str(new)]
    document = _json("diff", start(command, timeout, cwd).text)
    return Comparison(document["different"], document["summary"], document)


def explain(topic: str, *, timeout: float | None = TIMEOUT) -> str:
    """Return the page of an instruction, a finding, an error or a word, as Markdown.

    >>> explain("movej").splitlines()[0]
    '# movej (instruction, manual 10.6)'

    :raises UsageError: there is no such page; the message names similar ones
    """
    document = _json("explain", start(["explain", "--format", "json", topic], timeout).text)
    pages = [page["page"] for page in document["pages"] if page.get("page")]
    if not pages:
        names = ", ".join(page["names"][0] for page in document["pages"][:8])
        raise UsageError(f"there is no page `{topic}`; pages that contain it: {names}")
    return "\n".join(pages)


def _finding(entry: dict[str, Any]) -> Finding:
    start_of = entry["range"]["start"]
    return of(Finding, {**entry, "line": start_of["line"], "column": start_of["column"]})


def _json(command: str, text: str) -> dict[str, Any]:
    try:
        document: dict[str, Any] = json.loads(text)
    except json.JSONDecodeError as error:
        raise UsageError(f"`val3 {command}` did not print JSON: {text[:200]!r}") from error
    return document
