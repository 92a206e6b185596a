// Chromium for the tests of pages. VAL3_CHROMIUM names another browser.
const { chromium } = require("playwright-core");

/** Longest time of a step, in ms. A busy machine needs much of it. */
const TIMEOUT = 180_000;

/** Launches the build of Chromium that only tests use: a page needs a quarter less processor time in it. */
function launch(...flags) {
  return chromium.launch({
    executablePath: process.env.VAL3_CHROMIUM ?? "/usr/bin/chromium-headless-shell",
    // Only the picture is drawn by an emulated graphics card. If it drew the whole page, tests would take almost twice the time.
    args: ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", ...flags],
  });
}

module.exports = { launch, TIMEOUT };
