// Runs the steps of one test in one workbench, one after the other. Every step saves a screenshot in
// target/editors/output.
const { rmSync } = require("node:fs");
const { join } = require("node:path");
const { User } = require("./user");
const { startVsCode } = require("./vscode");

/** Runs a test file. `folder` is a scratch folder, `open` the first folder or workspace of the workbench. */
function runSteps(test) {
  run(test).then((failed) => process.exit(failed), (fault) => {
    console.error(fault);
    process.exit(1);
  });
}

async function run({ name, folder, open, steps, ...options }) {
  const vscode = await startVsCode(folder, process.env.VAL3_VSIX, options);
  const user = await User.open(vscode.address, open);
  let number = 0;
  let fault;
  for (const [title, step] of Object.entries(steps)) {
    number += 1;
    const started = Date.now();
    fault = await step(user).then(() => undefined, (fault) => fault);
    const picture = `${name}-${String(number).padStart(2, "0")}-${title.replaceAll(/[^\w]+/g, "-")}.png`;
    await user.page.screenshot({ path: join(process.env.VAL3_OUTPUT, picture) });
    console.log(`${fault === undefined ? "ok" : "FAILED"} ${title} (${Date.now() - started} ms)`);
    if (fault !== undefined) {
      console.log(String(fault.stack ?? fault).slice(0, 2000));
      console.log(await user.describe().catch(String));
      break;
    }
  }
  await user.leave();
  await vscode.stop();
  // Processes of extensions end some time after the server, and write until then.
  rmSync(folder, { recursive: true, force: true, maxRetries: 20, retryDelay: 250 });
  const failed = fault === undefined ? 0 : 1;
  console.log(`test result: ${failed ? "FAILED" : "ok"}. ${number - failed} passed; ${failed} failed; ${name}`);
  return failed;
}

module.exports = { runSteps };
