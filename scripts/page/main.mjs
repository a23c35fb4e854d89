// `./x build`: builds the playground into dist/, for any static host.

import { cpSync, mkdirSync, renameSync, rmSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { assemble } from "./assemble.mjs";
import { compile } from "./compile.mjs";
import { finish } from "./finish.mjs";

const source = fileURLToPath(new URL("../..", import.meta.url));
const dist = process.env.GIVEWAY_DIST ?? join(source, "dist");
const staging = join(process.env.CARGO_TARGET_DIR ?? join(source, "target"), "page-for-a-host");

rmSync(staging, { recursive: true, force: true });
mkdirSync(staging, { recursive: true });
try {
  await compile(source, staging, "page");
  assemble(source, staging);
  finish(source, staging);
} catch (error) {
  console.error(`build: ${error.message}`);
  process.exit(1);
}
// What was built before stays until the new page is whole.
cpSync(staging, `${dist}.part`, { recursive: true });
rmSync(dist, { recursive: true, force: true });
renameSync(`${dist}.part`, dist);
rmSync(staging, { recursive: true });
