// Actions of a user in the workbench, with the keyboard wherever that works.
const { launch } = require("../../../editors/view/test/chromium.js");

const TIMEOUT = 60_000;
const FOCUSED_EDITOR = ".editor-group-container.active .editor-instance .monaco-editor.focused";
/** Rows of the view *Variables*. */
const VARIABLE = ".debug-variables .monaco-list-row";
/** Rows of the view *Robot*. */
const ROBOT = '.pane:has(.pane-header[aria-label^="Robot"]) .monaco-list-row';

/** Returns the row with this label; its description follows. */
const robotItem = (label) => `${ROBOT}[aria-label^=${JSON.stringify(`${label} `)}]`;

class User {
  constructor(browser, page, address) {
    this.browser = browser;
    this.page = page;
    this.address = address;
  }

  /** Opens the workbench; `query` is `folder=…` or `workspace=…`. */
  static async open(address, query) {
    const browser = await launch();
    const page = await browser.newPage({ viewport: { width: 1400, height: 900 } });
    page.setDefaultTimeout(TIMEOUT);
    const user = new User(browser, page, address);
    await user.opens(query);
    return user;
  }

  async opens(query) {
    await this.page.goto(`${this.address}/?${query}`, { waitUntil: "domcontentloaded" });
    await this.page.waitForSelector(".monaco-workbench .statusbar", { timeout: 60000 });
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

  /** Types into the open quick input, waits for the item and accepts it. */
  async choose(text) {
    await this.page.waitForSelector(".quick-input-widget:visible");
    await this.take(text);
    await this.page.waitForSelector(".quick-input-widget", { state: "hidden" });
  }

  /** Like `choose`, if the quick input stays open afterwards. */
  async take(text) {
    await this.type(text);
    await this.page.waitForSelector(`.quick-input-list .monaco-list-row.focused:has-text(${JSON.stringify(text)})`);
    await this.keys("Enter");
  }

  /** Runs a command, optionally with the item that its quick input requires. */
  async command(title, choice) {
    await this.starts(title, choice);
    await this.page.waitForSelector(".quick-input-widget", { state: "hidden" });
  }

  /**
   * Starts a command, optionally with an item; it may open further inputs. The palette lists only the commands that
   * exist when it opens.
   */
  async starts(title, choice) {
    const row = this.page.locator(".quick-input-list .monaco-list-row.focused", { hasText: title });
    const input = this.page.locator(".quick-input-widget .quick-input-box input:focus");
    for (let attempt = 0; attempt < 5 && !(await row.isVisible()); attempt += 1) {
      await this.keys(...(attempt === 0 ? ["F1"] : ["Escape", "F1"]));
      // The palette closes if an editor takes the focus meanwhile. Keys would change the file then.
      if (await input.waitFor({ timeout: 5000 }).then(() => true, () => false)) {
        await this.type(title);
      }
      await row.waitFor({ timeout: 5000 }).catch(() => undefined);
    }
    await row.waitFor();
    await this.keys("Enter");
    if (choice !== undefined) {
      await this.page.waitForSelector(`.quick-input-list .monaco-list-row:has-text(${JSON.stringify(choice)})`);
      await this.take(choice);
    }
  }

  /** Enters a text in the open quick input, and waits for its reply, if any. */
  async answers(question, text, reply) {
    const message = (text) => `.quick-input-message:has-text(${JSON.stringify(text)})`;
    await this.page.waitForSelector(message(question));
    await this.keys("Control+A");
    await this.type(text);
    if (reply === undefined) {
      await this.keys("Enter");
      // The next prompt may open immediately in the same quick input.
      await this.page.waitForSelector(message(question), { state: "hidden" });
    } else {
      await this.page.waitForSelector(message(reply));
    }
  }

  /** Runs a command that prompts for a line of text, optionally after a list whose first item is accepted. */
  async commandWith(title, question, answer, choice) {
    await this.starts(title);
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

  /** Waits until the tab with this name is active. */
  async tab(name) {
    await this.page.waitForSelector(`.tab.active[data-resource-name=${JSON.stringify(name)}]`);
    await this.page.waitForSelector(".editor-instance .view-line");
  }

  /** Puts the cursor on a line and column, both from 1. Keys reach the editor once it has the focus back. */
  async goTo(line, column) {
    await this.keys("Control+G");
    await this.page.waitForSelector(".quick-input-widget:visible");
    await this.type(`${line}:${column}`);
    await this.keys("Enter");
    await this.page.waitForSelector(".quick-input-widget", { state: "hidden" });
    await this.page.waitForSelector(FOCUSED_EDITOR);
    await this.page.waitForSelector(`.statusbar-item [aria-label^="Ln ${line}, Col "]`);
  }

  /** Waits for a line of the active editor with this text. */
  async sees(text) {
    await this.page.waitForSelector(`.editor-instance .view-line:has-text(${JSON.stringify(text)})`);
  }

  /** Waits until a line has at least this number of colours. */
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

  /** Waits until the hover at the cursor contains `text`. */
  async hovers(text) {
    await this.keys("Control+K", "Control+I");
    await this.page.waitForSelector(`.monaco-hover:visible :text(${JSON.stringify(text)})`);
  }

  /**
   * Requests completions until `label` is among them. A list that opens by itself while the key is pressed gets the key,
   * and may close when the text has changed meanwhile; a user then presses it again.
   */
  async completes(label) {
    const row = this.page.locator(".suggest-widget.visible .monaco-list-row", { hasText: label }).first();
    for (let attempt = 0; attempt < 5 && !(await row.isVisible()); attempt += 1) {
      await this.keys("Control+Space");
      await row.waitFor({ timeout: 10_000 }).catch(() => undefined);
    }
    await row.waitFor({ timeout: 10_000 });
  }

  /** Description of the screen for the log of a failed step: the focused element, the status bar, messages, open lists. */
  async describe() {
    return this.page.evaluate(() => {
      const texts = (selector) => [...document.querySelectorAll(selector)].map((element) => element.innerText.replaceAll(/\s+/g, " "));
      const focused = document.activeElement;
      return JSON.stringify({
        focused: `${focused.tagName} ${focused.className} ${focused.ariaLabel ?? ""}`,
        status: texts(".statusbar-item").filter((text) => text !== ""),
        notifications: texts(".notification-list-item"),
        lists: texts(".suggest-widget.visible, .quick-input-widget, .monaco-hover").map((text) => text.slice(0, 300)),
        lines: texts(".editor-instance .view-line").slice(0, 60),
      });
    });
  }

  /** Accepts the completion `label` in the open list. */
  async takes(label) {
    await this.page.click(`.suggest-widget.visible .monaco-list-row:has-text(${JSON.stringify(label)})`);
    await this.page.waitForSelector(".suggest-widget.visible", { state: "detached" });
  }

  /** Waits until the list of problems has this number of rows with this text. */
  async problems(text, count) {
    await this.page.waitForFunction(([text, count]) => {
      const rows = [...document.querySelectorAll(".markers-panel .monaco-list-row")];
      return rows.filter((row) => row.querySelector(".marker-icon") !== null && row.textContent.includes(text)).length === count;
    }, [text, count]);
  }

  /** Waits until the terminal contains this text. */
  async terminal(text) {
    await this.page.waitForFunction((text) => {
      const rows = [...document.querySelectorAll(".xterm-rows > div")].map((row) => row.textContent.replaceAll("\u00a0", " "));
      return rows.join("").includes(text);
    }, text);
  }

  /** Waits for a file icon in the explorer or the tabs whose picture has this name. */
  async icon(file, picture) {
    await this.page.waitForFunction(([file, picture]) => {
      const labels = [...document.querySelectorAll(".explorer-folders-view .monaco-icon-label")];
      const label = labels.find((label) => label.textContent === file);
      return label !== undefined && getComputedStyle(label, "::before").backgroundImage.includes(picture);
    }, [file, picture]);
  }

  /** Clicks a lens until its target is shown, because a click can miss a lens that is being redrawn. */
  async opensLens(text, shown) {
    const lens = this.page.locator(".codelens-decoration a", { hasText: text });
    for (let attempt = 0; attempt < 10 && !(await this.page.isVisible(shown)); attempt += 1) {
      await lens.click();
      await this.page.waitForSelector(shown, { timeout: 2000 }).catch(() => undefined);
    }
    await this.page.waitForSelector(shown);
  }

  /** Waits for a message with this text, and clicks its button or closes it. */
  async told(text, button) {
    const toast = this.page.locator(".notification-toast", { hasText: text }).first();
    await toast.waitFor();
    if (button === undefined) {
      await this.command("Notifications: Clear All Notifications");
    } else {
      await toast.hover();
      await toast.locator(".monaco-button", { hasText: button }).click();
    }
    await toast.waitFor({ state: "detached" });
  }

  /** Waits until a web view shows this text. */
  async webview(text) {
    await this.frameWith(text);
  }

  /** Returns the frame of the web view that shows this text. */
  async frameWith(text) {
    const shows = (frame) => frame.evaluate((text) => document.body?.textContent.includes(text) === true, text).catch(() => false);
    for (const end = Date.now() + TIMEOUT; Date.now() < end; await this.page.waitForTimeout(50)) {
      const frames = this.page.frames().filter((frame) => frame !== this.page.mainFrame());
      const showing = await Promise.all(frames.map(shows));
      const found = frames[showing.lastIndexOf(true)];
      if (found !== undefined) {
        return found;
      }
    }
    throw new Error(`No web view shows ${text}`);
  }

  /** Closes a web view with the mouse, because it gets the keyboard focus only some time after its tab is clicked. */
  async closesTab(name) {
    const tab = this.page.locator(`.tab[aria-label^=${JSON.stringify(name)}]`);
    await tab.click({ button: "middle" });
    await tab.waitFor({ state: "detached" });
  }

  /** Selects an entry in the open menu, with the keyboard. */
  async picks(entry) {
    await this.page.waitForSelector(".monaco-menu .action-item");
    const count = await this.page.locator(".monaco-menu .action-item").count();
    for (let step = 0; step < count; step += 1) {
      if (await this.page.locator(".monaco-menu .action-item.focused", { hasText: entry }).count() > 0) {
        await this.keys("Enter");
        // The menu returns the focus when it closes.
        await this.page.waitForSelector(".monaco-menu", { state: "detached" });
        return;
      }
      await this.keys("ArrowDown");
    }
    throw new Error(`The menu has no ${entry}`);
  }

  /** Opens these views of the debug sidebar, and closes all others to save space. */
  async views(...names) {
    for (const name of ["Variables", "Watch", "Call Stack", "Breakpoints", "Robot"]) {
      const header = this.page.locator(`.pane-header[aria-label^="${name}"]`);
      if ((await header.getAttribute("aria-expanded")) !== String(names.includes(name))) {
        await header.click();
      }
    }
  }

  /** Waits for an item of the view *Robot* with this label, and optionally with a text in its description. */
  async robot(label, description = "") {
    await this.page.locator(ROBOT, { hasText: label }).filter({ hasText: description }).first().waitFor();
  }

  /** Opens a closed item of the view *Robot*. */
  async expands(label) {
    const item = this.page.locator(robotItem(label));
    await item.waitFor();
    if ((await item.getAttribute("aria-expanded")) === "false") {
      await item.click();
    }
    await this.page.waitForSelector(`${robotItem(label)}[aria-expanded=true]`);
  }

  /** Clicks the action of an item in the view *Robot* whose title begins with a text. */
  async acts(label, action) {
    const item = this.page.locator(robotItem(label));
    await item.hover();
    await item.locator(`.action-label[aria-label^=${JSON.stringify(action)}]`).click();
  }

  /** Presses a key of the pendant that has a button. */
  async pendantKey(label) {
    const frame = await this.frame("#pendant");
    await frame.click(`#pendant button:text-is(${JSON.stringify(label)})`);
  }

  /** Returns the frame of a web view with an element. */
  async frame(selector) {
    for (const end = Date.now() + TIMEOUT; Date.now() < end; await this.page.waitForTimeout(50)) {
      for (const frame of this.page.frames()) {
        if ((await frame.$(selector).catch(() => null)) !== null) {
          return frame;
        }
      }
    }
    throw new Error(`No web view has ${selector}`);
  }

  /** Waits until this icon is in the margin of the editor, or is not. */
  async icons(picture, isShown) {
    await this.page.waitForFunction(([picture, isShown]) => {
      const icons = [...document.querySelectorAll(".editor-instance .glyph-margin-widgets > *")];
      return icons.some((icon) => getComputedStyle(icon).backgroundImage.includes(picture)) === isShown;
    }, [picture, isShown]);
  }

  /** Waits until the run has stopped at a line of a file, which is then shown. */
  async stopsAt(name, line) {
    await this.tab(name);
    await this.page.waitForSelector(".editor-instance .debug-top-stack-frame-line");
    await this.page.waitForSelector(`.statusbar-item:has-text("Ln ${line}, Col")`);
  }

  /** Waits for a variable with this value in the sidebar. */
  async variable(name, value, timeout = TIMEOUT) {
    const row = this.page.locator(VARIABLE, { hasText: `${name} =` }).filter({ hasText: value }).first();
    await row.waitFor({ timeout });
  }

  /** Opens a scope or variable in the sidebar, which contains another variable. */
  async opensVariable(text, inside) {
    await this.page.locator(VARIABLE, { hasText: text }).first().click();
    await this.page.locator(VARIABLE, { hasText: inside }).first().waitFor();
  }

  /**
   * Changes the value of a variable in the sidebar. If VS Code redraws the list, which it does once more some time
   * after a stop, the click misses or the input closes.
   */
  async changes(name, value) {
    const variable = this.page.locator(VARIABLE, { hasText: `${name} =` }).first();
    const input = this.page.locator(".debug-variables .inputBoxContainer input");
    let fault;
    for (let attempt = 0; attempt < 10; attempt += 1) {
      try {
        await variable.dblclick({ timeout: 2000 });
        await input.fill(value, { timeout: 2000 });
        await input.press("Enter", { timeout: 2000 });
        return await this.variable(name, value, 2000);
      } catch (reason) {
        fault = reason;
      }
    }
    throw fault;
  }

  /** Clicks a button in the toolbar of the debugger. */
  async tool(title) {
    await this.page.click(`.debug-toolbar .action-label[aria-label^=${JSON.stringify(title)}]`);
  }

  /** Pauses the run. Until the tasks are known, the button has no effect. */
  async pauses() {
    const line = this.page.locator(".editor-instance .debug-top-stack-frame-line");
    for (let attempt = 0; attempt < 10 && !(await line.isVisible()); attempt += 1) {
      await this.tool("Pause").catch(() => {});
      await line.waitFor({ timeout: 2000 }).catch(() => {});
    }
    await line.waitFor();
  }

  /** Focuses the first group of editors. */
  async focusEditor() {
    await this.keys("Control+1");
    await this.page.waitForSelector(FOCUSED_EDITOR);
  }

  /**
   * Moves the focus from a web view that was just clicked to the first group of editors. VS Code notices the click some
   * time later, and only then its group becomes active.
   */
  async leavesWebview(name) {
    await this.page.waitForSelector(`.editor-group-container.active .tab[aria-label^=${JSON.stringify(name)}]`);
    await this.focusEditor();
  }
}

module.exports = { User };
