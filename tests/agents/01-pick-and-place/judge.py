"""Judges the application by three scenarios."""

from judging import Judge

judge = Judge()
judge.no_errors("usr/usrapp/feeder")
judge.scenarios("good", "noPart", "lost")
judge.end()
