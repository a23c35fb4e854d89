// Builds the package for JavaScript into a folder: for the web, for bundlers and for Node, with
// its types, worker, README and licences. Called by `./x package`, which finds the tools.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";

import { settings } from "./release/settings.mjs";

const root = fileURLToPath(new URL("..", import.meta.url));
const crate = join(root, "crates/giveway-wasm");
const out = process.argv[2] ?? join(root, "target/package");
const WASM = "giveway_wasm_bg.wasm";

const run = (command, ...args) => execFileSync(command, args, { cwd: root, stdio: ["ignore", "inherit", "inherit"] });
const { version, address } = settings(root);

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const small = new Map();
for (const target of ["web", "bundler", "nodejs"]) {
  const folder = join(out, target);
  run("wasm-pack", "build", crate, "--mode", "no-install", "--profile", "page", "--no-opt", "--no-pack",
    "--no-typescript", "--no-gitignore", "--target", target, "--out-dir", folder, "--", "--locked");
  // To make it small takes a minute, and all three may hold the same.
  const wasm = join(folder, WASM);
  const print = createHash("sha256").update(readFileSync(wasm)).digest("hex");
  if (!small.has(print)) {
    // What is written inline no longer resembles what else there is, and compresses worse: only
    // what is hardly more than its call, and hence slow as one. Functions that are called often
    // come first, and have short numbers.
    run("wasm-opt", "-Oz", "--one-caller-inline-max-function-size=0", "--always-inline-max-function-size=8",
      "--reorder-functions", wasm, "--output", wasm);
    small.set(print, readFileSync(wasm));
  }
  writeFileSync(wasm, small.get(print));
  const type = target === "nodejs" ? "commonjs" : "module";
  writeFileSync(join(folder, "package.json"), `${JSON.stringify({ type }, null, 2)}\n`);
}

const types = join(out, "types");
mkdirSync(types);
for (const name of ["types", "web", "worker"]) {
  cpSync(join(crate, "package", `${name}.d.ts`), join(types, `${name}.d.ts`));
}
writeFileSync(join(types, "package.json"), `${JSON.stringify({ type: "module" }, null, 2)}\n`);
const worker = join(out, "worker");
mkdirSync(worker);
for (const name of ["client.js", "solver.js"]) {
  cpSync(join(crate, "package", name), join(worker, name));
}
writeFileSync(join(worker, "package.json"), `${JSON.stringify({ type: "module" }, null, 2)}\n`);
for (const licence of ["LICENSE-MIT", "LICENSE-APACHE"]) {
  cpSync(join(root, licence), join(out, licence));
}

const bytes = brotliCompressSync(readFileSync(join(out, "web", WASM))).length
  + brotliCompressSync(readFileSync(join(out, "web/giveway_wasm.js"))).length;
const size = `What a page loads is ${Math.ceil(bytes / 1000)} kB, compressed by brotli.`;
const readme = readFileSync(join(crate, "package/README.md"), "utf8");
writeFileSync(join(out, "README.md"), readme.replace("\nSIZE\n", `\n${size}\n`));
writeFileSync(join(out, "package.json"), `${JSON.stringify({
  name: "giveway",
  version,
  description: "Plans for several robots on a grid, proved best, and explained",
  license: "MIT OR Apache-2.0",
  ...(address && { homepage: address }),
  keywords: ["multi-agent path finding", "MAPF", "SAT", "explanation", "WebAssembly"],
  types: "./types/types.d.ts",
  main: "./nodejs/giveway_wasm.js",
  exports: {
    ".": { types: "./types/types.d.ts", node: "./nodejs/giveway_wasm.js", default: "./bundler/giveway_wasm.js" },
    "./web": { types: "./types/web.d.ts", default: "./web/giveway_wasm.js" },
    "./worker": { types: "./types/worker.d.ts", default: "./worker/client.js" },
    "./worker/solver": "./worker/solver.js",
    "./giveway.wasm": `./web/${WASM}`,
    "./package.json": "./package.json",
  },
  files: ["bundler", "nodejs", "types", "web", "worker", "LICENSE-APACHE", "LICENSE-MIT"],
  sideEffects: ["./bundler/giveway_wasm.js", "./nodejs/giveway_wasm.js"],
}, null, 2)}\n`);
console.log(`${out}: ${size}`);
