// Trunk's last step (Trunk.toml): makes of what it has built a folder for any static host.
//
// 1. The worker gets the hash of what it holds into its path, as Trunk gives all other
//    files: so no cache can mix two versions.
// 2. The policy loses the nonce, which only `trunk serve` needs.
// 3. The service worker gets the list of files.
//
// While `trunk serve` runs, none of it is done, so that nothing old is ever shown.

import { createHash } from "node:crypto";
import { readFileSync, readdirSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const NONCE = "trunk-nonce";
const PAGE = "index.html";
const WORKER = "worker.js";

const source = process.env.TRUNK_SOURCE_DIR;
const built = process.env.TRUNK_STAGING_DIR;
if (!source || !built) {
  fail("found no TRUNK_SOURCE_DIR and TRUNK_STAGING_DIR, expected to be called by Trunk");
}

const isServed = readFileSync(join(built, PAGE), "utf8").includes("__TRUNK_ADDRESS__");
if (!isServed) {
  finishPage(nameWorker());
  writeServiceWorker();
}

function fail(message) {
  console.error(`finish-page: ${message}`);
  process.exit(1);
}

function hash(contents) {
  const digest = createHash("sha256");
  for (const content of contents) {
    digest.update(content);
  }
  return digest.digest("hex").slice(0, 16);
}

function read(name) {
  return readFileSync(join(built, name));
}

function nameWorker() {
  const name = WORKER.replace(".", `-${hash([read(WORKER)])}.`);
  renameSync(join(built, WORKER), join(built, name));
  return name;
}

function finishPage(worker) {
  // Without the comments, which are for those who read the source, and their lines.
  const text = read(PAGE).toString().replaceAll(/<!--.*?-->/gs, "").replaceAll(/^\s*\n/gm, "");
  const finished = replace(text.replaceAll(` nonce="${NONCE}"`, ""), [
    [` 'nonce-${NONCE}'`, ""],
    [`content="./${WORKER}">`, `content="./${worker}">\n  <meta name="giveway-service-worker" content="./service-worker.js">`],
  ]);
  // What the policy would refuse is found here and not by a user.
  for (const refused of [/<script(?![^>]*\bsrc=)/, /\bstyle=/, /<style/, /\bon[a-z]+=/, new RegExp(NONCE)]) {
    const found = finished.match(refused);
    if (found) {
      fail(`${PAGE} has ${found[0]}, which its policy does not allow`);
    }
  }
  writeFileSync(join(built, PAGE), finished);
}

function replace(text, pairs) {
  for (const [from, to] of pairs) {
    if (text.split(from).length !== 2) {
      fail(`expected ${JSON.stringify(from)} once in what was built`);
    }
    text = text.replace(from, () => to);
  }
  return text;
}

function writeServiceWorker() {
  const names = readdirSync(built, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(built.length + 1).replaceAll("\\", "/"))
    .sort();
  const version = hash(names.flatMap((name) => [name, "\0", read(name)]));
  const files = names.map((name) => (name === PAGE ? "./" : name));
  const template = readFileSync(join(source, "static/service-worker.js"), "utf8");
  const script = replace(template, [
    ['"{version}"', JSON.stringify(version)],
    ['["{files}"]', JSON.stringify(files, null, 2)],
  ]);
  writeFileSync(join(built, "service-worker.js"), script);
}
