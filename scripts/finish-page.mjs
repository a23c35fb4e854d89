// Trunk's last step (Trunk.toml): makes of what it has built a folder for any static host.
//
// 1. The programs of the workers and of the course, and the scripts, get the hashes of what they hold into their
//    paths, as Trunk gives all other files: so no cache can mix two versions.
// 2. The style sheets become one, in their order, those of the course another, and that of presenting a third: fewer
//    requests and bytes before the first paint.
// 3. The page's scripts lose their comments and indentation, and the page is told how
//    large its Wasm is.
// 4. The policy loses the nonce, which only `trunk serve` needs.
// 5. The page's head gets the address where it is published, if that is set in Cargo.toml.
// 6. The catalogues of languages lose what only translators read.
// 7. The service worker gets the list of files.
//
// While `trunk serve` runs, none of it is done, so that nothing old is ever shown.

import { createHash } from "node:crypto";
import { copyFileSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { PICTURE, withAddress } from "./release/head.mjs";
import { settings } from "./release/settings.mjs";

const NONCE = "trunk-nonce";
const PAGE = "index.html";
/** The programs beside the page's own: the script that starts one, the program's bindings, its Wasm. */
const PROGRAMS = [
  ["worker.js", "solver.js", "solver_bg.wasm"],
  ["analyst-worker.js", "analyst.js", "analyst_bg.wasm"],
  ["reader-worker.js", "reader.js", "reader_bg.wasm"],
  ["course-start.js", "course.js", "course_bg.wasm"],
];
/** The script of what is fetched by itself. */
const SCRIPTS = ["present.js"];
/** What is fetched when a file asks for it, and not kept beforehand. */
const ON_DEMAND = /^static\/(maps|languages)\//;
/** What only translators read in a catalogue. */
const REMARKS = /^(#.*)?\n/gm;
/** The style sheets that come later: those of the course when it is opened, that of presenting when that begins. */
const LATER = [
  ["course-style", /^(author|course|lesson|print|tour)-[0-9a-f]+\.css$/],
  ["present-style", /^present-[0-9a-f]+\.css$/],
];
const STYLES = /<link rel="stylesheet" href="\.\/([^"]+)"[^>]*>\s*/g;

const source = process.env.TRUNK_SOURCE_DIR;
const built = process.env.TRUNK_STAGING_DIR;
if (!source || !built) {
  fail("found no TRUNK_SOURCE_DIR and TRUNK_STAGING_DIR, expected to be called by Trunk");
}

const isServed = readFileSync(join(built, PAGE), "utf8").includes("__TRUNK_ADDRESS__");
if (!isServed) {
  finishPage();
  shortenLanguages();
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

/** Gives a file a path that says what it holds, and what that is where it names others. */
function rename(name, pairs = []) {
  const content = pairs.length > 0 ? replace(read(name).toString(), pairs) : read(name);
  const renamed = name.replace(/[._]/, (end) => `-${hash([content])}${end}`);
  rmSync(join(built, name));
  writeFileSync(join(built, renamed), content);
  return renamed;
}

function finishPage() {
  const programs = PROGRAMS.flatMap(([script, bindings, wasm]) => {
    const wasmAt = rename(wasm);
    const bindingsAt = rename(bindings, [[wasm, wasmAt]]);
    const scriptAt = rename(script, [[`./${bindings}`, `./${bindingsAt}`]]);
    return [
      [`content="./${wasm}">`, `content="./${wasmAt}">`],
      [`content="./${script}">`, `content="./${scriptAt}">`],
    ];
  });
  programs.push(...SCRIPTS.map((script) => [`content="./${script}">`, `content="./${rename(script)}">`]));
  for (const name of readdirSync(built).filter((name) => /^(app|boot|guard|opening)-.*\.js$/.test(name))) {
    writeFileSync(join(built, name), plain(read(name).toString()));
  }
  // Without the comments, which are for those who read the source, and their lines.
  const text = read(PAGE).toString().replaceAll(/<!--.*?-->/gs, "").replaceAll(/^\s*\n/gm, "");
  const sized = joinStyles(text).replace(/data-wasm="([^"]+)"/, (given, path) => `${given} data-bytes="${read(path).length}"`);
  const finished = replace(sized.replaceAll(` nonce="${NONCE}"`, ""), [
    [` 'nonce-${NONCE}'`, ""],
    ...programs,
    ["<title>", `<meta name="giveway-service-worker" content="./service-worker.js">\n  <title>`],
  ]);
  // What the policy would refuse is found here and not by a user.
  for (const refused of [/<script(?![^>]*\bsrc=)/, /\bstyle=/, /<style/, /\bon[a-z]+=/, new RegExp(NONCE)]) {
    const found = finished.match(refused);
    if (found) {
      fail(`${PAGE} has ${found[0]}, which its policy does not allow`);
    }
  }
  const { address } = settings(source);
  if (address) {
    copyFileSync(join(source, "docs", PICTURE), join(built, PICTURE));
  }
  writeFileSync(join(built, PAGE), withAddress(finished, address));
}

/** A script that has no text of several lines, without comments and indentation. */
function plain(script) {
  return script.replaceAll(/^\s*\/\*\*.*?\*\/\n/gms, "").replaceAll(/^\s*\/\/.*\n/gm, "").replaceAll(/^\s+/gm, "");
}

/** The page's style sheets become one, in the place of the first; those that come later are named in its head. */
function joinStyles(text) {
  const names = [...text.matchAll(STYLES)].map(([, name]) => name);
  const isLater = (name) => LATER.some(([, pattern]) => pattern.test(name));
  const style = joined("style", names.filter((name) => !isLater(name)));
  const later = LATER.map(([stem, pattern]) => [stem, joined(stem, names.filter((name) => pattern.test(name)))]);
  let isFirst = true;
  return text.replaceAll(STYLES, () => {
    const metas = later.map(([stem, name]) => `<meta name="giveway-${stem}" content="./${name}">\n  `).join("");
    const links = isFirst ? `<link rel="stylesheet" href="./${style}">\n  ${metas}` : "";
    isFirst = false;
    return links;
  });
}

/** One style sheet of several, without comments; its name. */
function joined(stem, names) {
  const all = names.map((name) => read(name).toString()).join("\n");
  const style = all.replaceAll(/\/\*.*?\*\//gs, "").replaceAll(/\s*\n\s*/g, "\n").trim();
  const name = `${stem}-${hash([style])}.css`;
  writeFileSync(join(built, name), style);
  for (const one of names) {
    rmSync(join(built, one));
  }
  return name;
}

function shortenLanguages() {
  const folder = join(built, "static/languages");
  for (const name of readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".po"))) {
    const path = join(folder, name);
    writeFileSync(path, readFileSync(path, "utf8").replaceAll(REMARKS, ""));
  }
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
    .filter((name) => name !== PICTURE && !ON_DEMAND.test(name))
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
