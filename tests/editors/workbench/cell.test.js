// A user opens the example cell and works in it. Every step saves a screenshot in target/editors/output.
const assert = require("node:assert/strict");
const { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");

const { publisher } = require(join(process.env.VAL3_ROOT, "editors/vscode/package.json"));
const EXAMPLE = join(process.env.VAL3_ROOT, "examples/palletiser");
const folder = mkdtempSync(join(tmpdir(), "val3-workbench-"));
const cell = join(folder, "cell");
const APPLICATION = join(cell, "usr/usrapp/palletiser");

const read = (name) => readFileSync(join(APPLICATION, name), "utf8");
const original = (name) => readFileSync(join(EXAMPLE, "usr/usrapp/palletiser", name), "utf8");

/** Returns the example's file after these replacements, each of which must apply. */
function after(name, ...replacements) {
  return replacements.reduce((text, [before, now]) => {
    assert.ok(text.includes(before), `${name} has no ${before}`);
    return text.replaceAll(before, now);
  }, original(name));
}

/** A program in the format of s6 controllers. */
const OLD = ['<?xml version="1.0" encoding="utf-8" ?>', '<programList xmlns="ProgramNameSpace" >', '  <program name="old" public="false" >',
  "    <source><code>begin", "  if nAbove&lt;3", "  endIf", "end", "    </code></source>", "  </program>", "</programList>", ""].join("\r\n");

/** A file with two programs. */
const TWO = '<?xml version="1.0" encoding="utf-8"?>\n<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">\n'
  + ["two", "second"].map((name) => `  <Program name="${name}">\n    <Code><![CDATA[begin\n  bOverrun=${name === "second"}\nend]]></Code>\n  </Program>\n`).join("")
  + "</Programs>\n";

/** Full-width punctuation, which VS Code highlights as probably mistyped, and a full-width space. */
const CHINESE = original("pick.pgx").replace('name="pick"', 'name="chinese"').replace("[begin\n", "[begin\n  logMsg(\"你好，世界（一）\u3000\")\n");

const row = (text) => `.part.sidebar .monaco-list-row:has-text(${JSON.stringify(text)})`;

/** Waits until a file on the disk has this text. */
async function becomes(name, expected) {
  for (let attempt = 0; attempt < 100 && read(name) !== expected; attempt += 1) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  assert.equal(read(name), expected);
}

/** Extracts the value that is assigned in a line, and renames the variable to `name`. */
async function extracts(user, line, name) {
  await user.goTo(line, 11);
  await user.keys("Shift+End");
  await user.command("Refactor...");
  await user.page.waitForSelector('.action-widget .monaco-list-row.focused:has-text("Extract into a local variable")');
  await user.keys("Enter");
  await user.page.waitForSelector(".rename-box input");
  await user.page.fill(".rename-box input", name);
  await user.keys("Enter");
}

const STEPS = {
  async "the program opens with its colours"(user) {
    await user.openFile("pick.pgx");
    await user.sees("io:doConveyor=true");
    await user.coloured("movej(l_pNear", 3);
  },

  async "files have icons of their own"(user) {
    await user.icon("pick.pgx", "program-light.svg");
    await user.icon("palletiser.pjx", "project-light.svg");
    await user.command("Preferences: File Icon Theme", "VAL 3");
    await user.icon("palletiser.dtx", "data-light.svg");
  },

  async "a lens counts the calls of a program"(user) {
    await user.goTo(1, 1);
    await user.opensLens("1 reference", ".peekview-widget .view-line:has-text('call pick')");
  },

  async "a mistake is found while it is typed, and its repair as well"(user) {
    await user.keys("Escape");
    await user.goTo(24, 17);
    await user.type("1");
    await user.problem("waitEndMove");
    await user.focusEditor();
    await user.keys("Control+Z");
    await user.noSquiggle();
  },

  async "hover tells what a point is"(user) {
    await user.goTo(23, 12);
    await user.hovers("pPick");
  },

  async "completion knows the instructions and the data"(user) {
    await user.keys("Escape");
    await user.goTo(24, 5);
    await user.keys("End", "Enter");
    await user.type("movej(pS");
    await user.completes("pSafe");
  },

  async "what was completed can be undone"(user) {
    await user.takes("pSafe");
    await user.sees("movej(pSafe");
    await user.command("File: Revert File");
    await user.seesNot("movej(pSafe");
  },

  async "the check of the workspace says the same, and lists nothing twice"(user) {
    await user.command("VAL 3: Check Workspace");
    await user.terminal("info[V0531]");
    await user.terminal("3 infos in 1 of");
    await user.keys("Control+Shift+M");
    await user.problems("is in the folder but not listed", 3);
    await user.focusEditor();
  },

  async "definition leads to the data file and back"(user) {
    await user.goTo(23, 20);
    await user.keys("F12");
    await user.tab("palletiser.dtx");
    await user.sees('name="tSuction"');
    await user.openFile("pick.pgx");
  },

  async "a name is changed in every file"(user) {
    await user.goTo(26, 7);
    await user.keys("F2");
    await user.page.fill(".rename-box input", "bCarries");
    await user.keys("Enter");
    await user.sees("bCarries=x_bOk");
    await user.command("File: Save All Files");
    for (const file of ["init.pgx", "pick.pgx", "place.pgx", "sensors.pgx", "palletiser.dtx"]) {
      await becomes(file, after(file, ["bHolding", "bCarries"]));
    }
  },

  async "formatting lays out the code alone"(user) {
    await user.openFile("home.pgx");
    await user.goTo(13, 8);
    await user.type("   ");
    await user.sees("x_bOk   =isInRange");
    await user.command("File: Save");
    await becomes("home.pgx", after("home.pgx", ["x_bOk=isInRange", "x_bOk   =isInRange"]));
    await user.command("Format Document");
    await user.sees("x_bOk=isInRange");
    await user.command("File: Save");
    await becomes("home.pgx", original("home.pgx"));
  },

  async "an extracted variable gets its name at once, in the file and in the code view"(user) {
    await user.openFile("average.pgx");
    await extracts(user, 18, "l_nMean");
    await user.sees('<Local name="l_nMean" type="num"');
    await user.sees("x_nMean=l_nMean");
    await user.keys("Control+Z", "Control+Z");
    await user.command("VAL 3: Open Code without XML");
    await user.tab("average.pgx (code)");
    await extracts(user, 7, "l_nMean");
    await user.sees("x_nMean=l_nMean");
    await user.keys("Control+Z", "Control+Z");
  },

  async "the code view shows code without XML"(user) {
    await user.openFile("place.pgx");
    await user.command("VAL 3: Open Code without XML");
    await user.tab("place.pgx (code)");
    await user.sees("begin");
    await user.seesNot("<Program");
  },

  async "a mistake is found in the code view"(user) {
    await user.goTo(1, 6);
    await user.keys("Enter");
    await user.type("bCarries=nAbove");
    await user.problem("a `num` cannot be assigned");
    await user.problems("a `num` cannot be assigned", 1);
    await user.focusEditor();
  },

  async "the finding follows the user to the file and back"(user) {
    await user.command("VAL 3: Open the Program File");
    await user.tab("place.pgx");
    await user.page.waitForSelector(".editor-instance .squiggly-error", { state: "attached" });
    await user.problems("a `num` cannot be assigned", 1);
    await user.command("VAL 3: Open Code without XML");
    await user.tab("place.pgx (code)");
    await user.page.waitForSelector(".editor-instance .squiggly-error", { state: "attached" });
    await user.problems("a `num` cannot be assigned", 1);
  },

  async "hover and completion work in the code view"(user) {
    await user.goTo(2, 13);
    await user.hovers("num");
    await user.keys("Escape", "End");
    for (let letter = 0; letter < "nAbove".length; letter += 1) {
      await user.keys("Backspace");
    }
    await user.type("bOver");
    await user.completes("bOverrun");
    await user.takes("bOverrun");
    await user.noSquiggle();
  },

  async "saving the code view changes the code of the file alone"(user) {
    await user.command("File: Save");
    await becomes("place.pgx", after("place.pgx", ["bHolding", "bCarries"], ["[begin\n", "[begin\n  bCarries=bOverrun\n"]));
  },

  async "a lens above the first line counts the calls of the program"(user) {
    await user.openFile("tower.pgx");
    await user.command("VAL 3: Open Code without XML");
    await user.tab("tower.pgx (code)");
    await user.opensLens(/^\d+ references$/, ".peekview-widget .view-line:has-text('call tower(')");
    await user.tab("tower.pgx (code)");
    await user.keys("Escape");
  },

  async "the code view has an outline, breadcrumbs and symbols"(user) {
    await user.page.waitForSelector('.breadcrumbs-control .monaco-breadcrumb-item:has-text("tower.pgx (code)")');
    await user.keys("Control+Shift+O");
    await user.page.waitForSelector('.quick-input-list .monaco-list-row:has-text("x_sColour")');
    await user.choose("l_sKey");
    await user.page.waitForSelector('.statusbar-item:has-text("Ln 3, Col 3")');
    await user.page.waitForSelector('.breadcrumbs-control .monaco-breadcrumb-item:has-text("l_sKey")');
    await user.command("Explorer: Focus on Outline View");
    await user.page.waitForSelector('.outline-pane .monaco-list-row:has-text("x_sColour")');
    await user.focusEditor();
  },

  async "Chinese text is not marked"(user) {
    await user.openFile("chinese.pgx");
    await user.sees("你好，世界（一）");
    await user.page.waitForTimeout(1000);
    assert.equal(await user.page.locator(".editor-instance .unicode-highlight").count(), 0);
    await user.command("VAL 3: Open Code without XML");
    await user.tab("chinese.pgx (code)");
    await user.sees("你好，世界（一）");
    await user.page.waitForTimeout(1000);
    assert.equal(await user.page.locator(".editor-instance .unicode-highlight").count(), 0);
  },

  async "the code view of the old dialect keeps entities and line ends"(user) {
    await user.openFile("old.pgx");
    await user.command("VAL 3: Open Code without XML");
    await user.tab("old.pgx (code)");
    await user.sees("if nAbove<3");
    await user.goTo(2, 14);
    await user.type(' or libPath()!="<&>"');
    await user.command("File: Save");
    await becomes("old.pgx", OLD.replace("&lt;3", "&lt;3 or libPath()!=&quot;&lt;&amp;&gt;&quot;"));
  },

  async "definition leads from code view to code view"(user) {
    await user.openFile("cycle.pgx");
    await user.goTo(22, 9);
    await user.command("VAL 3: Open Code without XML");
    await user.tab("cycle.pgx (code)");
    await user.keys("F12");
    await user.tab("pick.pgx (code)");
    await user.sees("io:doConveyor=true");
  },

  async "a file with several programs has a code view for each"(user) {
    await user.openFile("two.pgx");
    await user.command("VAL 3: Open Code without XML", "second");
    await user.tab("two.pgx (second)");
    await user.sees("bOverrun=true");
    await user.goTo(2, 16);
    await user.type(" and bRun");
    await user.command("File: Save");
    await becomes("two.pgx", TWO.replace("bOverrun=true", "bOverrun=true and bRun"));
  },

  async "the tree shows applications and programs"(user) {
    await user.command("View: Show VAL 3");
    await user.page.click(row("palletiser"));
    await user.page.click(row("Programs"));
    await user.page.waitForSelector(row("clearPallet"));
  },

  async "a new program gets its entry in the project"(user) {
    await user.openFile("pick.pgx");
    await user.commandWith("VAL 3: New Program", "The name of the program", "basket");
    await user.tab("basket.pgx");
    await user.sees("// basket");
    await user.page.waitForSelector(row("basket"));
    const next = '    <Program file="clearPallet.pgx" />\n';
    await becomes("palletiser.pjx", after("palletiser.pjx", [next, `    <Program file="basket.pgx" />\n${next}`]));
  },

  async "a new application is ready to be written"(user) {
    await user.commandWith("VAL 3: New Application", "The name of the application", "sorter", "usrapp");
    await acceptDefaults(user);
    await user.tab("start.pgx");
    await user.sees("The user page of the pendant");
    await user.noSquiggle();
  },

  async "the page of a finding opens"(user) {
    await user.openFile("pick.pgx");
    await user.goTo(24, 17);
    await user.type("1");
    await user.problem("waitEndMove");
    await user.focusEditor();
    await user.command("VAL 3: Open the Page of a Finding");
    await user.page.waitForSelector('.tab.active:has-text("Preview V0204")');
    await user.webview("Every parameter of a program");
  },

  async "a server that was started anew knows what the old one knew"(user) {
    await user.openFile("pick.pgx");
    await user.command("VAL 3: Restart Server");
    await user.problem("waitEndMove");
    await user.problems("waitEndMove", 1);
    await user.command("File: Revert File");
    await user.problems("waitEndMove", 0);
  },

  async "the settings are described"(user) {
    await user.command("Preferences: Open Settings (UI)");
    await user.page.waitForSelector(".settings-editor .suggest-input-container .view-line");
    await user.type(`@ext:${publisher}.val3 inlay`);
    await user.page.waitForSelector('.setting-item:has-text("Point Frames")');
  },

  async "the walkthrough leads through the first steps"(user) {
    await user.command("Welcome: Open Walkthrough", "Write VAL 3");
    await user.page.click('.getting-started-step:has-text("Write code without XML")');
    await user.page.click('.getting-started-step.expanded .monaco-button:has-text("Open Code without XML")');
    await user.page.waitForSelector('.quick-input-widget:visible input[placeholder="Program whose code is shown"]');
    await user.keys("Escape");
    await user.page.waitForSelector(".getting-started-step.expanded [role=checkbox][aria-checked=true]");
    await user.page.waitForFunction((count) => document.querySelectorAll(".getting-started-step [role=checkbox][aria-checked=true]").length === count, 4);
    await user.page.click('.getting-started-step:has-text("See the robot")');
    await user.page.click('.getting-started-step.expanded .monaco-button:has-text("Show Robot")');
    await user.page.waitForSelector('.getting-started-step:has-text("See the robot") [role=checkbox][aria-checked=true]', { state: "attached" });
  },

  async "a folder without an application is told how to get one"(user) {
    const empty = join(folder, "empty");
    mkdirSync(empty);
    await user.opens(`folder=${empty}`);
    await user.command("View: Show VAL 3");
    await user.page.waitForSelector('.welcome-view:has-text("This folder has no VAL 3 application yet.")');
    await user.commandWith("VAL 3: New Application", "The name of the application", "sorter");
    await acceptDefaults(user);
    await user.tab("start.pgx");
    await user.page.waitForSelector(row("sorter"));
  },
};

/** Accepts the defaults for version and arm of a new application. */
async function acceptDefaults(user) {
  for (const question of ["The version of VAL 3 on the controller", "The arm"]) {
    await user.page.waitForSelector(`.quick-input-widget:visible input[placeholder=${JSON.stringify(question)}]`);
    await user.page.waitForSelector('.quick-input-list .monaco-list-row.focused:has-text("From the cell")');
    await user.keys("Enter");
  }
}

cpSync(join(EXAMPLE, "usr"), join(cell, "usr"), { recursive: true });
writeFileSync(join(APPLICATION, "old.pgx"), OLD);
writeFileSync(join(APPLICATION, "two.pgx"), TWO);
writeFileSync(join(APPLICATION, "chinese.pgx"), CHINESE);
runSteps({ name: "workbench", folder, open: `folder=${cell}`, steps: STEPS });
