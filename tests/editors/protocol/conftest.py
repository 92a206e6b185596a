"""The server over its standard input and output, with the capabilities that VS Code, Neovim and Emacs have."""

import os
import pathlib
import shutil
import sys

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities, make_test_lsp_client

ROOT = pathlib.Path(os.environ["VAL3_ROOT"])
OUTPUT = pathlib.Path(os.environ["VAL3_OUTPUT"])
os.environ["VAL3_TRACE"] = str(OUTPUT / "traces" / "protocol.jsonl")

RECORD = [sys.executable, str(ROOT / "tests/editors/record"), "lsp"]


def make_client():
    """A client that accepts registrations of the server."""
    client = make_test_lsp_client()
    for method in [types.CLIENT_REGISTER_CAPABILITY, types.CLIENT_UNREGISTER_CAPABILITY]:
        client.feature(method)(lambda *_: None)
    return client


@pytest.fixture
def cell(tmp_path):
    """A copy of the example cell; the path of its application."""
    shutil.copytree(ROOT / "examples/palletiser/usr", tmp_path / "cell/usr")
    return tmp_path / "cell/usr/usrapp/palletiser"


@pytest_lsp.fixture(
    params=["visual-studio-code", "neovim", "emacs"],
    config=ClientServerConfig(server_command=RECORD, client_factory=make_client),
)
async def client(request, cell, lsp_client: LanguageClient):
    params = types.InitializeParams(
        capabilities=client_capabilities(request.param),
        process_id=os.getpid(),
        root_uri=cell.as_uri(),
        workspace_folders=[types.WorkspaceFolder(uri=cell.as_uri(), name="cell")],
    )
    await lsp_client.initialize_session(params)
    yield
    await lsp_client.shutdown_session()


def pytest_terminal_summary(terminalreporter):
    """The line that the project's test command counts."""
    passed = len(terminalreporter.stats.get("passed", []))
    failed = sum(len(terminalreporter.stats.get(kind, [])) for kind in ["failed", "error"])
    word = "ok" if failed == 0 else "FAILED"
    terminalreporter.write_line(f"test result: {word}. {passed} passed; {failed} failed; protocol")
