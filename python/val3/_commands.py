"""Commands that read: check, test, diff, explain."""

from collections.abc import Iterable, Sequence
from typing import Any

from ._answers import Comparison, Finding, Report, TestReport, TestResult, of
from ._command import TIMEOUT, PathLike, report
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
    answer = report(command, timeout, cwd)
    summary = answer.document["summary"]
    findings = tuple(_finding(entry) for entry in answer.document["diagnostics"])
    counts = {name: summary[name] for name in ("errors", "warnings", "infos", "code_lines")}
    is_ok = answer.is_complete and summary["errors"] == 0
    return Report(ok=is_ok, findings=findings, **counts, messages=answer.messages)


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
    answer = report(command, timeout, cwd)
    passed, failed = answer.document["passed"], answer.document["failed"]
    tests = tuple(of(TestResult, entry) for entry in answer.document["tests"])
    return TestReport(answer.is_complete and failed == 0, passed, failed, tests, answer.messages)


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
    document = report(command, timeout, cwd).document
    return Comparison(document["different"], document["summary"], document)


def explain(topic: str, *, timeout: float | None = TIMEOUT) -> str:
    """Return the page of an instruction, a finding, an error or a word, as Markdown.

    >>> explain("movej").splitlines()[0]
    '# movej (instruction, manual 10.6)'

    :raises UsageError: there is no such page; the message names similar ones
    """
    document = report(["explain", "--format", "json", topic], timeout).document
    pages = [page["page"] for page in document["pages"] if page.get("page")]
    if not pages:
        names = ", ".join(page["names"][0] for page in document["pages"][:8])
        raise UsageError(f"there is no page `{topic}`; pages that contain it: {names}")
    return "\n".join(pages)


def _finding(entry: dict[str, Any]) -> Finding:
    start_of = entry["range"]["start"]
    return of(Finding, {**entry, "line": start_of["line"], "column": start_of["column"]})
