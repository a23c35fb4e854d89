// How the page is put together for a host; that it works there is tested end to end.

import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { assemble } from "../../scripts/page/assemble.mjs";
import { programs } from "../../scripts/page/elements.mjs";
import { finish } from "../../scripts/page/finish.mjs";

/** A finished page whose programs are texts, after a change of its parts. */
function built(change = () => {}) {
  const folder = mkdtempSync(join(tmpdir(), "giveway-page-"));
  for (const { name } of programs(".")) {
    writeFileSync(join(folder, `${name}.js`), `// Binds.\nexport const name = "${name}";\n`);
    writeFileSync(join(folder, `${name}_bg.wasm`), name);
  }
  assemble(".", folder);
  change(folder);
  finish(".", folder);
  return folder;
}

const at = (folder, name) => readFileSync(join(folder, name), "utf8");

test("every path that the page names is there, with the hash of what it holds", () => {
  const folder = built();
  const page = at(folder, "index.html");
  const named = [...page.matchAll(/(?:href|src|content|data-wasm)="\.\/([^"]+)"/g)].map(([, path]) => path);
  assert.ok(named.length >= 18, `found ${named.length} files named`);
  assert.deepEqual(named.filter((path) => !existsSync(join(folder, path))), []);
  const unhashed = named.filter((path) => !/-[0-9a-f]{16}[._]/.test(path));
  assert.deepEqual(unhashed, ["service-worker.js"]);
  assert.deepEqual(readdirSync(folder).filter((name) => /\.(css|js|wasm)$/.test(name) && !named.includes(name) && !/^(solver|analyst|reader|course)-[0-9a-f]{16}\.js$/.test(name)), []);
  rmSync(folder, { recursive: true });
});

test("a changed file changes the paths of all that name it, and no other", () => {
  const [before, after] = [built(), built((folder) => {
    writeFileSync(join(folder, "solver_bg.wasm"), "another");
    writeFileSync(join(folder, "reader.js"), "another");
  })];
  const gone = readdirSync(before).filter((name) => !existsSync(join(after, name)));
  assert.deepEqual(gone.map((name) => name.replace(/-[0-9a-f]{16}/, "")).sort(), ["reader-worker.js", "reader.js", "solver_bg.wasm"]);
  assert.notEqual(at(before, "service-worker.js"), at(after, "service-worker.js"));
  for (const folder of [before, after]) {
    rmSync(folder, { recursive: true });
  }
});

test("style sheets are joined, those of what comes later apart", () => {
  const folder = built();
  const sheets = readdirSync(folder).filter((name) => name.endsWith(".css")).map((name) => name.replace(/-[0-9a-f]{16}/, ""));
  assert.deepEqual(sheets.sort(), ["course-style.css", "end-style.css", "hand-style.css", "later-style.css", "present-style.css", "style.css"]);
  const page = at(folder, "index.html");
  const links = [...page.matchAll(/(?:href|content)="\.\/((?:end-|later-)?style)-/g)].map(([, stem]) => stem);
  assert.deepEqual(links, ["style", "later-style", "end-style"], "each has its place in the order");
  rmSync(folder, { recursive: true });
});

test("what the page's policy refuses is refused here", () => {
  const spoil = (folder) => {
    const page = at(folder, "index.html");
    writeFileSync(join(folder, "index.html"), page.replace("<body>", '<body style="color: red">'));
  };
  assert.throws(() => built(spoil), /index\.html has style=, which its policy does not allow/);
});
