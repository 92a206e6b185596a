// Buttons keep their places while an operator uses the panels.
const assert = require("node:assert/strict");
const { test } = require("node:test");
const { BOXES, moveForever, served } = require("./served.js");

const SIZES = [[1280, 800], [900, 500], [390, 844]];

/**
 * Returns the places of all visible controls of the panel, by name. Values are not part of a name. A click may have
 * scrolled the table to show its button.
 */
const places = (page) => page.evaluate(() => {
  document.querySelector(".signals").scrollTo(0, 0);
  document.querySelector(".panel.io").scrollTo(0, 0);
  // The table prepares rows outside the window.
  const controls = [...document.querySelectorAll(".panel.io :is(button, select, input)")].filter((control) => control.getBoundingClientRect().top < innerHeight);
  return controls.map((control) => {
    const { left, top, width, height } = control.getBoundingClientRect();
    const name = (control.getAttribute("aria-label") ?? "").replace(/ is .*/, "");
    return `${name}: ${[left, top, width, height].map(Math.round).join()}`;
  }).filter((place) => !place.startsWith("Hide this message"));
});

/** Returns the boards, the names of signals, their buttons and choices that are not inside the table's window, or cut. */
const outside = (page) => page.evaluate(() => {
  const box = document.querySelector(".signals").getBoundingClientRect();
  const cells = [...document.querySelectorAll(".signals :is(.board-name, tbody th[scope=row], button, input, select)")].filter((cell) => cell.getBoundingClientRect().top < innerHeight);
  return cells.length === 0 ? ["no signals"] : cells.filter((cell) => {
    const { left, right } = cell.getBoundingClientRect();
    return left < box.left - 1 || right > box.right + 1 || cell.scrollWidth > cell.clientWidth + 1;
  }).map((cell) => cell.getAttribute("aria-label") ?? cell.textContent);
});

/** Returns the visible buttons, choices and fields that are too small for a finger, with their sizes. */
const small = (page) => page.evaluate(() => {
  const controls = [...document.querySelectorAll("button, summary, select, input:not([type=range], [type=checkbox], [type=radio])")].filter((control) => control.checkVisibility());
  return controls.flatMap((control) => {
    const { width, height } = control.getBoundingClientRect();
    const name = control.getAttribute("aria-label") ?? control.textContent;
    return Math.min(width, height) < 39.5 ? [`${name}: ${Math.round(width)} x ${Math.round(height)}`] : [];
  });
});

test("the buttons of the inputs and outputs keep their places", () => served([], async (run) => {
  const page = await run.open();
  await page.getByRole("tab", { name: "Inputs and outputs" }).click();
  for (const [width, height] of [[1280, 800], [1366, 768], [1920, 1080]]) {
    await page.setViewportSize({ width, height });
    await page.waitForTimeout(300);
    assert.deepEqual(await outside(page), [], `in ${width}x${height}`);
  }
  for (const [width, height] of SIZES) {
    await page.setViewportSize({ width, height });
    await page.waitForTimeout(300);
    const before = await places(page);
    assert.ok(before.length > 8, before.join("\n"));
    // No program reads this input. A fault of another one would stop a task, and the bar of the error moves the panels.
    const lock = page.getByRole("button", { name: /^Lock .*%I6$/ });
    const value = page.getByRole("button", { name: /%I6 is / });
    const sim = page.getByRole("button", { name: /^Sim .*%I6$/ });
    const fault = page.getByRole("combobox", { name: /^Fault of .*%I6$/ });
    const presses = [() => lock.click(), () => value.click(), () => value.click(), () => lock.click(), () => sim.click(), () => sim.click(), () => fault.selectOption("-3"), () => fault.selectOption("0")];
    for (const [index, press] of presses.entries()) {
      await press();
      await page.waitForTimeout(300);
      assert.deepEqual(await places(page), before, `press ${index} in ${width}x${height}`);
    }
  }
}));

test("a rejection covers the panel and moves nothing", () => served([], async (run) => {
  const page = await run.open();
  await page.getByRole("tab", { name: "Inputs and outputs" }).click();
  for (const [width, height] of SIZES) {
    await page.setViewportSize({ width, height });
    await page.waitForTimeout(300);
    const before = await places(page);
    const refused = await page.evaluate(async () => {
      const notice = document.querySelector(".panel.io .notice");
      notice.textContent = "This is a sentence about a rejected command that is longer than a line of the panel. ".repeat(3);
      return notice.getBoundingClientRect().height;
    });
    assert.ok(refused > 20, `the sentence has ${refused} px`);
    assert.deepEqual(await places(page), before, `${width}x${height}`);
  }
}));

test("no text of the task table covers another column", () => served(BOXES, async (run) => {
  const page = await run.open();
  await page.getByRole("tab", { name: "Tasks", exact: true }).first().click();
  await page.getByRole("table", { name: "Tasks" }).getByRole("row", { name: /^production/ }).waitFor();
  for (const [width, height] of [[1280, 800], [1366, 768], [390, 844]]) {
    await page.setViewportSize({ width, height });
    const cut = await page.locator(".task-table :is(th, td)").evaluateAll((cells) => cells.filter((cell) => cell.scrollWidth > cell.clientWidth).map((cell) => cell.textContent));
    assert.deepEqual(cut, [], `${width}x${height}`);
  }
}));

test("in a low window, the tabs and the time bar each have one line", () => served([], async (run) => {
  const page = await run.open(0, { viewport: { width: 900, height: 500 } });
  for (const part of ["[role=tablist] > *", ".time-bar > :not(.notice)"]) {
    const middles = await page.locator(part).evaluateAll((parts) => parts.map((part) => part.getBoundingClientRect()).map(({ top, height }) => top + height / 2));
    assert.ok(middles.length >= 5 && Math.max(...middles) - Math.min(...middles) < 10, `${part}: ${middles.map(Math.round)}`);
  }
}));

/** Returns the ids of all tabs in a list. */
const tabs = (page, list) => page.locator(`${list} > [role=tab]`).evaluateAll((all) => all.map(({ id }) => id));

test("the buttons of all tabs are large enough for fingers", () => served(["--power"], async (run) => {
  const page = await run.open(0, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  assert.deepEqual(await small(page), [], "at first");
  await page.getByText("Keys of the pendant", { exact: true }).tap();
  await page.getByRole("button", { name: "Enter joints…" }).tap();
  assert.deepEqual(await small(page), [], "Pendant");
  for (const tab of await tabs(page, ".panel-tabs > .tabs")) {
    await page.locator(`#${tab}`).tap();
    assert.deepEqual(await small(page), [], tab);
    for (const inner of await tabs(page, ".panel .tabs")) {
      await page.locator(`#${inner}`).tap();
      assert.deepEqual(await small(page), [], inner);
    }
  }
  await page.getByRole("button", { name: "pPick", exact: true }).tap();
  await page.getByRole("form", { name: "Values of pPick" }).waitFor();
  await page.getByRole("combobox", { name: /^Frame or tool/ }).selectOption("fPallet");
  assert.deepEqual(await small(page), [], "the selected point");
}, moveForever));
