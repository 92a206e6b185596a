"""Tests of `val3 pull`, `status`, `push` and `diff` with pyftpdlib, in its usual form and like an old controller."""

import json
import logging
import os
import random
import shutil
import subprocess
import tempfile
import threading
import time
import unittest
from collections.abc import Callable
from pathlib import Path
from typing import Any

import val3

from pyftpdlib.authorizers import DummyAuthorizer  # type: ignore[import-untyped]
from pyftpdlib.handlers import FTPHandler  # type: ignore[import-untyped]
from pyftpdlib.servers import FTPServer  # type: ignore[import-untyped]

PALLETISER = Path(__file__).parents[2] / "examples" / "palletiser"

#: Commands that an old controller does not have.
MODERN = {"MLSD", "MLST", "MDTM", "MFMT", "SIZE", "FEAT", "EPSV", "EPRT"}

#: Number of pushes whose process is killed.
KILLS = int(os.environ.get("VAL3_KILLS", "12"))

SECRET = "not shown"

logging.getLogger("pyftpdlib").disabled = True


class Server:
    """An FTP server in a thread, whose root is a folder."""

    def __init__(
        self, root: Path, old: bool = False, rights: str = "elradfmwMT", base: type = FTPHandler, port: int = 0
    ) -> None:
        authorizer = DummyAuthorizer()
        authorizer.add_user("maintenance", SECRET, str(root), perm=rights)
        authorizer.add_user("default", "", str(root), perm="elr")
        outer = self
        self.root, self.authorizer = root, authorizer

        class Handler(base):  # type: ignore[misc]
            def pre_process_command(self, line: str, cmd: str, arg: str) -> None:
                outer.on_command()
                outer.names.append(cmd)
                super().pre_process_command(line, cmd, arg)

        Handler.authorizer = authorizer
        Handler.auth_failed_timeout = 0
        if old:
            Handler.proto_cmds = {name: rules for name, rules in base.proto_cmds.items() if name not in MODERN}  # type: ignore[attr-defined]
        self.commands = 0
        #: Names of the commands.
        self.names: list[str] = []
        #: Called with the number of each command.
        self.hook: Callable[[int], None] = lambda _: None
        self.server: Any = FTPServer(("127.0.0.1", port), Handler)
        self.is_closed = threading.Event()
        self.thread = threading.Thread(target=self.serve, daemon=True)
        self.thread.start()

    def serve(self) -> None:
        """Serve connections until the server is closed."""
        while not self.is_closed.is_set():
            self.server.serve_forever(timeout=0.01, blocking=False, handle_exit=False)
        self.server.close_all()

    def on_command(self) -> None:
        """Count a command."""
        self.hook(self.commands)
        self.commands += 1

    def protect(self, folder: str) -> None:
        """Let users list the files of a folder, but not read them."""
        for user in ("maintenance", "default"):
            self.authorizer.override_perm(user, str(self.root / folder), "el", recursive=True)

    def address(self, user: str = "maintenance") -> str:
        """Address of the server."""
        return f"ftp://{user}@127.0.0.1:{self.server.address[1]}"

    def close(self) -> None:
        """Stop the server."""
        self.is_closed.set()
        self.thread.join()


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
    """The palletiser on a server."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root, self.cell = Path(folder.name) / "robot", Path(folder.name) / "cell"
        shutil.copytree(PALLETISER / "usr", self.root / "usr")
        serial = '<String name="serialNumber" value="F10-0001" /></controller>'
        replace(self.root / "usr/configs/controller.cfx", "</controller>", serial)
        self.cell.mkdir()

    def start(self, old: bool = False, rights: str = "elradfmwMT") -> Server:
        """Start a server."""
        server = Server(self.root, old, rights)
        self.addCleanup(server.close)
        return server

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
        self.run_val3("pull", "--all", *options, server.address())
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


class ControllerTest(ControllerCase):
    """Servers without encryption."""

    def test_a_day_with_a_new_controller(self) -> None:
        self.day(self.start(old=False))

    def test_a_day_with_an_old_controller(self) -> None:
        self.day(self.start(old=True))

    def test_a_day_in_active_mode(self) -> None:
        server = self.start()
        self.day(server, "--active")
        self.assertIn("PORT", server.names)
        self.assertNotIn("PASV", server.names)
        self.assertIn("active = true", (self.cell / ".val3/controller.toml").read_text())
        self.run_val3("pull", "--passive")
        self.assertIn("PASV", server.names)
        self.assertNotIn("active", (self.cell / ".val3/controller.toml").read_text())

    def test_a_controller_that_cannot_connect_to_this_computer_has_a_remedy(self) -> None:
        class Blocked(FTPHandler):  # type: ignore[misc]
            def ftp_PORT(self, _: str) -> None:
                self.respond("425 Can't connect to specified address.")

        server = Server(self.root, base=Blocked)
        self.addCleanup(server.close)
        output = self.run_val3("pull", "--active", server.address(), code=2)
        self.assertIn("cannot open the data connection to this computer: 425", output)
        self.assertIn("--passive", output)

    def test_a_controller_that_closes_idle_connections_is_read(self) -> None:
        class Impatient(FTPHandler):  # type: ignore[misc]
            def ftp_RETR(self, line: str) -> None:
                if line.endswith("palletiser.dtx") and not seen:
                    seen.append(line)
                    self.respond("421 Control connection timed out.")
                    self.close_when_done()
                else:
                    super().ftp_RETR(line)

        seen: list[str] = []
        server = Server(self.root, base=Impatient)
        self.addCleanup(server.close)
        self.run_val3("pull", server.address())
        self.assertEqual((len(seen), server.names.count("PASS")), (1, 2))
        self.run_val3("status")

    def test_a_profile_without_write_access_cannot_push(self) -> None:
        server = self.start(rights="elr")
        self.run_val3("pull", server.address())
        replace(self.cell / "usr/usrapp/palletiser/palletiser.dtx", 'j2="-20"', 'j2="-25"')
        before = contents(self.root)
        output = self.run_val3("push", "--unloaded", code=2)
        self.assertIn("550", output)
        self.assertIn("writeAccess", output)
        self.assertEqual(contents(self.root), before)

    def test_an_empty_password_is_sent(self) -> None:
        server = self.start()
        done = subprocess.run(
            [val3.find_binary(), "pull", server.address("default")],
            cwd=self.cell,
            env={name: value for name, value in environment().items() if name != "VAL3_PASSWORD"},
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("530", self.run_val3("pull", server.address("nobody"), code=2))

    def description(self, old: bool) -> None:
        """Logs and the description by address."""
        (self.root / "log").mkdir()
        (self.root / "log/errors.log").write_text(
            "[01/05/21 08:00:30]: <0x5402> palletiser application started\n"
            "[01/05/21 08:02:40]: <0x5405> (File start.pgx-line 5) 'host' : undefined program\n"
        )
        before = contents(self.root)
        address = self.start(old).address()
        output = self.run_val3("log", address)
        self.assertIn(f"{address}/usr/usrapp/palletiser/start.pgx:8: taskCreate", output)
        document = json.loads(self.run_val3("log", address, "--format", "json").splitlines()[0])
        self.assertEqual(document["messages"][0]["file"], f"{address}/log/errors.log")
        self.assertNotIn("start.pgx:8", self.run_val3("log", address, "--sources", "."))
        output = self.run_val3("info", address)
        self.assertIn("F10-0001", output)
        self.assertIn(f"Logs (val3 log)\n  {address}/log", output)
        self.assertIn("Missing for val3 run\n  nothing", output)
        self.assertEqual((contents(self.root), contents(self.cell)), (before, {}))

    def test_a_new_controller_is_described(self) -> None:
        self.description(old=False)

    def test_an_old_controller_is_described(self) -> None:
        self.description(old=True)

    def test_files_without_rights_are_named_in_the_description(self) -> None:
        server = self.start()
        server.protect("usr/usrapp/palletiser")
        output = self.run_val3("info", server.address(), code=2)
        self.assertIn("F10-0001", output)
        self.assertIn("usr/usrapp/palletiser/start.pgx", output)
        self.assertIn("550", output)

    def test_one_file_is_printed(self) -> None:
        server = self.start()
        path = "usr/usrapp/palletiser/start.pgx"
        done = subprocess.run(
            [val3.find_binary(), "pull", "--print", path, server.address()],
            cwd=self.cell,
            env=environment(),
            capture_output=True,
            stdin=subprocess.DEVNULL,
            check=True,
        )
        self.assertEqual((done.stdout, done.stderr), ((self.root / path).read_bytes(), b""))
        self.assertEqual(contents(self.cell), {})
        self.assertIn("has no file", self.run_val3("pull", "--print", f"{path}x", server.address(), code=2))

    def test_a_killed_push_leaves_the_old_or_the_new_application(self) -> None:
        server = self.start()
        self.run_val3("pull", server.address())
        replace(self.cell / "usr/usrapp/palletiser/palletiser.dtx", 'j2="-20"', 'j2="-25"')
        replace(self.cell / "usr/usrapp/partBag/grip.pgx", "delay(nSettle)", "delay(0.5)")
        replace(self.cell / "usr/usrapp/palletiser/palletiser.pjx", 'version="', ' version="')
        shutil.copytree(self.cell / "usr/usrapp/types/Slot", self.cell / "usr/usrapp/types/Spare")
        (self.cell / "usr/usrapp/types/Spare/Slot.pjx").rename(self.cell / "usr/usrapp/types/Spare/Spare.pjx")
        copies = self.root.with_name("copies")
        shutil.copytree(self.root, copies / "robot")
        shutil.copytree(self.cell, copies / "cell")
        command = [val3.find_binary(), "push", "--unloaded", "--ignore", "V"]
        server.commands = 0
        subprocess.run(command, cwd=self.cell, env=environment(), check=True, capture_output=True)
        total, old, new = server.commands, contents(copies / "robot"), contents(self.root)
        first = self.first_write(total)
        chance, outcomes = random.Random(1), {"old": 0, "new": 0, "restored": 0}
        for number in range(KILLS):
            for folder in (self.root, self.cell):
                shutil.rmtree(folder)
                shutil.copytree(copies / folder.name, folder)
            at, delay = chance.randrange(first, total + 1), chance.choice([0, 0, chance.random() * 0.01])
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
            # The server still executes the last command.
            time.sleep(0.05)
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
        print(f"kills: {outcomes}, commands of a push: {total}")

    @staticmethod
    def first_write(total: int) -> int:
        """First command at which a process is killed: half of a push only reads."""
        return total // 3


if __name__ == "__main__":
    unittest.main()
