// What a user does in the workbench, with the keyboard wherever that works.
const { chromium } = require("playwright-core");

const FLAGS = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const PATIENCE = 20000;

class User {
  constructor(browser, page) {
    this.browser = browser;
    this.page = page;
  }

  static async open(address, folder) {
    const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", headless: true, args: FLAGS });
    const page = await browser.newPage({ viewport: { width: 1400, height: 900 } });
    page.setDefaultTimeout(PATIENCE);
    await page.goto(`${address}/?folder=${folder}`, { waitUntil: "domcontentloaded" });
    await page.waitForSelector(".monaco-workbench .statusbar", { timeout: 60000 });
    return new User(browser, page);
  }

  async leave() {
    await this.browser.close();
  }

  async keys(...keys) {
    for (const key of keys) {
      await this.page.keyboard.press(key);
    }
  }

  async type(text) {
    await this.page.keyboard.type(text, { delay: 15 });
  }

  /** Types into the open quick input, waits for the choice and takes it. */
  async choose(text, choice = text) {
    await this.page.waitForSelector(".quick-input-widget:visible");
    await this.type(text);
    await this.page.waitForSelector(`.quick-input-list .monaco-list-row.focused:has-text(${JSON.stringify(choice)})`);
    await this.keys("Enter");
    await this.page.waitForSelector(".quick-input-widget", { state: "hidden" });
  }

  async command(title) {
    await this.keys("F1");
    await this.choose(title);
  }

  /** Runs a command that asks for a line of text, perhaps after a choice of which the first is taken, and answers. */
  async commandWith(title, question, answer, choice) {
    await this.keys("F1");
    await this.page.waitForSelector(".quick-input-widget:visible");
    await this.type(title);
    await this.page.waitForSelector(`.quick-input-list .monaco-list-row.focused:has-text(${JSON.stringify(title)})`);
    await this.keys("Enter");
    if (choice !== undefined) {
      await this.page.waitForSelector(`.quick-input-list .monaco-list-row.focused:has-text(${JSON.stringify(choice)})`);
      await this.keys("Enter");
    }
    await this.page.waitForSelector(`.quick-input-message:has-text(${JSON.stringify(question)})`);
    await this.type(answer);
    await this.keys("Enter");
  }

  async openFile(name) {
    await this.keys("Control+P");
    await this.choose(name);
    await this.tab(name);
  }

  /** Waits until the tab with this name is the active one. */
  async tab(name) {
    await this.page.waitForSelector(`.tab.active[data-resource-name=${JSON.stringify(name)}]`);
    await this.page.waitForSelector(".editor-instance .view-line");
  }

  /** Puts the cursor on a line and column, both from 1. */
  async goTo(line, column) {
    await this.keys("Control+G");
    await this.page.waitForSelector(".quick-input-widget:visible");
    await this.type(`${line}:${column}`);
    await this.keys("Enter");
    await this.page.waitForSelector(".quick-input-widget", { state: "hidden" });
  }

  /** Waits for a line of the active editor that has this text. */
  async sees(text) {
    await this.page.waitForSelector(`.editor-instance .view-line:has-text(${JSON.stringify(text)})`);
  }

  /** Waits until a line has at least this many colours. */
  async coloured(text, count) {
    await this.page.waitForFunction(([text, count]) => {
      const line = [...document.querySelectorAll(".editor-instance .view-line")].find((line) => line.textContent.includes(text));
      return new Set([...(line?.querySelectorAll("span span") ?? [])].map((part) => part.className)).size >= count;
    }, [text, count]);
  }

  async seesNot(text) {
    await this.page.waitForSelector(`.editor-instance .view-line:has-text(${JSON.stringify(text)})`, { state: "detached" });
  }

  async problem(text) {
    await this.page.waitForSelector(".editor-instance .squiggly-error, .editor-instance .squiggly-warning", { state: "attached" });
    await this.keys("Control+Shift+M");
    await this.page.waitForSelector(`.markers-panel .monaco-list-row:has-text(${JSON.stringify(text)})`);
  }

  async noSquiggle() {
    await this.page.waitForSelector(".editor-instance .squiggly-error", { state: "detached" });
  }

  /** The text of the hover at the cursor, once it holds `text`. */
  async hovers(text) {
    await this.keys("Control+K", "Control+I");
    await this.page.waitForSelector(`.monaco-hover:visible :text(${JSON.stringify(text)})`);
  }

  /** Asks for completions until `label` is among them. */
  async completes(label) {
    await this.keys("Control+Space");
    await this.page.waitForSelector(`.suggest-widget.visible .monaco-list-row:has-text(${JSON.stringify(label)})`);
  }

  async focusEditor() {
    await this.keys("Control+1");
  }
}

module.exports = { User };
