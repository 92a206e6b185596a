// The view of the robot in VS Code: opened from the tables, without an editor and from the view VAL 3; the point of the
// selected row; and a session that is started, stopped and continued next to it.
const assert = require("node:assert/strict");
const { cpSync, mkdtempSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");
const { Tables } = require("./tables");

const folder = mkdtempSync(join(tmpdir(), "val3-robot-"));
const cell = join(folder, "cell");
cpSync(join(process.env.VAL3_ROOT, "examples/palletiser/usr"), join(cell, "usr"), { recursive: true });

const APPLICATION = '.part.sidebar .pane-body [role="tree"] .monaco-list-row[aria-label^="palletiser, application"]';

/** Returns the page of the robot, which shows the arm of the palletiser. */
const robot = (user) => user.frameWith("TX90L");

/** Waits until the page has this role: `preview` without a session. */
const role = (view, role) => view.waitForFunction((role) => window.val3View.store.scene.value?.role === role, role);

const starts = (user) => user.page.waitForSelector(".debug-toolbar");

async function stops(user) {
  await user.tool("Stop");
  await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
}

const STEPS = {
  async "without an open editor, the only application is shown"(user) {
    await user.command("VAL 3: Show Robot");
    const view = await robot(user);
    await role(view, "preview");
    await view.getByRole("status", { name: "Status" }).getByText("The application does not run.").waitFor();
    await view.getByRole("tab", { name: "Points" }).click();
    await view.getByRole("button", { name: "pSafe", exact: true }).waitFor();
  },

  async "an editor that is opened later appears next to the view"(user) {
    await user.openFile("start.pgx");
    await user.page.waitForFunction(() => document.querySelectorAll(".editor-group-container").length === 2);
    assert.ok(await (await robot(user)).locator("canvas").first().isVisible());
    await user.closesTab("Robot");
    await user.command("View: Close All Editors");
    await user.page.waitForSelector(".tab", { state: "detached" });
  },

  async "the tables show the robot of their application, and the point of the selected row"(user) {
    const tables = await Tables.open(user, "palletiser.dtx");
    await user.page.click('.editor-actions .action-label[aria-label^="Show Robot"]');
    const view = await robot(user);
    await role(view, "preview");
    await view.getByRole("tab", { name: "Points" }).click();
    await tables.type("pointRx");
    await tables.select("pSafe", "Name");
    await view.getByRole("form", { name: "Values of pSafe" }).waitFor();
    await view.locator(".names .name.selected").getByText("pSafe").waitFor();
    await tables.select("pPick", "Name");
    await view.getByRole("form", { name: "Values of pPick" }).waitFor();
    await tables.type("frame");
    await tables.select("fConveyor", "Name");
    await view.waitForFunction(() => JSON.stringify(window.val3View.store.selection.value) === '{"kind":"frame","name":"fConveyor"}');
    await user.command("View: Close All Editors");
    await user.page.waitForSelector(".tab", { state: "detached" });
  },

  async "the view VAL 3 shows the robot of an application"(user) {
    // The view stays visible next to an editor, in which the stopped line appears.
    await user.openFile("start.pgx");
    await user.command("View: Show VAL 3");
    await user.page.click(APPLICATION, { button: "right" });
    await user.picks("Show Robot");
    await role(await robot(user), "preview");
  },

  async "the preview runs the application"(user) {
    const view = await robot(user);
    await view.getByRole("button", { name: "Run", exact: true }).click();
    await starts(user);
    await role(view, "debugger");
    await view.getByText("Run by the debugger", { exact: true }).waitFor();
    await view.waitForFunction(() => window.val3View.store.newest.value > 0.5);
    await stops(user);
    await role(view, "preview");
  },

  async "the preview debugs the application, and its bar tells when the debugger stops it"(user) {
    const view = await robot(user);
    await view.getByRole("button", { name: "Debug", exact: true }).click();
    await starts(user);
    await role(view, "debugger");
    await user.pauses();
    await view.getByText("Stopped by the debugger", { exact: true }).waitFor();
    await view.getByRole("status", { name: "Status" }).getByText("The debugger has stopped the run.").waitFor();
    assert.equal(await view.getByRole("button", { name: "Stopped", exact: true }).count(), 1);
    assert.equal(await view.getByRole("button", { name: "Pause", exact: true }).count(), 0);
    const stopped = await view.evaluate(() => window.val3View.store.newest.value);
    await user.tool("Continue");
    await view.getByText("Run by the debugger", { exact: true }).waitFor();
    await view.waitForFunction((stopped) => window.val3View.store.newest.value > stopped, stopped);
    await stops(user);
  },
};

runSteps({ name: "robot", folder, open: `folder=${cell}`, steps: STEPS });
