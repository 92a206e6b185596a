"""Tests of the commands for a controller's files by FTP over TLS, with pyftpdlib."""

import os
import pty
import subprocess

import val3

import controller_cases
from controller_cases import environment, replace
from controller_servers import Certificate, PyftpdlibServer, Server, TlsServer

from cryptography.hazmat.primitives.asymmetric import rsa
from OpenSSL import SSL


class TlsCase(controller_cases.ControllerCase):
    """Checks of servers with TLS."""

    def check_resumption(self, server: Server) -> None:
        """Check that all data connections have resumed the session of the control connection."""
        assert isinstance(server, TlsServer)
        self.assertGreater(len(server.resumed), 100)
        self.assertTrue(all(server.resumed), f"{server.resumed.count(False)} of {len(server.resumed)}")


class TlsControllerTest(TlsCase, controller_cases.ServerCases):
    """TLS 1.3."""

    def new_server(self, is_writable: bool) -> Server:
        return TlsServer(self.root, Certificate(self.folder / "certificate.pem"), is_writable=is_writable)

    def day(self, server: Server, *options: str) -> None:
        """The flow of a day. All data connections resume the session."""
        super().day(server, *options)
        self.check_resumption(server)


class TlsTest(TlsCase):
    """Properties of connections with TLS."""

    def setUp(self) -> None:
        super().setUp()
        self.certificate = Certificate(self.folder / "first.pem")

    def serve(self, certificate: Certificate, version: int = SSL.TLS1_3_VERSION, port: int = 0) -> TlsServer:
        """Start a server."""
        server = TlsServer(self.root, certificate, version, port)
        self.addCleanup(server.close)
        return server

    def test_a_day_with_tls_1_2_and_an_rsa_key(self) -> None:
        key = rsa.generate_private_key(65537, 2048)
        server = self.serve(Certificate(self.folder / "rsa.pem", key), SSL.TLS1_2_VERSION)
        self.day(server)
        self.check_resumption(server)

    def test_the_first_connection_needs_the_fingerprint(self) -> None:
        server = self.serve(self.certificate)
        output = self.run_val3("pull", server.address(), code=2)
        self.assertIn(f"its certificate is not known: {self.certificate.fingerprint}", output)
        self.assertIn("--fingerprint", output)
        self.assertFalse({"USER", "PASS"} & set(server.names))
        self.run_val3("pull", "--fingerprint", self.certificate.fingerprint.lower(), server.address())
        self.assertIn(self.certificate.fingerprint, (self.cell / ".val3/controller.toml").read_text())
        # Other commands in the project know the certificate.
        self.run_val3("status")
        self.run_val3("diff", server.address())
        self.assertIn("F10-0001", self.run_val3("info", server.address()))
        (self.root / "log").mkdir()
        (self.root / "log/errors.log").write_text("[01/05/21 08:00:30]: <0x5402> palletiser application started\n")
        self.run_val3("log", server.address())

    def test_commands_outside_of_a_project_have_the_option(self) -> None:
        server = self.serve(self.certificate)
        self.run_val3("info", server.address(), code=2)
        self.assertNotIn("PASS", server.names)
        output = self.run_val3("info", "--fingerprint", self.certificate.fingerprint, server.address())
        self.assertIn("F10-0001", output)

    def test_another_certificate_is_rejected_until_it_is_accepted(self) -> None:
        server = self.serve(self.certificate)
        self.run_val3("pull", "--fingerprint", self.certificate.fingerprint, server.address())
        port = server.server.address[1]
        server.close()
        second = Certificate(self.folder / "second.pem")
        repaired = self.serve(second, port=port)
        for command in (["status"], ["push", "--unloaded"], ["pull"], ["diff", repaired.address()]):
            output = self.run_val3(*command, code=2)
            self.assertIn(f"its certificate is {second.fingerprint}", output)
            self.assertIn(f"the accepted one is {self.certificate.fingerprint}", output)
            self.assertIn("val3 pull --fingerprint", output)
        self.assertFalse({"USER", "PASS"} & set(repaired.names))
        self.run_val3("pull", "--fingerprint", second.fingerprint)
        self.run_val3("status")

    def test_a_transfer_without_an_end_is_not_used(self) -> None:
        server = self.serve(self.certificate)
        server.cuts_off = True
        output = self.run_val3("pull", "--fingerprint", self.certificate.fingerprint, server.address(), code=2)
        self.assertIn("without the mark of TLS", output)
        self.assertFalse((self.cell / "usr").exists())

    def test_a_server_without_tls_is_rejected(self) -> None:
        server = PyftpdlibServer(self.root)
        self.addCleanup(server.close)
        address = server.address().replace("ftp://", "ftps://")
        for options in ([], ["--fingerprint", self.certificate.fingerprint]):
            output = self.run_val3("pull", *options, address, code=2)
            self.assertIn("the controller does not offer TLS: 50", output)
            self.assertIn("`ftp://`", output)
        self.assertFalse({"USER", "PASS"} & set(server.names))

    def ask(self, server: TlsServer, answer: str) -> subprocess.CompletedProcess[str]:
        """Pull at a terminal, and answer the question."""
        master, terminal = pty.openpty()
        os.write(master, answer.encode())
        try:
            return subprocess.run(
                [val3.find_binary(), "pull", server.address()],
                cwd=self.cell,
                env=environment(),
                capture_output=True,
                text=True,
                stdin=terminal,
                timeout=300,
                check=False,
            )
        finally:
            os.close(master)
            os.close(terminal)

    def test_a_terminal_asks_for_the_certificate(self) -> None:
        server = self.serve(self.certificate)
        rejected = self.ask(server, "\n")
        self.assertEqual(rejected.returncode, 2, rejected.stderr)
        self.assertIn(f"Its fingerprint is {self.certificate.fingerprint}.", rejected.stderr)
        self.assertIn("was not accepted", rejected.stderr)
        self.assertFalse({"USER", "PASS"} & set(server.names))
        accepted = self.ask(server, "y\n")
        self.assertEqual(accepted.returncode, 0, accepted.stderr)
        replace(self.cell / "usr/usrapp/palletiser/palletiser.dtx", 'j2="-20"', 'j2="-25"')
        self.run_val3("push", "--unloaded")
