// What the Wasm of the page's programs weighs, and what that of the page and of its solver consists of, by what it costs
// on the wire: `./x weigh` writes docs/weight.md. They are built as for a host, but whole and with the names of functions;
// then, one group after the other, the bodies of all functions whose names say that they belong to it are left out, and
// what is left is compressed again.

import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";

import { root } from "../e2e/dist.mjs";
import { programs } from "../../scripts/page/elements.mjs";
import { listOf } from "../../scripts/page/later.mjs";

/** The programs of which it is told what they consist of. */
const PROGRAMS = [["app", "the page"], ["solver", "the solver"]];
const TARGET = "wasm32-unknown-unknown";
const FEATURES = ["bulk-memory", "reference-types", "sign-ext", "nontrapping-float-to-int", "multivalue", "mutable-globals"]
  .map((feature) => `--enable-${feature}`);

/** Groups of functions by their names. They overlap: a map of the solver's is of both. */
const GROUPS = [
  ["the page's elements", /giveway_web/],
  ["Yew, and what it compiles for each component", /^"?[<&(]*(mut )?yew/],
  ["the page as plain data", /giveway_page/],
  ["the solver: search and encodings", /giveway_solve(?!::(explain|change))/],
  ["explanations", /giveway_solve::explain/],
  ["changes while a plan runs", /giveway_solve::change/],
  ["the model, the judge, the readers of files", /giveway_model/],
  ["certificates and their checker", /giveway_proof|varisat_checker/],
  ["varisat", /varisat(?!_checker)/],
  ["reading and writing JSON", /serde/],
  ["messages between page and worker", /borsh/],
  ["maps and sets in order", /collections::btree/],
  ["sorting", /slice::sort/],
  ["floats as text", /flt2dec|dec2flt/],
];

const OPTIMISED = ["-Oz", "--one-caller-inline-max-function-size=0"];

const kilobytes = (n) => (n / 1000).toFixed(1);

const folder = mkdtempSync(join(tmpdir(), "weight-"));
const at = (name) => join(folder, name);
try {
  const names = programs(root).map(({ name }) => name);
  build(names);
  const parts = names.flatMap(partsOf);
  const tables = PROGRAMS.map(([program, name]) => {
    run("wasm-dis", ...FEATURES, at(`${program}.whole.wasm`), "-o", at(`${program}.wat`));
    const text = readFileSync(at(`${program}.wat`), "utf8").split("\n");
    const whole = weight(text, null);
    return table(name, whole, GROUPS.map(([group, names]) => [group, weight(text, names)]));
  });
  const written = document(parts, tables);
  writeFileSync(join(root, "docs/weight.md"), written);
  console.log(`${written}\nwritten: docs/weight.md`);
} finally {
  rmSync(folder, { recursive: true });
}

function run(command, ...args) {
  return execFileSync(command, args, { cwd: root, encoding: "utf8", stdio: ["ignore", "pipe", "inherit"], maxBuffer: 1 << 26 });
}

function build(names) {
  run("cargo", "build", "--quiet", "--locked", "--profile", "page", "--target", TARGET, "--package", "giveway-web", "--bins",
    "--config", `target.${TARGET}.rustflags=["-Csymbol-mangling-version=v0"]`);
  const { target_directory } = JSON.parse(run("cargo", "metadata", "--format-version", "1", "--no-deps", "--locked"));
  for (const name of names) {
    run("giveway-bind", join(target_directory, TARGET, `page/${name}.wasm`), folder, name);
    run("wasm-opt", ...OPTIMISED, "-g", ...FEATURES, at(`${name}_bg.wasm`), "-o", at(`${name}.whole.wasm`));
  }
}

/** A row for each part of a program: its name, its bytes, and those that are sent. */
function partsOf(name) {
  const list = listOf(root, name);
  copyFileSync(at(`${name}.whole.wasm`), at("first.wasm"));
  if (!existsSync(list)) {
    return [[name, optimised("first.wasm")]];
  }
  run("giveway-bind", "split", at("first.wasm"), at("later.wasm"), list);
  return [[`${name}, its first part`, optimised("first.wasm")], [`${name}, what comes later`, optimised("later.wasm")]];
}

function optimised(file) {
  run("wasm-opt", ...OPTIMISED, ...FEATURES, at(file), "-o", at("small.wasm"));
  return weigh(at("small.wasm"));
}

/** Bytes before and after compression, without the functions with such names. */
function weight(text, names) {
  writeFileSync(at("cut.wat"), without(text, names));
  run("wasm-as", ...FEATURES, at("cut.wat"), "-o", at("cut.wasm"));
  return weigh(at("cut.wasm"));
}

/** Bytes of a file before and after compression. */
function weigh(path) {
  const wasm = readFileSync(path);
  const params = { [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY, [constants.BROTLI_PARAM_SIZE_HINT]: wasm.length };
  return [wasm.length, brotliCompressSync(wasm, { params }).length];
}

/** The module without the bodies of functions with such names: nobody runs what is weighed. */
function without(text, names) {
  const kept = [];
  let inside = false;
  for (const line of text) {
    const name = /^ \(func \$("[^"]*"|\S+)/.exec(line)?.[1];
    const ends = inside && line === " )";
    if (!inside || ends) {
      kept.push(line);
    }
    inside = inside ? !ends : name !== undefined && names?.test(name) === true;
    if (name !== undefined && inside) {
      kept.push("  (unreachable)");
    }
  }
  return kept.join("\n");
}

/** The table of a program, without the groups that it has nothing of. */
function table(name, [bytes, compressed], groups) {
  const rows = groups.filter(([, [b]]) => b < bytes);
  const row = ([group, [b, c]]) => `| ${group} | ${kilobytes(bytes - b)} | ${kilobytes(compressed - c)} |`;
  return `| ${name} | Wasm | compressed |
|---|---:|---:|
| all of it | ${kilobytes(bytes)} | ${kilobytes(compressed)} |
${rows.map(row).join("\n")}
`;
}

function document(parts, tables) {
  const rows = parts.map(([name, [bytes, compressed]]) => `| ${name} | ${kilobytes(bytes)} | ${kilobytes(compressed)} |`);
  return `# What the page weighs

\`./x weigh\` writes this file: the Wasm of the page's programs, in kB, as it is and compressed by brotli. The page and its
solver come in two parts: what a first visit runs, and the rest, which the page fetches once it can solve and a worker once
it needs it (scripts/page/later/). What a visit fetches until the application is there and until it can solve is limited
in tests/e2e/size.test.mjs.

| program | Wasm | compressed |
|---|---:|---:|
${rows.join("\n")}

What the page and its solver consist of, both parts together: a row tells how much smaller a program is without the functions
of that group. Groups overlap, and what is left of two may compress less well than both, so the rows do not add up.

${tables.join("\n")}`;
}
