// Creates the pictures in the README and the book: `node tests/editors/pictures.js` after `tests/editors/run debug
// history`, with the variables of `run`.
const { readFileSync, readdirSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const { test } = require("node:test");
const { BOXES, openFile, served, until } = require("./view/served.js");

const picture = (name) => ({ path: join(process.env.VAL3_ROOT, "docs/src", name), quality: 82 });

test("the palletiser stacks a box", () => served(BOXES, async (run) => {
  const page = await run.open();
  await until(page, 8);
  await page.evaluate(() => (window.val3View.store.chosen.value = 4.6));
  await page.getByRole("button", { name: "Fit" }).click();
  await page.waitForTimeout(1500);
  await page.screenshot(picture("robot.jpg"));
}));

test("the program is next to the picture", () => served(BOXES, async (run) => {
  const page = await run.open();
  await until(page, 8);
  await page.getByRole("tab", { name: "Program", exact: true }).click();
  await page.evaluate(() => (window.val3View.store.chosen.value = 4.6));
  await page.getByRole("combobox", { name: "Followed task" }).selectOption({ label: "production" });
  await page.getByRole("button", { name: "Fit" }).click();
  await page.waitForTimeout(1500);
  await page.screenshot(picture("program.jpg"));
}));

/** Reports pairs below 150 mm. */
function widen(folder) {
  const file = join(folder, "cell.toml");
  writeFileSync(file, readFileSync(file, "utf8").replace("clearance = 50", "clearance = 150"));
}

test("the gripper comes near to the belt", () => served(BOXES, async (run) => {
  const page = await run.open();
  await until(page, 8);
  await page.getByRole("tab", { name: "Tasks" }).click();
  await page.getByText("Distances", { exact: true }).click();
  await page.locator(".clearances button.place").first().click();
  await page.getByRole("button", { name: "Fit" }).click();
  await page.waitForTimeout(1500);
  await page.screenshot(picture("cell.jpg"));
}, widen));

/** Copies the screenshot of a step in the workbench. */
async function copy(step, name) {
  const output = process.env.VAL3_OUTPUT;
  const shot = readdirSync(output).find((file) => file.includes(step));
  const page = await openFile(join(output, shot));
  await page.setViewportSize({ width: 1400, height: 900 });
  await page.screenshot(picture(name));
}

test("the robot is next to the code", () => copy("the-robot-is-shown-next-to-the-code", "robot-code.jpg"));

test("the history of a joint is next to the code", () => copy("the-history-of-a-joint", "history.jpg"));
