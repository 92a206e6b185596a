// A user works in the view "VAL 3": applications with their libraries and types, the filter, and the menu of each item.
const assert = require("node:assert/strict");
const { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");

const folder = mkdtempSync(join(tmpdir(), "val3-tree-"));
const cell = join(folder, "cell");
const USRAPP = join(cell, "usr/usrapp");
const EXAMPLE = join(process.env.VAL3_ROOT, "examples/palletiser/usr/usrapp");

/** Recorded messages between the editor and the server. */
const TRACE = join(process.env.VAL3_OUTPUT, "traces/val3-tree.jsonl");

const read = (name) => readFileSync(join(USRAPP, name), "utf8");
const original = (name) => readFileSync(join(EXAMPLE, name), "utf8");

/** Returns a text after these replacements, each of which must apply once. */
function after(text, ...replacements) {
  return replacements.reduce((text, [before, now]) => {
    assert.equal(text.split(before).length, 2, `${before} is not there once`);
    return text.replace(before, () => now);
  }, text);
}

const MANIFEST = "palletiser/palletiser.pjx";
const DATA = "palletiser/palletiser.dtx";

/** An application in the format of s6 controllers. */
const OLD_MANIFEST = ['<?xml version="1.0" encoding="utf-8" ?>', '<project xmlns="ProjectNameSpace" >',
  '  <parameters version="s6.8" stackSize="5000" millimeterUnit="true" />', "  <programSection>", '    <program file="start.pgx" />',
  "  </programSection>", "  <dataSection>", '    <data file="old.dtx" />', "  </dataSection>", "  <aliasSection>",
  '    <alias name="io" interface="io" autoload="true" password="" />', "  </aliasSection>", "</project>", ""].join("\r\n");
const OLD_DATA = ['<?xml version="1.0" encoding="iso-8859-1" ?>', '<dataList xmlns="DataNameSpace" >', "  <stringSection>",
  '    <string name="sMot" public="false" size="1" >', '      <valueString index="0" value="déjà &gt; vu" />', "    </string>",
  '    <string name="sAutre" public="true" size="1" >', '      <valueString index="0" value="é" />', "    </string>",
  "  </stringSection>", "</dataList>", ""].join("\r\n");
const OLD_PROGRAM = ['<?xml version="1.0" encoding="utf-8" ?>', '<programList xmlns="ProgramNameSpace" >', '  <program name="start" public="false" >',
  "    <source><code>begin", "  sMot=sMot+&quot;.&quot;", "end", "    </code></source>", "  </program>", "</programList>", ""].join("\r\n");

const NAMESPACE = "http://www.staubli.com/robotics/VAL3";
const SPARE = `<?xml version="1.0" encoding="utf-8"?>\n<Project xmlns="${NAMESPACE}/Project/3">\n`
  + '  <Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />\n  <Programs />\n  <Database>\n    <Data file="spare.dtx" />\n  </Database>\n'
  + "  <Libraries />\n  <Types />\n</Project>\n";
const SPARE_DATA = `<?xml version="1.0" encoding="utf-8"?>\n<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="${NAMESPACE}/Data/2">\n`
  + '  <Datas>\n    <Data name="nSpare" access="public" xsi:type="array" type="num" size="1" />\n  </Datas>\n</Database>\n';

/** Waits until a file on the disk has these bytes. */
async function becomes(name, expected, encoding = "utf8") {
  const path = join(USRAPP, name);
  const bytes = () => (existsSync(path) ? readFileSync(path) : Buffer.alloc(0)).toString(encoding);
  for (let attempt = 0; attempt < 100 && bytes() !== expected; attempt += 1) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  assert.equal(bytes(), expected);
}

/** Returns the number of requests for the items of the view. */
const requests = () => readFileSync(TRACE, "utf8").split('"val3/workspaceTree"').length - 1;

const VIEW = '.part.sidebar .pane-body [role="tree"]';
/** Returns the row whose label for screen readers begins with a text; a number of items must match completely. */
const row = (text) => `${VIEW} .monaco-list-row[aria-label${/, \d+$/.test(text) ? "" : "^"}=${JSON.stringify(text)}]`;

/** Waits until the view no longer contains an item. When the view is redrawn, it closes an open menu. */
const leaves = (user, text) => user.page.waitForSelector(row(text), { state: "detached" });

const labels = (user, level) => user.page.locator(`${VIEW} .monaco-list-row[aria-level="${level}"] .label-name`).allTextContents();

/** Opens items of the view with the keyboard, repeatedly if a newly opened editor receives the focus meanwhile. */
async function opens(user, ...texts) {
  for (const text of texts) {
    const isOpen = `${row(text)}[aria-expanded=true]`;
    for (let attempt = 0; attempt < 5 && !(await user.page.isVisible(isOpen)); attempt += 1) {
      await focuses(user, text);
      if ((await user.page.getAttribute(row(text), "aria-expanded")) === "false") {
        await user.keys("ArrowRight");
      }
      await user.page.waitForSelector(isOpen, { timeout: 3000 }).catch(() => undefined);
    }
    await user.page.waitForSelector(isOpen);
  }
}

/** Largest number of rows of the view in this test. */
const ROWS = 100;

/** Moves the focus of the view to an item, only with the arrow keys. The item may be out of sight, or appear soon. */
async function focuses(user, text) {
  await user.page.focus(".part.sidebar .pane-body .monaco-list");
  for (let step = 0; step < 3 * ROWS; step += 1) {
    if (step % ROWS === 0) {
      await user.keys("Home");
    }
    if (await user.page.locator(`${row(text)}.focused`).count() > 0) {
      return;
    }
    await user.keys("ArrowDown");
  }
  throw new Error(`The focus does not reach ${text}`);
}

/** Selects an entry in the menu of an item, with the keyboard. */
async function menu(user, text, entry) {
  await focuses(user, text);
  await user.keys("Shift+F10");
  await user.picks(entry);
}

/** Replaces the text of the open input box and accepts it. */
async function enters(user, question, text) {
  await user.page.waitForSelector(`.quick-input-message:has-text(${JSON.stringify(question)})`);
  await user.keys("Control+A");
  await user.type(text);
  await user.page.waitForTimeout(300);
  await user.keys("Enter");
}

async function answersDialog(user, text, button) {
  await user.page.waitForSelector(`.monaco-dialog-box:has-text(${JSON.stringify(text)})`);
  await user.page.screenshot({ path: join(process.env.VAL3_OUTPUT, `tree-dialog-${button.replaceAll(" ", "-")}.png`) });
  await user.page.click(`.monaco-dialog-box .monaco-button:has-text(${JSON.stringify(button)})`);
  await user.page.waitForSelector(".monaco-dialog-box", { state: "detached" });
}

/** Returns the class and the colour of an item's icon. */
const icon = (user, text) => user.page.locator(`${row(text)} .custom-view-tree-node-item-icon`).evaluate((icon) => {
  const name = [...icon.classList].find((name) => name.startsWith("codicon-"));
  return `${name} ${getComputedStyle(icon).color}`;
});

const STEPS = {
  async "applications come first, what none uses comes last"(user) {
    await user.command("View: Show VAL 3");
    // Closing the other view enlarges the tree.
    await user.page.click('.pane-header[aria-label^="Variables"]');
    await user.page.waitForSelector(row("palletiser, application"));
    assert.deepEqual(await labels(user, 1), ["old", "palletiser", "Not Used by an Application"]);
    await opens(user, "Not Used by an Application");
    await user.page.waitForSelector(row("spare, library"));
  },

  async "libraries and types are below the application, with values and access"(user) {
    await opens(user, "palletiser, application");
    await user.page.waitForSelector(row("Programs, 23"));
    assert.deepEqual(await labels(user, 2), ["Programs", "Data", "Libraries", "Types", "spare"]);
    await opens(user, "Types, 1", "Slot, user type", "Libraries, 2", "part, library", "Data, 29");
    await user.page.waitForSelector(row("nAbove, private num"));
    await user.page.waitForSelector(row("bRun, public bool, false"));
    await user.page.waitForSelector(`${row("nAbove, private")}:has-text("num = 150")`);
    const icons = await Promise.all(["palletiser, application", "bHolding, private", "bRun, public", "fCell", "nAbove"].map((text) => icon(user, text)));
    assert.equal(new Set(icons).size, icons.length, icons.join());
    await opens(user, "Programs, 23");
    const programs = await Promise.all(["clearPallet, public", "cycle, private"].map((text) => icon(user, text)));
    assert.notEqual(programs[0], programs[1]);
    await focuses(user, "Programs, 23");
    await user.keys("ArrowLeft");
  },

  async "an edit keeps open what is open"(user) {
    await user.openFile("palletiser.dtx");
    await user.goTo(34, 29);
    await user.keys("Delete");
    await user.type("2");
    await user.page.waitForSelector(row("nAbove, private num, 250"));
    await user.page.waitForSelector(`${row("palletiser, application")}[aria-expanded=true]`);
    await user.command("File: Revert File");
    await user.page.waitForSelector(row("nAbove, private num"));
  },

  async "a hidden view asks for nothing, and shows the change when it is seen"(user) {
    await user.command("View: Show Explorer");
    const before = requests();
    await user.goTo(34, 29);
    await user.keys("Delete");
    await user.type("3");
    // Much longer than the pause after which a visible view sends a request.
    await user.page.waitForTimeout(1500);
    assert.equal(requests(), before);
    await user.command("View: Show VAL 3");
    await user.page.waitForSelector(row("nAbove, private num, 350"));
    assert.ok(requests() > before);
    await user.command("File: Revert File");
    await user.page.waitForSelector(row("nAbove, private num, 150"));
  },

  async "the filter leaves names that contain a text"(user) {
    // The actions of a view appear while the mouse is over it.
    await user.page.hover('.pane-header[aria-label^="Applications"]');
    await user.page.click('.part.sidebar .pane-header [aria-label^="Filter the View"]');
    await enters(user, "A part of the names", "GRIP");
    await user.page.waitForSelector('.part.sidebar .message:has-text("Filter “GRIP”: 3 names")');
    await user.page.waitForSelector(row("grip, public program"));
    assert.deepEqual(await labels(user, 1), ["palletiser"]);
  },

  async "the filter is kept when the window is opened again, and cleared with its button"(user) {
    await user.page.reload();
    await user.page.waitForSelector('.part.sidebar .message:has-text("Filter “GRIP”")');
    await user.page.waitForSelector(row("grip, public program"));
    await user.page.hover('.pane-header[aria-label^="Applications"]');
    await user.page.click('.part.sidebar .pane-header [aria-label^="Clear the Filter"]');
    await user.page.waitForSelector(row("old, application"));
    await user.page.waitForSelector('.part.sidebar .message:has-text("Filter")', { state: "hidden" });
  },

  async "a command without an item says so"(user) {
    await user.page.focus(".part.sidebar .pane-body .monaco-list");
    await user.keys("F2");
    await user.told("No item of the view VAL 3 is selected.");
  },

  async "a filter that no name contains says so"(user) {
    await user.commandWith("VAL 3: Filter the View", "A part of the names", "zzz");
    await user.page.waitForSelector('.part.sidebar .message:has-text("no name contains it")');
    await user.command("VAL 3: Clear the Filter");
    await user.page.waitForSelector(row("old, application"));
  },

  async "a new program belongs to the project of the item"(user) {
    await menu(user, "palletiser, application", "New Program Here");
    await enters(user, "The name of the program", "phase");
    await user.tab("phase.pgx");
    const next = '    <Program file="pick.pgx" />\n';
    await becomes(MANIFEST, after(original(MANIFEST), [next, `    <Program file="phase.pgx" />\n${next}`]));
  },

  async "F2 renames the item with the focus"(user) {
    await opens(user, "palletiser, application", "Programs, 24");
    await focuses(user, "phase, private program");
    await user.keys("F2");
    await enters(user, "The new name of phase", "1st");
    await user.page.waitForSelector('.quick-input-message:has-text("`1st` is no name")');
    await enters(user, "is no name", "stage");
    await user.page.waitForSelector(row("stage, private program"));
    const next = '    <Program file="pick.pgx" />\n';
    await becomes(MANIFEST, after(original(MANIFEST), [next, `    <Program file="stage.pgx" />\n${next}`]));
    assert.ok(read("palletiser/stage.pgx").includes('<Program name="stage">'));
    assert.ok(!existsSync(join(USRAPP, "palletiser/phase.pgx")));
  },

  async "the menu deletes a program that nothing uses"(user) {
    await menu(user, "stage, private program", "Delete");
    await answersDialog(user, "Nothing uses it.", "Delete");
    await leaves(user, "stage, private program");
    await becomes(MANIFEST, original(MANIFEST));
    assert.ok(!existsSync(join(USRAPP, "palletiser/stage.pgx")));
  },

  async "what the controller calls is not renamed"(user) {
    await menu(user, "start, private program", "Rename");
    await user.told("The controller itself calls `start`.");
  },

  async "uses are found"(user) {
    await menu(user, "clearPallet, public program", "Find Uses");
    await user.page.waitForSelector(".peekview-widget .view-line:has-text('call clearPallet')");
    await user.keys("Escape");
  },

  async "the uses are shown before a deletion, which can be left"(user) {
    await focuses(user, "clearPallet, public program");
    await user.keys("Delete");
    await answersDialog(user, "2 places use it and will have an error.", "Show Uses");
    await user.page.waitForSelector(".peekview-widget .view-line:has-text('call clearPallet')");
    await user.keys("Escape");
    await focuses(user, "clearPallet, public program");
    await user.keys("Delete");
    await answersDialog(user, "2 places use it", "Cancel");
    await becomes(MANIFEST, original(MANIFEST));
  },

  async "data is deleted with its values"(user) {
    await opens(user, "Data, 29");
    await focuses(user, "nAbove, private");
    await user.keys("Delete");
    await answersDialog(user, "Delete the data nAbove?", "Delete");
    const lines = '    <Data name="nAbove" access="private" xsi:type="array" type="num" size="1">\n      <Value key="0" value="150" />\n    </Data>\n';
    await becomes(DATA, after(original(DATA), [lines, ""]));
    await leaves(user, "nAbove, private");
    writeFileSync(join(USRAPP, DATA), original(DATA));
    await user.page.waitForSelector(row("Data, 29"));
  },

  async "data of a file in Latin-1 is renamed and deleted byte for byte"(user) {
    await opens(user, "old, application", "Data, 2");
    await user.page.waitForSelector(row('sMot, private string, "déjà > vu"'));
    await menu(user, "sMot, private", "Rename");
    await enters(user, "The new name of sMot", "sWord");
    await user.page.waitForSelector(row("sWord, private"));
    await becomes("old/old.dtx", OLD_DATA.replace("sMot", "sWord"), "latin1");
    await becomes("old/start.pgx", OLD_PROGRAM.replaceAll("sMot", "sWord"));
    await menu(user, "sAutre, public", "Delete");
    await answersDialog(user, "Nothing uses it.", "Delete");
    const lines = '    <string name="sAutre" public="true" size="1" >\r\n      <valueString index="0" value="é" />\r\n    </string>\r\n';
    await becomes("old/old.dtx", after(OLD_DATA.replace("sMot", "sWord"), [lines, ""]), "latin1");
    await leaves(user, "sAutre, public");
  },

  async "a library of the cell is added in the new dialect"(user) {
    await menu(user, "palletiser, application", "Add Library");
    await user.page.waitForSelector('.quick-input-list .monaco-list-row:has-text("there as part")');
    await user.page.screenshot({ path: join(process.env.VAL3_OUTPUT, "tree-candidates.png") });
    await user.take("spare");
    await enters(user, "The identifier of the library spare", "part");
    await user.page.waitForSelector('.quick-input-message:has-text("There is already a library identifier")');
    await enters(user, "There is already", "spare");
    const last = '    <Library alias="part" path="Disk://partBox/partBox.pjx" autoload="false" />\n';
    await becomes(MANIFEST, after(original(MANIFEST), [last, `${last}    <Library alias="spare" path="Disk://spare/spare.pjx" />\n`]));
    assert.deepEqual(await labels(user, 1), ["old", "palletiser"]);
  },

  async "an entry of a library is renamed and deleted"(user) {
    await opens(user, "Libraries, 3");
    await menu(user, "spare, library", "Rename");
    await enters(user, "The new name of spare", "reserve");
    await user.page.waitForSelector(row("reserve, library"));
    await menu(user, "reserve, library", "Delete");
    await answersDialog(user, "Delete the entry reserve?", "Delete");
    await becomes(MANIFEST, original(MANIFEST));
    await leaves(user, "reserve, library");
  },

  async "a user type is added, renamed and deleted"(user) {
    await menu(user, "palletiser, application", "Add Type");
    await user.page.waitForSelector('.quick-input-list .monaco-list-row:has-text("1 field")');
    await user.take("spare");
    await enters(user, "The name of the type spare", "Spare");
    const last = '    <Type name="Slot" path="Disk://types/Slot/Slot.pjx" />\n';
    const withType = (name) => after(original(MANIFEST), [last, `${last}    <Type name="${name}" path="Disk://spare/spare.pjx" />\n`]);
    await becomes(MANIFEST, withType("Spare"));
    await opens(user, "Types, 2");
    await menu(user, "Spare, user type", "Rename");
    await enters(user, "The new name of Spare", "Reserve");
    await becomes(MANIFEST, withType("Reserve"));
    await menu(user, "Reserve, user type", "Delete");
    await answersDialog(user, "Delete the entry Reserve?", "Delete");
    await becomes(MANIFEST, original(MANIFEST));
    await leaves(user, "Reserve, user type");
  },

  async "a library of the cell is added in the old dialect"(user) {
    await menu(user, "old, application", "Add Library");
    await user.page.waitForSelector('.quick-input-list .monaco-list-row:has-text("there as io")');
    await user.take("spare");
    await enters(user, "The identifier of the library spare", "spare");
    const last = '    <alias name="io" interface="io" autoload="true" password="" />\r\n';
    await becomes("old/old.pjx", after(OLD_MANIFEST, [last, `${last}    <alias name="spare" interface="spare" />\r\n`]));
  },

  async "a file with errors is refused"(user) {
    writeFileSync(join(USRAPP, "old/old.pjx"), OLD_MANIFEST.replace("</aliasSection>", "</aliasSect"));
    await user.page.waitForTimeout(1500);
    await menu(user, "old, application", "Add Library");
    await user.page.waitForSelector('.quick-input-list .monaco-list-row:has-text("there as io")');
    await user.take("spare");
    await user.told("`old.pjx` has errors");
    writeFileSync(join(USRAPP, "old/old.pjx"), OLD_MANIFEST);
    await user.page.waitForTimeout(1500);
  },

  async "files, code and tables open from the menu"(user) {
    await menu(user, "pick, private program", "Open File");
    await user.tab("pick.pgx");
    await menu(user, "pick, private program", "Open Code without XML");
    await user.tab("pick.pgx (code)");
    await menu(user, "bRun, public", "Open as Tables");
    await user.webview("bRun");
  },

  async "an item is revealed in the explorer"(user) {
    await menu(user, "pick, private program", "Reveal in Explorer");
    await user.page.waitForSelector('.explorer-folders-view .monaco-list-row.focused:has-text("pick.pgx")');
    await user.command("View: Show VAL 3");
  },

  async "an application runs and is debugged"(user) {
    await menu(user, "palletiser, application", "Debug");
    await user.page.waitForSelector(".debug-toolbar");
    await user.keys("Shift+F5");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
    await user.command("View: Show VAL 3");
    await menu(user, "start, private program", "Run");
    await user.page.waitForSelector(".debug-toolbar");
    await user.keys("Shift+F5");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
  },

  async "the view in a dark theme"(user) {
    await user.keys("Control+K", "Control+T");
    await user.choose("Dark Modern");
    await user.command("View: Show VAL 3");
    await opens(user, "palletiser, application", "Libraries, 2", "part, library", "Data, 29");
    await focuses(user, "palletiser, application");
  },

  async "file icons in the default theme, in any letter case"(user) {
    await user.command("View: Show Explorer");
    writeFileSync(join(USRAPP, "palletiser/UPPER.PGX"), "");
    writeFileSync(join(USRAPP, "palletiser/UPPER.PJX"), "");
    writeFileSync(join(USRAPP, "palletiser/Mixed.Pgx"), "");
    await user.openFile("pick.pgx");
    await user.icon("pick.pgx", "program-dark.svg");
    await user.icon("palletiser.pjx", "project-dark.svg");
    await user.icon("UPPER.PGX", "program-dark.svg");
    await user.icon("UPPER.PJX", "project-dark.svg");
    await user.icon("Mixed.Pgx", "program-dark.svg");
  },
};

cpSync(join(process.env.VAL3_ROOT, "examples/palletiser/usr"), join(cell, "usr"), { recursive: true });
const files = { "old/old.pjx": OLD_MANIFEST, "old/start.pgx": OLD_PROGRAM, "spare/spare.pjx": SPARE, "spare/spare.dtx": SPARE_DATA };
mkdirSync(join(USRAPP, "old"));
mkdirSync(join(USRAPP, "spare"));
Object.entries(files).forEach(([name, text]) => writeFileSync(join(USRAPP, name), text));
writeFileSync(join(USRAPP, "old/old.dtx"), OLD_DATA, "latin1");
runSteps({ name: "tree", folder, open: `folder=${cell}`, steps: STEPS, showsDialogs: true });
