// s5 files, which are and declare to be in ISO-8859-1: the saved bytes are exactly what the user wrote.
const assert = require("node:assert/strict");
const { mkdirSync, mkdtempSync, readFileSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { runSteps } = require("./steps");

const folder = mkdtempSync(join(tmpdir(), "val3-encoding-"));
const cell = join(folder, "cell");
const APPLICATION = join(cell, "usr/usrapp/coffee");

const HEAD = '<?xml version="1.0" encoding="iso-8859-1" ?>';
const lines = (...lines) => [...lines, ""].join("\r\n");
const program = (name, ...code) => lines(HEAD, '<programList xmlns="ProgramNameSpace" >', `  <program name="${name}" public="false" >`,
  "    <description></description>", "    <paramSection></paramSection>", "    <localSection></localSection>",
  `    <source><code>begin`, ...code, "end", "    </code></source>", "  </program>", "</programList>");
const FILES = {
  "coffee.pjx": lines(HEAD, '<project xmlns="ProjectNameSpace" >', '  <parameters version="s5.3.2" stackSize="5000" millimeterUnit="true" />',
    "  <programSection>", ...["cup", "pot", "start", "stop"].map((name) => `    <program file="${name}.pgx" />`), "  </programSection>",
    "  <dataSection>", '    <data file="coffee.dtx" />', "  </dataSection>", "  <aliasSection>", "  </aliasSection>", "</project>"),
  "coffee.dtx": lines(HEAD, '<dataList xmlns="DataNameSpace" >', "  <stringSection>", '    <string name="sDrink" public="false" size="1" >',
    '      <valueString index="0" value="café" />', "    </string>", "  </stringSection>", "</dataList>"),
  "cup.pgx": program("cup", "  // crème", "  sDrink=&quot;café&quot;"),
  "pot.pgx": program("pot", "  sDrink=&quot;thé vert&quot;"),
  "start.pgx": program("start", "  call cup()", "  call pot()"),
  "stop.pgx": program("stop", "  // arrêt", "  // total"),
};
/** A program in the format of newer controllers, but in ISO-8859-1. */
const SECTION = lines(HEAD, '<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">', '  <Program name="section">',
  "    <Code><![CDATA[begin", "  // thé", "end]]></Code>", "  </Program>", "</Programs>");
/** A file that declares UTF-8 but is not in UTF-8. */
const FALSE = Buffer.from(program("false", "  // crème").replace("iso-8859-1", "utf-8"), "latin1");

const read = (name) => readFileSync(join(APPLICATION, name));

/** Waits until a file on the disk has these bytes. */
async function becomes(name, expected) {
  const bytes = Buffer.from(expected, "latin1");
  for (let attempt = 0; attempt < 100 && !read(name).equals(bytes); attempt += 1) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  assert.equal(read(name).toString("latin1"), bytes.toString("latin1"));
}

const after = (name, before, now) => FILES[name].replaceAll(before, now);

const STEPS = {
  async "a program in ISO-8859-1 shows its letters"(user) {
    await user.openFile("cup.pgx");
    await user.sees("// crème");
    await user.sees("sDrink=&quot;café&quot;");
    await user.page.waitForSelector('.statusbar-item:has-text("ISO 8859-1")');
  },

  async "what is saved is in ISO-8859-1"(user) {
    await user.goTo(8, 11);
    await user.type(" brûlée");
    await user.keys("Control+S");
    FILES["cup.pgx"] = after("cup.pgx", "crème", "crème brûlée");
    await becomes("cup.pgx", FILES["cup.pgx"]);
  },

  async "a letter that ISO-8859-1 lacks becomes a reference"(user) {
    await user.goTo(9, 20);
    await user.type("中");
    await user.keys("Control+S");
    await becomes("cup.pgx", after("cup.pgx", "café", "café&#20013;"));
    await user.sees("café&#20013;");
    await user.keys("Control+Z", "Control+Z");
    await user.seesNot("&#20013;");
    await user.keys("Control+S");
    await becomes("cup.pgx", FILES["cup.pgx"]);
  },

  async "a CDATA section has no references, so its file becomes UTF-8 and says so"(user) {
    await user.openFile("section.pgx");
    await user.sees("// thé");
    await user.goTo(5, 9);
    await user.type("中");
    await user.keys("Control+S");
    await user.told("section.pgx is saved in UTF-8: iso88591 does not have 中.");
    const now = SECTION.replace("iso-8859-1", "utf-8").replace("thé", "thé中");
    await becomes("section.pgx", Buffer.from(now).toString("latin1"));
    await user.page.waitForSelector('.statusbar-item:has-text("UTF-8")');
  },

  async "the code view shows the letters and saves them"(user) {
    await user.openFile("pot.pgx");
    await user.command("VAL 3: Open Code without XML");
    await user.sees('sDrink="thé vert"');
    await user.goTo(2, 19);
    await user.type(" âgé");
    await user.keys("Control+S");
    FILES["pot.pgx"] = after("pot.pgx", "thé vert", "thé vert âgé");
    await becomes("pot.pgx", FILES["pot.pgx"]);
    await user.command("View: Close All Editors");
  },

  async "a name is changed in files that are not open"(user) {
    await user.openFile("start.pgx");
    await user.command("View: Close All Editors");
    await user.openFile("cup.pgx");
    await user.goTo(9, 4);
    await user.keys("F2");
    await user.page.fill(".rename-box input", "sCup");
    await user.keys("Enter");
    await user.sees("sCup=");
    await user.command("File: Save All Files");
    for (const name of ["cup.pgx", "pot.pgx", "coffee.dtx"]) {
      FILES[name] = after(name, "sDrink", "sCup");
      await becomes(name, FILES[name]);
    }
  },

  async "text is replaced in files that are not open"(user) {
    await user.command("View: Close All Editors");
    await user.command("Search: Replace in Files");
    await user.page.fill('.search-view textarea[placeholder="Search"]', "total");
    await user.page.waitForSelector('.search-view .monaco-list-row:has-text("stop.pgx")');
    await user.page.fill('.search-view textarea[placeholder="Replace"]', "brusque");
    await user.page.waitForSelector('.search-view .monaco-list-row:has-text("totalbrusque")');
    await user.page.click(".search-view .codicon-search-replace-all");
    FILES["stop.pgx"] = after("stop.pgx", "total", "brusque");
    await becomes("stop.pgx", FILES["stop.pgx"]);
    await user.openFile("stop.pgx");
    await user.sees("// arrêt");
    await user.sees("// brusque");
    await user.page.waitForSelector('.statusbar-item:has-text("ISO 8859-1")');
  },

  async "a file whose bytes are not as it says keeps them"(user) {
    await user.openFile("false.pgx");
    await user.sees("// crème");
    await user.goTo(8, 11);
    await user.type(" fraîche");
    await user.keys("Control+S");
    await becomes("false.pgx", FALSE.toString("latin1").replace("crème", "crème fraîche"));
  },
};

mkdirSync(APPLICATION, { recursive: true });
for (const [name, text] of Object.entries(FILES)) {
  writeFileSync(join(APPLICATION, name), text, "latin1");
}
writeFileSync(join(APPLICATION, "false.pgx"), FALSE);
writeFileSync(join(APPLICATION, "section.pgx"), SECTION, "latin1");
runSteps({ name: "encoding", folder, open: `folder=${cell}`, steps: STEPS });
