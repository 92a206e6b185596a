"""Judges the library by the given test, and by another application that uses it."""

from judging import Judge

PRINTS = ["0", "false", "false", "10", "19"]
SORTED = ["19", "16", "11", "4", "-5", "-16", "-29", "-44", "-61", "-80"]

judge = Judge()
judge.unchanged("tests/main.toml", "usr/usrapp/main/start.pgx")
judge.no_findings("usr/usrapp/stack")
judge.tests()
judge.copy("usr/usrapp/hidden")
result = judge.run("usr/usrapp/hidden", until=20)
judge.expect(list(result.prints) == [*PRINTS, *SORTED, "-3", "0", "0"], f"the library computes: {result.prints}")
judge.end()
