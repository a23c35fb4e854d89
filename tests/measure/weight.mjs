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

/** The modules that rules of a scene's own added, from the model to the page; what is inlined elsewhere is not seen. */
const OF_RULES = [
  "giveway_model::constraint", "giveway_model::check::constraints", "giveway_model::check::over_time::constraints",
  "giveway_model::change::apply::constraints", "giveway_model::snapshot::rules",
  "giveway_page::rules", "giveway_page::board::rules", "giveway_page::board::zones", "giveway_page::edit::rules",
  "giveway_page::reduce::rules", "giveway_page::reduce::prices",
  "giveway_web::board::rules", "giveway_web::inspector::rules", "giveway_web::inspector::rule_card", "giveway_web::inspector::slot_editor",
  "giveway_web::timeline::rules", "giveway_web::timeline::clash",
  "giveway_picture::rules", "giveway_picture::draw::rules",
  "giveway_solve::price", "giveway_solve::encode::rules", "giveway_solve::change::rules", "giveway_solve::freedom::rules",
  "giveway_planners::rules", "giveway_planners::lacam::constraints", "giveway_planners::bottleneck", "giveway_planners::local::rules",
];
const RULES = new RegExp(`(${OF_RULES.join("|")})\\b`);

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
  ["rules of a scene's own", RULES],
  ["sorting", /slice::sort/],
  ["floats as text", /flt2dec|dec2flt/],
];

/** What a compiler adds to the name of a crate. */
const HASH = /\[[0-9a-f]{12,16}\]/g;

const OPTIMISED = ["-Oz", "--one-caller-inline-max-function-size=0"];

const kilobytes = (n) => (n / 1000).toFixed(1);

const folder = mkdtempSync(join(tmpdir(), "weight-"));
const at = (name) => join(folder, name);
try {
  const names = programs(root).map(({ name }) => name);
  build(names);
  const parts = names.flatMap(partsOf);
  const rules = names.flatMap(rulesOf);
  const tables = PROGRAMS.map(([program, name]) => {
    run("wasm-dis", ...FEATURES, at(`${program}.whole.wasm`), "-o", at(`${program}.wat`));
    const text = readFileSync(at(`${program}.wat`), "utf8").split("\n");
    const whole = weight(text, null);
    return table(name, whole, GROUPS.map(([group, names]) => [group, weight(text, names)]));
  });
  const written = document(parts, rules, tables);
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

/** What the first part of a program would weigh less by, if rules of a scene's own came later. */
function rulesOf(name) {
  const list = listOf(root, name);
  if (!existsSync(list)) {
    return [];
  }
  const first = (modules) => {
    copyFileSync(at(`${name}.whole.wasm`), at("first.wasm"));
    writeFileSync(at("later.txt"), readFileSync(list, "utf8") + modules.map((module) => `${module}\n`).join(""));
    run("giveway-bind", "split", at("first.wasm"), at("later.wasm"), at("later.txt"));
    return optimised("first.wasm");
  };
  const [with_, without_] = [first([]), first(OF_RULES)];
  return [[name, with_.map((bytes, place) => bytes - without_[place])]];
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
    inside = inside ? !ends : name !== undefined && names?.test(name.replaceAll(HASH, "")) === true;
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

function document(parts, rules, tables) {
  const rows = parts.map(([name, [bytes, compressed]]) => `| ${name} | ${kilobytes(bytes)} | ${kilobytes(compressed)} |`);
  const ofRules = rules.map(([name, [, compressed]]) => `${kilobytes(compressed)} kB of ${name}`).join(", ");
  return `# What the page weighs

\`./x weigh\` writes this file: the Wasm of the page's programs, in kB, as it is and compressed by brotli. The page and its
solver come in two parts: what a first visit runs, and the rest, which the page fetches once it can solve and a worker once
it needs it (scripts/page/later/). What a visit fetches until the application is there and until it can solve is limited
in tests/e2e/size.test.mjs.

| program | Wasm | compressed |
|---|---:|---:|
${rows.join("\n")}

If all modules of rules of a scene's own came later, the first parts would weigh less by ${ofRules} (compressed).

What the page and its solver consist of, both parts together: a row tells how much smaller a program is without the functions
of that group. Groups overlap, and what is left of two may compress less well than both, so the rows do not add up.

${tables.join("\n")}`;
}
