// A user edits data files as tables: in both dialects, in the text at the same time, and with thousands of points.
const assert = require("node:assert/strict");
const { cpSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { COFFEE, LARGE, POINTS } = require("./dataCells");
const { runSteps } = require("./steps");
const { GRID, Tables } = require("./tables");

const folder = mkdtempSync(join(tmpdir(), "val3-data-"));
const cell = join(folder, "cell");
const APPLICATIONS = join(cell, "usr/usrapp");
const DATA = "palletiser/palletiser.dtx";

cpSync(join(process.env.VAL3_ROOT, "examples/palletiser/usr"), join(cell, "usr"), { recursive: true });
for (const [path, content] of Object.entries({ ...COFFEE, ...LARGE })) {
  mkdirSync(join(APPLICATIONS, path, ".."), { recursive: true });
  writeFileSync(join(APPLICATIONS, path), content, "latin1");
}

const read = (path) => readFileSync(join(APPLICATIONS, path), "latin1");
const bytes = (text) => Buffer.from(text).toString("latin1");
const ORIGINAL = read(DATA);

/** Returns a text after these replacements, each of which must apply once. */
function after(text, ...replacements) {
  return replacements.map((pair) => pair.map(bytes)).reduce((text, [before, now]) => {
    assert.equal(text.split(before).length, 2, `${before} is not there once`);
    return text.replace(before, () => now);
  }, text);
}

/** Waits until a file on the disk has these bytes. */
async function becomes(path, expected) {
  for (let attempt = 0; attempt < 100 && read(path) !== expected; attempt += 1) {
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  assert.equal(read(path), expected);
}

/**
 * Executes a change and saves it, then undoes it and saves again. The file must have exactly the expected bytes both
 * times.
 */
async function changes(tables, path, expected, change) {
  const before = read(path);
  await change();
  await tables.focus();
  await tables.user.keys("Control+S");
  await becomes(path, expected);
  await tables.user.keys("Control+Z");
  await tables.frame.waitForTimeout(300);
  await tables.user.keys("Control+S");
  await becomes(path, before);
}

/**
 * Saves all files until they have their expected bytes: one editor may show a change that another one does not have
 * yet.
 */
async function savesAll(user, files) {
  const isSaved = () => Object.entries(files).every(([path, expected]) => read(path) === expected);
  for (let attempt = 0; attempt < 20 && !isSaved(); attempt += 1) {
    await user.command("File: Save All Files");
    await user.page.waitForTimeout(200);
  }
  Object.entries(files).forEach(([path, expected]) => assert.equal(read(path), expected));
}

let tables;

const STEPS = {
  async "a button of the text opens the tables at the datum with the cursor"(user) {
    await user.openFile("palletiser.dtx");
    await user.goTo(28, 20);
    await user.page.click('.editor-actions .action-label[aria-label^="Open Data as Tables"]');
    tables = await Tables.of(user);
    await tables.frame.waitForSelector('td.active:has-text("mFast")');
    await tables.shows("mFast", "vel", "90");
    await tables.frame.waitForSelector('thead th:has-text("vel"):has-text("%")');
  },

  async "a value is typed, and undone"(user) {
    await changes(tables, DATA, after(ORIGINAL, ['vel="90"', 'vel="85"']), () => tables.set("mFast", "vel", "85"));
  },

  async "a default is written, and a value becomes the default"(user) {
    await changes(tables, DATA, after(ORIGINAL, [' vel="90" leave="120"', ' vel="90" decel="80" leave="120"']), () => tables.set("mFast", "decel", "80"));
    await changes(tables, DATA, after(ORIGINAL, [' vel="90" leave="120"', ' leave="120"']), async () => {
      await tables.select("mFast", "vel");
      await user.keys("Delete");
      await tables.shows("mFast", "vel", "100");
    });
  },

  async "a wrong value is shown while it is typed, and is not lost"(user) {
    await tables.select("mFast", "vel");
    await user.type("fast");
    await tables.frame.waitForSelector(".cell-editor[aria-invalid=true]");
    await tables.frame.waitForFunction(() => document.querySelector("#cell-verdict").textContent !== "");
    await user.keys("Escape");
    await tables.shows("mFast", "vel", "90");
  },

  async "truth values, access, choices and fathers"(user) {
    await tables.type("bool");
    await changes(tables, DATA, after(ORIGINAL, ['name="bRun" access="public" xsi:type="array" type="bool" size="1" />', 'name="bRun" access="public" xsi:type="array" type="bool" size="1">\n      <Value key="0" value="true" />\n    </Data>']), async () => {
      await tables.select("bRun", "value");
      await user.keys("Space");
      await tables.frame.waitForFunction(() => document.querySelector("td.active input")?.checked === true);
    });
    await changes(tables, DATA, after(ORIGINAL, ['name="bRun" access="public"', 'name="bRun" access="private"']), async () => {
      await tables.select("bRun", "Access");
      await user.keys("Enter");
      await tables.shows("bRun", "Access", "private");
    });
    await tables.type("pointRx");
    await changes(tables, DATA, after(ORIGINAL, ['z="50" rx="180" shoulder="lefty"', 'z="50" rx="180" shoulder="righty"']), async () => {
      await tables.select("pPick", "shoulder");
      await user.keys("Enter");
      await user.type("r");
      await user.keys("Enter");
      await tables.shows("pPick", "shoulder", "righty");
    });
    await changes(tables, DATA, after(ORIGINAL, ['elbow="epositive" wrist="wpositive" fatherId="fConveyor[0]"', 'elbow="epositive" wrist="wpositive" fatherId="fPallet[0]"']), () => tables.set("pPick", "father", "fPallet[0]"));
  },

  async "poses in world and reachability are shown"() {
    await tables.row("pPick").locator('td:text-is("reachable")').waitFor();
    await tables.row("pPick").locator("td.world", { hasText: /-?\d+\.\d/ }).waitFor();
  },

  async "arrays expand, and change their size"(user) {
    await tables.expand("pCorner");
    await tables.shows("[1]", "y", "1200");
    await changes(tables, DATA, after(ORIGINAL, ['<Value key="1" y="1200"', '<Value key="1" x="5" y="1200"']), () => tables.set("[1]", "x", "5"));
    await changes(tables, DATA, after(ORIGINAL, ['name="pCorner" access="private" xsi:type="array" type="pointRx" size="3"', 'name="pCorner" access="private" xsi:type="array" type="pointRx" size="2"'], ['      <Value key="2" x="-800" fatherId="fCell[0]" />\n', ""]), () => tables.set("pCorner", "Size", "2"));
  },

  async "keys of collections are added, renamed and removed"(user) {
    await tables.type("num");
    await tables.expand("nDone");
    await changes(tables, DATA, after(ORIGINAL, ['      <Value key="box" />\n    </Data>\n    <Data name="nLayer"', '      <Value key="box" />\n      <Value key="crate" />\n    </Data>\n    <Data name="nLayer"']), async () => {
      await tables.select("nDone", "Name");
      await user.keys("Insert");
      await tables.answer("crate");
    });
    await changes(tables, DATA, after(ORIGINAL, ['<Value key="bag" />', '<Value key="sack" />']), () => tables.set('["bag"]', "Name", "sack"));
    await changes(tables, DATA, after(ORIGINAL, ['      <Value key="bag" />\n', ""]), async () => {
      await tables.select('["bag"]', "Name");
      await user.keys("Delete");
      await tables.row('["bag"]').waitFor({ state: "detached" });
    });
  },

  async "data are added, duplicated and deleted"(user) {
    await changes(tables, DATA, after(ORIGINAL, ['    <Data name="nDone"', '    <Data name="nNew" access="private" xsi:type="array" type="num" size="1" />\n    <Data name="nDone"']), async () => {
      await tables.select("nAbove", "Name");
      await user.keys("Insert");
      await tables.answer("nNew");
      await tables.frame.waitForSelector('td.active:has-text("nNew")');
    });
    await changes(tables, DATA, after(ORIGINAL, ['    <Data name="nDone"', '    <Data name="nAbove2" access="private" xsi:type="array" type="num" size="1">\n      <Value key="0" value="150" />\n    </Data>\n    <Data name="nDone"']), async () => {
      await tables.select("nAbove", "Name");
      await tables.press("Duplicate");
      await tables.answer();
    });
    await changes(tables, DATA, after(ORIGINAL, ['    <Data name="nAbove" access="private" xsi:type="array" type="num" size="1">\n      <Value key="0" value="150" />\n    </Data>\n', ""]), async () => {
      await tables.select("nAbove", "Name");
      await user.keys("Delete");
      await tables.frame.waitForSelector(".uses li");
      await tables.answer();
    });
  },

  async "a rectangle is copied and pasted as text of a spreadsheet"(user) {
    await tables.type("frame");
    await tables.select("fCell", "x");
    await user.keys("Shift+ArrowRight", "Control+C");
    await changes(tables, DATA, after(ORIGINAL, ['<Value key="0" rz="90" fatherId="fCell[0]" />', '<Value key="0" x="950" y="-600" rz="90" fatherId="fCell[0]" />']), async () => {
      await tables.select("fPallet", "x");
      await user.keys("Control+V");
      await tables.shows("fPallet", "y", "-600");
    });
  },

  async "fields of user types expand and are edited"(user) {
    await tables.type("Slot");
    await tables.expand("tSlots");
    await tables.expand("[0,1]");
    const value = '<Value key="0" x="600" y="150" z="20"';
    await changes(tables, DATA, after(ORIGINAL, [value, '<Value key="0" x="650" y="150" z="20"']), async () => {
      await tables.row("pPlace").locator("td", { hasText: /^x 600/ }).click();
      await tables.focus();
      await user.type("650");
      await user.keys("Enter");
      await tables.row("pPlace").locator("td", { hasText: /^x 650/ }).waitFor();
    });
    await changes(tables, DATA, after(ORIGINAL, ['type="Slot" size="2 3"', 'type="Slot" size="2 4"']), () => tables.set("tSlots", "Size", "2 4"));
  },

  async "a datum is renamed in all files"(user) {
    const pick = read("palletiser/pick.pgx");
    await tables.type("num");
    await tables.set("nAbove", "Name", "nOver");
    await tables.row("nOver").waitFor();
    await user.command("File: Save All Files");
    await becomes(DATA, after(ORIGINAL, ['name="nAbove"', 'name="nOver"']));
    assert.ok(pick.includes("nAbove"));
    await becomes("palletiser/pick.pgx", pick.replaceAll("nAbove", "nOver"));
    await tables.focus();
    await tables.set("nOver", "Name", "nAbove");
    await tables.row("nAbove").waitFor();
    await user.command("File: Save All Files");
    await becomes(DATA, ORIGINAL);
  },

  async "text and tables stay in step"(user) {
    await tables.select("nAbove", "Name");
    await user.page.click('.editor-actions .action-label[aria-label^="Open the Data File"]');
    await user.tab("palletiser.dtx");
    await user.page.waitForSelector('.statusbar-item:has-text("Ln 33, Col")');
    await user.command("View: Close All Editors");
    await user.openFile("palletiser.dtx");
    await user.keys("Control+\\");
    await user.page.waitForFunction(() => document.querySelectorAll(".editor-group-container").length === 2);
    await user.command("VAL 3: Open Data as Tables");
    tables = await Tables.of(user);
    await tables.type("num");
    await tables.set("nAbove", "value", "175");
    await user.sees('value="175"');
    await user.focusEditor();
    await user.keys("Control+Z");
    await user.seesNot('value="175"');
    await tables.shows("nAbove", "value", "150");
    await user.goTo(34, 29);
    await user.type("9");
    await tables.shows("nAbove", "value", "9150");
    await user.keys("Control+Z");
    await tables.shows("nAbove", "value", "150");
    await user.command("View: Close All Editors");
  },

  async "the keyboard alone is enough"(user) {
    tables = await Tables.open(user, "palletiser.dtx");
    await user.keys("Control+F");
    await user.type("nabove");
    await tables.frame.waitForFunction(() => document.querySelector("[id='type-num'] .count").textContent.startsWith("1 of"));
    await user.keys("Tab", "Tab", "Tab", "Tab");
    for (let presses = 0; presses < 12 && !(await tables.frame.evaluate(() => document.activeElement.matches("[role=tab]"))); presses += 1) {
      await user.keys("Tab");
    }
    while ((await tables.frame.evaluate(() => document.activeElement.id)) !== "type-num") {
      await user.keys("ArrowDown");
    }
    await user.keys("Tab");
    await tables.frame.waitForFunction((grid) => document.activeElement.matches(grid), GRID);
    await user.keys("Control+ArrowRight");
    await user.type("160");
    await user.keys("Enter");
    await tables.shows("nAbove", "value", "160");
    await user.keys("Control+S");
    await becomes(DATA, after(ORIGINAL, ['<Value key="0" value="150" />', '<Value key="0" value="160" />']));
    await user.keys("Control+Z");
    await tables.shows("nAbove", "value", "150");
    await user.keys("Control+S");
    await becomes(DATA, ORIGINAL);
  },

  async "a change on the disk is followed"() {
    writeFileSync(join(APPLICATIONS, DATA), after(ORIGINAL, ['<Value key="0" value="150" />', '<Value key="0" value="99" />']), "latin1");
    await tables.shows("nAbove", "value", "99");
    writeFileSync(join(APPLICATIONS, DATA), ORIGINAL, "latin1");
    await tables.shows("nAbove", "value", "150");
  },

  async "a change of equal size on the disk is not replaced unnoticed"(user) {
    await tables.set("nAbove", "value", "151");
    writeFileSync(join(APPLICATIONS, DATA), after(ORIGINAL, ['vel="90"', 'vel="77"']), "latin1");
    await user.told("Another program has changed", "Compare");
    await user.page.waitForSelector(".monaco-diff-editor");
    const elsewhere = after(ORIGINAL, ['vel="90"', 'vel="78"']);
    writeFileSync(join(APPLICATIONS, DATA), elsewhere, "latin1");
    await user.told("Another program has changed", "Discard My Changes");
    // The text becomes the active editor for it, and has the keyboard focus.
    await user.page.waitForSelector('.tab.active[data-resource-name="palletiser.dtx"]:not([aria-label*="↔"])');
    await user.page.waitForSelector(".editor-instance .monaco-editor.focused");
    tables = await Tables.open(user, "palletiser.dtx");
    await tables.type("num");
    await tables.shows("nAbove", "value", "150");
    assert.equal(read(DATA), elsewhere);
    writeFileSync(join(APPLICATIONS, DATA), ORIGINAL, "latin1");
  },

  async "a change on the disk and unsaved changes are both kept until the user decides"(user) {
    // VS Code compares the sizes of files.
    const elsewhere = after(ORIGINAL, ['vel="90"', 'vel="100"']);
    await tables.set("nAbove", "value", "151");
    writeFileSync(join(APPLICATIONS, DATA), elsewhere, "latin1");
    await user.told("Another program has changed");
    await tables.shows("nAbove", "value", "151");
    await tables.focus();
    await user.keys("Control+S");
    await user.page.waitForSelector('.notification-toast:has-text("Failed to save")');
    assert.equal(read(DATA), elsewhere);
    await tables.shows("nAbove", "value", "151");
    await user.told("Failed to save", "Overwrite");
    await becomes(DATA, after(ORIGINAL, ['<Value key="0" value="150" />', '<Value key="0" value="151" />']));
    await tables.set("nAbove", "value", "150");
    await tables.focus();
    await user.keys("Control+S");
    await becomes(DATA, ORIGINAL);
    await user.command("View: Close All Editors");
  },

  async "a file of the s5 series keeps its dialect, its line ends and its encoding"(user) {
    tables = await Tables.open(user, "coffee.dtx");
    await tables.type("num");
    await tables.expand("nCups");
    await changesOld([['index="1" value="4"', 'index="1" value="5"']], () => tables.set("[1]", "value", "5"));
    await changesOld([['<num name="nCups" public="false"', '<num name="nCups" public="true"']], async () => {
      await tables.select("nCups", "Access");
      await user.keys("Enter");
      await tables.shows("nCups", "Access", "public");
    });
    await changesOld([['      <valueNum index="1" value="4" />\r\n', '      <valueNum index="1" value="4" />\r\n      <valueNum index="2" value="0" />\r\n']], () => tables.set("nCups", "Size", "3"));
    await tables.type("point");
    await changesOld([['<tpValue x="1" y="2"', '<tpValue x="1" y="2.5"']], () => tables.set("pCup", "y", "2.5"));
    await changesOld([['<cpValue shoulder="ssame"', '<cpValue shoulder="lefty"']], async () => {
      await tables.select("pCup", "shoulder");
      await user.keys("Enter");
      await user.type("l");
      await user.keys("Enter");
      await tables.shows("pCup", "shoulder", "lefty");
    });
    await changesOld([['<pFather alias="" name="fTable"', '<pFather alias="" name="world"']], () => tables.set("pCup", "father", "world[0]"));
    await tables.type("string");
    await tables.shows("sDrink", "value", "café & crème");
    await changesOld([["café &amp; crème", "thé &amp; crème"]], () => tables.set("sDrink", "value", "thé & crème"));
  },

  async "joints, motion descriptors, tools and truth values of the s5 series"(user) {
    await tables.type("joint");
    await changesOld([['j3="90" j4="0"', 'j3="90" j4="-45"']], () => tables.set("jHome", "j4", "-45"));
    await tables.type("mdesc");
    await changesOld([['vel="50"', 'vel="60"']], () => tables.set("mSlow", "vel", "60"));
    await tables.type("tool");
    await changesOld([['z="95"', 'z="97.5"']], () => tables.set("tGrip", "z", "97.5"));
    await changesOld([['ioIndex="0" open="0"', 'ioIndex="0" open="0.2"']], () => tables.set("tGrip", "otime", "0.2"));
    await changesOld([['name="dValve" ioIndex="0"', 'name="dValve" ioIndex="1"']], () => tables.set("tGrip", "gripper", "dValve[1]"));
    await tables.type("bool");
    await changesOld([['<valueBool index="0" value="true" />', '<valueBool index="0" value="false" />']], async () => {
      await tables.select("bHot", "value");
      await user.keys("Space");
      await tables.frame.waitForFunction(() => document.querySelector("td.active input")?.checked === false);
    });
  },

  async "sizes of the s5 series, with and without values"() {
    await tables.type("dio");
    await changesOld([['<dio name="dValve" public="false" privilege="0" size="2" />', '<dio name="dValve" public="false" privilege="0" size="4" />']], () => tables.set("dValve", "Size", "4"));
    await tables.type("num");
    await changesOld([['      <valueNum index="1" value="4" />\r\n', ""]], () => tables.set("nCups", "Size", "1"));
    await tables.type("joint");
    await changesOld([["      </valueJoint>\r\n", '      </valueJoint>\r\n      <valueJoint index="1" >\r\n        <jointValue j1="0" j2="0" j3="0" j4="0" j5="0" j6="0" />\r\n      </valueJoint>\r\n']], () => tables.set("jHome", "Size", "2"));
  },

  async "data of the s5 series are added, duplicated and deleted"(user) {
    await tables.type("num");
    await changesOld([["    </num>\r\n", '    </num>\r\n    <num name="nNew" public="false" privilege="0" >\r\n      <valueNum index="0" value="0" />\r\n    </num>\r\n']], async () => {
      await tables.select("nCups", "Name");
      await user.keys("Insert");
      await tables.answer("nNew");
      await tables.frame.waitForSelector('td.active:has-text("nNew")');
    });
    await changesOld([["  <trsfSection />", ['  <trsfSection>', '    <trsf name="trNew" public="false" privilege="0" >', '      <valueTrsf index="0" >',
      '        <trsfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />', "      </valueTrsf>", "    </trsf>", "  </trsfSection>"].join("\r\n")]], async () => {
      await tables.press("Add");
      await tables.frame.selectOption("dialog label:has-text('Type') select", "trsf");
      await tables.frame.focus("dialog input");
      await tables.answer("trNew");
      await tables.frame.waitForSelector('td.active:has-text("trNew")');
    });
    await tables.type("point");
    const point = COFFEE_DATA.slice(COFFEE_DATA.indexOf('    <point name="pCup"'), COFFEE_DATA.indexOf("  </pointSection>"));
    await changesOld([["  </pointSection>", `${point.replace("pCup", "pCup2")}  </pointSection>`]], async () => {
      await tables.select("pCup", "Name");
      await tables.press("Duplicate");
      await tables.answer();
      await tables.row("pCup2").waitFor();
    });
    await changesOld([[`  <pointSection>\r\n${point}  </pointSection>`, "  <pointSection />"]], async () => {
      await tables.select("pCup", "Name");
      await user.keys("Delete");
      await tables.answer();
      await tables.row("pCup").waitFor({ state: "detached" });
    });
  },

  async "a rectangle is pasted into a file of the s5 series"(user) {
    await tables.type("frame");
    await tables.select("fTable", "x");
    await user.keys("Shift+ArrowRight", "Control+C");
    await changesOld([['<tfValue x="100" y="0" z="0" rx="0"', '<tfValue x="100" y="100" z="0" rx="0"']], async () => {
      await tables.select("fTable", "y");
      await user.keys("Control+V");
      await tables.shows("fTable", "y", "100");
    });
  },

  async "data of the s5 series are renamed in all files"(user) {
    const [data, program] = [COFFEE_DATA, COFFEE["coffee/start.pgx"]];
    await tables.type("num");
    await tables.set("nCups", "Name", "nMugs");
    await tables.row("nMugs").waitFor();
    await savesAll(user, { "coffee/coffee.dtx": afterLatin(data, ["nCups", "nMugs"]), "coffee/start.pgx": afterLatin(program, ["nCups", "nMugs"]) });
    await tables.focus();
    await tables.set("nMugs", "Name", "nCups");
    await tables.row("nCups").waitFor();
    await savesAll(user, { "coffee/coffee.dtx": data, "coffee/start.pgx": program });
    await user.command("View: Close All Editors");
  },

  async "ten thousand points and an array of ten thousand elements"(user) {
    const started = Date.now();
    tables = await Tables.open(user, "large.dtx");
    await tables.type("pointRx");
    await tables.frame.waitForSelector(`[id="type-pointRx"] .count:text-is("${POINTS}")`);
    console.log(`opened in ${Date.now() - started} ms`);
    await tables.focus();
    await user.keys("Control+End");
    await tables.row(`pPoint${POINTS - 1}`).waitFor();
    assert.ok(await tables.frame.evaluate(() => document.querySelectorAll("tbody tr").length) < 80, "only rows on the screen are drawn");
    const large = LARGE["large/large.dtx"];
    await changes(tables, "large/large.dtx", after(large, [`x="999" y="${(POINTS - 1) / 8}"`, `x="998.5" y="${(POINTS - 1) / 8}"`]), async () => {
      const set = Date.now();
      await tables.set(`pPoint${POINTS - 1}`, "x", "998.5");
      await tables.shows(`pPoint${POINTS - 1}`, "x", "998.5");
      console.log(`edited in ${Date.now() - set} ms`);
    });
    await tables.type("num");
    await tables.expand("nMany");
    await user.keys("Control+End");
    await tables.shows("[9999]", "value", "1");
    await user.command("View: Close All Editors");
  },

  async "the uses of data are shown before they are deleted, with links"(user) {
    tables = await Tables.open(user, "palletiser.dtx");
    await tables.type("num");
    await tables.select("nAbove", "Name");
    await user.keys("Delete");
    await tables.frame.waitForSelector('.uses li:has-text("appro")');
    await tables.frame.click(".uses li button");
    await user.sees("nAbove");
    await user.keys("Control+F4");
    await tables.frame.click("dialog button:text-is('Cancel')");
    await tables.frame.waitForSelector("dialog", { state: "detached" });
    assert.equal(read(DATA), ORIGINAL);
    await user.command("View: Close All Editors");
  },

  async "the tables follow a dark theme"(user) {
    await user.keys("Control+K", "Control+T");
    await user.choose("Dark Modern");
    tables = await Tables.open(user, "palletiser.dtx");
    await tables.type("pointRx");
    await tables.expand("pCorner");
    const [text, page] = await tables.frame.evaluate(() => ["color", "backgroundColor"].map((name) => getComputedStyle(document.body)[name]));
    const brightness = (colour) => colour.match(/\d+/g).slice(0, 3).reduce((sum, part) => sum + Number(part), 0);
    assert.ok(brightness(text) > 400 && brightness(page) < 200, `${text} on ${page}`);
  },

  async "the tables follow a theme with high contrast"(user) {
    await user.keys("Control+K", "Control+T");
    await user.choose("Dark High Contrast");
    await tables.frame.waitForFunction(() => document.body.classList.contains("vscode-high-contrast"));
    await tables.select("pPick", "x");
    await tables.press("Add");
    await tables.frame.waitForSelector("dialog[open]");
  },
};

/** Like `after`, for a file in ISO-8859-1, whose text represents its bytes. */
function afterLatin(text, ...replacements) {
  return replacements.reduce((text, [before, now]) => {
    assert.equal(text.split(before).length, 2, `${before} is not there once`);
    return text.replace(before, () => now);
  }, text);
}

const COFFEE_DATA = COFFEE["coffee/coffee.dtx"];

/** Like `changes`, for the s5 file. */
function changesOld(replacements, change) {
  return changes(tables, "coffee/coffee.dtx", afterLatin(COFFEE_DATA, ...replacements), change);
}

runSteps({ name: "data", folder, open: `folder=${cell}`, steps: STEPS });
