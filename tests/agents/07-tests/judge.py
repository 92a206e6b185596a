"""Judges the tests by their number, the executed lines, and the seeded mistakes that they find."""

import json
import re

from judging import Judge

judge = Judge()
judge.unchanged("usr/usrapp/sorter/grade.pgx", "usr/usrapp/sorter/start.pgx")
judge.tests(at_least=5)
judge.command("test", ".", "--coverage-output", "json=coverage.json")
files = json.loads(judge.read("coverage.json") or "{}").get("files", [])
lines = [line["hits"] for file in files if file["file"].endswith("/grade.pgx") for line in file["lines"]]
executed = sum(hits > 0 for hits in lines) / max(len(lines), 1)
judge.expect(executed >= 0.9, f"the tests execute 90 % of the lines: {executed:.0%}")
report = judge.command("test", ".", "--mutate").text
found = re.search(r"mutants: (\d+), found (\d+)", report)
judge.expect(found is not None and int(found[2]) >= 0.8 * int(found[1]), f"the tests find mistakes: {report[:300]}")
judge.end()
