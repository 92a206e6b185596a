"""Test of `val3 run --controller` with a client that moves the arm in the remote mode."""

import csv
import math
import tempfile
import time
import unittest
from pathlib import Path
from typing import ClassVar
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from test_soap import Client, Fault, RunCase, numbers

#: Joints in rad within the range of the palletiser's arm.
READY = [0.1, 0.2, 1.2, 0.0, 0.5, -0.3]
AXES = ["nx", "ny", "nz", "ox", "oy", "oz", "ax", "ay", "az", "px", "py", "pz"]
IDENTITY = "".join(f"<{name}>{int(name in ('nx', 'oy', 'az'))}</{name}>" for name in AXES)


def description(blend: str = "BLEND-OFF", speed: float = 1.0, config: str = "") -> str:
    """Motion descriptor with the values that clients send."""
    config = config or (
        "<anthroConfig><shoulder>SSAME</shoulder><elbow>PNSAME</elbow><wrist>PNSAME</wrist></anthroConfig>"
    )
    return (
        f"<mdesc><tool>{IDENTITY}</tool><frame>{IDENTITY}</frame><absRel>ABSOLUTE-MOVE</absRel><config>{config}</config>"
        f"<blendType>{blend}</blendType><distBlendPrev>0.05</distBlendPrev><distBlendNext>0.05</distBlendNext>"
        f"<vel>{speed}</vel><acc>1</acc><dec>1</dec><transVel>99999</transVel><rotVel>99999</rotVel><freq>1</freq></mdesc>"
    )


def items(name: str, values: list[float]) -> str:
    """Element with a list of numbers."""
    return f"<{name}>{''.join(f'<item>{value!r}</item>' for value in values)}</{name}>"


def content(element: Element | None) -> str:
    """Children of an element as text."""
    assert element is not None
    return "".join(ElementTree.tostring(child, encoding="unicode") for child in element)


def free_arm(client: Client) -> None:
    """Kill the tasks of the application, discard their moves, and switch the power on."""
    while tasks := client.call("V2", "getTasks").findall("tasks/Task"):
        for task in tasks:
            task_names = f"<taskName>{task.findtext('name')}</taskName><createdBy>{task.findtext('createdBy')}</createdBy>"
            try:
                client.call("V2", "taskKill", task_names)
            except Fault as fault:
                # A task may have ended meanwhile.
                if fault.code != "TASK-NOT-FOUND":
                    raise
    # After the last task, the controller executes the program `stop`, whose task owns the arm.
    end = time.monotonic() + 20
    while client.call("V3", "resetMotion").findtext("motRet") != "SCSV3-MOT-NO-ERR":
        assert time.monotonic() < end, "the moves of the application cannot be discarded"
        time.sleep(0.01)
    assert client.call("V3", "setPower", "<power>true</power>").findtext("code") == "POWER-NO-ERR"


class MotionTest(RunCase):
    """A client that moves the arm."""

    folder: ClassVar["tempfile.TemporaryDirectory[str]"]

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        cls.options = ["--trace-all", f"{cls.folder.name}/trace.csv"]
        super().setUpClass()

    @classmethod
    def tearDownClass(cls) -> None:
        super().tearDownClass()
        cls.folder.cleanup()

    def move(self, client: Client, operation: str, destination: str, mdesc: str) -> int:
        """Record a move. Return its id."""
        answer = client.call("V3", operation, f"<robot>0</robot>{destination}{mdesc}")
        self.assertEqual(answer.findtext("motRet"), "SCSV3-MOT-NO-ERR", operation)
        return int(answer.findtext("id") or "")

    def arrive(self, client: Client) -> list[float]:
        """Wait until all moves are done. Return the joints."""
        for _ in range(200):
            state = client.call("V3", "schedulerRefresh")
            robot = state.find("allRobotsPos/RobotsPos")
            assert robot is not None
            if state.findtext("motionEmpty") == "true" and robot.findtext("settled") == "true":
                return numbers(robot, "joint")
            time.sleep(0.05)
        raise AssertionError("the arm does not arrive")

    def assert_near(self, found: list[float], expected: list[float]) -> None:
        for one, other in zip(found, expected, strict=True):
            self.assertAlmostEqual(one, other, 6)

    def test_moves(self) -> None:
        client = self.login()
        free_arm(client)
        first = self.move(client, "moveJJ", items("joint", READY), description())
        self.assert_near(self.arrive(client), READY)
        near = [0.3, 0.3, 1.1, 0.0, 0.5, -0.3]
        flange = client.call("V3", "forwardKin", f"<robot>0</robot>{items('joint', near)}")
        frame, config = content(flange.find("position")), content(flange.find("config"))
        self.assertEqual(self.move(client, "moveL", f"<frame>{frame}</frame>", description(config=config)), first + 1)
        self.assert_near(self.arrive(client), near)
        blended = description("BLEND-JOINT")
        for step in range(10):
            self.move(client, "moveJJ", items("joint", [0.3 - 0.05 * step, *near[1:]]), blended)
        self.move(client, "moveJJ", items("joint", READY), description())
        self.assert_near(self.arrive(client), READY)

        # A relative move goes along the axes of the tool: here 30 mm against the axis of the flange.
        found = client.call("V3", "forwardKin", f"<robot>0</robot>{items('joint', READY)}").find("position")
        assert found is not None
        before = {axis: float(found.findtext(axis) or "") for axis in AXES}
        way = IDENTITY.replace("<pz>0</pz>", "<pz>-0.03</pz>")
        relative = description().replace("ABSOLUTE-MOVE", "RELATIVE-MOVE")
        self.move(client, "moveL", f"<frame>{way}</frame>", relative)
        joints = self.arrive(client)
        found = client.call("V3", "forwardKin", f"<robot>0</robot>{items('joint', joints)}").find("position")
        assert found is not None
        for axis in "xyz":
            expected = before[f"p{axis}"] - 0.03 * before[f"a{axis}"]
            self.assertAlmostEqual(float(found.findtext(f"p{axis}") or ""), expected, 9)
        self.move(client, "moveJJ", items("joint", READY), description())
        self.assert_near(self.arrive(client), READY)

        # A slow move is stopped, continued and discarded.
        self.move(client, "moveJJ", items("joint", near), description(speed=0.05))
        time.sleep(0.3)
        self.assertEqual(client.call("V3", "stopMotion").findtext("motRet"), "SCSV3-MOT-NO-ERR")
        time.sleep(0.3)
        stopped = numbers(client.call("V0", "getRobotJointPos", "<robot>0</robot>"), "pos")
        time.sleep(0.3)
        self.assertEqual(numbers(client.call("V0", "getRobotJointPos", "<robot>0</robot>"), "pos"), stopped)
        self.assertGreater(math.dist(stopped, READY), 1e-4)
        self.assertGreater(math.dist(stopped, near), 1e-4)
        self.assertEqual(client.call("V3", "restartMotion").findtext("motRet"), "SCSV3-MOT-NO-ERR")
        time.sleep(0.3)
        self.assertNotEqual(numbers(client.call("V0", "getRobotJointPos", "<robot>0</robot>"), "pos"), stopped)
        self.assertEqual(client.call("V3", "resetMotion").findtext("motRet"), "SCSV3-MOT-NO-ERR")
        self.arrive(client)

        # A rejected move blocks the next moves until the reset.
        far = f"<robot>0</robot>{items('joint', [9.0, *near[1:]])}{description()}"
        self.assertEqual(client.call("V3", "moveJJ", far).findtext("motRet"), "SCSV3-MOT-ERR-PARAM")
        again = f"<robot>0</robot>{items('joint', near)}{description()}"
        self.assertEqual(client.call("V3", "moveJJ", again).findtext("motRet"), "SCSV3-MOT-ERR-MISUSE")
        client.call("V3", "resetMotion")
        self.move(client, "moveJJ", items("joint", near), description())
        joints = self.arrive(client)
        self.assertEqual(numbers(client.call("V0", "getRobotJointPos", "<robot>0</robot>"), "pos"), joints)
        self.assertEqual(client.call("V3", "setPower", "<power>false</power>").findtext("code"), "POWER-NO-ERR")
        without_power = client.call("V3", "moveJJ", again)
        self.assertEqual(without_power.findtext("motRet"), "SCSV3-MOT-NOT-READY")

        # The trace has the same joints in degrees.
        self.run_process.terminate()
        self.run_process.wait(20)
        with Path(self.folder.name, "trace.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assert_near([math.radians(float(rows[-1][f"j{axis}"])) for axis in range(1, 7)], joints)


if __name__ == "__main__":
    unittest.main()
