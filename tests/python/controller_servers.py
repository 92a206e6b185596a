"""FTP servers whose root is a controller's folder: pyftpdlib, also with TLS or like an old controller, and vsftpd."""

import datetime
import logging
import os
import re
import secrets
import shutil
import socket
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec, rsa
from cryptography.x509.oid import NameOID
from OpenSSL import SSL
from pyftpdlib.authorizers import DummyAuthorizer  # type: ignore[import-untyped]
from pyftpdlib.handlers import DTPHandler, FTPHandler, TLS_DTPHandler, TLS_FTPHandler  # type: ignore[import-untyped]
from pyftpdlib.servers import FTPServer  # type: ignore[import-untyped]

#: Commands that an old controller does not have.
MODERN = {"MLSD", "MLST", "MDTM", "MFMT", "SIZE", "FEAT", "EPSV", "EPRT"}

#: Password of all servers. It is random, because vsftpd has the rights of the user who runs the tests.
SECRET = secrets.token_urlsafe(16)

#: Time in seconds within which a server changes its state, also on a busy machine.
PATIENCE = 60

logging.getLogger("pyftpdlib").disabled = True


def wait_for(condition: Callable[[], bool], state: str) -> None:
    """Wait until a server is in a state."""
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError(f"the server is not {state} after {PATIENCE} s")
        time.sleep(0.001)


class Server:
    """An FTP server."""

    def __init__(self, root: Path) -> None:
        self.root = root
        #: Number of commands.
        self.commands = 0
        #: Names of the commands.
        self.names: list[str] = []
        #: Called with the number of each command.
        self.hook: Callable[[int], None] = lambda _: None
        #: Options that the first connection needs.
        self.options: tuple[str, ...] = ()

    def address(self) -> str:
        """Address of the server, with the user."""
        raise NotImplementedError

    def is_idle(self) -> bool:
        """Whether all connections are closed and their commands are counted."""
        raise NotImplementedError

    def close(self) -> None:
        """Stop the server."""
        raise NotImplementedError

    def wait_until_idle(self) -> None:
        """Wait until the last command of the last client was executed."""
        wait_for(self.is_idle, "idle")

    def on_command(self, name: str) -> None:
        """Count a command."""
        self.hook(self.commands)
        self.commands += 1
        self.names.append(name)


class PyftpdlibServer(Server):
    """pyftpdlib in a thread."""

    def __init__(
        self, root: Path, old: bool = False, is_writable: bool = True, base: type = FTPHandler, port: int = 0
    ) -> None:
        super().__init__(root)
        authorizer = DummyAuthorizer()
        authorizer.add_user("maintenance", SECRET, str(root), perm="elradfmwMT" if is_writable else "elr")
        authorizer.add_user("default", "", str(root), perm="elr")
        self.authorizer = authorizer
        outer = self

        class Handler(base):  # type: ignore[misc]
            def pre_process_command(self, line: str, cmd: str, arg: str) -> None:
                outer.on_command(cmd)
                super().pre_process_command(line, cmd, arg)

        Handler.authorizer = authorizer
        Handler.auth_failed_timeout = 0
        if old:
            Handler.proto_cmds = {name: rules for name, rules in base.proto_cmds.items() if name not in MODERN}  # type: ignore[attr-defined]
        self.server: Any = FTPServer(("127.0.0.1", port), Handler)
        self.is_closed = threading.Event()
        self.thread = threading.Thread(target=self.serve, daemon=True)
        self.thread.start()

    def serve(self) -> None:
        """Serve connections until the server is closed."""
        while not self.is_closed.is_set():
            self.server.serve_forever(timeout=0.01, blocking=False, handle_exit=False)
        self.server.close_all()

    def protect(self, folder: str) -> None:
        """Let users list the files of a folder, but not read them."""
        for user in ("maintenance", "default"):
            self.authorizer.override_perm(user, str(self.root / folder), "el", recursive=True)

    def address(self, user: str = "maintenance") -> str:
        """Address of the server."""
        return f"ftp://{user}@127.0.0.1:{self.server.address[1]}"

    def is_idle(self) -> bool:
        """Whether only the listening socket is open."""
        return len(self.server.ioloop.socket_map) <= 1

    def close(self) -> None:
        """Stop the server."""
        self.is_closed.set()
        self.thread.join()


class Certificate:
    """A self-signed certificate with its key, in one file. It is not valid any more, like that of an old controller."""

    def __init__(self, path: Path, key: ec.EllipticCurvePrivateKey | rsa.RSAPrivateKey | None = None) -> None:
        key = key or ec.generate_private_key(ec.SECP256R1())
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


class TlsServer(PyftpdlibServer):
    """pyftpdlib that requires TLS for the login and for data."""

    def __init__(
        self,
        root: Path,
        certificate: Certificate,
        version: int = SSL.TLS1_3_VERSION,
        port: int = 0,
        is_writable: bool = True,
    ) -> None:
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
        super().__init__(root, is_writable=is_writable, base=Control, port=port)
        self.options = ("--fingerprint", certificate.fingerprint)

    def address(self, user: str = "maintenance") -> str:
        """Address of the server."""
        return super().address(user).replace("ftp://", "ftps://")


#: Settings of vsftpd. It needs neither root nor an account: its only user is the anonymous one, with a password list. The
#: root of the server is the root of the file system, so that the address contains the folder of the controller.
VSFTPD = {
    "listen": "NO",
    "run_as_launching_user": "YES",
    "local_enable": "NO",
    "anonymous_enable": "YES",
    "secure_email_list_enable": "YES",
    "anon_upload_enable": "YES",
    "anon_mkdir_write_enable": "YES",
    "anon_other_write_enable": "YES",
    "anon_world_readable_only": "NO",
    "anon_umask": "022",
    "delay_failed_login": "0",
    "xferlog_enable": "YES",
    "xferlog_std_format": "NO",
    "log_ftp_protocol": "YES",
}

#: Additional settings with TLS. vsftpd then rejects data connections that do not resume the session of the control
#: connection, and uploads without the mark of TLS at the end.
VSFTPD_TLS = {
    "ssl_enable": "YES",
    "allow_anon_ssl": "YES",
    "force_anon_logins_ssl": "YES",
    "force_anon_data_ssl": "YES",
    "require_ssl_reuse": "YES",
    "strict_ssl_read_eof": "YES",
}


class Vsftpd(Server):
    """vsftpd, one process for each connection, as inetd starts it."""

    def __init__(
        self, root: Path, folder: Path, is_writable: bool = True, certificate: Certificate | None = None
    ) -> None:
        super().__init__(root)
        # Debian has no folder of system commands in the PATH of users.
        command = shutil.which("vsftpd", path=f"{os.environ.get('PATH', os.defpath)}:/usr/sbin")
        if command is None:
            raise FileNotFoundError("vsftpd is not installed: run `cargo xtask setup python`")
        (folder / "passwords").write_text(SECRET + "\n")
        (folder / "empty").mkdir()
        self.log = folder / "log"
        self.log.touch()
        settings = {
            **VSFTPD,
            "write_enable": "YES" if is_writable else "NO",
            "email_password_file": str(folder / "passwords"),
            "secure_chroot_dir": str(folder / "empty"),
            "vsftpd_log_file": str(self.log),
        }
        self.scheme = "ftp"
        if certificate:
            self.scheme = "ftps"
            settings |= {**VSFTPD_TLS, "rsa_cert_file": str(certificate.path)}
            self.options = ("--fingerprint", certificate.fingerprint)
        configuration = folder / "vsftpd.conf"
        configuration.write_text("".join(f"{name}={value}\n" for name, value in settings.items()))
        self.command = [command, str(configuration)]
        self.sessions: list[subprocess.Popen[bytes]] = []
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        #: Number of bytes of the log whose commands are counted.
        self.counted = 0
        self.is_closed = threading.Event()
        self.threads = [threading.Thread(target=work, daemon=True) for work in (self.accept, self.follow)]
        for thread in self.threads:
            thread.start()

    def accept(self) -> None:
        """Start a process for each connection."""
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return  # closed
            with connection:
                self.sessions.append(subprocess.Popen(self.command, stdin=connection.fileno(), stdout=connection.fileno()))

    def follow(self) -> None:
        """Count the commands in the log until the server is closed."""
        with self.log.open("rb") as log:
            rest = b""
            while not self.is_closed.wait(0.001):
                *lines, rest = (rest + log.read()).split(b"\n")
                for name in commands(lines):
                    self.on_command(name)
                self.counted = log.tell() - len(rest)

    def address(self) -> str:
        """Address of the server."""
        return f"{self.scheme}://ftp@127.0.0.1:{self.port}{self.root}"

    def is_idle(self) -> bool:
        """Whether all processes have ended and the log was read."""
        have_ended = all(session.poll() is not None for session in self.sessions)
        return have_ended and self.counted == self.log.stat().st_size

    def close(self) -> None:
        """Stop the server."""
        self.is_closed.set()
        # A closed socket does not wake up a thread that waits in `accept`.
        self.listener.shutdown(socket.SHUT_RDWR)
        self.listener.close()
        for thread in self.threads:
            thread.join()
        for session in self.sessions:
            session.kill()
            session.wait()


def commands(lines: list[bytes]) -> Iterator[str]:
    """Names of the commands in lines of vsftpd's log."""
    for line in lines:
        found = re.search(rb'FTP command: Client "[^"]*", "(\w+)', line)
        if found:
            yield found[1].decode()
