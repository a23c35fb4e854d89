// What the Wasm of the page and of its solver consists of, by what it costs on the wire:
// `./x weigh` writes docs/weight.md. It is built as for a host, but with the names of functions; then, one
// group after the other, the bodies of all functions whose names say that they belong to
// it are left out, and what is left is compressed again.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";

import { root } from "../e2e/dist.mjs";

/** The programs that are weighed. */
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

const kilobytes = (n) => (n / 1000).toFixed(1);

const folder = mkdtempSync(join(tmpdir(), "weight-"));
const at = (name) => join(folder, name);
try {
  build();
  const tables = PROGRAMS.map(([program, name]) => {
    const text = readFileSync(at(`${program}.wat`), "utf8").split("\n");
    const whole = weight(text, null);
    return table(name, whole, GROUPS.map(([group, names]) => [group, weight(text, names)]));
  });
  const written = document(tables);
  writeFileSync(join(root, "docs/weight.md"), written);
  console.log(`${written}\nwritten: docs/weight.md`);
} finally {
  rmSync(folder, { recursive: true });
}

function run(command, ...args) {
  return execFileSync(command, args, { cwd: root, encoding: "utf8", stdio: ["ignore", "pipe", "inherit"], maxBuffer: 1 << 26 });
}

function build() {
  run("cargo", "build", "--quiet", "--locked", "--profile", "page", "--target", TARGET, "--package", "giveway-web");
  const { target_directory } = JSON.parse(run("cargo", "metadata", "--format-version", "1", "--no-deps", "--locked"));
  for (const [program] of PROGRAMS) {
    run("wasm-bindgen", "--target", "web", "--keep-debug", "--out-dir", folder, "--out-name", program,
      join(target_directory, TARGET, `page/${program}.wasm`));
    run("wasm-opt", "-Oz", "--one-caller-inline-max-function-size=0", "-g", ...FEATURES, at(`${program}_bg.wasm`), "-o", at("small.wasm"));
    run("wasm-dis", ...FEATURES, at("small.wasm"), "-o", at(`${program}.wat`));
  }
}

/** Bytes before and after compression, without the functions with such names. */
function weight(text, names) {
  writeFileSync(at("cut.wat"), without(text, names));
  run("wasm-as", ...FEATURES, at("cut.wat"), "-o", at("cut.wasm"));
  const wasm = readFileSync(at("cut.wasm"));
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

function document(tables) {
  return `# What the page weighs

\`./x weigh\` writes this file: the Wasm of the page and of its solver, in kB, as it is and compressed by brotli. A row
tells how much smaller it is without the functions of that group. Groups overlap, and what is left of two may compress
less well than both, so the rows do not add up.

${tables.join("\n")}`;
}
