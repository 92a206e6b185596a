"""Tests of `val3 mcp` with the official client, in both revisions of the protocol."""

import asyncio
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import val3

from mcp import ClientSession, MCPError, StdioServerParameters, stdio_client
from mcp.types import CallToolResult, TextContent

EXAMPLES = Path(__file__).parents[2] / "examples"
PALLETISER = "palletiser/usr/usrapp/palletiser"
SORTER = "faulty/usr/usrapp/sorter"

#: Tools that change no file.
READING = {"outline", "explain", "check", "eval", "run", "test"}
#: Tools that change files.
WRITING = {"write_program", "write_data", "rename"}

#: Limits of answers in bytes.
SHORT, LONG = 8_000, 24_000


@asynccontextmanager
async def session(root: Path, *arguments: str, initialized: bool = True) -> AsyncIterator[ClientSession]:
    """Start the server, and connect by `initialize` or by `server/discover`."""
    command = StdioServerParameters(
        command=val3.find_binary(), args=["mcp", "--root", str(root), *arguments], env=dict(os.environ)
    )
    async with stdio_client(command) as (read, write), ClientSession(read, write) as client:
        if initialized:
            await client.initialize()
        else:
            await client.discover()
        yield client


async def call(client: ClientSession, tool: str, **arguments: Any) -> tuple[bool, str]:
    """Call a tool. Return whether it is an error, and the text."""
    result = await client.call_tool(tool, arguments)
    assert isinstance(result, CallToolResult)
    [content] = result.content
    assert isinstance(content, TextContent)
    return bool(result.is_error), content.text


class ServerTest(unittest.IsolatedAsyncioTestCase):
    """The server with the example cells as root."""

    async def test_both_revisions_offer_the_same_tools(self) -> None:
        for initialized in (True, False):
            async with session(EXAMPLES, initialized=initialized) as client:
                listed = await client.list_tools()
                self.assertEqual({tool.name for tool in listed.tools}, READING)
                for tool in listed.tools:
                    assert tool.annotations is not None
                    hints = tool.annotations
                    self.assertEqual((hints.read_only_hint, hints.destructive_hint), (True, False))
                    self.assertEqual((hints.idempotent_hint, hints.open_world_hint), (True, False))
                error, text = await call(client, "eval", code="1+2")
                self.assertEqual((error, "3" in text), (False, True))

    async def test_tools_that_change_files_have_to_be_requested(self) -> None:
        async with session(EXAMPLES, "--write") as client:
            listed = await client.list_tools()
            self.assertEqual({tool.name for tool in listed.tools}, READING | WRITING)
            size = len(listed.model_dump_json(by_alias=True, exclude_none=True))
            self.assertLessEqual(size, 9_000)
        async with session(EXAMPLES) as client:
            error, text = await call(client, "write_program", path=".", text="")
            self.assertEqual((error, "there is no tool" in text), (True, True))

    async def test_an_offer_can_be_restricted(self) -> None:
        async with session(EXAMPLES, "--tools", "check,explain") as client:
            listed = await client.list_tools()
            self.assertEqual([tool.name for tool in listed.tools], ["explain", "check"])

    async def test_each_tool_that_reads(self) -> None:
        async with session(EXAMPLES) as client:
            error, text = await call(client, "outline", path=PALLETISER, program="pick")
            self.assertFalse(error)
            self.assertIn("begin", text)
            self.assertNotIn("CDATA", text)
            error, text = await call(client, "check", path=SORTER, max=3)
            self.assertEqual((error, text.startswith("not ok: 9 errors")), (False, True))
            self.assertIn(f"{SORTER}/", text)
            error, text = await call(client, "explain", topic="movel")
            self.assertIn("movel", text)
            error, text = await call(client, "explain", topic="guide")
            self.assertIn("VAL 3 in two pages", text)
            error, text = await call(client, "explain", topic="blend approach")
            self.assertIn("best first", text)
            error, text = await call(client, "run", path=PALLETISER, until=3, power=True, set={"mFast.vel": 50})
            self.assertEqual((error, "limit after 3.000 s" in text), (False, True))
            error, text = await call(client, "test", path="palletiser")
            self.assertEqual((error, text.startswith("ok: ")), (False, True), text)

    async def test_tests_and_files_that_cannot_be_used_are_in_the_answer(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            cell = Path(folder) / "palletiser"
            shutil.copytree(EXAMPLES / "palletiser", cell)
            (cell / "tests/zz.toml").write_text(
                'application = "../usr/usrapp/palletiser"\n[expect]\nxyz = 1\n', encoding="utf-8"
            )
            async with session(Path(folder)) as client:
                error, text = await call(client, "test", path="palletiser", filter="zz")
                self.assertEqual((error, text.startswith("not ok: 0 passed, 1 failed")), (False, True), text)
                self.assertIn("unknown field `xyz`", text)
                error, text = await call(client, "test", path="palletiser", filter="nothing")
                self.assertEqual((error, "nothing" in text), (True, True), text)
                grip = cell / "usr/usrapp/partBag/grip.pgx"
                grip.unlink()
                os.mkfifo(grip)
                error, text = await call(client, "check", path="palletiser")
                self.assertEqual((error, text.startswith("not ok: "), "V0502" in text), (False, True, True), text)

    async def test_text_of_a_script_is_accepted(self) -> None:
        async with session(EXAMPLES) as client:
            _, text = await call(client, "run", path=PALLETISER, until=3, script="[[at]]\nt = 0.5\npower = true\n")
            [production] = [line for line in text.splitlines() if line.startswith("task `production`")]
            self.assertNotIn("no power", production)
            error, text = await call(client, "run", path=PALLETISER, script="[[at]]\nt = true\n")
            self.assertEqual((error, "script.toml" in text), (True, True), text)
            self.assertNotIn("/tmp", text)

    async def test_wrong_arguments_have_the_right_form(self) -> None:
        async with session(EXAMPLES) as client:
            wrong: list[tuple[str, dict[str, Any]]] = [
                ("explain", {}),
                ("check", {"path": 3}),
                ("run", {"until": 1e9}),
                ("eval", {"x": 1}),
            ]
            for tool, arguments in wrong:
                error, text = await call(client, tool, **arguments)
                self.assertTrue(error, tool)
                self.assertIn("rite ", text)
            error, text = await call(client, "outline", path="palletiser", program="pikc")
            self.assertTrue(error)
            error, text = await call(client, "outline", path=PALLETISER, program="pikc")
            self.assertEqual((error, "did you mean `pick`" in text), (True, True), text)

    async def test_paths_outside_are_refused(self) -> None:
        attacks = ["..", "../crates", "/etc", "/etc/passwd", "file:///etc", "palletiser/../../docs", "C:\\", "a\0b", "--help", ""]
        async with session(EXAMPLES) as client:
            for path in attacks:
                for tool in ("check", "outline", "run", "test"):
                    error, text = await call(client, tool, path=path)
                    self.assertTrue(error, f"{tool} {path!r}: {text}")
                error, _ = await call(client, "eval", code="1", path=path)
                self.assertTrue(error)
            for script in ("/etc/passwd", "../Cargo.toml"):
                error, _ = await call(client, "run", path=PALLETISER, script=script)
                self.assertTrue(error)
            error, _ = await call(client, "run", path=PALLETISER, arm="/etc/passwd")
            self.assertTrue(error)

    async def test_programs_without_end_are_ended(self) -> None:
        async with session(EXAMPLES) as client:
            error, text = await call(client, "eval", code="num n=0\nwhile true\n  n=n+1\nendWhile")
            self.assertEqual((error, "wall time" in text), (True, True), text)
            error, text = await call(client, "eval", code="2+2")
            self.assertIn("4", text)

    async def test_a_cancelled_call_ends(self) -> None:
        async with session(EXAMPLES) as client:
            endless = asyncio.create_task(call(client, "eval", code="while true\nendWhile"))
            await asyncio.sleep(0.5)
            endless.cancel()
            begun = asyncio.get_running_loop().time()
            _, text = await call(client, "eval", code="2+2")
            self.assertIn("4", text)
            self.assertLess(asyncio.get_running_loop().time() - begun, 5)

    async def test_a_flood_of_calls_is_answered(self) -> None:
        async with session(EXAMPLES) as client:
            answers = await asyncio.gather(*(call(client, "eval", code="1") for _ in range(200)))
            refused = [text for error, text in answers if error]
            self.assertGreater(len(answers) - len(refused), 60)
            self.assertTrue(all("calls have no answer yet" in text for text in refused))

    async def test_prompts_and_resources(self) -> None:
        for initialized in (True, False):
            async with session(EXAMPLES, initialized=initialized) as client:
                prompts = await client.list_prompts()
                self.assertEqual(len(prompts.prompts), 3)
                prompt = await client.get_prompt("review-cell", {"path": "palletiser"})
                self.assertIn("palletiser", prompt.model_dump_json())
                with self.assertRaises(MCPError):
                    await client.get_prompt("review-cell", {})
                resource = await client.read_resource("val3://explain/movej")
                self.assertIn("movej", resource.model_dump_json())
                with self.assertRaises(MCPError):
                    await client.read_resource("val3://explain/pneumatics")


class BudgetTest(unittest.IsolatedAsyncioTestCase):
    """Sizes of answers."""

    async def test_answers_have_the_size_of_a_screen(self) -> None:
        sizes: list[int] = []
        async with session(EXAMPLES) as client:
            for path in ("palletiser", "faulty"):
                cell = EXAMPLES / path / "usr/usrapp"
                calls: list[tuple[str, dict[str, Any]]] = [("check", {"path": path}), ("test", {"path": path})]
                for project in sorted(cell.iterdir()):
                    here = str(project.relative_to(EXAMPLES))
                    calls += [("outline", {"path": here}), ("check", {"path": here, "motion": True})]
                    programs = sorted(project.glob("*.pgx"))
                    calls += [("outline", {"path": here, "program": program.stem}) for program in programs]
                    if (project / "start.pgx").exists():
                        calls.append(("run", {"path": here, "power": True}))
                for tool, arguments in calls:
                    _, text = await call(client, tool, **arguments)
                    sizes.append(len(text.encode()))
            for topic in ("guide", "movej", "mdesc", "V0101", "20", "father", "sio", "speed of a move"):
                _, text = await call(client, "explain", topic=topic)
                sizes.append(len(text.encode()))
            _, text = await call(client, "check", path="faulty", max=1000, detail=True)
            self.assertLessEqual(len(text.encode()), LONG)
        sizes.sort()
        self.assertLessEqual(sizes[len(sizes) * 95 // 100], SHORT)
        self.assertLessEqual(sizes[-1], LONG)


class WritingTest(unittest.IsolatedAsyncioTestCase):
    """Tools that change files, in a copy of the examples."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        shutil.copytree(EXAMPLES / "palletiser", self.root / "palletiser")

    def files(self) -> dict[str, bytes]:
        """Return all files with their bytes."""
        return {str(path): path.read_bytes() for path in sorted(self.root.rglob("*")) if path.is_file()}

    async def test_a_program_and_its_data_are_written(self) -> None:
        text = "program wave(num x_nTimes)\n  num l_n\nbegin\n  for l_n=1 to x_nTimes\n    nWaves=nWaves+1\n  endFor\nend"
        async with session(self.root, "--write") as client:
            before = self.files()
            error, answer = await call(client, "write_program", path=PALLETISER, text=text, dry_run=True)
            self.assertFalse(error, answer)
            self.assertIn("V0101", answer)
            self.assertTrue(answer.startswith("not ok: nothing was written"), answer)
            self.assertEqual(self.files(), before)
            error, answer = await call(client, "write_data", path=PALLETISER, name="nWaves", type="num", values={"0": 2})
            self.assertEqual((error, answer.startswith("ok: written")), (False, True), answer)
            error, answer = await call(client, "write_program", path=PALLETISER, text=text)
            self.assertEqual((error, "wave.pgx" in answer), (False, True), answer)
            after = self.files()
            error, answer = await call(client, "write_program", path=PALLETISER, text=text)
            self.assertIn("nothing changes", answer)
            self.assertEqual(self.files(), after)
            error, answer = await call(client, "eval", path=PALLETISER, code="call wave(3)\nnWaves")
            self.assertIn("5", answer)
            error, answer = await call(client, "outline", path=PALLETISER, program="wave")
            self.assertIn("program wave(num x_nTimes)", answer)

    async def test_a_name_is_renamed_everywhere(self) -> None:
        async with session(self.root, "--write") as client:
            error, answer = await call(client, "rename", path=PALLETISER, name="pick", to="grasp")
            self.assertFalse(error, answer)
            self.assertFalse((self.root / PALLETISER / "pick.pgx").exists())
            self.assertTrue((self.root / PALLETISER / "grasp.pgx").exists())
            error, answer = await call(client, "check", path="palletiser")
            self.assertTrue(answer.startswith("ok: 0 errors"), answer)
            error, answer = await call(client, "rename", path=PALLETISER, name="grasp", to="if")
            self.assertTrue(error, answer)

    async def test_a_new_folder_becomes_an_application(self) -> None:
        async with session(self.root, "--write") as client:
            path = "palletiser/usr/usrapp/waver"
            text = "program start()\nbegin\n  putln(\"hello\")\nend"
            error, answer = await call(client, "write_program", path=path, text=text)
            self.assertFalse(error, answer)
            error, answer = await call(client, "run", path=path)
            self.assertIn("hello", answer)

    async def test_nothing_outside_is_written(self) -> None:
        async with session(self.root / "palletiser", "--write") as client:
            before = self.files()
            for path in ("..", "/tmp", "../other", "usr/../../other"):
                for tool, arguments in (
                    ("write_program", {"text": "program a()\nbegin\nend"}),
                    ("write_data", {"name": "nA", "type": "num"}),
                    ("rename", {"name": "pick", "to": "grasp"}),
                ):
                    error, answer = await call(client, tool, path=path, **arguments)
                    self.assertTrue(error, answer)
            self.assertEqual(self.files(), before)


class FloodTest(unittest.TestCase):
    """Messages that no client sends."""

    def serve(self, text: bytes) -> subprocess.CompletedProcess[bytes]:
        command = [val3.find_binary(), "mcp", "--root", str(EXAMPLES)]
        return subprocess.run(command, input=text, capture_output=True, timeout=60)

    def test_nonsense_does_not_end_the_server(self) -> None:
        client = {"name": "test", "version": "1"}
        opening = {"protocolVersion": "2025-11-25", "capabilities": {}, "clientInfo": client}
        requests = [
            json.dumps({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": opening}).encode(),
            json.dumps({"jsonrpc": "2.0", "method": "notifications/initialized"}).encode(),
            b"nonsense",
            b"[" * 100_000,
            b"\xff\xfe\x00",
            b'{"jsonrpc": "2.0", "id": 2, "method": "tools/call", "params": {"name": 3}}',
            b'{"jsonrpc": "2.0", "id": 3, "method": "tools/call", "params": {"name": "eval", "arguments": {"code": "1+1"}}}',
        ]
        done = self.serve(b"\n".join(requests) + b"\n")
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertTrue(any(answer.get("id") == 1 and "result" in answer for answer in answers), done)

    def test_a_message_without_end_is_refused(self) -> None:
        done = self.serve(b'{"jsonrpc": "' + b"a" * (16 << 20))
        self.assertLess(len(done.stdout), 10_000)


if __name__ == "__main__":
    unittest.main()
