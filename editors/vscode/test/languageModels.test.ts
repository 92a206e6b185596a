import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, test } from "node:test";
import * as vscode from "vscode";
import { PROVIDER, registerTools } from "../src/languageModels";

interface Definition {
  label: string;
  command: string;
  args: string[];
}

/** The stand-in, with the parts of newer editors. */
const editor = vscode as unknown as Record<string, unknown> & { workspace: { workspaceFolders?: object[] } };

afterEach(() => {
  delete editor.version;
  delete editor.lm;
  delete editor.McpStdioServerDefinition;
  delete editor.workspace.workspaceFolders;
});

/** Servers that an editor receives for folders; `undefined` if nothing is registered. */
function offered(command: string | undefined, folders: string[], version = "1.101.0"): Definition[] | undefined {
  let found: Definition[] | undefined;
  editor.version = version;
  editor.McpStdioServerDefinition = class {
    constructor(readonly label: string, readonly command: string, readonly args: string[]) {}
  };
  editor.lm = {
    registerMcpServerDefinitionProvider: (id: string, provider: { provideMcpServerDefinitions(): Definition[] }) => {
      assert.equal(id, PROVIDER);
      found = provider.provideMcpServerDefinitions();
      return new vscode.Disposable(() => undefined);
    },
  };
  const folder = (path: string): object => ({ name: path.slice(1), uri: vscode.Uri.parse(`file:${path}`) });
  editor.workspace.workspaceFolders = folders.map(folder);
  registerTools({ command });
  return found;
}

test("each folder has a server", () => {
  const [first, second] = offered("/bin/val3", ["/a", "/b"]) ?? [];
  assert.deepEqual([first?.label, second?.label], ["VAL 3: a", "VAL 3: b"]);
  assert.deepEqual([first?.command, first?.args], ["/bin/val3", ["mcp", "--root", "/a"]]);
  assert.equal(offered("/bin/val3", ["/a"])?.[0]?.label, "VAL 3");
});

test("without a command or a folder there is no server", () => {
  assert.deepEqual([offered(undefined, ["/a"]), offered("/bin/val3", [])], [[], []]);
});

test("older editors have no servers", () => {
  editor.version = "1.95.0";
  assert.deepEqual(registerTools({ command: "/bin/val3" }), []);
  // It has the function, but only for extensions with a proposed interface.
  assert.equal(offered("/bin/val3", ["/a"], "1.100.3"), undefined);
});

test("the manifest names the provider", () => {
  const manifest = JSON.parse(readFileSync(join(__dirname, "../../package.json"), "utf8")) as {
    contributes: { mcpServerDefinitionProviders: { id: string }[] };
  };
  assert.deepEqual(manifest.contributes.mcpServerDefinitionProviders.map(({ id }) => id), [PROVIDER]);
});
