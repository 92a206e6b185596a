// The palletiser is operated in a browser: keys, signals, points, and the recording of a run.
const assert = require("node:assert/strict");
const { spawnSync } = require("node:child_process");
const { readFileSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { BOXES, hold, jogTo, moveForever, openFile, served, until } = require("./served.js");

const POINTS = "usr/usrapp/palletiser/palletiser.dtx";

test("typed keys and forced inputs let the program continue", () => served([], async (run) => {
  const page = await run.open();
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
  await page.getByRole("application").focus();
  await page.keyboard.press("F1");
  await page.getByText("State    running").waitFor();
  assert.deepEqual(await page.evaluate(() => window.val3View.store.panels.cell.motion.value.queue), []);
  const still = await page.evaluate(() => window.val3View.pose());
  await page.getByRole("tab", { name: "Inputs and outputs" }).click();
  for (const input of ["I0", "I4", "I5"]) {
    await page.getByRole("searchbox").fill(`%${input}`);
    await page.getByRole("button", { name: `%${input} is` }).first().click();
    await page.waitForFunction((input) => window.val3View.store.panels.cell.levels.value.get(`BasicIO-1\\%${input}`)?.value === 1, input);
  }
  await page.waitForFunction((still) => window.val3View.pose().some((part, axis) => Math.abs(part - still[axis]) > 5), still);
}));

test("an operator moves the arm by hand", () => served([], async (run) => {
  const page = await run.open();
  const joint = () => page.evaluate(() => window.val3View.store.panels.cell.sample.value.joints[0]);
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
  const start = await joint();
  const plus = page.getByRole("button", { name: "J1 plus" });
  await plus.focus();
  await page.keyboard.press("Enter");
  await page.getByText("Choose the manual working mode to jog.").first().waitFor();
  assert.equal(await joint(), start);
  await page.getByLabel(/mode/i).first().selectOption("manual");
  // Another working mode switches the power off.
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
  await plus.focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction((start) => Math.abs(window.val3View.store.panels.cell.sample.value.joints[0] - start) > 4.99, start);
  await hold(page, page.getByRole("button", { name: "J1 minus" }), (start) => window.val3View.store.panels.cell.sample.value.joints[0] < start - 8, start);
}));

// These files have no volume: distances of them would be an error.
test("links have the shapes of their files", () => served(["--cell", "none"], async (run) => {
  const page = await run.open();
  await page.getByText("Link 1 is drawn as a solid, because its file cannot be read").waitFor();
  assert.equal(await page.getByText("The base is drawn").count(), 0);
}, (folder) => {
  const triangle = "solid base\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 300 0 0\nvertex 0 300 0\nendloop\nendfacet\nendsolid base\n";
  writeFileSync(join(folder, "base.stl"), triangle);
  writeFileSync(join(folder, "link.glb"), "glTF");
  writeFileSync(join(folder, "val3.toml"), '[run]\nshapes = { base = "base.stl", link1 = "link.glb" }\n');
}));

test("a point is taught and saved, and nothing else is", () => served(["--power"], async (run) => {
  const file = join(run.folder, POINTS);
  const before = readFileSync(file, "latin1");
  const page = await run.open();
  await until(page, 3);
  await page.getByRole("tab", { name: "Points" }).click();
  const point = await page.evaluate(() => window.val3View.store.panels.cell.points.value.find(({ name }) => !name.includes(":")));
  const name = point.key === null ? point.name : `${point.name}[${point.key}]`;
  await page.getByRole("button", { name, exact: true }).click();
  await page.getByRole("button", { name: /here/i }).click();
  const save = page.getByRole("button", { name: "Save to .dtx (1)" });
  await save.click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  const saved = readFileSync(file, "latin1");
  const lines = before.split("\n");
  const changed = saved.split("\n").filter((line, number) => line !== lines[number]);
  assert.equal(changed.length, 1, changed.join("\n"));
  assert.match(changed[0], / x="/);
  const [now] = await page.evaluate((name) => window.val3View.store.panels.cell.points.value.filter((point) => point.name === name).map(({ local }) => local), point.name);
  assert.ok(changed[0].includes(`x="${Number(now[0].toFixed(6))}"`), `${changed[0]} has ${now}`);

  const edited = `${saved}<!-- by hand -->\n`;
  writeFileSync(file, edited, "latin1");
  await until(page, 4.5);
  await page.getByRole("button", { name: /here/i }).click();
  await save.click();
  await page.getByRole("button", { name: "Keep the file" }).click();
  assert.equal(readFileSync(file, "latin1"), edited);
  await save.click();
  await page.getByRole("button", { name: "Overwrite" }).click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
  const overwritten = readFileSync(file, "latin1");
  assert.notEqual(overwritten, edited);
  assert.ok(overwritten.endsWith("<!-- by hand -->\n"));
}, moveForever));

test("a stopped application starts again with its unsaved point", () => served(BOXES, async (run) => {
  const page = await run.open();
  await until(page, 3);
  await page.getByRole("tab", { name: "Points" }).click();
  const point = await page.evaluate(() => window.val3View.store.panels.cell.points.value.find(({ name }) => !name.includes(":")));
  await page.getByRole("button", { name: point.key === null ? point.name : `${point.name}[${point.key}]`, exact: true }).click();
  await page.getByRole("button", { name: /here/i }).click();
  const save = page.getByRole("button", { name: "Save to .dtx (1)" });
  await save.waitFor();
  await page.getByRole("tab", { name: "Pendant" }).click();
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await page.waitForFunction(() => window.val3View.store.end.value !== undefined);
  const ended = await page.evaluate(() => window.val3View.store.newest.value);
  // The application does not start with an error; its old run stays.
  const program = join(run.folder, "usr/usrapp/palletiser/start.pgx");
  const code = readFileSync(program, "latin1");
  writeFileSync(program, code.replace("begin", "begin\n  nUnknown=1"), "latin1");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByText(/^the application does not start: .*nUnknown/).waitFor();
  writeFileSync(program, code, "latin1");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.waitForFunction((ended) => window.val3View.store.end.value === undefined && window.val3View.store.newest.value < ended, ended);
  await until(page, 0.5);
  await page.getByRole("tab", { name: "Points" }).click();
  await save.click();
  await page.getByText("Saved palletiser.dtx.").waitFor();
}));

test("a point is taught with a tool, changed back, and reached by hand", () => served([], async (run) => {
  const page = await run.open();
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
  await page.getByLabel(/mode/i).first().selectOption("manual");
  // Another working mode switches the power off.
  await page.getByRole("button", { name: "Switch power on" }).click();
  await page.getByRole("button", { name: "Switch power off" }).waitFor();
  await jogTo(page, [5, 10, 90, 0, -40, 0]);
  await page.getByRole("tab", { name: "Points" }).click();
  const point = await page.evaluate(() => window.val3View.store.panels.cell.points.value.find(({ name }) => !name.includes(":")));
  const name = point.key === null ? point.name : `${point.name}[${point.key}]`;
  await page.getByRole("button", { name, exact: true }).click();
  await page.getByRole("combobox", { name: /^Tool/ }).selectOption("flange");
  await page.getByRole("button", { name: /Teach here: tool flange, .*wnegative|Teach here: tool flange, .*wsame/ }).click();
  const local = () => page.evaluate(({ name, key }) => window.val3View.store.panels.cell.points.value.find((found) => found.name === name && found.key === key).local, point);
  await page.getByRole("button", { name: `Undo ${name}` }).waitFor();
  assert.notDeepEqual(await local(), point.local);
  // The point gets another father, and its own one again.
  const father = () => page.evaluate(({ name, key }) => window.val3View.store.panels.cell.points.value.find((found) => found.name === name && found.key === key).father, point);
  const frames = page.getByRole("combobox", { name: "Frame", exact: true });
  const other = await frames.locator("option").nth(1).innerText();
  assert.notEqual(other, point.father ?? "world");
  await frames.selectOption({ index: 1 });
  await page.getByRole("button", { name: `Teach here: tool flange, frame ${other}` }).click();
  await page.waitForFunction(({ name, key, father }) => window.val3View.store.panels.cell.points.value.find((found) => found.name === name && found.key === key).father !== father, point);
  assert.equal((await father()) ?? "world", other);
  await page.getByRole("button", { name: `Undo ${name}` }).click();
  await page.waitForFunction(({ name, key, father }) => window.val3View.store.panels.cell.points.value.find((found) => found.name === name && found.key === key).father === father, point);
  await jogTo(page, [15, 10, 90, 0, -40, 0]);
  await hold(page, page.getByRole("button", { name: `Go to ${name}` }), () => [5, 10, 90, 0, -40, 0].every((joint, axis) => Math.abs(window.val3View.store.panels.cell.sample.value.joints[axis] - joint) < 1e-3));
  await page.getByRole("button", { name: `Undo ${name}` }).click();
  await page.getByRole("button", { name: "Save to .dtx", exact: true }).waitFor();
  assert.deepEqual(await local(), point.local);
  // Ctrl-C loses no point.
  await page.getByRole("button", { name: /Teach here/ }).first().click();
  await page.getByRole("button", { name: "Save to .dtx (1)" }).waitFor();
  await run.end();
  assert.notEqual(readFileSync(join(run.folder, `${POINTS}.unsaved`), "latin1"), readFileSync(join(run.folder, POINTS), "latin1"));
}));

test("an exported run plays from the disk with the poses of its trace", () => served([...BOXES, "--export", "run.html", "--trace", "trace.csv"], async (run) => {
  const live = await run.open();
  await until(live, 6);
  await run.end();
  const page = await openFile(join(run.folder, "run.html"));
  await page.waitForFunction(() => window.val3View?.store.end.value !== undefined);
  // It plays without a click.
  await page.waitForFunction(() => window.val3View.store.time.value > 0.1);
  assert.equal(await page.evaluate(() => window.val3View.store.scene.value.role), "recording");
  const row = readFileSync(join(run.folder, "trace.csv"), "utf8").trim().split("\n").at(-200).split(",").map(Number);
  const pose = await page.evaluate((time) => {
    window.val3View.store.chosen.value = time;
    return window.val3View.pose();
  }, row[0]);
  assert.ok(Math.hypot(...[0, 1, 2].map((axis) => pose[axis] - row[9 + axis])) < 0.002, `${pose} ${row}`);
  // The reach is part of the messages, because a recording has no server.
  const tools = await page.evaluate((times) => times.map((time) => {
    window.val3View.store.chosen.value = time;
    return window.val3View.store.panels.cell.unreachable.value.tool;
  }), [0, row[0]]);
  assert.deepEqual(tools, ["flange", "tSuction"]);
  await page.evaluate(() => (window.val3View.store.chosen.value = 0));
  await page.getByRole("button", { name: /play/i }).first().click();
  await page.waitForFunction(() => window.val3View.store.time.value > 0.3);
}));

test("a scenario of the run is recorded, and passes", () => served(BOXES, async (run) => {
  const page = await run.open();
  await until(page, 3);
  await page.getByRole("button", { name: "Record scenario…" }).click();
  const dialog = page.getByRole("dialog", { name: "Record scenario" });
  await dialog.getByLabel("Name").fill("two boxes");
  await page.keyboard.press("Enter");
  await dialog.getByText("The name has 1 to 64 letters").waitFor();
  await dialog.getByLabel("Name").fill("twoBoxes");
  await page.keyboard.press("Enter");
  await dialog.getByText("Wrote tests/twoBoxes.toml.").waitFor();
  const text = await dialog.getByLabel("Text of the scenario").innerText();
  assert.equal(text.trim(), readFileSync(join(run.folder, "tests/twoBoxes.toml"), "utf8").trim());
  assert.match(text, /\[expect\]/);
  await dialog.getByRole("button", { name: "Close" }).click();
  const tested = spawnSync(process.env.VAL3_SERVER, ["test", "tests/twoBoxes.toml"], { cwd: run.folder, encoding: "utf8" });
  assert.equal(tested.status, 0, tested.stdout + tested.stderr);
  const guest = await run.open(1);
  assert.equal(await guest.getByRole("button", { name: "Record scenario…" }).count(), 0);
}));
