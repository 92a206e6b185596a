"""Judges the cell by its findings, its texts, and the runs of its applications."""

from judging import Judge

PRINTS = {"boxes": "7.5", "bags": "12.5", "rolls": "20"}

judge = Judge()
judge.no_errors(".")
judge.expect("nAmount" not in judge.read("usr/usrapp/types/Order/Order.dtx"), "the type has the new field")
judge.expect('"nAmount"' in judge.read("usr/usrapp/weights/weights.dtx"), "the variable `nAmount` of `weights` keeps its name")
judge.expect(not any(".nAmount" in text for text in judge.programs()), "no program uses the old field")
for name, weight in PRINTS.items():
    result = judge.run(f"usr/usrapp/{name}", until=5)
    judge.expect(list(result.prints) == [weight, "true"], f"`{name}` prints what it did: {result.prints}")
judge.end()
