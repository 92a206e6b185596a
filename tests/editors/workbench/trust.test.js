// A folder that the user does not trust is checked and shown, but not executed. Trusting it needs no reload.
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const { cpSync, mkdtempSync, readFileSync, realpathSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");

const folder = realpathSync(mkdtempSync(join(tmpdir(), "val3-trust-")));
const cell = join(folder, "cell");
cpSync(join(process.env.VAL3_ROOT, "examples/palletiser/usr"), join(cell, "usr"), { recursive: true });
execFileSync(process.env.VAL3_SERVER, ["test", "--init", join(cell, "usr/usrapp/partBox")], { stdio: "ignore" });

/** Returns the `val3` commands that VS Code has started. */
const started = () => new Set(readFileSync(join(folder, "commands.log"), "utf8").split("\n").filter((command) => command !== ""));

const lens = (text) => `.codelens-decoration a:text-is(${JSON.stringify(text)})`;
/** Icon of the Testing view, which VS Code shows when an extension has tests. */
const TESTING = ".activitybar .action-item:has(.codicon-test-view-icon)";

const STEPS = {
  async "programs of the folder are checked"(user) {
    await user.page.waitForSelector('.statusbar-item:has-text("Restricted Mode")');
    await user.openFile("start.pgx");
    await user.page.waitForSelector('.codelens-decoration:has-text("references")');
    await user.goTo(5, 9);
    await user.hovers("init");
    assert.equal(await user.page.locator(`${lens("Run")}, ${lens("Debug")}`).count(), 0);
  },

  async "there are no tests and no view of the robot"(user) {
    assert.equal(await user.page.locator(TESTING).count(), 0);
    await user.keys("F1");
    await user.page.waitForSelector(".quick-input-widget:visible");
    await user.type("VAL 3: ");
    await user.page.waitForSelector('.quick-input-list .monaco-list-row:has-text("VAL 3: Check Workspace")');
    assert.equal(await user.page.locator('.quick-input-list .monaco-list-row:has-text("Robot")').count(), 0);
    await user.keys("Escape");
  },

  async "the view of the controller asks for trust"(user) {
    await user.command("View: Show VAL 3");
    const pane = '.pane:has(.pane-header[aria-label^="Controller"])';
    await user.page.click(`${pane} .pane-header`);
    await user.page.waitForSelector(`${pane} .monaco-button:has-text("Manage Workspace Trust")`);
    await user.page.click(`${pane} .pane-header`);
  },

  async "the debugger asks for trust"(user) {
    await user.openFile("start.pgx");
    await user.keys("F5");
    await user.page.waitForSelector('.monaco-dialog-box:has-text("trust")');
    await user.page.click('.monaco-dialog-box .monaco-button:has-text("Cancel")');
    await user.page.waitForSelector(".monaco-dialog-box", { state: "hidden" });
    assert.deepEqual(started(), new Set(["lsp"]));
  },

  async "trusting the folder turns everything on"(user) {
    await user.command("Workspaces: Manage Workspace Trust");
    await user.page.click('.workspace-trust-editor .monaco-button:text-is("Trust")');
    await user.openFile("start.pgx");
    await user.page.waitForSelector(lens("Debug"));
    await user.page.click(TESTING);
    await user.page.waitForSelector(".test-explorer .monaco-list-row");
    await user.openFile("start.pgx");
    await user.opensLens("Debug", ".debug-toolbar");
    await user.keys("Shift+F5");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
    assert.ok(started().has("test") && started().has("dap"));
  },
};

runSteps({ name: "trust", folder, open: `folder=${cell}`, steps: STEPS, showsDialogs: true, isRestricted: true });
