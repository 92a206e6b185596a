"""Test of `val3 push --soap`: the applications in memory, read from the SOAP interface of a virtual controller."""

import subprocess
import unittest

import val3

import controller_cases
from controller_cases import contents, environment, replace
from controller_servers import PyftpdlibServer, wait_for
from test_soap import Client


class LoadedTest(controller_cases.ControllerCase):
    """A folder of controller files, from which a virtual controller has loaded the palletiser."""

    def setUp(self) -> None:
        super().setUp()
        command = [val3.find_binary(), "run", "usr/usrapp/palletiser", "--controller", "0"]
        self.process = subprocess.Popen(
            command, cwd=self.root, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
        )
        self.addCleanup(self.end)
        assert self.process.stderr is not None
        found = next(line for line in self.process.stderr if "http://" in line)
        self.address = found.split("http://")[1].strip(" /\n")

    def end(self) -> None:
        """End the controller."""
        self.process.kill()
        self.process.wait()
        assert self.process.stderr is not None
        self.process.stderr.close()

    def push(self) -> "subprocess.CompletedProcess[str]":
        """Push without a password: the profile `default` has none."""
        variables = {name: value for name, value in environment().items() if name != "VAL3_PASSWORD"}
        return subprocess.run(
            [val3.find_binary(), "push", "--soap", self.address],
            cwd=self.cell,
            env=variables,
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
            check=False,
        )

    def test_a_loaded_application_stops_a_push(self) -> None:
        self.run_val3("pull", str(self.root))
        replace(self.cell / "usr/usrapp/palletiser/palletiser.dtx", 'j2="-20"', 'j2="-25"')
        before = contents(self.root)
        refused = self.push()
        self.assertEqual(refused.returncode, 1, refused.stderr)
        self.assertIn("loaded on the controller: ", refused.stderr)
        self.assertIn("`Disk://palletiser/palletiser.pjx`", refused.stderr)
        self.assertEqual(contents(self.root), before)
        client = Client(f"http://{self.address}/")
        client.call("V0", "login", "<user>default</user><pwd></pwd>")
        client.call("V2", "stopAndUnloadAll")
        pushes = []

        def is_unloaded() -> bool:
            pushes.append(self.push())
            return "loaded on the controller" not in pushes[-1].stderr

        # The application is unloaded when its program `stop` has ended.
        wait_for(is_unloaded, "without applications")
        self.assertEqual(pushes[-1].returncode, 0, pushes[-1].stderr)
        self.assertIn("pushed and verified: 1 file", pushes[-1].stderr)

    def test_an_interface_that_cannot_be_reached_stops_a_push(self) -> None:
        self.run_val3("pull", str(self.root))
        replace(self.cell / "usr/usrapp/palletiser/palletiser.dtx", 'j2="-20"', 'j2="-25"')
        before = contents(self.root)
        self.end()
        refused = self.push()
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn("does not answer `login`", refused.stderr)
        self.assertEqual(contents(self.root), before)

    def test_the_interface_of_another_host_stops_a_push(self) -> None:
        server = PyftpdlibServer(self.root)
        self.addCleanup(server.close)
        self.run_val3("pull", server.address())
        output = self.run_val3("push", "--soap", self.address.replace("127.0.0.1", "localhost"), code=2)
        self.assertIn("`--soap` names the host localhost, but the project is on 127.0.0.1", output)


if __name__ == "__main__":
    unittest.main()
