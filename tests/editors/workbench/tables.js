// Actions of a user in the tables of a data file.
const assert = require("node:assert/strict");

const GRID = "[role=treegrid]";

class Tables {
  constructor(user, frame) {
    this.user = user;
    this.frame = frame;
  }

  /** Waits for the only open tables, and focuses them. */
  static async of(user) {
    const tables = new Tables(user, await user.frame(GRID));
    await tables.focus();
    return tables;
  }

  /** Opens a data file as tables. VS Code opens a file again in the editor in which it was last open. */
  static async open(user, name) {
    await user.keys("Control+P");
    await user.choose(name);
    await user.page.waitForSelector(`.tab.active[data-resource-name=${JSON.stringify(name)}]`);
    const text = user.page.locator(".editor-instance .view-line").first();
    if (await text.waitFor({ timeout: 3000 }).then(() => true, () => false)) {
      await user.command("VAL 3: Open Data as Tables");
    }
    return Tables.of(user);
  }

  async focus() {
    await this.frame.focus(GRID);
  }

  async type(name) {
    await this.frame.click(`[role=tab][id="type-${name}"]`);
    await this.focus();
  }

  row(label) {
    return this.frame.locator("tbody tr", { has: this.frame.locator(`td.name:text-is(${JSON.stringify(label)})`) }).first();
  }

  async cell(label, heading) {
    const column = await this.frame.evaluate((heading) => [...document.querySelectorAll("thead th")].findIndex((cell) => cell.textContent.trim().startsWith(heading)), heading);
    assert.ok(column >= 0, `there is no column ${heading}`);
    return this.row(label).locator(`td[data-column="${column}"]`);
  }

  /** Selects a cell with the mouse. */
  async select(label, heading) {
    await (await this.cell(label, heading)).click();
    await this.focus();
  }

  /** Types a text into a cell. */
  async set(label, heading, text) {
    await this.select(label, heading);
    await this.user.keys("F2", "Control+A");
    await this.user.type(text);
    await this.user.keys("Enter");
    await this.frame.waitForSelector(".cell-editor", { state: "detached" });
  }

  async shows(label, heading, text) {
    const cell = await this.cell(label, heading);
    await cell.filter({ hasText: new RegExp(`^${text.replaceAll(/[.*+?^${}()|[\]\\]/g, "\\$&")}$`) }).waitFor();
  }

  async press(button) {
    await this.frame.click(`.tools button:text-matches("^${button}")`);
  }

  async expand(label) {
    await this.select(label, "Name");
    await this.user.keys("Space");
    await this.row(label).and(this.frame.locator("[aria-expanded=true]")).waitFor();
  }

  /** Confirms the dialog of the page, optionally with a text. */
  async answer(text) {
    await this.frame.waitForSelector("dialog[open]");
    if (text !== undefined) {
      // The frame may not have the keyboard focus yet.
      await this.frame.fill("dialog input", text);
    }
    await this.frame.click("dialog .primary");
    await this.frame.waitForSelector("dialog", { state: "detached" });
  }
}

module.exports = { GRID, Tables };
