"""Judges the answer, and the corrected program."""

from judging import Judge

judge = Judge()
judge.answer("take:8", "take:9")
judge.unchanged("tests/takesThePart.toml", "cell.toml", "usr/usrapp/grip/grip.dtx")
judge.no_findings("usr/usrapp/grip")
judge.tests()
judge.end()
