// A user debugs the palletiser: program steps, motion steps, values, inputs and the pendant. The run is in real time,
// and time does not advance while it is stopped.
const assert = require("node:assert/strict");
const { spawn } = require("node:child_process");
const { cpSync, mkdirSync, mkdtempSync, renameSync, rmSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { basename, join } = require("node:path");
const { Application } = require("../dap/application");
const { runSteps } = require("./steps");

const folder = mkdtempSync(join(tmpdir(), "val3-debug-"));
const cell = join(folder, "cell");

const APPLICATION = "usr/usrapp/palletiser";
const LAUNCH = {
  type: "val3", request: "launch", name: "Debug palletiser", program: `\${workspaceFolder}/${APPLICATION}`, time: "real",
  power: true, script: "${workspaceFolder}/rails.toml",
};

function configure(...configurations) {
  writeFileSync(join(cell, ".vscode/launch.json"), JSON.stringify({ version: "0.2.0", configurations }));
}

/** Returns the port through which a run can be debugged and its secret, which the run prints. */
function addressOf(run) {
  let output = "";
  return new Promise((resolve, reject) => {
    run.stderr.on("data", (bytes) => {
      output += bytes;
      const [, port, secret] = /127\.0\.0\.1:(\d+) with the secret (\w+)\s/.exec(output) ?? [];
      if (port !== undefined) {
        resolve({ port, secret });
      }
    });
    run.on("close", () => reject(new Error(`The run has ended: ${output}`)));
  });
}

/** A box lies between the rails. The test activates the sensor. */
const SCRIPT = "[[at]]\nt = 0.1\nio = { 'BasicIO-1\\%I4' = true, 'BasicIO-1\\%I5' = true }\n";

/** An application with a division by zero. */
const BROKEN = {
  data: { "num nShare": "", "num nWhole": "", "num nParts": "" },
  programs: `
program start()
begin
  // The view of the robot begins to receive events after the start of the session.
  delay(5)
  call divide()
end
program divide()
begin
  nShare=nWhole/nParts
end
`,
};

const STEPS = {
  async "programs that can be started have lenses"(user) {
    await user.openFile("start.pgx");
    await user.page.waitForSelector('.codelens-decoration a:text-is("Run")');
    await user.page.waitForSelector('.codelens-decoration a:text-is("Debug")');
  },

  async "the robot of an application that does not run is shown, with the point at the cursor"(user) {
    await user.openFile("pick.pgx");
    await user.command("VAL 3: Show Robot");
    const view = await user.frameWith("TX90L");
    await view.getByRole("tab", { name: "Points" }).click();
    await user.leavesWebview("Robot");
    await user.goTo(23, 12);
    await view.getByRole("form", { name: "Values of pPick" }).waitFor();
    await user.closesTab("Robot");
  },

  async "a breakpoint is set at a move"(user) {
    await user.openFile("pick.pgx");
    await user.goTo(22, 5);
    await user.keys("F9");
    await user.page.waitForSelector(".editor-instance .codicon-debug-breakpoint");
  },

  async "the lens starts the application"(user) {
    await user.openFile("start.pgx");
    await user.opensLens(/^Debug$/, ".debug-toolbar");
    await user.views("Robot");
    await user.robot("Arm");
  },

  async "the user page shows the application"(user) {
    await user.command("VAL 3 Pendant: Focus on User page View");
    await user.webview("State    waiting");
  },

  async "a key of the pendant reaches the application"(user) {
    await user.pendantKey("F1");
    await user.webview("State    running");
  },

  async "an input is forced, and the run stops at the breakpoint"(user) {
    await user.expands("Inputs and outputs");
    await user.expands("BasicIO-1");
    await user.acts("%I0", "Lock");
    await user.robot("%I0", "locked");
    await user.acts("%I0", "Toggle");
    await user.stopsAt("pick.pgx", 22);
  },

  async "variables are shown in the sidebar and in the code"(user) {
    await user.views("Variables");
    await user.variable("x_bOk", "true");
    await user.sees("x_bOk = true");
    await user.opensVariable("Locals", "l_pNear =");
    await user.opensVariable("l_pNear =", "trsf =");
  },

  async "a step over a move shows the executing line and that of the arm"(user) {
    await user.views("Robot");
    await user.keys("F10");
    await user.stopsAt("pick.pgx", 23);
    await user.icons("arm-light.svg", true);
    await user.robot("movej", "pick.pgx:22");
  },

  async "the motion is stepped by itself"(user) {
    await user.tool("Move Step by Step");
    await user.robot("Arm", "step by step");
    await user.tool("Step the Motion");
    // The leave point of the move.
    await user.robot("position", "x 294.6  y -736.8");
  },

  async "the robot is shown next to the code"(user) {
    await user.command("VAL 3: Show Robot");
    await user.webview("TX90L");
    const view = await user.frameWith("TX90L");
    await view.getByRole("tab", { name: "Inputs and outputs" }).click();
    await view.getByText("BasicIO-1").first().waitFor();
    await view.getByRole("tab", { name: "Points" }).click();
    await view.getByText("pSafe").first().waitFor();
  },

  async "the line of a task is opened from the robot's page"(user) {
    const view = await user.frameWith("TX90L");
    await view.getByRole("tab", { name: "Tasks" }).click();
    const line = view.locator("button.place").first();
    const name = basename(await line.getAttribute("title"));
    await line.click();
    await user.tab(name);
    await user.closesTab("Robot");
  },

  async "a value is changed"(user) {
    await user.views("Variables");
    await user.changes("x_bOk", "false");
    await user.variable("x_bOk", "false");
  },

  async "the debug console completes and evaluates"(user) {
    await user.command("Debug Console: Focus on Debug Console View");
    await user.type("nAbo");
    await user.completes("nAbove");
    await user.keys("Escape");
    await user.type("ve*2");
    await user.keys("Enter");
    await user.page.waitForSelector('.repl .monaco-list-row:has-text("300")');
  },

  async "a step back undoes the motion and the value, and another one the line"(user) {
    await user.focusEditor();
    await user.tool("Step Back");
    await user.variable("x_bOk", "true");
    await user.icons("arm-light.svg", false);
    await user.tool("Step Back");
    await user.stopsAt("pick.pgx", 22);
  },

  async "steps back lead to the line before and out of the program, by a key and a button"(user) {
    await user.keys("Alt+F11");
    await user.stopsAt("pick.pgx", 21);
    await user.tool("Step Back Out");
    await user.stopsAt("cycle.pgx", 22);
    await user.keys("F11");
    await user.stopsAt("pick.pgx", 12);
    await user.keys("F5");
    await user.stopsAt("pick.pgx", 22);
  },

  async "a breakpoint of the code view stops the run there"(user) {
    await user.command("VAL 3: Open Code without XML");
    await user.tab("pick.pgx (code)");
    // The breakpoint of the file.
    await user.icons("breakpoint.svg", true);
    await user.goTo(15, 5);
    await user.keys("F9");
    await user.page.waitForSelector(".editor-instance .codicon-debug-breakpoint");
    await user.tool("Move Continuously");
    await user.page.waitForSelector('.debug-toolbar .action-label[aria-label^="Move Step by Step"]');
    await user.keys("F5");
    await user.stopsAt("pick.pgx (code)", 15);
  },

  async "the end of the session clears the marks"(user) {
    await user.keys("Shift+F5");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
    await user.icons("arm-light.svg", false);
  },

  async "a run that began without a debugger is paused, and continues when the debugger leaves"(user) {
    const run = spawn(process.env.VAL3_SERVER, ["run", join(cell, APPLICATION), "--time", "real", "--debug-port", "0"]);
    try {
      configure({ type: "val3", request: "attach", name: "Attach to a run" });
      const { port, secret } = await addressOf(run);
      await user.starts("Debug: Select and Start Debugging", "Attach to a run");
      await user.answers("The port of the run", "0", "A port is a number from 1 to 65535.");
      await user.answers("A port is a number", port);
      await user.answers(`The secret that val3 run has printed with the port ${port}`, secret);
      await user.page.waitForSelector(".debug-toolbar");
      await user.pauses();
      await user.tool("Disconnect");
      await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
      assert.equal(run.exitCode, null);
    } finally {
      run.kill();
    }
  },

  async "F5 debugs the application of the file without any configuration"(user) {
    rmSync(join(cell, ".vscode/launch.json"));
    await user.openFile("pick.pgx");
    await user.keys("F5");
    await user.page.waitForSelector(".debug-toolbar");
    await user.views("Call Stack");
    await user.page.waitForSelector('.debug-call-stack .monaco-list-row:has-text("production")');
    await user.keys("Shift+F5");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
  },

  async "a fault is shown with the code of its line"(user) {
    cpSync(new Application("broken", BROKEN).folder(), join(cell, "usr/usrapp/broken"), { recursive: true });
    await user.openFile("divide.pgx");
    await user.command("VAL 3: Show Robot");
    await user.keys("F5");
    await user.page.waitForSelector(".editor-instance .debug-top-stack-frame-line, .editor-instance .debug-focused-stack-frame-line");
    const bar = (await user.frame(".fault-bar code")).locator(".fault-bar");
    assert.match(await bar.innerText(), /^Error 10: .* in task broken~ at divide:\d+/);
    assert.equal(await bar.locator("code").innerText(), "nShare=nWhole/nParts");
    await user.tool("Stop");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
    await user.closesTab("Robot");
  },

  async "among several applications the user picks one"(user) {
    cpSync(join(cell, APPLICATION), join(cell, "usr/usrapp/second"), { recursive: true });
    renameSync(join(cell, "usr/usrapp/second/palletiser.pjx"), join(cell, "usr/usrapp/second/second.pjx"));
    renameSync(join(cell, "usr/usrapp/second/palletiser.dtx"), join(cell, "usr/usrapp/second/second.dtx"));
    // A program of a library.
    await user.openFile("grip.pgx");
    await user.keys("F5");
    await user.page.waitForSelector('.quick-input-list .monaco-list-row:has-text("palletiser")');
    await user.choose("palletiser");
    await user.page.waitForSelector(".debug-toolbar");
    await user.keys("Shift+F5");
    await user.page.waitForSelector(".debug-toolbar", { state: "hidden" });
  },
};

cpSync(join(process.env.VAL3_ROOT, "examples/palletiser/usr"), join(cell, "usr"), { recursive: true });
mkdirSync(join(cell, ".vscode"));
configure(LAUNCH);
writeFileSync(join(cell, "rails.toml"), SCRIPT);
runSteps({ name: "debug", folder, open: `folder=${cell}`, steps: STEPS });
