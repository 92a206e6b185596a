"""Judges the application by two conversations."""

from judging import Judge

judge = Judge()
judge.no_errors("usr/usrapp/host")
judge.scenarios("good", "silent")
judge.end()
