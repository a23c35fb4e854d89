// Makes a page load itself anew when the server tells of a change; its policy lets it listen
// to the place that it comes from.

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { PAGE } from "../page/elements.mjs";

const SCRIPT = "reload.js";
const RELOADS = `new EventSource("./events").onmessage = () => location.reload();\n`;

/**
 * Adds the script to an assembled page.
 * @param {string} folder where the page is
 */
export function makeReloading(folder) {
  const page = readFileSync(join(folder, PAGE), "utf8");
  writeFileSync(join(folder, PAGE), page.replace("</head>", `  <script type="module" src="./${SCRIPT}"></script>\n</head>`));
  writeFileSync(join(folder, SCRIPT), RELOADS);
}
