"""Judges the cell by its findings, and by what the repair has kept."""

from judging import Judge

judge = Judge()
judge.no_findings("usr/usrapp/sorter")
judge.no_findings("usr/usrapp/feederStep")
judge.no_suppressions()
names = {finding.code for finding in judge.findings_at_start("usr/usrapp/sorter")}
missing = sorted(name for name in names if name not in judge.read("answer.txt"))
judge.expect(not missing, f"the answer names each finding; missing: {missing}")
kept = {"belt": "sort()", "count": "nSorted", "drop": "movej(", "home": "movej(", "pause": "delay(1)", "rest": "open(", "show": "putln(", "start": "libLoad("}
for name, code in kept.items():
    judge.expect(code in judge.read(f"usr/usrapp/sorter/{name}.pgx"), f"`{name}` still has `{code}`")
judge.end()
