// A user pulls the files of a controller, compares, pushes, and resolves conflicts in the view "Controller". The
// controller is the folder of an emulator, and for passwords a server that only speaks the login of FTP.
const assert = require("node:assert/strict");
const { mkdirSync, mkdtempSync, readFileSync, realpathSync, writeFileSync } = require("node:fs");
const { createServer } = require("node:net");
const { tmpdir } = require("node:os");
const { dirname, join } = require("node:path");
const { runSteps } = require("./steps");

const folder = realpathSync(mkdtempSync(join(tmpdir(), "val3-controller-")));
const ROBOT = join(folder, "robot");
const CELL = join(folder, "cell");

const NAMESPACE = "http://www.staubli.com/robotics/VAL3";
const IDENTITY = '<?xml version="1.0" encoding="utf-8"?>\n<controller><String name="serialNumber" value="F10-0001" /></controller>\n';
const MANIFEST = `<?xml version="1.0" encoding="utf-8"?>\n<Project xmlns="${NAMESPACE}/Project/3">\n`
  + '  <Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />\n  <Programs>\n    <Program file="start.pgx" />\n'
  + '    <Program file="stop.pgx" />\n  </Programs>\n  <Database>\n    <Data file="demo.dtx" />\n  </Database>\n  <Libraries />\n  <Types />\n</Project>\n';

/** Data in Latin-1, so that a comparison in another encoding would show wrong letters. */
const data = (word, count) => `<?xml version="1.0" encoding="iso-8859-1"?>\n<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="${NAMESPACE}/Data/2">\n`
  + `  <Datas>\n    <Data name="nCount" access="private" xsi:type="array" type="num" size="1">\n      <Value key="0" value="${count}" />\n    </Data>\n`
  + `    <Data name="sWord" access="private" xsi:type="array" type="string" size="1">\n      <Value key="0" value="${word}" />\n    </Data>\n  </Datas>\n</Database>\n`;
const program = (name, code) => `<?xml version="1.0" encoding="utf-8"?>\n<Programs xmlns="${NAMESPACE}/Program/2">\n`
  + `  <Program name="${name}" access="private">\n    <Code><![CDATA[begin\n  ${code}\nend]]></Code>\n  </Program>\n</Programs>\n`;

const DEMO = "usr/usrapp/demo";
const START = `${DEMO}/start.pgx`;
const STOP = `${DEMO}/stop.pgx`;
const DATA = `${DEMO}/demo.dtx`;

function write(root, path, text, encoding = "utf8") {
  mkdirSync(dirname(join(root, path)), { recursive: true });
  writeFileSync(join(root, path), text, encoding);
}

const read = (root, path) => readFileSync(join(root, path), "latin1");

const PANE = '.pane:has(.pane-header[aria-label^="Controller"])';
/** Returns the row whose label for screen readers begins with a text. */
const row = (text) => `${PANE} .monaco-list-row[aria-label^=${JSON.stringify(text)}]`;

/** Clicks an action in the title of the view. */
async function title(user, name) {
  await user.page.hover(`${PANE} .pane-header`);
  await user.page.click(`${PANE} .pane-header [aria-label^=${JSON.stringify(name)}]`);
}

/** Opens the comparison of a file. A click can miss a row that is being redrawn. */
async function showsChanges(user, name, text) {
  const lines = user.page.locator(".editor-instance .diff-editor, .editor-instance .monaco-diff-editor");
  await user.page.click(`${PANE} .monaco-list-row[aria-label^=${JSON.stringify(`${name}, `)}]`);
  await user.page.waitForSelector(`.tab.active[aria-label^=${JSON.stringify(`${name} (controller ↔ local)`)}]`);
  await lines.first().waitFor();
  await user.sees(text);
}

/** Returns the text of the dialog before its button is clicked. */
async function answersDialog(user, text, button) {
  const dialog = user.page.locator(".monaco-dialog-box", { hasText: text });
  await dialog.waitFor();
  const shown = await dialog.innerText();
  await user.page.screenshot({ path: join(process.env.VAL3_OUTPUT, `controller-dialog-${button.replaceAll(/\W+/g, "-")}.png`) });
  await dialog.locator(`.monaco-button:has-text(${JSON.stringify(button)})`).click();
  await user.page.waitForSelector(".monaco-dialog-box", { state: "detached" });
  return shown;
}

/** Passwords that the server has received. */
const passwords = [];
/** Whether the server greets its clients. */
let isSilent = false;
const server = createServer((socket) => {
  socket.on("error", () => undefined);
  if (!isSilent) {
    socket.write("220 ready\r\n");
  }
  socket.setEncoding("utf8").on("data", (line) => {
    const [, password] = /^PASS ?(.*)\r\n/.exec(line) ?? [];
    if (password !== undefined) {
      passwords.push(password);
    }
    socket.write(password === undefined ? "331 password\r\n" : "530 Login incorrect\r\n");
  });
});

const STEPS = {
  async "the first pull asks for the address"(user) {
    await user.command("View: Show VAL 3");
    await user.page.click('.pane-header[aria-label^="Controller"]');
    await user.page.click(`${PANE} .monaco-button:has-text("Pull from Controller")`);
    await user.answers("The address of the controller", "elsewhere", "This folder contains no usr.");
    await user.answers("This folder contains no usr.", "ftp://me:secret@robot", "contains no password");
    await user.answers("contains no password", "../robot");
    await user.take("Applications Only");
    await user.told("4 files of the controller");
    await user.page.waitForSelector(row(`${ROBOT}, controller, F10-0001, no difference at`));
    await user.page.waitForSelector(row("demo, application, unchanged"));
    assert.equal(read(CELL, START), read(ROBOT, START));
  },

  async "another window shows the controller, and connects only for a command"(user) {
    // A new window also watches the folders that the pull has created, which the watcher on Linux can miss.
    await user.page.reload();
    await user.page.waitForSelector(row(`${ROBOT}, controller, F10-0001, not compared`));
    await user.page.waitForSelector('.pane-header[aria-label^="Applications"]');
  },

  async "a changed file is below its application"(user) {
    write(CELL, START, program("start", "nCount=nCount+2"));
    await title(user, "Compare with Controller");
    await user.page.waitForSelector(row("demo, application, changed here, 1 file"));
    await user.page.waitForSelector(row("start.pgx, changed here"));
  },

  async "the changes are shown in the comparison of the editor"(user) {
    await showsChanges(user, "start.pgx", "nCount=nCount+1");
    await user.sees("nCount=nCount+2");
  },

  async "a push is left in its confirmation"(user) {
    await title(user, "Push to Controller");
    const shown = await answersDialog(user, "Push 1 file to the controller F10-0001", "Cancel");
    assert.match(shown, /replace demo\/start\.pgx \(\d+ bytes\)/);
    assert.match(shown, /Is the application demo stopped and unloaded on the controller\?/);
    assert.match(read(ROBOT, START), /nCount\+1/);
  },

  async "the log of this controller states nothing, so nothing is pushed"(user) {
    await title(user, "Push to Controller");
    await answersDialog(user, "Push 1 file", "Not Sure: Check the Log");
    await user.told("The log of the controller does not state whether an application is loaded.");
    assert.match(read(ROBOT, START), /nCount\+1/);
  },

  async "an application is pushed"(user) {
    await user.page.hover(row("demo, application"));
    await user.page.click(`${row("demo, application")} .action-label[aria-label^="Push This Application"]`);
    await answersDialog(user, "Push 1 file", "Unloaded: Push");
    await user.told("Load on the controller again: demo.");
    await user.page.waitForSelector(row("demo, application, unchanged"));
    assert.match(read(ROBOT, START), /nCount\+2/);
  },

  async "an error of the check stops a push"(user) {
    write(CELL, STOP, program("stop", "nCout=0"));
    await user.command("VAL 3: Push to Controller");
    await user.told("The check has found errors, so nothing was pushed.", "Show Output");
    // The VS Code of the tests has no native module for the text of output channels.
    await user.page.waitForSelector('.part.panel .monaco-select-box:has-text("VAL 3 Controller"), .part.panel select[title="VAL 3 Controller"]');
    await user.command("View: Toggle Output");
    assert.match(read(ROBOT, STOP), /nCount=0/);
    write(CELL, STOP, program("stop", "nCount=0"));
  },

  async "data that the operator has changed is compared in its encoding, and pulled"(user) {
    write(ROBOT, DATA, data("déjà lu", 5), "latin1");
    await title(user, "Compare with Controller");
    await user.page.waitForSelector(row("demo, application, changed on the controller, 1 file"));
    await showsChanges(user, "demo.dtx", "déjà lu");
    await user.sees("déjà vu");
    await title(user, "Pull from Controller");
    await user.told("1 updated");
    await user.page.waitForSelector(row("demo, application, unchanged"));
    assert.equal(read(CELL, DATA), data("déjà lu", 5));
    await user.seesNot("déjà vu");
  },

  async "a conflict stops a push, and is merged by a pull"(user) {
    write(ROBOT, DATA, data("déjà lu", 6), "latin1");
    write(CELL, DATA, data("déjà su", 5), "latin1");
    await title(user, "Compare with Controller");
    await user.page.waitForSelector(row("demo, application, conflict, 1 file"));
    await user.page.waitForSelector(row("demo.dtx, changed on both sides"));
    await title(user, "Push to Controller");
    await user.told("1 file changed here and on the controller");
    await title(user, "Pull from Controller");
    await user.told("1 file changed here and on the controller", "Merge");
    await user.page.waitForSelector(row("demo, application, changed here, 1 file"));
    assert.equal(read(CELL, DATA), data("déjà su", 6));
  },

  async "a rejected login asks for the password, which is not stored"(user) {
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    const state = join(CELL, ".val3/controller.toml");
    const address = `ftp://me@127.0.0.1:${server.address().port}`;
    writeFileSync(state, readFileSync(state, "utf8").replace(/^address = .*$/m, `address = "${address}"`));
    await title(user, "Compare with Controller");
    await user.answers("The connectionPassword of the profile", "secret");
    await user.page.waitForSelector('.quick-input-message:has-text("The controller rejected the password")');
    await user.page.screenshot({ path: join(process.env.VAL3_OUTPUT, "controller-password.png") });
    await user.keys("Escape");
    await user.told("530 Login incorrect");
    assert.deepEqual(passwords, ["", "secret"]);
    assert.ok(!readFileSync(state, "utf8").includes("secret"));
  },

  async "a connection without an answer is cancelled"(user) {
    const progress = user.page.locator(".notification-toast", { hasText: "Comparing with ftp://me@127.0.0.1" });
    await progress.waitFor({ state: "detached" });
    isSilent = true;
    await title(user, "Compare with Controller");
    await progress.hover();
    await progress.locator(".monaco-button", { hasText: "Cancel" }).click();
    await user.told("The command was cancelled.");
    server.close();
  },
};

write(ROBOT, "usr/configs/controller.cfx", IDENTITY);
write(ROBOT, `${DEMO}/demo.pjx`, MANIFEST);
write(ROBOT, DATA, data("déjà vu", 5), "latin1");
write(ROBOT, START, program("start", "nCount=nCount+1"));
write(ROBOT, STOP, program("stop", "nCount=0"));
mkdirSync(CELL);
runSteps({ name: "controller", folder, open: `folder=${CELL}`, steps: STEPS, showsDialogs: true });
