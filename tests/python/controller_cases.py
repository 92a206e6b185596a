"""Cases of `val3 pull`, `status`, `push`, `diff`, `log` and `info` that hold with every server."""

import json
import os
import random
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import val3

from controller_servers import SECRET, Server

PALLETISER = Path(__file__).parents[2] / "examples" / "palletiser"

#: Number of pushes whose process is killed, for each server.
KILLS = int(os.environ.get("VAL3_KILLS", "12"))


def environment() -> dict[str, str]:
    """Variables of a command, with the password."""
    return {**os.environ, "VAL3_PASSWORD": SECRET, "NO_COLOR": "1"}


def contents(folder: Path) -> dict[str, bytes]:
    """All files in a folder."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def replace(path: Path, old: str, new: str) -> None:
    """Replace a text in a file."""
    text = path.read_text(encoding="utf-8-sig")
    assert old in text, f"{old} is not in {path}"
    path.write_text(text.replace(old, new), encoding="utf-8-sig")


class ControllerCase(unittest.TestCase):
    """The palletiser as the files of a controller."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        #: Folder of the test for further files.
        self.folder = Path(folder.name)
        self.root, self.cell = self.folder / "robot", self.folder / "cell"
        shutil.copytree(PALLETISER / "usr", self.root / "usr")
        serial = '<String name="serialNumber" value="F10-0001" /></controller>'
        replace(self.root / "usr/configs/controller.cfx", "</controller>", serial)
        self.cell.mkdir()

    def run_val3(self, *arguments: str, code: int = 0) -> str:
        """Run a command in the cell. Return its whole output."""
        done = subprocess.run(
            [val3.find_binary(), *arguments],
            cwd=self.cell,
            env=environment(),
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
            timeout=300,
            check=False,
        )
        output = done.stdout + done.stderr
        self.assertEqual(done.returncode, code, output)
        self.assertNotIn(SECRET, output)
        return output

    def day(self, server: Server, *options: str) -> None:
        """The flow of a day: acceptance test of the commands."""
        self.run_val3("pull", "--all", *server.options, *options, server.address())
        self.assertNotIn(SECRET.encode(), b"".join(contents(self.cell).values()))
        self.run_val3("status")
        grip = self.cell / "usr/usrapp/partBag/grip.pgx"
        data = self.cell / "usr/usrapp/palletiser/palletiser.dtx"
        replace(grip, "delay(nSettle)", "delay(nSetle)")
        replace(data, 'j2="-20"', 'j2="-25"')
        self.assertIn("2 changed here", self.run_val3("status", code=1))
        before = contents(self.root)
        self.assertIn("nSetle", self.run_val3("push", "--unloaded", code=1))
        replace(grip, "nSetle", "nSettle+0.1")
        self.assertIn("replace", self.run_val3("push", "--dry-run"))
        self.assertEqual(contents(self.root), before)
        self.assertIn("pushed and verified: 2 files", self.run_val3("push", "--unloaded"))
        self.run_val3("diff", server.address())
        self.run_val3("status")
        # The operator teaches a point.
        replace(self.root / "usr/usrapp/palletiser/palletiser.dtx", 'vel="90"', 'vel="60"')
        replace(data, 'j2="-25"', 'j2="-30"')
        self.assertIn("merge the changes", self.run_val3("push", "--unloaded", code=1))
        self.run_val3("pull", code=1)
        self.run_val3("pull", "--merge")
        self.run_val3("push", "--unloaded")
        self.run_val3("diff", server.address())
        text = (self.root / "usr/usrapp/palletiser/palletiser.dtx").read_text(encoding="utf-8-sig")
        self.assertTrue('vel="60"' in text and 'j2="-30"' in text)
        self.assertFalse([name for name in contents(self.root) if "val3" in Path(name).suffix or "lock" in name])


class ServerCases(ControllerCase):
    """Cases for one kind of server. A subclass names the server, and inherits the tests."""

    def new_server(self, is_writable: bool) -> Server:
        """Start a server on a free port."""
        raise NotImplementedError

    def start(self, is_writable: bool = True) -> Server:
        """Start a server, which ends with the test."""
        server = self.new_server(is_writable)
        self.addCleanup(server.close)
        return server

    def test_a_day(self) -> None:
        server = self.start()
        self.day(server)
        self.assertTrue({"PASV", "EPSV"} & set(server.names))
        self.assertFalse({"PORT", "EPRT"} & set(server.names))

    def test_a_day_in_active_mode(self) -> None:
        server = self.start()
        self.day(server, "--active")
        server.wait_until_idle()
        self.assertTrue({"PORT", "EPRT"} & set(server.names))
        self.assertFalse({"PASV", "EPSV"} & set(server.names))
        self.assertIn("active = true", (self.cell / ".val3/controller.toml").read_text())
        self.run_val3("pull", "--passive")
        server.wait_until_idle()
        self.assertTrue({"PASV", "EPSV"} & set(server.names))
        self.assertNotIn("active", (self.cell / ".val3/controller.toml").read_text())

    def test_a_profile_without_write_access_cannot_push(self) -> None:
        server = self.start(is_writable=False)
        self.run_val3("pull", *server.options, server.address())
        replace(self.cell / "usr/usrapp/palletiser/palletiser.dtx", 'j2="-20"', 'j2="-25"')
        before = contents(self.root)
        output = self.run_val3("push", "--unloaded", code=2)
        self.assertIn("550", output)
        self.assertIn("writeAccess", output)
        self.assertEqual(contents(self.root), before)

    def test_a_wrong_password_is_rejected(self) -> None:
        server = self.start()
        done = subprocess.run(
            [val3.find_binary(), "pull", *server.options, server.address()],
            cwd=self.cell,
            env={**environment(), "VAL3_PASSWORD": "wrong"},
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
            check=False,
        )
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("530", done.stderr)
        self.assertEqual(contents(self.cell), {})

    def test_logs_and_the_description_are_read(self) -> None:
        (self.root / "log").mkdir()
        (self.root / "log/errors.log").write_text(
            "[01/05/21 08:00:30]: <0x5402> palletiser application started\n"
            "[01/05/21 08:02:40]: <0x5405> (File start.pgx-line 5) 'host' : undefined program\n"
        )
        before = contents(self.root)
        server = self.start()
        address, options = server.address(), server.options
        output = self.run_val3("log", *options, address)
        self.assertIn(f"{address}/usr/usrapp/palletiser/start.pgx:8: taskCreate", output)
        document = json.loads(self.run_val3("log", *options, address, "--format", "json").splitlines()[0])
        self.assertEqual(document["messages"][0]["file"], f"{address}/log/errors.log")
        self.assertNotIn("start.pgx:8", self.run_val3("log", *options, address, "--sources", "."))
        output = self.run_val3("info", *options, address)
        self.assertIn("F10-0001", output)
        self.assertIn(f"Logs (val3 log)\n  {address}/log", output)
        self.assertIn("Missing for val3 run\n  nothing", output)
        self.assertEqual((contents(self.root), contents(self.cell)), (before, {}))

    def test_one_file_is_printed(self) -> None:
        server = self.start()
        path = "usr/usrapp/palletiser/start.pgx"
        done = subprocess.run(
            [val3.find_binary(), "pull", "--print", path, *server.options, server.address()],
            cwd=self.cell,
            env=environment(),
            capture_output=True,
            stdin=subprocess.DEVNULL,
            check=True,
        )
        self.assertEqual((done.stdout, done.stderr), ((self.root / path).read_bytes(), b""))
        self.assertEqual(contents(self.cell), {})
        output = self.run_val3("pull", "--print", f"{path}x", *server.options, server.address(), code=2)
        self.assertIn("has no file", output)

    def test_a_killed_push_leaves_the_old_or_the_new_application(self) -> None:
        server = self.start()
        self.run_val3("pull", *server.options, server.address())
        replace(self.cell / "usr/usrapp/palletiser/palletiser.dtx", 'j2="-20"', 'j2="-25"')
        replace(self.cell / "usr/usrapp/partBag/grip.pgx", "delay(nSettle)", "delay(0.5)")
        replace(self.cell / "usr/usrapp/palletiser/palletiser.pjx", 'version="', ' version="')
        shutil.copytree(self.cell / "usr/usrapp/types/Slot", self.cell / "usr/usrapp/types/Spare")
        (self.cell / "usr/usrapp/types/Spare/Slot.pjx").rename(self.cell / "usr/usrapp/types/Spare/Spare.pjx")
        copies = self.root.with_name("copies")
        shutil.copytree(self.root, copies / "robot")
        shutil.copytree(self.cell, copies / "cell")
        command = [val3.find_binary(), "push", "--unloaded", "--ignore", "V"]
        server.wait_until_idle()
        begin = len(server.names)
        subprocess.run(command, cwd=self.cell, env=environment(), check=True, capture_output=True)
        server.wait_until_idle()
        names, old, new = server.names[begin:], contents(copies / "robot"), contents(self.root)
        # The first third of a push only reads. The renames are few, so that half of the kills are aimed at them.
        ends = len(names) - names[::-1].index("RNTO")
        moments = [(len(names) // 3, len(names)), (names.index("RNFR"), ends)]
        chance, outcomes = random.Random(1), {"old": 0, "new": 0, "restored": 0}
        for number in range(KILLS):
            for folder in (self.root, self.cell):
                shutil.rmtree(folder)
                shutil.copytree(copies / folder.name, folder)
            at = chance.randint(*chance.choice(moments))
            delay = chance.choice([0, 0, chance.random() * 0.01])
            process = subprocess.Popen(
                command, cwd=self.cell, env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )

            def kill(count: int, process: subprocess.Popen[bytes] = process, at: int = at, delay: float = delay) -> None:
                if count >= at and process.poll() is None:
                    time.sleep(delay)
                    process.kill()

            server.commands, server.hook = 0, kill
            process.wait(300)
            server.hook = lambda _: None
            server.wait_until_idle()
            at_kill = contents(self.root)
            output = subprocess.run(
                [val3.find_binary(), "status"], cwd=self.cell, env=environment(), capture_output=True, text=True, check=False
            ).stderr
            after = contents(self.root)
            self.assertIn(after, (old, new), f"kill {number} at command {at}: {output}")
            if at_kill not in (old, new):
                self.assertIn("interrupted", output, f"kill {number} at command {at}")
            state = "restored" if "restored from" in output else "new" if after == new else "old"
            outcomes[state] += 1
            server.wait_until_idle()
        print(f"kills: {outcomes}, commands of a push: {len(names)}")
