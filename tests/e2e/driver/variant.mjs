// The built page, a little changed: with a script before all others that notes every
// complaint, since not every browser tells them, and style sheets as an old browser reads them.

import { cp, mkdtemp, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { dist } from "../dist.mjs";

const NOTES = `
window.complaints = [];
addEventListener("error", (event) => complaints.push("error: " + (event.message ?? event.target?.outerHTML)), true);
addEventListener("unhandledrejection", (event) => complaints.push("promise: " + event.reason));
addEventListener("securitypolicyviolation", (event) => complaints.push("policy: " + event.violatedDirective));
console.error = (...words) => complaints.push("console: " + words.join(" "));
`;

/**
 * A copy of the built folder; the test takes it away again.
 * @param options `before`, a function that the page runs first; `sheet`, which changes a style sheet
 */
export async function variant(t, { before = () => undefined, sheet = (text) => text } = {}) {
  const folder = await mkdtemp(join(tmpdir(), "giveway-page-"));
  t.after(() => rm(folder, { recursive: true, force: true }));
  await cp(dist, folder, { recursive: true });
  await writeFile(join(folder, "notes.js"), `${NOTES}(${before})();\n`);
  await change(join(folder, "index.html"), (text) => text.replace("</title>", '</title><script src="notes.js"></script>'));
  for (const name of await readdir(folder)) {
    if (name.endsWith(".css")) {
      await change(join(folder, name), sheet);
    }
  }
  return folder;
}

async function change(file, by) {
  await writeFile(file, by(await readFile(file, "utf8")));
}
