"""Attacks on `val3 run --controller`: each has a fault, a rejection or a closed connection, and other clients continue."""

import errno
import http.client
import random
import socket
import time
import unittest
from urllib.parse import urlsplit

from test_soap import SOAP, V0, Client, Fault, RunCase
from test_soap_motion import IDENTITY, description, free_arm, items

HEAD = "POST / HTTP/1.1\r\nHost: robot\r\nContent-Type: application/soap+xml\r\n"


def envelope(body: str, header: str = "") -> str:
    """Message in SOAP 1.2."""
    return f"<s:Envelope xmlns:s='{SOAP}' xmlns:v='{V0}'><s:Header>{header}</s:Header><s:Body>{body}</s:Body></s:Envelope>"


class AttackTest(RunCase):
    """Hostile clients beside a client that reads the joints."""

    def setUp(self) -> None:
        parts = urlsplit(self.address)
        self.host, self.port = parts.hostname or "", parts.port or 0
        self.good = self.login()
        # The connection remains open, as that of a client of a controller.
        self.connection = http.client.HTTPConnection(self.host, self.port, timeout=5)
        self.addCleanup(self.good.call, "V0", "logout")
        self.addCleanup(self.connection.close)
        self.read_joints()

    def read_joints(self) -> float:
        """Read the joints on the open connection. Return the time of the answer in seconds."""
        header = f"<v:sessionId>{self.good.session}</v:sessionId>"
        text = envelope("<v:getRobotJointPos><robot>0</robot></v:getRobotJointPos>", header)
        start = time.monotonic()
        self.connection.request("POST", "/", text, {"Content-Type": "application/soap+xml"})
        answer = self.connection.getresponse()
        self.assertEqual(answer.status, 200)
        self.assertEqual(answer.read().count(b"<item>"), 6)
        return time.monotonic() - start

    def tearDown(self) -> None:
        self.assertLess(self.read_joints(), 1)
        self.assertIsNone(self.run_process.poll())

    def send(self, data: bytes) -> bytes:
        """Send bytes, and read until the connection is closed."""
        with socket.create_connection((self.host, self.port), 30) as stream:
            received = b""
            try:
                stream.sendall(data)
                stream.shutdown(socket.SHUT_WR)
                while block := stream.recv(1 << 16):
                    received += block
            except OSError as error:
                # The server has closed the connection.
                self.assertIn(error.errno, (errno.ECONNRESET, errno.EPIPE, errno.ENOTCONN))
            return received

    def post(self, body: str | bytes, kind: str = "application/soap+xml") -> tuple[int, str]:
        """Status and text of the response to a body."""
        connection = http.client.HTTPConnection(self.host, self.port, timeout=30)
        try:
            data = body if isinstance(body, bytes) else body.encode()
            connection.request("POST", "/", data, {"Content-Type": kind})
            answer = connection.getresponse()
            return answer.status, answer.read().decode()
        finally:
            connection.close()

    def test_large_and_endless_requests(self) -> None:
        large = envelope(f"<v:ping><message>{'x' * (1 << 20)}</message></v:ping>")
        self.assertNotIn(b"200 OK", self.send((HEAD + f"Content-Length: {len(large)}\r\n\r\n{large}").encode()))
        with socket.create_connection((self.host, self.port), 30) as stream:
            stream.sendall((HEAD + "Transfer-Encoding: chunked\r\n\r\n").encode())
            block = b"10000\r\n" + b" " * (1 << 16) + b"\r\n"
            with self.assertRaises((ConnectionResetError, BrokenPipeError)):
                for _ in range(10_000):
                    stream.sendall(block)
        self.assertNotIn(b"200 OK", self.send((HEAD + "X: " + "y" * (1 << 20) + "\r\n\r\n").encode()))
        self.assertNotIn(b"200 OK", self.send((HEAD + "Content-Length: 5\r\nContent-Length: 6\r\n\r\n<a></a>").encode()))

    def test_hostile_xml(self) -> None:
        lol = "".join(f"<!ENTITY l{n} '{f'&l{n - 1};' * 10 if n else 'lol'}'>" for n in range(9))
        bodies = [
            "<a>" * 100_000,
            "<a>" * 1000 + "</a>" * 1000,
            envelope("<v:ping>" + "<a/>" * 50_000 + "</v:ping>"),
            f"<!DOCTYPE lol [{lol}]>" + envelope("<v:ping><message>&l8;</message></v:ping>"),
            "<!DOCTYPE a SYSTEM 'file:///etc/passwd'>" + envelope("<v:ping/>"),
            envelope("<v:ping><message>&#xFFFFFFFF;</message></v:ping>"),
            envelope("<v:ping " + " ".join(f"a{n}='1'" for n in range(50_000)) + "/>"),
            "\x00" * 1000,
            "",
        ]
        for body in bodies:
            with self.subTest(body[:80]):
                start = time.monotonic()
                status, text = self.post(body)
                self.assertEqual(status, 500)
                self.assertIn("Fault", text)
                self.assertNotIn("lollol", text)
                self.assertLess(len(text), 2000)
                self.assertLess(time.monotonic() - start, 2)

    def test_noise(self) -> None:
        noise = random.Random(1)
        for _ in range(50):
            data = noise.randbytes(noise.randrange(1, 4000))
            self.assertNotIn(b"200 OK", self.send(data))
            self.assertEqual(self.post(data)[0], 500)
        message = envelope("<v:ping><message>hello</message></v:ping>")
        for _ in range(200):
            at = noise.randrange(len(message))
            text = message[:at] + chr(noise.randrange(1, 128)) + message[at + noise.randrange(3):]
            self.assertIn(self.post(text)[0], (200, 500))

    def test_wrong_content_types(self) -> None:
        message = envelope("<v:ping><message>hello</message></v:ping>")
        for kind in ["", "text/plain", "application/json", "multipart/related", "multipart/related; boundary=", "\xff"]:
            with self.subTest(kind):
                status, text = self.post(message, kind)
                self.assertIn(status, (415, 500))
                self.assertNotIn("hello", text)

    def test_slow_and_many_connections(self) -> None:
        idle = [socket.create_connection((self.host, self.port), 30) for _ in range(200)]
        try:
            for number, stream in enumerate(idle):
                try:
                    stream.sendall([b"", b"POST ", (HEAD + "Content-Length: 100\r\n\r\n<a").encode()][number % 3])
                except (ConnectionResetError, BrokenPipeError):
                    pass
            for _ in range(20):
                self.assertLess(self.read_joints(), 1)
            # The body of the third kind does not arrive in time.
            self.assertIn(b" 408 ", idle[2].recv(4096))
        finally:
            for stream in idle:
                stream.close()
            time.sleep(0.5)

    def test_many_sessions(self) -> None:
        clients = []
        while True:
            client = Client(self.address)
            if client.call("V0", "login", "<user>default</user>").findtext("sid") == "0":
                break
            clients.append(client)
            self.assertLessEqual(len(clients), 32)
        self.read_joints()
        for client in clients:
            client.call("V0", "logout")
        self.login().call("V0", "logout")

    def test_requests_after_logout(self) -> None:
        client = self.login()
        session = client.session
        client.call("V0", "logout")
        joints = f"<robot>0</robot>{items('joint', [0.0] * 6)}{description()}"
        for server, operation, text in [
            ("V0", "getRobots", ""),
            ("V2", "getTasks", ""),
            ("V3", "moveJJ", joints),
            ("V3", "setPower", "<power>true</power>"),
            ("V3", "resetMotion", ""),
            ("V0", "logout", ""),
        ]:
            for number in [session, "0", "-1", "2147483647"]:
                client.session = number
                with self.assertRaises(Fault) as raised:
                    client.call(server, operation, text)
                self.assertEqual(raised.exception.code, "INVALID-SESSION-ID-CODE", operation)

    def test_numbers_without_sense(self) -> None:
        client = self.login()
        free_arm(client)
        joints = f"<robot>0</robot>{items('joint', [0.1, 0.2, 1.2, 0.0, 0.5, -0.3])}{description()}"
        client.call("V3", "moveJJ", joints)
        for number in ["NaN", "INF", "-INF", "1e999", "", "0x10", "1,5", "9" * 5000]:
            for wrong in [joints.replace("<vel>1.0<", f"<vel>{number}<"), joints.replace("<item>1.2<", f"<item>{number}<")]:
                with self.assertRaises(Fault) as raised:
                    client.call("V3", "moveJJ", wrong)
                self.assertEqual(raised.exception.code, "INVALID-PARAMETERS", number)
        for robot in ["-1", "1", "2147483647"]:
            with self.assertRaises(Fault) as raised:
                client.call("V3", "moveJJ", joints.replace("<robot>0<", f"<robot>{robot}<"))
            self.assertEqual(raised.exception.code, "INVALID-ROBOT-ID-CODE")
        for number in ["1e308", "-1e308", "1e-308", "0"]:
            for name in ["vel", "acc", "transVel", "distBlendNext", "item", "px"]:
                text = joints.replace("<item>1.2<", f"<item>{number}<") if name == "item" else joints
                for before in ["1", "1.0", "0", "0.05", "99999"]:
                    text = text.replace(f"<{name}>{before}</{name}>", f"<{name}>{number}</{name}>")
                answer = client.call("V3", "moveJJ", text)
                self.assertRegex(answer.findtext("motRet") or "", "^SCSV3-MOT-")
                client.call("V3", "resetMotion")
        frame = f"<frame>{IDENTITY.replace('<nx>1<', '<nx>0<')}</frame>"
        answer = client.call("V3", "moveL", f"<robot>0</robot>{frame}{description()}")
        self.assertEqual(answer.findtext("motRet"), "SCSV3-MOT-ERR-PARAM")
        client.call("V0", "logout")


if __name__ == "__main__":
    unittest.main()
