"""Judges the run by its time, its path at the places, and its distance from the wall."""

import math

from judging import Judge

LIMIT = 9.0
PICK, PLACE = (400.0, -250.0, 60.0), (400.0, 250.0, 60.0)

judge = Judge()
judge.unchanged("usr/usrapp/mover/start.pgx", "cell.toml", "val3.toml")
judge.no_errors("usr/usrapp/mover")
judge.scenarios("wall")
result = judge.run("usr/usrapp/mover", until=60, trace=True)
judge.expect(result.reason == "finished", f"the run ends: {result.reason}")
judge.expect(result.seconds < LIMIT, f"the run is below {LIMIT} s: {result.seconds:.2f} s")
trace = result.trace
assert trace is not None
samples = list(zip(trace["t"], trace["x"], trace["y"], trace["z"], trace["v"], strict=True))
switched = [event for event in result.events("io", link=r"BasicIO-1\%Q0") if event["t"] > 0.01]
judge.expect(len(switched) == 8, f"the gripper switches eight times: {len(switched)}")
for event in switched:
    place = PICK if event["value"] else PLACE
    before = [sample for sample in samples if sample[0] <= event["t"]][-1]
    judge.expect(math.dist(before[1:4], place) < 1, f"the gripper is at its place at {event['t']} s")
    after = [sample for sample in samples if event["t"] < sample[0] < event["t"] + 0.09]
    judge.expect(all(math.dist(sample[1:4], place) < 1 for sample in after), f"the arm rests at {event['t']} s")
for place in (PICK, PLACE):
    low = [sample for sample in samples if sample[3] < place[2] + 50 and math.dist(sample[1:3], place[:2]) < 200]
    judge.expect(all(math.dist(sample[1:3], place[:2]) < 5 for sample in low), f"the path at {place} is vertical")
judge.end()
