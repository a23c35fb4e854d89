// Compiles the page's programs to Wasm, with the scripts that bind them to the browser.

import { spawn } from "node:child_process";
import { mkdirSync, renameSync } from "node:fs";
import { join } from "node:path";

import { programs } from "./elements.mjs";

const TARGET = "wasm32-unknown-unknown";

/**
 * Writes each program's Wasm and bindings into the folder.
 * @param {string} source the project's folder
 * @param {string} folder where they go
 * @param {"quick" | "page"} profile of Cargo.toml: quick to build, or small and optimised by wasm-opt for a host
 * @throws {Error} where a step fails; it has said itself why
 */
export async function compile(source, folder, profile) {
  mkdirSync(folder, { recursive: true });
  const compiled = process.env.CARGO_TARGET_DIR ?? join(source, "target");
  await run("cargo", ["build", "--locked", "--profile", profile, "--target", TARGET, "--package", "giveway-web", "--bins"], source);
  await Promise.all(programs(source).map(async ({ name, optimise }) => {
    await run("giveway-bind", [join(compiled, TARGET, profile, `${name}.wasm`), folder, name], source);
    if (profile === "page") {
      const wasm = join(folder, `${name}_bg.wasm`);
      await run("wasm-opt", [...optimise, wasm, "--output", `${wasm}.part`], source);
      renameSync(`${wasm}.part`, wasm);
    }
  }));
}

function run(command, args, folder) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: folder, stdio: "inherit" });
    child.on("error", (error) => reject(new Error(`${command}: ${error.message}`)));
    child.on("exit", (code) => (code === 0 ? resolve() : reject(new Error(`${command} ended with ${code}`))));
  });
}
