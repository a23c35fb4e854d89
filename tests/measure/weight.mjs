// What the page's Wasm consists of, by what it costs on the wire: `./x weigh` writes
// docs/weight.md. It is built as for a host, but with the names of functions; then, one
// group after the other, the bodies of all functions whose names say that they belong to
// it are left out, and what is left is compressed again.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";

import { root } from "../e2e/dist.mjs";

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

const folder = mkdtempSync(join(tmpdir(), "weight-"));
const at = (name) => join(folder, name);
try {
  build();
  const text = readFileSync(at("page.wat"), "utf8").split("\n");
  const whole = weight(text, null);
  const rows = GROUPS.map(([name, names]) => [name, weight(text, names)]);
  const written = document(whole, rows);
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
  run("wasm-bindgen", "--target", "web", "--keep-debug", "--out-dir", folder, "--out-name", "page",
    join(target_directory, TARGET, "page/app.wasm"));
  // As Trunk is told in index.html.
  run("wasm-opt", "-Oz", "--one-caller-inline-max-function-size=0", "-g", ...FEATURES, at("page_bg.wasm"), "-o", at("small.wasm"));
  run("wasm-dis", ...FEATURES, at("small.wasm"), "-o", at("page.wat"));
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

function document([bytes, compressed], rows) {
  const kilobytes = (n) => (n / 1000).toFixed(1);
  const row = ([name, [b, c]]) => `| ${name} | ${kilobytes(bytes - b)} | ${kilobytes(compressed - c)} |`;
  return `# What the page weighs

\`./x weigh\` writes this file. All Wasm of the page is one file of ${kilobytes(bytes)} kB, or ${kilobytes(compressed)} kB compressed by
brotli. A row tells how much smaller it is without the functions of that group, in kB. Groups overlap, and what is left
of two may compress less well than both, so the rows do not add up.

| what | Wasm | compressed |
|---|---:|---:|
${rows.map(row).join("\n")}
`;
}
