// A user opens the example cell and works in it. Every step leaves a screenshot in target/editors/output.
const assert = require("node:assert/strict");
const { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { User } = require("./user");
const { startVsCode } = require("./vscode");

const EXAMPLE = join(process.env.VAL3_ROOT, "examples/palletiser");
const folder = mkdtempSync(join(tmpdir(), "val3-workbench-"));
const cell = join(folder, "cell");
const APPLICATION = join(cell, "usr/usrapp/palletiser");

const read = (name) => readFileSync(join(APPLICATION, name), "utf8");
const original = (name) => readFileSync(join(EXAMPLE, "usr/usrapp/palletiser", name), "utf8");

/** The example's file after these replacements, each of which must apply. */
function after(name, ...replacements) {
  return replacements.reduce((text, [before, now]) => {
    assert.ok(text.includes(before), `${name} has no ${before}`);
    return text.replaceAll(before, now);
  }, original(name));
}

/** A program as a controller of the s6 series writes it. */
const OLD = ['<?xml version="1.0" encoding="utf-8" ?>', '<programList xmlns="ProgramNameSpace" >', '  <program name="old" public="false" >',
  "    <source><code>begin", "  if nAbove&lt;3", "  endIf", "end", "    </code></source>", "  </program>", "</programList>", ""].join("\r\n");

/** Waits until a file on the disk has this text. */
async function becomes(name, expected) {
  for (let attempt = 0; attempt < 100 && read(name) !== expected; attempt += 1) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  assert.equal(read(name), expected);
}

const STEPS = {
  async "the program opens with its colours"(user) {
    await user.openFile("pick.pgx");
    await user.sees("io:doConveyor=true");
    await user.coloured("movej(l_pNear", 3);
  },

  async "a mistake is found while it is typed, and its repair as well"(user) {
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
    await user.keys("Tab");
    await user.sees("movej(pSafe");
    await user.command("File: Revert File");
    await user.seesNot("movej(pSafe");
  },

  async "the check of the workspace is a task with problems"(user) {
    await user.command("VAL 3: Check Workspace");
    await user.page.waitForSelector(".markers-panel .monaco-list-row:has-text('val3 check')");
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
    await user.command("Format Document");
    await user.command("File: Save");
    await becomes("home.pgx", original("home.pgx"));
  },

  async "the code view shows code without XML"(user) {
    await user.openFile("place.pgx");
    await user.command("VAL 3: Open Code without XML");
    await user.tab("place.val3");
    await user.sees("begin");
    await user.seesNot("<Program");
  },

  async "a mistake is found in the code view"(user) {
    await user.goTo(1, 6);
    await user.keys("Enter");
    await user.type("bCarries=nAbove");
    await user.problem("a `num` cannot be assigned");
    await user.focusEditor();
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
    await user.keys("Tab");
    await user.noSquiggle();
  },

  async "saving the code view changes the code of the file alone"(user) {
    await user.command("File: Save");
    await becomes("place.pgx", after("place.pgx", ["bHolding", "bCarries"], ["[begin\n", "[begin\n  bCarries=bOverrun\n"]));
  },

  async "the code view of the old dialect keeps entities and line ends"(user) {
    await user.openFile("old.pgx");
    await user.command("VAL 3: Open Code without XML");
    await user.tab("old.val3");
    await user.sees("if nAbove<3");
    await user.goTo(2, 14);
    await user.type(' or "a"<"b"');
    await user.command("File: Save");
    await becomes("old.pgx", OLD.replace("&lt;3", "&lt;3 or &quot;a&quot;&lt;&quot;b&quot;"));
  },

  async "the tree shows applications and programs"(user) {
    await user.command("View: Show VAL 3");
    const row = (text) => `.part.sidebar .monaco-list-row:has-text(${JSON.stringify(text)})`;
    await user.page.click(row("palletiser"));
    await user.page.click(row("Programs"));
    await user.page.waitForSelector(row("clearPallet"));
  },

  async "a new program gets its entry in the project"(user) {
    await user.openFile("pick.pgx");
    await user.commandWith("VAL 3: New Program", "The name of the program", "phase");
    await user.tab("phase.pgx");
    await user.sees("// phase");
    const next = '    <Program file="pick.pgx" />\n';
    await becomes("palletiser.pjx", after("palletiser.pjx", [next, `    <Program file="phase.pgx" />\n${next}`]));
  },

  async "a new application is ready to be written"(user) {
    await user.commandWith("VAL 3: New Application", "The name of the application", "sorter", "usrapp");
    await user.tab("start.pgx");
    await user.sees("Runs when the operator starts it");
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
  },
};

async function main() {
  cpSync(EXAMPLE, cell, { recursive: true });
  writeFileSync(join(APPLICATION, "old.pgx"), OLD);
  const vscode = await startVsCode(folder, process.env.VAL3_VSIX);
  const user = await User.open(vscode.address, cell);
  let number = 0;
  let fault;
  for (const [name, step] of Object.entries(STEPS)) {
    number += 1;
    const started = Date.now();
    fault = await step(user).then(() => undefined, (fault) => fault);
    const picture = `${String(number).padStart(2, "0")}-${name.replaceAll(/[^\w]+/g, "-")}.png`;
    await user.page.screenshot({ path: join(process.env.VAL3_OUTPUT, picture) });
    console.log(`${fault === undefined ? "ok" : "FAILED"} ${name} (${Date.now() - started} ms)`);
    if (fault !== undefined) {
      console.log(String(fault.stack ?? fault).slice(0, 2000));
      break;
    }
  }
  await user.leave();
  vscode.stop();
  rmSync(folder, { recursive: true, force: true });
  const failed = fault === undefined ? 0 : 1;
  console.log(`test result: ${failed ? "FAILED" : "ok"}. ${number - failed} passed; ${failed} failed; workbench`);
  process.exit(failed);
}

main().catch((fault) => {
  console.error(fault);
  process.exit(1);
});
