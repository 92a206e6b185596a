// A user looks at the values that variables have had: as a list and a plot beside the code, at several moments of a run,
// and at the elements of an array as a table.
const assert = require("node:assert/strict");
const { mkdtempSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { Application } = require("../dap/application");
const { runSteps } = require("./steps");

const app = new Application("counter", {
  data: { "num nSquare": "", "joint jWork": "", "string sState": "", "joint jMany[3]": "" },
  programs: `
program start()
  num l_nAt
begin
  sState="counts"
  for l_nAt=1 to 12
    nSquare=l_nAt*l_nAt
    jWork.j1=10*l_nAt
    jWork.j3=90-5*l_nAt
    jMany[1]=jWork
    delay(0.1)
  endFor
  sState="done"
  nSquare=0
end
`,
});
const SQUARE = app.line("start", "nSquare=l_nAt");

/** Returns the frame of a variable's history or table, which the context menu of *Variables* opens. */
async function opens(user, name, [command, title, content] = ["Show History of Variable", "History of", "[role=grid]"]) {
  const row = user.page.locator(".debug-variables .monaco-list-row", { hasText: `${name} =` }).first();
  const item = user.page.locator(".monaco-menu .action-label", { hasText: command });
  const tab = user.page.locator(`.tab[aria-label^="${title} counter:${name}"]`);
  // The list may be redrawn some time after a stop, which closes the menu, and a new menu ignores clicks.
  for (let attempt = 0; attempt < 5 && !(await tab.isVisible()); attempt += 1) {
    await user.keys("Escape");
    await row.click({ button: "right" });
    await item.click({ timeout: 5000, delay: 100 }).catch(() => {});
    await tab.waitFor({ timeout: 10_000 }).catch(() => {});
  }
  const frame = await user.frameWith(`counter:${name}`);
  await frame.waitForSelector(content);
  return frame;
}

const rows = (frame) => frame.locator("tbody tr:not(.spacer)").allInnerTexts();
const selected = (frame) => frame.locator("[role=slider]").getAttribute("aria-valuetext");

/** Returns the number of pixels with a colour of a line in the plot. */
const plotted = (frame, line) => frame.evaluate((line) => {
  const canvas = document.querySelector("canvas");
  const probe = document.createElement("canvas").getContext("2d");
  probe.fillStyle = getComputedStyle(canvas).getPropertyValue(`--plot-${line}`).trim();
  probe.fillRect(0, 0, 1, 1);
  const [red, green, blue] = probe.getImageData(0, 0, 1, 1).data;
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let at = 0; at < data.length; at += 4) {
    count += data[at] === red && data[at + 1] === green && data[at + 2] === blue && data[at + 3] === 255 ? 1 : 0;
  }
  return count;
}, line);

let number;

const STEPS = {
  async "a run stops before its end"(user) {
    await user.openFile("start.pgx");
    await user.keys("F5");
    await user.page.waitForSelector(".editor-instance .debug-top-stack-frame-line");
    // The view of the robot opens with the first session.
    await user.closesTab("Robot");
    await user.views("Variables");
    await user.opensVariable("Globals", "nSquare =");
    // The panel below would hide most of the history.
    await user.command("View: Toggle Panel Visibility");
  },

  async "the code shows present values after its lines"(user) {
    await user.page.locator(".editor-instance .view-line", { hasText: /nSquare=0\s+nSquare\s=\s0/ }).first().waitFor();
    await user.page.locator(".editor-instance .view-line", { hasText: /sState="done"\s+sState\s=\s"done"/ }).first().waitFor();
  },

  async "the history of a number is a list and a plot"(user) {
    number = await opens(user, "nSquare");
    const [last, before, ...rest] = await rows(number);
    assert.match(last, /^1\.\d{3} s\t0\tstart:\d+\tcounter~$/);
    assert.match(before, new RegExp(`^1\\.\\d{3} s\\t144\\tstart:${SQUARE}\\tcounter~$`));
    assert.equal(rest.length, 12);
    assert.match(rest.at(-1), /^0\.000 s\t0\tbefore these writes/);
    assert.ok(await plotted(number, 1) > 200, "no line is drawn");
    assert.equal(await plotted(number, 2), 0);
  },

  async "a click opens the line, and the history stays open"(user) {
    await number.locator("tr", { hasText: "144" }).click();
    await user.page.waitForSelector(`.editor-group-container .editor-instance .view-line:has-text("nSquare=l_nAt*l_nAt")`);
    assert.match(await selected(number), new RegExp(`^144, 1\\.\\d{3} s, start:${SQUARE}$`));
    await number.locator("[role=grid]").focus();
    await number.locator("[role=grid]").press("Enter");
    await user.page.waitForSelector(`.statusbar-item [aria-label^="Ln ${SQUARE}, Col "]`);
    assert.equal(await user.page.locator('.tab[aria-label^="History of counter:nSquare"]').count(), 1);
  },

  async "a click in the plot selects the write in the list"(user) {
    const plot = await number.locator("[role=slider]").boundingBox();
    await number.locator("[role=slider]").click({ position: { x: 72 + (plot.width - 82) / 2, y: 60 } });
    const [row] = await number.locator("tr[aria-selected=true]").allInnerTexts();
    assert.match(row, /^0\.[56]\d\d s\t(36|49)\t/);
  },

  async "the history of a joint has a line for each axis"(user) {
    await user.focusEditor();
    const joint = await opens(user, "jWork");
    // With the heading and the value before all writes.
    assert.equal(await joint.locator("[role=grid]").getAttribute("aria-rowcount"), "26");
    // The other axes do not move and cover each other.
    for (const line of [1, 3]) {
      assert.ok(await plotted(joint, line) > 100, `axis ${line} is not drawn`);
    }
    await joint.getByRole("button", { name: "j1" }).click();
    await joint.waitForFunction(() => document.querySelector('button[aria-pressed="false"]') !== null);
    assert.equal(await plotted(joint, 1), 0);
    await joint.getByRole("button", { name: "j1" }).click();
  },

  async "a string has a list only"(user) {
    await user.focusEditor();
    const text = await opens(user, "sState");
    assert.deepEqual((await rows(text)).map((row) => row.split("\t")[1]), ['"done"', '"counts"', '""']);
    await text.getByText("Values of the type string are listed without a plot.").waitFor();
    await user.closesTab("History of counter:sState");
    await user.closesTab("History of counter:jWork");
  },

  async "an array is a table with a column for each axis"(user) {
    await user.focusEditor();
    const table = await opens(user, "jMany", ["Show as Table", "Table of", "table"]);
    assert.deepEqual(await table.locator("th").allInnerTexts(), ["Index", ...[1, 2, 3, 4, 5, 6].map((axis) => `j${axis} (°)`)]);
    assert.equal(await table.locator("tr", { hasText: "[1]" }).innerText(), "[1]\t120\t0\t30\t0\t0\t0");
    assert.ok(await plotted(table, 1) > 20, "axis 1 is not drawn over the index");
    await user.closesTab("Table of counter:jMany");
  },

  async "a filter shows only some variables"(user) {
    await user.focusEditor();
    await user.command("VAL 3: Filter Variables…");
    const input = user.page.locator(".quick-input-widget input:visible");
    await input.fill("j");
    await input.press("Enter");
    const row = (text) => user.page.locator(".debug-variables .monaco-list-row", { hasText: text }).first();
    await row("nSquare =").waitFor({ state: "detached" });
    await row("jWork =").waitFor();
    await user.command("VAL 3: Filter Variables…");
    await input.fill("");
    await input.press("Enter");
    await row("nSquare =").waitFor();
  },

  async "after a step back the history ends at the present"(user) {
    await user.focusEditor();
    await user.tool("Step Back");
    await number.waitForFunction(() => !/\t0\tstart/.test(document.querySelector("tbody tr:not(.spacer)").innerText));
    assert.match((await rows(number))[0], /\t144\t/);
    assert.equal(await number.locator(".present").innerText(), "present: 1.200 s");
    const later = number.waitForFunction(() => document.querySelector(".present").innerText === "present: 1.100 s");
    for (let line = 0; line < 4; line += 1) {
      await user.tool("Step Back");
      await user.page.waitForTimeout(500);
    }
    await later;
  },

  async "the plot has the colours of the theme"(user) {
    await user.command("Preferences: Toggle between Light/Dark Themes");
    await user.page.waitForSelector(".monaco-workbench.vs-dark");
    await number.waitForFunction(() => document.body.classList.contains("vscode-dark"));
    await user.page.waitForTimeout(300);
    assert.ok(await plotted(number, 1) > 200, "the line has not the new colour");
  },

  async "the end of the session is stated"(user) {
    await user.focusEditor();
    await user.keys("Shift+F5");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
    await number.getByText("This is the history of another debug session.").waitFor();
  },
};

runSteps({ name: "history", folder: mkdtempSync(join(tmpdir(), "val3-history-")), open: `folder=${app.cell}`, steps: STEPS });
