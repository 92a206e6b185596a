"""Judges the application by its files, its findings, and its user page."""

from judging import Judge

APPLICATION = "usr/usrapp/counter"

judge = Judge()
judge.expect('version="s8.' in judge.read(f"{APPLICATION}/counter.pjx"), "the project has a version of s8")
for file, root in {"counter.pjx": "<Project", "counter.dtx": "<Database", "start.pgx": "<Programs", "sum.pgx": "<Programs"}.items():
    judge.expect(root in judge.read(f"{APPLICATION}/{file}"), f"`{file}` has the form of s8")
judge.no_findings(APPLICATION)
judge.scenarios("screen")
judge.end()
