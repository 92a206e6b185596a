"""Tests of `val3 status --soap` with servers that are no controllers: each is an error, and never an empty state."""

import subprocess
import threading
import unittest
from http.server import BaseHTTPRequestHandler, HTTPServer
from typing import Any

import val3

ENVELOPE = "<s:Envelope xmlns:s='http://www.w3.org/2003/05/soap-envelope' xmlns:v='CS8ServerV0'><s:Body>{}</s:Body></s:Envelope>"

LOGIN = ENVELOPE.format("<v:loginResponse><sid>7</sid></v:loginResponse>")


def status(answers: list[tuple[int, str, str]]) -> "subprocess.CompletedProcess[str]":
    """Read the state of a server with these answers: status, content type and text. The last one is repeated."""
    left = iter(answers)

    class Handler(BaseHTTPRequestHandler):
        last = answers[-1]

        def do_POST(self) -> None:  # noqa: N802
            self.rfile.read(int(self.headers["Content-Length"]))
            code, kind, text = next(left, self.last)
            self.send_response(code)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(text.encode())))
            self.end_headers()
            self.wfile.write(text.encode())

        def log_message(self, *_: Any) -> None:
            pass

    with HTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        command = [val3.find_binary(), "status", "--soap", f"127.0.0.1:{server.server_address[1]}"]
        run = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=60, check=False)
        server.shutdown()
    return run


class StatusTest(unittest.TestCase):
    """Wrong answers."""

    def test_wrong_answers_are_errors(self) -> None:
        soap = "application/soap+xml"
        other = ENVELOPE.format("<v:pingResponse/>")
        for name, answers, reason in [
            ("a web page", [(200, "text/html", "<html/>")], "content type"),
            ("no SOAP server", [(404, "text/html", "not found")], "HTTP status 404"),
            ("an incomplete answer", [(200, soap, LOGIN[:-30])], "does not answer `login`"),
            ("an empty answer", [(200, soap, "")], "does not answer `login`"),
            ("another answer", [(200, soap, other)], "loginResponse"),
            ("more than 1 MiB", [(200, soap, LOGIN.replace("7", "7" + " " * (1 << 21)))], "does not answer `login`"),
            ("nothing after the login", [(200, soap, LOGIN), (200, soap, other)], "does not answer `getSoapServerVersion`"),
        ]:
            with self.subTest(name):
                run = status(answers)
                self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
                self.assertIn(reason, run.stderr)
