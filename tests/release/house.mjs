// What the tests of releases share: the workspace as Cargo sees it, and texts kept in files.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of the clone. */
export const root = fileURLToPath(new URL("../..", import.meta.url));

/** A file of the clone. */
export const read = (path) => readFileSync(join(root, path), "utf8");

/** What a command prints, run in the clone or another folder. */
export function output(command, args, cwd = root) {
  return execFileSync(command, args, { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"], maxBuffer: 2 ** 28 });
}

/** What a command of Cargo prints; it fetches only where something is missing. */
export function cargo(args, cwd = root) {
  try {
    return output("cargo", [...args, "--offline"], cwd);
  } catch {
    return output("cargo", args, cwd);
  }
}

/** `cargo metadata` of a folder. */
export function metadata(options = [], cwd = root) {
  return JSON.parse(cargo(["metadata", "--format-version", "1", "--locked", ...options], cwd));
}

/** A package of package-lock.json, which `x` keeps outside of the clone. */
export const tool = (name) => createRequire(import.meta.url)(name);

/** Compares with a text that is kept in a file; UPDATE_EXPECT=1 writes it, as in the Rust tests. */
export function expectFile(path, text) {
  if (process.env.UPDATE_EXPECT === "1") {
    writeFileSync(join(root, path), text);
  }
  assert.equal(text, read(path), `${path} differs; if that is meant, set UPDATE_EXPECT=1`);
}
