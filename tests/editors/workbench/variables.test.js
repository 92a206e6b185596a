// The table of parameters and locals next to a program, with only the keyboard: the changed files are compared byte for
// byte.
const assert = require("node:assert/strict");
const { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");

const EXAMPLE = join(process.env.VAL3_ROOT, "examples/palletiser");
const folder = mkdtempSync(join(tmpdir(), "val3-variables-"));
const cell = join(folder, "cell");
const APPLICATION = join(cell, "usr/usrapp/palletiser");
const SETTINGS = join(cell, ".vscode/settings.json");

const read = (name) => readFileSync(join(APPLICATION, name), "utf8");

/** Expected texts of the files that the test changes. */
const FILES = {};

/** An s6 program in ISO-8859-1, with Windows line ends. */
const OLD = ['<?xml version="1.0" encoding="iso-8859-1" ?>', '<programList xmlns="ProgramNameSpace" >', '  <program name="old" public="false" >',
  "    <description></description>", "    <paramSection/>", "    <localSection/>", "    <source><code>begin", "  // caf\u00e9", "  put(1&lt;2)", "end", "    </code></source>",
  "  </program>", "</programList>"].join("\r\n");

/** Sets the expected text of a file by replacements, each of which must apply. */
function expect(name, ...replacements) {
  FILES[name] = replacements.reduce((text, [before, now]) => {
    assert.ok(text.includes(before), `${name} has no ${before}`);
    return text.replace(before, now);
  }, FILES[name] ?? read(name));
}

/** Saves all files and waits until they have their expected bytes. */
async function saved(user) {
  for (const [name, expected] of Object.entries(FILES)) {
    for (let attempt = 0; attempt < 60 && read(name) !== expected; attempt += 1) {
      await user.command("File: Save All Files");
      await user.page.waitForTimeout(100);
    }
    assert.equal(read(name), expected, name);
  }
}

/** Returns the frame of the table that shows this text. */
const table = (user, text) => user.frameWith(text);

/** Focuses the table with VS Code's command for each view. */
async function focusView(user) {
  await user.command("VAL 3: Focus on Variables View");
}

/** Waits for a field of a row and focuses it. */
async function focusField(user, label) {
  const frame = await table(user, "Parameters");
  const hasFocus = () => frame.evaluate(() => document.hasFocus());
  if (!(await hasFocus())) {
    await focusView(user);
    await frame.waitForFunction(() => document.hasFocus());
  }
  await frame.locator(`[aria-label="${label}"]`).focus();
  return frame;
}

/** Waits until the first fields of a table have these values. */
async function names(user, list, expected) {
  const frame = await table(user, "Parameters");
  await frame.waitForFunction(([list, expected]) => {
    const fields = [...document.querySelectorAll(`.${list} tr[data-list] td.name input`)];
    return fields.map((field) => field.value).join() === expected;
  }, [list, expected.join()]);
}

async function refused(user, reason) {
  const frame = await table(user, "Parameters");
  await frame.waitForSelector(`tr.reason [role="alert"]:has-text(${JSON.stringify(reason)})`);
}

const STEPS = {
  async "the table follows the active program"(user) {
    await user.page.click('.activitybar [aria-label^="VAL 3"]');
    await user.openFile("place.pgx");
    await focusView(user);
    await names(user, "parameters", ["x_nRow", "x_nColumn", "x_bOk"]);
    await user.openFile("palletiser.dtx");
    await table(user, "Open a program to see its parameters and local variables.");
    await user.openFile("nextSlot.pgx");
    await names(user, "parameters", ["x_tSlots", "x_nRow", "x_nColumn", "x_bFound"]);
    await names(user, "locals", ["l_nColumn", "l_nRow"]);
  },

  async "the code view has the table of its program"(user) {
    await user.openFile("place.pgx");
    await user.command("VAL 3: Open Code without XML");
    await user.tab("place.pgx (code)");
    await names(user, "parameters", ["x_nRow", "x_nColumn", "x_bOk"]);
  },

  async "a parameter is renamed in the code"(user) {
    await focusField(user, "Name of parameter x_nColumn");
    await user.keys("Home", "Shift+End");
    await user.type("x_nLane");
    await user.keys("Enter");
    await names(user, "parameters", ["x_nRow", "x_nLane", "x_bOk"]);
    FILES["place.pgx"] = read("place.pgx").replaceAll("x_nColumn", "x_nLane");
    await saved(user);
  },

  async "a parameter moves with Alt+Up, and the call follows"(user) {
    const frame = await focusField(user, "Name of parameter x_nLane");
    await user.keys("Alt+ArrowUp");
    await names(user, "parameters", ["x_nLane", "x_nRow", "x_bOk"]);
    // The focus stays with the row.
    await frame.waitForFunction(() => document.activeElement?.value === "x_nLane");
    const line = (name) => `<Parameter name="${name}" type="num" xsi:type="element" />`;
    expect("place.pgx", [line("x_nRow"), "ONE"], [line("x_nLane"), line("x_nRow")], ["ONE", line("x_nLane")]);
    expect("cycle.pgx", ["call place(l_nRow,l_nColumn,x_bOk)", "call place(l_nColumn,l_nRow,x_bOk)"]);
    await saved(user);
  },

  async "a parameter that is used is not removed, and its row says why"(user) {
    await focusField(user, "Name of parameter x_nLane");
    await user.keys("Alt+Delete");
    await refused(user, "The parameter `x_nLane` is used");
    await saved(user);
  },

  async "a name that is taken is refused, and Escape takes it back"(user) {
    const frame = await focusField(user, "Name of parameter x_nLane");
    await user.keys("Home", "Shift+End");
    await user.type("x_bOk");
    await user.keys("Enter");
    await refused(user, "Two variables of the program would be called `x_bOk`");
    await user.keys("Escape");
    await frame.waitForSelector("tr.reason", { state: "detached" });
    await names(user, "parameters", ["x_nLane", "x_nRow", "x_bOk"]);
  },

  async "a type that does not suit is refused"(user) {
    const frame = await focusField(user, "Type of parameter x_nRow");
    await frame.locator('[aria-label="Type of parameter x_nRow"]').selectOption("string");
    await refused(user, "It would add an error in `cycle.pgx`");
    assert.equal(await frame.locator('[aria-label="Type of parameter x_nRow"]').inputValue(), "num");
  },

  async "a parameter is added, and the call passes its value"(user) {
    const frame = await focusField(user, "Name of parameter x_bOk");
    await frame.locator('button:has-text("Add parameter")').focus();
    await user.keys("Enter");
    await frame.waitForSelector("tr.new td.name input:focus");
    await user.keys("Enter");
    await refused(user, "A new variable needs a name.");
    await user.type("x_nSpeed");
    await frame.locator('[aria-label="Expression that callers pass"]').focus();
    await user.keys("Home", "Shift+End");
    await user.type("2*50");
    await user.keys("Enter");
    await names(user, "parameters", ["x_nLane", "x_nRow", "x_bOk", "x_nSpeed"]);
    const last = '<Parameter name="x_bOk" type="bool" xsi:type="element" use="reference" />';
    expect("place.pgx", [last, `${last}\n      <Parameter name="x_nSpeed" type="num" xsi:type="element" />`]);
    expect("cycle.pgx", ["call place(l_nColumn,l_nRow,x_bOk)", "call place(l_nColumn,l_nRow,x_bOk,2*50)"]);
    await saved(user);
  },

  async "its passing changes, as far as callers allow it"(user) {
    const frame = await focusField(user, "Passing of parameter x_nSpeed");
    await frame.locator('[aria-label="Passing of parameter x_nSpeed"]').selectOption("reference");
    await refused(user, "It would add an error in `cycle.pgx`");
  },

  async "it is removed without a trace"(user) {
    await focusField(user, "Name of parameter x_nSpeed");
    await user.keys("Alt+Delete");
    await names(user, "parameters", ["x_nLane", "x_nRow", "x_bOk"]);
    expect("place.pgx", ['\n      <Parameter name="x_nSpeed" type="num" xsi:type="element" />', ""]);
    expect("cycle.pgx", [",2*50", ""]);
    await saved(user);
  },

  async "locals are added, sized and moved"(user) {
    await user.openFile("nextSlot.pgx");
    await names(user, "locals", ["l_nColumn", "l_nRow"]);
    const frame = await focusField(user, "Name of local l_nRow");
    await frame.locator('button:has-text("Add local")').focus();
    await user.keys("Enter");
    await frame.waitForSelector("tr.new td.name input:focus");
    await user.type("l_nGrid");
    await user.keys("Enter");
    await names(user, "locals", ["l_nColumn", "l_nRow", "l_nGrid"]);
    await focusField(user, "Size of local l_nGrid");
    await user.keys("Home", "Shift+End");
    await user.type("three");
    await user.keys("Enter");
    await refused(user, "The size is one to three numbers");
    await user.keys("Home", "Shift+End");
    await user.type("3x4");
    await user.keys("Enter");
    await frame.waitForFunction(() => document.activeElement?.value === "3 x 4");
    await user.keys("Alt+ArrowUp");
    await names(user, "locals", ["l_nColumn", "l_nGrid", "l_nRow"]);
    const row = '      <Local name="l_nRow" type="num" xsi:type="array" size="1" />';
    expect("nextSlot.pgx", [row, `      <Local name="l_nGrid" type="num" xsi:type="array" size="3 4" />\n${row}`]);
    await saved(user);
  },

  async "programs that the controller calls keep their parameters"(user) {
    await user.openFile("start.pgx");
    const frame = await table(user, "The controller itself calls `start`, without arguments.");
    assert.equal(await frame.locator('button:has-text("Add parameter")').getAttribute("aria-disabled"), "true");
  },

  async "a program of s6 keeps its dialect, its encoding and its line ends"(user) {
    await user.openFile("old.pgx");
    await table(user, "The program has no local variables.");
    const frame = await table(user, "Add local");
    await focusView(user);
    await frame.waitForFunction(() => document.hasFocus());
    await frame.locator('button:has-text("Add local")').focus();
    await user.keys("Enter");
    await frame.waitForSelector("tr.new td.name input:focus");
    await user.type("l_nOld");
    await user.keys("Enter");
    await names(user, "locals", ["l_nOld"]);
    await user.command("File: Save All Files");
    const declared = '<localSection>\r\n      <local name="l_nOld" type="num" size="1" />\r\n    </localSection>';
    const expected = Buffer.from(OLD.replace("<localSection/>", declared), "latin1");
    const bytes = () => readFileSync(join(APPLICATION, "old.pgx"));
    for (let attempt = 0; attempt < 100 && !bytes().equals(expected); attempt += 1) {
      await user.page.waitForTimeout(100);
    }
    assert.equal(bytes().toString("latin1"), expected.toString("latin1"));
  },

  async "undo takes an edit back"(user) {
    await user.focusEditor();
    await user.keys("Control+Z");
    await table(user, "The program has no local variables.");
  },

  async "the table in a light theme"(user) {
    await user.openFile("place.pgx");
    await names(user, "parameters", ["x_nLane", "x_nRow", "x_bOk"]);
    await focusField(user, "Name of parameter x_nLane");
    await user.keys("Alt+Delete");
    await refused(user, "is used");
    writeFileSync(SETTINGS, JSON.stringify({ "workbench.colorTheme": "Default Light Modern" }));
    const frame = await table(user, "Parameters");
    await frame.waitForFunction(() => document.body.classList.contains("vscode-light"));
    await frame.locator('button:has-text("Add parameter")').focus();
    await user.keys("Enter");
    await frame.waitForSelector("tr.new");
  },

  async "the table in a wide side bar"(user) {
    const { x, y, height } = await user.page.locator(".part.sidebar").boundingBox();
    const edge = await user.page.locator(".part.sidebar").evaluate((bar) => bar.getBoundingClientRect().right);
    await user.page.mouse.move(edge, y + height / 2);
    await user.page.mouse.down();
    await user.page.mouse.move(x + 640, y + height / 2, { steps: 8 });
    await user.page.mouse.up();
    await user.page.waitForTimeout(500);
  },
};

cpSync(join(EXAMPLE, "usr"), join(cell, "usr"), { recursive: true });
writeFileSync(join(APPLICATION, "old.pgx"), Buffer.from(OLD, "latin1"));
const manifest = join(APPLICATION, "palletiser.pjx");
writeFileSync(manifest, readFileSync(manifest, "utf8").replace("</Programs>", '  <Program file="old.pgx" />\n  </Programs>'));
mkdirSync(join(cell, ".vscode"));
writeFileSync(SETTINGS, JSON.stringify({ "workbench.colorTheme": "Default Dark Modern" }));
runSteps({ name: "variables", folder, open: `folder=${cell}`, steps: STEPS });
