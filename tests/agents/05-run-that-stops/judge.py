"""Judges the answer, and a run of the corrected application."""

from judging import Judge

judge = Judge()
judge.answer("guard:8 bStart")
judge.unchanged("usr/usrapp/loader/work.pgx", "usr/usrapp/loader/feed.pgx", "usr/usrapp/loader/loader.dtx")
result = judge.run("usr/usrapp/loader", until=20)
judge.expect(result.reason == "finished", f"the run ends: {result.reason}")
judge.expect(len(result.events("io", link=r"BasicIO-1\%Q1", value=1.0)) == 3, "three parts are loaded")
judge.end()
