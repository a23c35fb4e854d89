// Compiles the page's programs to Wasm, with the scripts that bind them to the browser.

import { spawn } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { programs } from "./elements.mjs";
import { listOf, told, withLater } from "./later.mjs";

const TARGET = "wasm32-unknown-unknown";
/** Names of functions that tell one of two that are compiled of the same source for different types. */
const NAMES = ["--config", `target.${TARGET}.rustflags=["-Csymbol-mangling-version=v0"]`];
/** What wasm-opt may write: all that browsers have that this page is for. */
const FEATURES = ["bulk-memory", "multivalue", "mutable-globals", "nontrapping-float-to-int", "reference-types", "sign-ext"]
  .map((feature) => `--enable-${feature}`);

/**
 * Writes each program's Wasm and bindings into the folder.
 * @param {string} source the project's folder
 * @param {string} folder where they go
 * @param {"quick" | "page" | "visit"} kind quick to build; small for a host, optimised and in two parts; or as small, noting
 *   which functions run, with the names of those of `app` in `app.functions`
 * @throws {Error} where a step fails; it has said itself why
 */
export async function compile(source, folder, kind) {
  mkdirSync(folder, { recursive: true });
  const compiled = process.env.CARGO_TARGET_DIR ?? join(source, "target");
  const profile = kind === "quick" ? "quick" : "page";
  const names = kind === "quick" ? [] : NAMES;
  await run("cargo", ["build", "--locked", "--profile", profile, "--target", TARGET, "--package", "giveway-web", "--bins", ...names], source);
  await Promise.all(programs(source).map(async ({ name, optimise }) => {
    await run("giveway-bind", [join(compiled, TARGET, profile, `${name}.wasm`), folder, name], source);
    if (kind !== "quick") {
      await finish(source, folder, name, optimise, kind);
    }
  }));
}

/** Optimises a program, and splits it or has it note what runs. */
async function finish(source, folder, name, optimise, kind) {
  const wasm = join(folder, `${name}_bg.wasm`);
  const later = join(folder, `${name}_later.wasm`);
  const bindings = join(folder, `${name}.js`);
  const list = listOf(source, name);
  if (kind === "visit") {
    await optimised(wasm, [...optimise, "-g"], source);
    await run("giveway-bind", ["count", wasm, join(folder, `${name}.functions`)], source);
    writeFileSync(bindings, told(readFileSync(bindings, "utf8")));
  } else if (existsSync(list)) {
    await optimised(wasm, [...optimise, "-g"], source);
    await run("giveway-bind", ["split", wasm, later, list], source);
    await Promise.all([wasm, later].map((part) => optimised(part, [...FEATURES, ...optimise], source)));
    writeFileSync(bindings, withLater(readFileSync(bindings, "utf8"), `./${name}_later.wasm`));
  } else {
    await optimised(wasm, optimise, source);
  }
}

async function optimised(wasm, options, source) {
  await run("wasm-opt", [...options, wasm, "--output", `${wasm}.part`], source);
  renameSync(`${wasm}.part`, wasm);
}

function run(command, args, folder) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: folder, stdio: "inherit" });
    child.on("error", (error) => reject(new Error(`${command}: ${error.message}`)));
    child.on("exit", (code) => (code === 0 ? resolve() : reject(new Error(`${command} ended with ${code}`))));
  });
}
