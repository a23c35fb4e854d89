// The built page: `./x build` writes it.

import { readFileSync, readdirSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of the clone. */
export const root = fileURLToPath(new URL("../..", import.meta.url));

/** The built folder; another one can be named to test what is on a host. */
export const dist = process.env.GIVEWAY_DIST ?? join(root, "dist");

/** Every file of the built page, as paths inside of it. */
export function files(folder = dist) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)))
    .sort();
}

/** A built file's bytes. */
export function bytes(path, folder = dist) {
  return readFileSync(join(folder, path));
}
