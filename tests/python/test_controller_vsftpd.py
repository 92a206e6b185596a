"""Tests of the commands for a controller's files with vsftpd, with and without TLS."""

import unittest

import controller_cases
from controller_servers import Certificate, Server, Vsftpd


class VsftpdTest(controller_cases.ServerCases):
    """vsftpd."""

    def new_server(self, is_writable: bool) -> Server:
        return Vsftpd(self.root, self.folder, is_writable)


class VsftpdTlsTest(controller_cases.ServerCases):
    """vsftpd that requires TLS, and the resumption of the session by data connections."""

    def new_server(self, is_writable: bool) -> Server:
        return Vsftpd(self.root, self.folder, is_writable, Certificate(self.folder / "certificate.pem"))


if __name__ == "__main__":
    unittest.main()
