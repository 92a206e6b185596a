// A user works with the tests of an application: the Testing view, the lenses, the debugger and the coverage.
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");

const folder = mkdtempSync(join(tmpdir(), "val3-testing-"));
const cell = join(folder, "cell");
const TESTS = join(cell, "usr/usrapp/partBoxTest");

/** Writes a program in the format of the runner's first test, with other code. */
function writeProgram(name, code) {
  const first = readFileSync(join(TESTS, "testFirst.pgx"), "utf8");
  const text = first.replace("testFirst", name).replace(/begin\n[^]*\nend/, () => `begin\n${code}\nend`);
  writeFileSync(join(TESTS, `${name}.pgx`), text);
}

const listed = (...names) => names.map((name) => `    <Program file="${name}.pgx" />\n`).join("");

/** Returns the row of the Testing view with this label and this state. */
const row = (label, state = "") => `.test-explorer .monaco-list-row[aria-label^=${JSON.stringify(`${label} (${state}`)}]`;

const hasState = (user, label, state) => user.page.waitForSelector(row(label, state));

/** Waits until the message of a failure is shown at a line of the editor with this text. */
async function failsAt(user, message, line) {
  // Both positions are measured at the same moment, because lines move when lenses appear.
  const isBeside = ([message, line]) => {
    const top = (selector, text) => {
      const found = [...document.querySelectorAll(selector)].find((element) => element.textContent.includes(text));
      return found?.getBoundingClientRect().top;
    };
    const distance = top(".editor-instance .contentWidgets > *", message) - top(".editor-instance .view-line", line);
    return Math.abs(distance) < 10;
  };
  await user.page.waitForFunction(isBeside, [message, line]);
}

/** Clicks a lens until the Testing view has a row, because a click can miss a lens that is being redrawn. */
const runsLens = (user, lens, label, state) => user.opensLens(lens, row(label, state));

/** Opens the view, which the debugger may have replaced by its own. */
async function opensTestingView(user) {
  if (!(await user.page.isVisible(".test-explorer"))) {
    await user.page.click(".activitybar .action-item:has(.codicon-test-view-icon)");
  }
  await user.page.waitForSelector(".test-explorer");
}

const debugged = (user) => user.page.waitForSelector(".debug-toolbar", { state: "hidden" });

/** Waits until lines of the editor have these colours in the gutter. */
async function hasColours(user, expected) {
  await user.page.waitForFunction((expected) => {
    const lines = [...document.querySelectorAll(".editor-instance .line-numbers")];
    return Object.entries(expected).every(([number, colours]) => {
      const line = lines.find((line) => line.textContent === number);
      return ["hit", "miss"].every((colour) => line?.classList.contains(`coverage-deco-${colour}`) === colours.includes(colour));
    });
  }, expected);
}

const STEPS = {
  async "the Testing view has a tree of applications and tests"(user) {
    await opensTestingView(user);
    await user.page.click(row("partBoxTest"));
    await user.keys("ArrowRight");
    await hasState(user, "testFirst", "Not yet run");
    await hasState(user, "testSum", "Not yet run");
  },

  async "a run shows the failure at its line, with the output of the test"(user) {
    await user.openFile("sum.pgx");
    await user.command("Test: Run All Tests");
    await hasState(user, "testFirst", "Passed");
    await hasState(user, "testSum", "Failed");
    await failsAt(user, "2 != 3", "equalNum");
    await user.terminal("FAIL partBoxTest:testSum");
    await user.terminal("| sum");
  },

  async "a lens runs the test above which it is"(user) {
    await opensTestingView(user);
    await user.openFile("testSum.pgx");
    writeProgram("sum", sumCode(2));
    await runsLens(user, "Run test", "testSum", "Passed");
    await hasState(user, "testFirst", "Passed");
  },

  async "the code without XML has the lens too"(user) {
    await user.command("VAL 3: Open Code without XML");
    await user.tab("testSum.pgx (code)");
    writeProgram("sum", sumCode(3));
    await runsLens(user, "Run test", "testSum", "Failed");
  },

  async "a debugged test stops at a breakpoint"(user) {
    await user.openFile("testFirst.pgx");
    await user.goTo(6, 1);
    await user.keys("F9");
    await user.page.waitForSelector(".editor-instance .codicon-debug-breakpoint");
    await user.opensLens("Debug test", ".debug-toolbar");
    await user.stopsAt("testFirst.pgx", 6);
    await user.keys("F5");
    await debugged(user);
  },

  async "a failed assertion stops the debugger at the line of the test"(user) {
    await opensTestingView(user);
    await user.openFile("testSum.pgx");
    writeProgram("sum", sumCode(2));
    await runsLens(user, "Run test", "testSum", "Passed");
    writeProgram("sum", sumCode(3));
    await user.opensLens("Debug test", ".debug-toolbar");
    await user.stopsAt("sum.pgx", 6);
    await user.page.waitForSelector('.exception-widget:has-text("2 instead of 3")');
    await user.keys("F5");
    await debugged(user);
    await opensTestingView(user);
    await hasState(user, "testSum", "Failed");
  },

  async "a new test appears, and a run that is cancelled ends"(user) {
    listPrograms("sum", "testSum", "testEndless");
    // Each iteration is slow on this machine, but has 2 µs of the 60 s on the controller's clock.
    const slow = Array.from({ length: 40 }, () => `${"sin(cos(".repeat(10)}1${"))".repeat(10)}`).join("+");
    writeProgram("testEndless", `  while ${slow}<1000\n  endWhile`);
    await user.openFile("testEndless.pgx");
    await user.page.click(row("testEndless"));
    await runsLens(user, "Run test", "testEndless", "Running");
    await user.page.click(".sidebar .codicon-testing-cancel-icon");
    await hasState(user, "testEndless", "Skipped");
    await hasState(user, "testSum", "Failed");
  },

  async "a run with coverage colours the lines of the tested library"(user) {
    listPrograms("sum", "testSum", "testOffset");
    writeProgram("testOffset", "  call box:offset(0,0,0,trOffset)");
    await user.page.hover(row("testOffset"));
    await user.page.click(`${row("testOffset")} .codicon-testing-coverage-icon`);
    await hasState(user, "testOffset", "Passed");
    await user.page.click('.test-coverage-list-item:has-text("offset.pgx")');
    await user.tab("offset.pgx");
    // The condition was only false.
    await hasColours(user, { 12: ["hit"], 13: ["hit", "miss"], 14: ["miss"] });
  },

  async "an application that the compiler refuses shows the reason"(user) {
    writeProgram("testOffset", "  nUnknown=1");
    await user.page.waitForSelector('.test-explorer .monaco-list-row:has-text("the compiler rejects the application")');
  },
};

/** Returns the code of a program that compares a sum with a number. */
function sumCode(number) {
  return `  ? "sum"\n  call assert:equalNum(1+1,${number},0)`;
}

/** Writes the project with the programs that the first test does not contain. */
function listPrograms(...names) {
  const library = '    <Library alias="box" path="Disk://partBox/partBox.pjx" />\n  </Libraries>';
  const project = PROJECT.replace("  </Programs>", () => `${listed(...names)}  </Programs>`).replace("  </Libraries>", library);
  writeFileSync(join(TESTS, "partBoxTest.pjx"), project);
}

function writeData() {
  const path = join(TESTS, "partBoxTest.dtx");
  const data = '<Datas><Data name="trOffset" access="private" xsi:type="array" type="trsf" size="1" /></Datas>';
  writeFileSync(path, readFileSync(path, "utf8").replace("<Datas />", data));
}

cpSync(join(process.env.VAL3_ROOT, "examples/palletiser/usr"), join(cell, "usr"), { recursive: true });
execFileSync(process.env.VAL3_SERVER, ["test", "--init", join(cell, "usr/usrapp/partBox")], { stdio: "ignore" });
const PROJECT = readFileSync(join(TESTS, "partBoxTest.pjx"), "utf8");
listPrograms("sum", "testSum");
writeData();
writeProgram("sum", sumCode(3));
writeProgram("testSum", "  call sum()");
mkdirSync(join(cell, ".vscode"));
runSteps({ name: "testing", folder, open: `folder=${cell}`, steps: STEPS });
