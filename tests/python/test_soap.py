"""Tests of `val3 run --controller` with a client of the standard library: the samples of the interface, and a session."""

import base64
import io
import math
import re
import shutil
import subprocess
import tempfile
import time
import unittest
import urllib.error
import urllib.request
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import ClassVar
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import val3

ROOT = Path(__file__).parents[2]
PALLETISER = ROOT / "examples/palletiser/usr/usrapp/palletiser"
SAMPLES = ROOT / "crates/val3-soap/tests/samples"

SOAP = "http://www.w3.org/2003/05/soap-envelope"
OLD_SOAP = "http://schemas.xmlsoap.org/soap/envelope/"
V0 = "CS8ServerV0"
DATA = "{http://www.staubli.com/robotics/VAL3/Data/2}"

PROJECT = "Disk://palletiser/palletiser.pjx"

#: Samples that name an application, task or recording of another cell.
OTHER_CELL = {
    "getApplicationDatas": "APPLICATION-NOT-FOUND",
    "getRecord": "FILE-NOT-FOUND-CODE",
    "getProject": "APPLICATION-NOT-FOUND",
    "getWatches": "APPLICATION-NOT-FOUND",
    "getCallStack": "TASK-NOT-FOUND",
    "getStackFrame": "TASK-NOT-FOUND",
    "setCurrentInstruction": "TASK-NOT-FOUND",
    "execVal3": "TASK-NOT-FOUND",
    "replaceLine": "APPLICATION-NOT-FOUND",
    "setProjectAsModified": "APPLICATION-NOT-FOUND",
    "taskKill": "TASK-NOT-FOUND",
    "taskResume": "TASK-NOT-FOUND",
    "taskStep": "TASK-NOT-FOUND",
    "taskSuspend": "TASK-NOT-FOUND",
}


class Fault(Exception):
    """Fault of the controller: code and reason."""

    def __init__(self, code: str, reason: str) -> None:
        super().__init__(reason)
        self.code = code


class Client:
    """Client that keeps the session of the last answer, as the stubs of clients do."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.session = ""

    def post(self, path: str, text: str, kind: str = "application/soap+xml") -> Element:
        """Send a message. Return the element in the body of the answer."""
        headers = {"Content-Type": f"{kind}; charset=utf-8"}
        request = urllib.request.Request(self.address + path, text.encode(), headers)
        try:
            with urllib.request.urlopen(request, timeout=20) as response:
                answer = response.read()
        except urllib.error.HTTPError as error:
            if error.code != 500:
                raise
            answer = error.read()
        root = ElementTree.fromstring(answer)
        soap = OLD_SOAP if kind == "text/xml" else SOAP
        header = root.find(f"{{{soap}}}Header/{{{V0}}}sessionId")
        if header is not None:
            assert header.attrib == {}
            self.session = header.text or ""
        body = root.find(f"{{{soap}}}Body")
        assert body is not None
        [element] = body
        if element.tag == f"{{{soap}}}Fault":
            code = element.find(f".//{{{V0}}}ServerException/code")
            reason = element.find(f".//{{{soap}}}Text")
            raise Fault("" if code is None else code.text or "", "" if reason is None else reason.text or "")
        return element

    def call(self, server: str, operation: str, content: str = "") -> Element:
        """Send a request with the session."""
        path, namespace = ("", V0) if server == "V0" else (f"CS8Server{server}", f"urn:CS8Server{server}")
        header = f"<s:Header><v:sessionId xmlns:v='{V0}'>{self.session}</v:sessionId></s:Header>" if self.session else ""
        text = (
            f"<s:Envelope xmlns:s='{SOAP}'>{header}<s:Body><o:{operation} xmlns:o='{namespace}'>{content}"
            f"</o:{operation}></s:Body></s:Envelope>"
        )
        return self.post(path, text)


def names(element: Element) -> list[str]:
    """Names of an element and its descendants in the order of the document; a repeated item counts once."""
    found = [element.tag]
    for child in element:
        inner = names(child)
        if found[-len(inner):] != inner:
            found += inner
    return found


def numbers(element: Element, name: str) -> list[float]:
    """Numbers of a list."""
    return [float(item.text or "") for item in element.findall(f"{name}/item")]


def values(answer: Element) -> dict[str, dict[str, str]]:
    """Attributes of the first value of each data in a document; a default has no value."""
    root = ElementTree.fromstring(base64.b64decode(answer.findtext("data/data") or ""))
    found = {}
    for data in root.iter(f"{DATA}Data"):
        value = data.find(f"{DATA}Value")
        found[data.get("name", "")] = {} if value is None else dict(value.attrib)
    return found


def wait_for(client: Client, condition: Callable[[dict[str, Element]], bool]) -> dict[str, Element]:
    """Wait until the tasks of the controller meet a condition. Return the tasks by name."""
    end = time.monotonic() + 20
    while time.monotonic() < end:
        tasks = {task.findtext("name") or "": task for task in client.call("V2", "getTasks").findall("tasks/Task")}
        if condition(tasks):
            return tasks
        time.sleep(0.05)
    raise AssertionError(f"the tasks do not meet the condition: {sorted(tasks)}")


def line_of(task: Element) -> tuple[str, str, int]:
    """State of a task, its program and the number of its line."""
    line = task.find("programLine")
    assert line is not None
    return task.findtext("state") or "", line.findtext("pgmName") or "", int(line.findtext("lineNumber") or "")


class RunCase(unittest.TestCase):
    """A run of the palletiser with clients, for all tests of a class."""

    run_process: ClassVar["subprocess.Popen[str]"]
    address: ClassVar[str]
    #: Further arguments of the run.
    options: ClassVar[list[str]] = []
    #: Application of the run.
    application: ClassVar[Path] = PALLETISER

    @classmethod
    def setUpClass(cls) -> None:
        command = [val3.find_binary(), "run", str(cls.application), "--controller", "0", "--until", "300", "--until-ok"]
        command += cls.options
        cls.run_process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
        assert cls.run_process.stderr is not None
        for line in cls.run_process.stderr:
            found = re.search(r"reach the controller at (http://\S+)", line)
            if found:
                cls.address = found[1]
                return
        raise AssertionError("the run did not begin")

    @classmethod
    def tearDownClass(cls) -> None:
        cls.run_process.terminate()
        cls.run_process.wait(20)
        assert cls.run_process.stderr is not None
        cls.run_process.stderr.close()

    def login(self) -> Client:
        client = Client(self.address)
        sid = client.call("V0", "login", "<user>default</user><pwd/>").findtext("sid")
        self.assertEqual(sid, client.session)
        self.assertGreater(int(client.session), 0)
        return client


class ControllerTest(RunCase):
    """Clients of a run."""

    def test_samples_have_answers_of_the_same_form(self) -> None:
        client = self.login()
        # Only one session debugs at a time.
        self.addCleanup(client.call, "V0", "logout")
        session = client.session
        for request in sorted(SAMPLES.glob("V*.req.xml")):
            name = request.name.removesuffix(".req.xml")
            server, operation = name.split("-", 1)
            if operation in {"login", "login.soap11", "logout"}:
                continue
            text = request.read_text().replace(">42<", f">{session}<")
            path = "" if server == "V0" else f"CS8Server{server}"
            sample = ElementTree.fromstring(request.with_name(f"{name}.res.xml").read_text())
            body = sample.find(f"{{{SOAP}}}Body")
            assert body is not None
            try:
                answer = client.post(path, text)
            except Fault as fault:
                expected = OTHER_CELL.get(operation) or body.findtext(f".//{{{V0}}}ServerException/code")
                self.assertEqual(fault.code, expected, name)
                self.assertTrue(str(fault).startswith(f"{fault.code}: "), name)
            else:
                with self.subTest(name):
                    [element] = body
                    self.assertEqual(answer.tag, element.tag)
                    # No breakpoint is set here.
                    if operation != "getBreakpoints":
                        self.assertTrue(set(names(element)) <= set(names(answer)), names(answer))
            self.assertEqual(client.session, session, name)

    def test_soap_1_1(self) -> None:
        client = Client(self.address)
        answer = client.post("", (SAMPLES / "V0-login.soap11.req.xml").read_text(), "text/xml")
        self.assertEqual(answer.tag, f"{{{V0}}}loginResponse")

    def test_positions(self) -> None:
        client = self.login()
        joints = [0.1, 0.2, 1.2, 0.0, 0.5, -0.3]
        items = "".join(f"<item>{joint}</item>" for joint in joints)
        client.call("V0", "setRobotJointPos", f"<robot>0</robot><pos>{items}</pos>")
        answer = client.call("V0", "getRobotJntCartPos", "<robot>0</robot>")
        for read, written in zip(numbers(answer, "jntPos"), joints, strict=True):
            self.assertAlmostEqual(read, written, 12)
        reach = math.dist([float(answer.findtext(f"cartPos/{axis}") or "") for axis in "xyz"], [0, 0, 0])
        self.assertTrue(0.2 < reach < 3, reach)

    def test_data_and_signals(self) -> None:
        client = self.login()
        name = "<name>Disk://palletiser/palletiser.pjx</name>"
        data = client.call("V1", "getApplicationDatas", name).findtext("data") or ""
        root = ElementTree.fromstring(base64.b64decode(data))
        self.assertTrue(any(child.get("name") == "nLayer" for child in root.iter()))
        path = r"BasicIO-1\%Q15"
        ios = f"<ios><PhysicalPath>{path}</PhysicalPath></ios>"
        client.call("V2", "writeIos", f"{ios}<values><PhysicalIoValue>1</PhysicalIoValue></values>")
        state = client.call("V2", "readIos", f"{ios}<x-getDescription>true</x-getDescription>")
        self.assertEqual(state.findtext("state/PhysicalIoState/value"), "1")

    def test_debugging(self) -> None:
        client = self.login()
        # Only one session debugs at a time.
        self.addCleanup(client.call, "V0", "logout")
        task = f"<taskName>supervisor</taskName><createdBy>{PROJECT}</createdBy>"
        program = f"<appName>{PROJECT}</appName><pgmName>supervisor</pgmName>"
        line = f"<programLine>{program}<lineNumber>7</lineNumber></programLine>"
        wait_for(client, lambda tasks: "supervisor" in tasks)
        client.call("V2", "setBreakpoints", f"<breakpoints><BreakPoint>{line}</BreakPoint></breakpoints>")
        stopped = ("TASKSTATE-STOPPED", "supervisor", 7)
        wait_for(client, lambda tasks: line_of(tasks["supervisor"]) == stopped)
        client.call("V2", "taskStep", f"{task}<stepType>TASKSTEP-INTO</stepType>")
        wait_for(client, lambda tasks: line_of(tasks["supervisor"])[:2] == ("TASKSTATE-STOPPED", "onKey"))
        stack = client.call("V2", "getCallStack", task).findall("callStack/SfAbstract//pgmName")
        self.assertEqual([name.text for name in stack], ["onKey", "supervisor"])
        frame = values(client.call("V2", "getStackFrame", f"{task}<stackFrameIndex>0</stackFrameIndex>"))
        self.assertEqual(frame["x_nKey"], {"key": "0", "value": "-1"})
        watch = "".join(
            f"<SoapData><appName>{PROJECT}</appName><dataName>{name}</dataName><dataIndex>0</dataIndex></SoapData>"
            for name in ("mFast", "sState")
        )
        watched = values(client.call("V2", "getWatches", f"<watch>{watch}</watch>"))
        self.assertEqual(watched["sState"], {"key": "0", "value": "stopped"})
        self.assertEqual(list(watched), ["mFast", "sState"])
        client.call("V2", "taskStep", f"{task}<stepType>TASKSTEP-OUT</stepType>")
        wait_for(client, lambda tasks: line_of(tasks["supervisor"]) == ("TASKSTATE-STOPPED", "supervisor", 8))
        for number in (10, 8):
            next_line = f"<line>{program}<lineNumber>{number}</lineNumber></line>"
            client.call("V2", "setCurrentInstruction", f"{task}<resetMotion>false</resetMotion>{next_line}")
            expected = ("TASKSTATE-STOPPED", "supervisor", number)
            wait_for(client, lambda tasks: line_of(tasks["supervisor"]) == expected)
        client.call("V2", "clearAllBreakpoints")
        client.call("V2", "taskResume", task)
        wait_for(client, lambda tasks: line_of(tasks["supervisor"])[0] == "TASKSTATE-RUNNING")

    def test_project(self) -> None:
        data = self.login().call("V2", "getProject", f"<name>{PROJECT}</name>").findtext("data") or ""
        with zipfile.ZipFile(io.BytesIO(base64.b64decode(data))) as archive:
            self.assertIsNone(archive.testzip())
            start = archive.read("start.pgx")
        self.assertEqual(start, (PALLETISER / "start.pgx").read_bytes())

    def test_restart(self) -> None:
        client = self.login()
        path = f"<applicationPath>{PROJECT}</applicationPath>"
        for operation in ("stopAndUnloadAll", "loadProjectAsync", "startApplication"):
            client.call("V2", operation, path if operation != "stopAndUnloadAll" else "")
        wait_for(client, lambda tasks: "supervisor" in tasks)
        client.call("V2", "stopApplication")
        wait_for(client, lambda tasks: not tasks)
        client.call("V2", "startApplication", path)
        wait_for(client, lambda tasks: "supervisor" in tasks)

    def test_replace_line(self) -> None:
        client = self.login()
        # Only one session debugs at a time.
        self.addCleanup(client.call, "V0", "logout")
        wait_for(client, lambda tasks: "supervisor" in tasks)
        program = f"<appName>{PROJECT}</appName><pgmName>supervisor</pgmName>"

        def replace(number: int, content: str, code: str) -> tuple[str, str]:
            line = f"<line>{program}<lineNumber>{number}</lineNumber><lineContent>{content}</lineContent></line>"
            answer = client.call("V2", "replaceLine", f"{line}<newLine>{code}</newLine>")
            return answer.findtext("retCode") or "", answer.findtext("strOut") or ""

        def value() -> float:
            place = "<prjName>palletiser</prjName><stackFrameIndex>0</stackFrameIndex>"
            answer = client.call("V2", "execVal3", f"{place}<cmd>nTimes[3]</cmd>")
            return float(answer.findtext("strOut") or "")

        old, new = "call drawScreen()", "nTimes[3]=nTimes[3]+4711"
        with self.assertRaises(Fault) as raised:
            replace(9, "call other()", new)
        self.assertEqual(raised.exception.code, "MISMATCHED-CODE")
        self.assertEqual(replace(9, old, "call nothing()")[0], "RLI-COMPILATION-ERROR")
        self.assertEqual(replace(9, old, "endWhile")[0], "RLI-INSTRUCTION-CONTROL")
        self.assertEqual(replace(9, old, new), ("RLI-NO-ERROR", ""))
        end = time.monotonic() + 20
        while value() < 3 * 4711:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)
        self.assertEqual(replace(9, new, old), ("RLI-NO-ERROR", ""))
        client.call("V2", "setProjectAsModified", "<prjName>palletiser</prjName>")
        data = client.call("V2", "getProject", f"<name>{PROJECT}</name>").findtext("data") or ""
        with zipfile.ZipFile(io.BytesIO(base64.b64decode(data))) as archive:
            self.assertEqual(archive.read("supervisor.pgx"), (PALLETISER / "supervisor.pgx").read_bytes())

    def test_sessions(self) -> None:
        first, second = self.login(), self.login()
        self.assertNotEqual(first.session, second.session)
        session = first.session
        first.call("V0", "logout")
        first.session = session
        with self.assertRaises(Fault) as raised:
            first.call("V0", "getRobots")
        self.assertEqual(raised.exception.code, "INVALID-SESSION-ID-CODE")
        second.call("V0", "getRobots")
        rejected = Client(self.address).call("V0", "login", "<user>nobody</user>")
        self.assertEqual(rejected.findtext("sid"), "0")


class ProjectsTest(RunCase):
    """Clients of a run that load another application beside the one of the run."""

    folder: ClassVar["tempfile.TemporaryDirectory[str]"]

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        usr = Path(cls.folder.name) / "usr"
        shutil.copytree(PALLETISER.parents[1], usr)
        cls.application = usr / "usrapp/palletiser"
        command = [val3.find_binary(), "new", "second", "--folder", str(usr / "usrapp")]
        subprocess.run(command, check=True, capture_output=True, text=True)
        super().setUpClass()

    @classmethod
    def tearDownClass(cls) -> None:
        super().tearDownClass()
        cls.folder.cleanup()

    def test_another_application(self) -> None:
        client = self.login()
        name = "Disk://second/second.pjx"
        path = f"<applicationPath>{name}</applicationPath>"
        listed = client.call("V1", "getApplications").findall("applications/application")
        self.assertIn((name, "false"), [(item.findtext("name"), item.findtext("loaded")) for item in listed])
        with self.assertRaises(Fault):
            client.call("V2", "loadProjectAsync", path)
        client.call("V2", "stopAndUnloadAll")
        client.call("V2", "loadProjectAsync", path)
        client.call("V2", "startApplication", path)
        end = time.monotonic() + 20
        while True:
            listed = client.call("V1", "getApplications").findall("applications/application")
            loaded = {item.findtext("name") for item in listed if item.findtext("loaded") == "true"}
            if loaded == {name}:
                break
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)
        # An application that cannot be compiled is a fault with the reason.
        start = self.application.parent / "second/start.pgx"
        text = start.read_text(encoding="utf-8-sig")
        start.write_text(text.replace("begin", "begin\n  nNothing=1", 1), encoding="utf-8")
        client.call("V2", "stopAndUnloadAll")
        with self.assertRaises(Fault) as raised:
            client.call("V2", "loadProjectAsync", path)
        self.assertIn("nNothing", str(raised.exception))
        path = f"<applicationPath>{PROJECT}</applicationPath>"
        for operation in ("loadProjectAsync", "startApplication"):
            client.call("V2", operation, path)
        wait_for(client, lambda tasks: "supervisor" in tasks)


if __name__ == "__main__":
    unittest.main()
