// Builds the page for working on it: quick to build, and only where something changed.

import { spawn } from "node:child_process";
import { mkdirSync } from "node:fs";
import { join } from "node:path";

const PROFILE = "quick";
const TARGET = "wasm32-unknown-unknown";
/** The page, what its workers run, and the course. */
const PROGRAMS = ["app", "solver", "analyst", "reader", "course"];

/**
 * Compiles the Wasm and puts it into the folder.
 * @param {string} source the project's folder
 * @param {string} folder where the files for the page go
 * @throws {Error} where a step fails; it has said itself why
 */
export async function build(source, folder) {
  mkdirSync(folder, { recursive: true });
  const compiled = process.env.CARGO_TARGET_DIR ?? join(source, "target");
  await run("cargo", ["build", "--locked", "--profile", PROFILE, "--target", TARGET, "--package", "giveway-web", "--bins"], source);
  await Promise.all(PROGRAMS.map((name) => {
    const wasm = join(compiled, TARGET, PROFILE, `${name}.wasm`);
    return run("giveway-bind", [wasm, folder, name], source);
  }));
}

function run(command, args, folder) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: folder, stdio: "inherit" });
    child.on("error", (error) => reject(new Error(`${command}: ${error.message}`)));
    child.on("exit", (code) => (code === 0 ? resolve() : reject(new Error(`${command} ended with ${code}`))));
  });
}
