// Makes of the assembled page a folder for any static host.
//
// 1. The programs, the scripts and the style sheets get the hashes of what they hold into their paths: so no cache can
//    mix two versions.
// 2. The style sheets become few: those that a first visit needs before and behind those that come later, in whose place
//    the page puts a link, so that their order stays. Fewer requests and bytes before the first paint.
// 3. The page's scripts lose their comments and indentation, and the page is told how large its Wasm is.
// 4. The page's head gets the address where it is published, if that is set in Cargo.toml.
// 5. The catalogues of languages lose what only translators read.
// 6. The service worker gets the list of files.

import { createHash } from "node:crypto";
import { copyFileSync, existsSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { PICTURE, withAddress } from "../release/head.mjs";
import { settings } from "../release/settings.mjs";
import { PAGE } from "./elements.mjs";

/** The programs beside the page's own: the script that starts one, the program's bindings, its Wasm. */
const PROGRAMS = [
  ["worker.js", "solver.js", "solver_bg.wasm"],
  ["analyst-worker.js", "analyst.js", "analyst_bg.wasm"],
  ["reader-worker.js", "reader.js", "reader_bg.wasm"],
  ["course-start.js", "course.js", "course_bg.wasm"],
];
/** The scripts that the page's HTML loads itself. */
const SCRIPTS = ["unstarted.js", "opening.js", "guard.js", "boot.js"];
/** The script of what is fetched by itself. */
const LATER_SCRIPTS = ["present.js"];
/** What is fetched when a file asks for it, and not kept beforehand. */
const ON_DEMAND = /^static\/(maps|languages)\//;
/** What only translators read in a catalogue. */
const REMARKS = /^(#.*)?\n/gm;
/** The style sheets of views that no first visit begins with: they come with the later part of the page's program. */
const VIEWS = /^(audit|change|freedom|inside|ledger|order|sizing|steer)\.css$/;
/** The style sheets that come later: those views, those of the course when it is opened, those of presenting and of a search by hand when that begins. */
const LATER_STYLES = [
  ["later-style", VIEWS],
  ["course-style", /^(author|class|course|lesson|print|tour)\.css$/],
  ["present-style", /^present\.css$/],
  ["hand-style", /^by-hand\.css$/],
];
const STYLES = /<link rel="stylesheet" href="\.\/([^"]+)"[^>]*>\s*/g;

/**
 * Finishes a page.
 * @param {string} source the project's folder
 * @param {string} built the folder in which the page was assembled
 * @throws {Error} where the page lacks something that it must have, or has something that its policy refuses
 */
export function finish(source, built) {
  const text = readFileSync(join(built, PAGE), "utf8");
  // Without the comments, which are for those who read the source, and their lines.
  const bare = text.replaceAll(/<!--.*?-->/gs, "").replaceAll(/^\s*\n/gm, "");
  const page = replace(joinStyles(built, bare), [
    ...nameApplication(built),
    ...namePrograms(built),
    ...SCRIPTS.map((name) => [`src="./${name}"`, `src="./${rename(built, name, { isPlain: true })}"`]),
    ...LATER_SCRIPTS.map((name) => [`content="./${name}">`, `content="./${rename(built, name)}">`]),
    ["<title>", `<meta name="giveway-service-worker" content="./service-worker.js">\n  <title>`],
  ]);
  refuseWhatThePolicyRefuses(page);
  const { address } = settings(source);
  if (address) {
    copyFileSync(join(source, "docs", PICTURE), join(built, PICTURE));
  }
  writeFileSync(join(built, PAGE), withAddress(page, address));
  shortenLanguages(built);
  writeServiceWorker(source, built);
}

/** The page's own program, with its size, fetched as soon as the page is read. */
function nameApplication(built) {
  const wasm = rename(built, "app_bg.wasm");
  const bindings = rename(built, "app.js", { isPlain: true, pairs: namePart(built, "app.js") });
  const bytes = statSync(join(built, wasm)).size;
  return [[
    `href="./app.js" data-wasm="./app_bg.wasm">`,
    `href="./${bindings}" data-wasm="./${wasm}" data-bytes="${bytes}">\n  <link rel="preload" href="./${wasm}" as="fetch" type="application/wasm" crossorigin>`,
  ]];
}

/** The other programs, as the page's head names them: bindings are handed their Wasm, and do not name it. */
function namePrograms(built) {
  return PROGRAMS.flatMap(([script, bindings, wasm]) => {
    const wasmAt = rename(built, wasm);
    const bindingsAt = rename(built, bindings, { pairs: namePart(built, bindings) });
    const scriptAt = rename(built, script, { pairs: [[`./${bindings}`, `./${bindingsAt}`]] });
    return [
      [`content="./${wasm}">`, `content="./${wasmAt}">`],
      [`content="./${script}">`, `content="./${scriptAt}">`],
    ];
  });
}

/** The later part of a program in two, as its bindings name it. */
function namePart(built, bindings) {
  const later = bindings.replace(/\.js$/, "_later.wasm");
  return existsSync(join(built, later)) ? [[`"./${later}"`, `"./${rename(built, later)}"`]] : [];
}

/** What the policy would refuse is found here and not by a user. */
function refuseWhatThePolicyRefuses(page) {
  for (const refused of [/<script(?![^>]*\bsrc=)/, /\bstyle=/, /<style/, /\bon[a-z]+=/]) {
    const found = page.match(refused);
    if (found) {
      throw new Error(`${PAGE} has ${found[0]}, which its policy does not allow`);
    }
  }
}

/** The page's style sheets become two, in the place of the first; between them and in the page's head those that come later are named. */
function joinStyles(built, text) {
  const names = [...text.matchAll(STYLES)].map(([, name]) => name);
  const isLater = (name) => LATER_STYLES.some(([, pattern]) => pattern.test(name));
  const middle = names.findIndex((name) => VIEWS.test(name));
  const now = (stem, names) => `<link rel="stylesheet" href="./${joined(built, stem, names.filter((name) => !isLater(name)))}">\n  `;
  const [before, behind] = [now("style", names.slice(0, middle)), now("end-style", names.slice(middle))];
  const later = LATER_STYLES.map(([stem, pattern]) => {
    const name = joined(built, stem, names.filter((name) => pattern.test(name)));
    return `<meta name="giveway-${stem}" content="./${name}">\n  `;
  });
  let isFirst = true;
  return text.replaceAll(STYLES, () => {
    const links = isFirst ? [before, ...later, behind].join("") : "";
    isFirst = false;
    return links;
  });
}

/** One style sheet of several, without comments; its name. */
function joined(built, stem, names) {
  const all = names.map((name) => readFileSync(join(built, name), "utf8")).join("\n");
  const style = all.replaceAll(/\/\*.*?\*\//gs, "").replaceAll(/\s*\n\s*/g, "\n").trim();
  const name = `${stem}-${hash([style])}.css`;
  writeFileSync(join(built, name), style);
  for (const one of names) {
    rmSync(join(built, one));
  }
  return name;
}

function shortenLanguages(built) {
  const folder = join(built, "static/languages");
  for (const name of readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".po"))) {
    const path = join(folder, name);
    writeFileSync(path, readFileSync(path, "utf8").replaceAll(REMARKS, ""));
  }
}

function writeServiceWorker(source, built) {
  const names = readdirSync(built, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(built.length + 1).replaceAll("\\", "/"))
    .filter((name) => name !== PICTURE && !ON_DEMAND.test(name))
    .sort();
  const version = hash(names.flatMap((name) => [name, "\0", readFileSync(join(built, name))]));
  const files = names.map((name) => (name === PAGE ? "./" : name));
  const template = readFileSync(join(source, "static/service-worker.js"), "utf8");
  const script = replace(template, [
    ['"{version}"', JSON.stringify(version)],
    ['["{files}"]', JSON.stringify(files, null, 2)],
  ]);
  writeFileSync(join(built, "service-worker.js"), script);
}

/** Gives a file a path with the hash of what it holds, after other names in it are replaced; the path. */
function rename(built, name, { pairs = [], isPlain = false } = {}) {
  const bytes = readFileSync(join(built, name));
  const named = pairs.length > 0 ? replace(bytes.toString(), pairs) : bytes;
  const content = isPlain ? plain(named.toString()) : named;
  const renamed = name.replace(/[._]/, (end) => `-${hash([content])}${end}`);
  rmSync(join(built, name));
  writeFileSync(join(built, renamed), content);
  return renamed;
}

/** A script that has no text of several lines, without comments and indentation. */
function plain(script) {
  return script.replaceAll(/^\s*\/\*\*.*?\*\/\n/gms, "").replaceAll(/^\s*\/\/.*\n/gm, "").replaceAll(/^\s+/gm, "");
}

function replace(text, pairs) {
  for (const [from, to] of pairs) {
    if (text.split(from).length !== 2) {
      throw new Error(`expected ${JSON.stringify(from)} once in what was built`);
    }
    text = text.replace(from, () => to);
  }
  return text;
}

function hash(contents) {
  const digest = createHash("sha256");
  for (const content of contents) {
    digest.update(content);
  }
  return digest.digest("hex").slice(0, 16);
}
