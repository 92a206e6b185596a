"""Tests of the commands for a controller's files with pyftpdlib, in its usual form and like an old controller."""

import subprocess
import unittest

import val3

import controller_cases
from controller_cases import environment
from controller_servers import PyftpdlibServer, Server

from pyftpdlib.handlers import FTPHandler  # type: ignore[import-untyped]


class NewControllerTest(controller_cases.ServerCases):
    """pyftpdlib."""

    def new_server(self, is_writable: bool) -> Server:
        return PyftpdlibServer(self.root, is_writable=is_writable)


class OldControllerTest(controller_cases.ServerCases):
    """pyftpdlib with the commands of an old controller."""

    def new_server(self, is_writable: bool) -> Server:
        return PyftpdlibServer(self.root, old=True, is_writable=is_writable)


class ControllerTest(controller_cases.ControllerCase):
    """Properties of single servers."""

    def serve(self) -> PyftpdlibServer:
        """Start a server."""
        server = PyftpdlibServer(self.root)
        self.addCleanup(server.close)
        return server

    def test_a_controller_that_cannot_connect_to_this_computer_has_a_remedy(self) -> None:
        class Blocked(FTPHandler):  # type: ignore[misc]
            def ftp_PORT(self, _: str) -> None:
                self.respond("425 Can't connect to specified address.")

        server = PyftpdlibServer(self.root, base=Blocked)
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
        server = PyftpdlibServer(self.root, base=Impatient)
        self.addCleanup(server.close)
        self.run_val3("pull", server.address())
        self.assertEqual((len(seen), server.names.count("PASS")), (1, 2))
        self.run_val3("status")

    def test_an_empty_password_is_sent(self) -> None:
        server = self.serve()
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

    def test_files_without_rights_are_named_in_the_description(self) -> None:
        server = self.serve()
        server.protect("usr/usrapp/palletiser")
        output = self.run_val3("info", server.address(), code=2)
        self.assertIn("F10-0001", output)
        self.assertIn("usr/usrapp/palletiser/start.pgx", output)
        self.assertIn("550", output)


if __name__ == "__main__":
    unittest.main()
