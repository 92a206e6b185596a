"""Tests of `val3 pull`, `status`, `push`, `diff`, `log` and `info` by FTP over TLS, with pyftpdlib."""

import datetime
import os
import pty
import subprocess
import tempfile
from pathlib import Path

import val3

from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec, rsa
from cryptography.x509.oid import NameOID
from OpenSSL import SSL
from pyftpdlib.handlers import DTPHandler, TLS_DTPHandler, TLS_FTPHandler  # type: ignore[import-untyped]
from test_controller import ControllerCase, Server, environment, replace


class Certificate:
    """A self-signed certificate with its key, in one file. It is not valid any more, like that of an old controller."""

    def __init__(self, path: Path, key: ec.EllipticCurvePrivateKey | rsa.RSAPrivateKey) -> None:
        name = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "controller")])
        start = datetime.datetime(2001, 1, 1, tzinfo=datetime.timezone.utc)
        builder = x509.CertificateBuilder(name, name, key.public_key(), x509.random_serial_number())
        builder = builder.not_valid_before(start).not_valid_after(start + datetime.timedelta(days=365))
        certificate = builder.sign(key, hashes.SHA256())
        private = key.private_bytes(
            serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
        )
        path.write_bytes(private + certificate.public_bytes(serialization.Encoding.PEM))
        self.path = path
        self.fingerprint = "SHA256:" + certificate.fingerprint(hashes.SHA256()).hex(":").upper()


class TlsServer(Server):
    """A server that requires TLS for the login and for data."""

    def __init__(self, root: Path, certificate: Certificate, version: int = SSL.TLS1_3_VERSION, port: int = 0) -> None:
        outer = self
        #: Whether each data connection has resumed a session.
        self.resumed: list[bool] = []
        #: Whether transfers end without the mark of TLS.
        self.cuts_off = False

        class Data(TLS_DTPHandler):  # type: ignore[misc]
            def handle_ssl_established(self) -> None:
                library = SSL._lib  # type: ignore[attr-defined]
                outer.resumed.append(library.SSL_session_reused(self.socket._ssl) == 1)

            def close(self) -> None:
                if outer.cuts_off:
                    DTPHandler.close(self)
                else:
                    super().close()

        class Control(TLS_FTPHandler):  # type: ignore[misc]
            certfile = str(certificate.path)
            dtp_handler = Data
            tls_control_required = tls_data_required = True

        context = Control.get_ssl_context()
        context.set_min_proto_version(version)
        context.set_max_proto_version(version)
        super().__init__(root, base=Control, port=port)

    def address(self, user: str = "maintenance") -> str:
        """Address of the server."""
        return super().address(user).replace("ftp://", "ftps://")


class TlsTest(ControllerCase):
    """Servers with TLS."""

    def setUp(self) -> None:
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.certificate = Certificate(self.folder / "first.pem", ec.generate_private_key(ec.SECP256R1()))

    def serve(self, certificate: Certificate, version: int = SSL.TLS1_3_VERSION, port: int = 0) -> TlsServer:
        """Start a server."""
        server = TlsServer(self.root, certificate, version, port)
        self.addCleanup(server.close)
        return server

    def day_with(self, certificate: Certificate, version: int, *options: str) -> TlsServer:
        """A day with a server that has this certificate. All data connections resume the session."""
        server = self.serve(certificate, version)
        self.day(server, "--fingerprint", certificate.fingerprint, *options)
        self.assertGreater(len(server.resumed), 100)
        self.assertTrue(all(server.resumed), f"{server.resumed.count(False)} of {len(server.resumed)}")
        return server

    def test_a_day_with_tls_1_3(self) -> None:
        self.day_with(self.certificate, SSL.TLS1_3_VERSION)

    def test_a_day_with_tls_1_2_and_an_rsa_key(self) -> None:
        key = rsa.generate_private_key(65537, 2048)
        self.day_with(Certificate(self.folder / "rsa.pem", key), SSL.TLS1_2_VERSION)

    def test_a_day_in_active_mode(self) -> None:
        server = self.day_with(self.certificate, SSL.TLS1_3_VERSION, "--active")
        self.assertNotIn("PASV", server.names)

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
        second = Certificate(self.folder / "second.pem", ec.generate_private_key(ec.SECP256R1()))
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
        server = self.start()
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
