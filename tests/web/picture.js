// SPDX-License-Identifier: MIT
// A picture of the page for the README: picture.js INDEX.html PICTURE.png
import path from "node:path";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const require = createRequire(path.join(process.env.NODE_MODULES, "index.js"));
const { chromium } = require("playwright-core");

const [index, picture] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--force-color-profile=srgb"] });
const page = await browser.newPage({ viewport: { width: 1120, height: 800 } });
await page.goto(pathToFileURL(path.resolve(index)).href);
await page.waitForFunction(() => document.body.dataset.settled, null, { timeout: 60000 });
await page.screenshot({ path: picture });
await browser.close();
