// The two things about a release that are set by hand, both in the workspace's Cargo.toml:
// the version, and the address where the page is published, empty until somebody does.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of the clone. */
export const root = fileURLToPath(new URL("../..", import.meta.url));

/** Where Cargo builds to. */
export const built = process.env.CARGO_TARGET_DIR ?? join(root, "target");

/** The files of a release, with their sums. */
export const releaseFiles = join(built, "release-files");

/** The package for Python, as wheels and as sources. */
export const releaseWheels = join(built, "release-wheels");

/** `{ version, address }` of the workspace in a folder. */
export function settings(folder = root) {
  const manifest = readFileSync(join(folder, "Cargo.toml"), "utf8");
  const value = (table, key) => {
    const start = manifest.indexOf(`\n[${table}]\n`);
    const text = start < 0 ? "" : manifest.slice(start + 1).split(/\n(?=\[)/)[0];
    const found = new RegExp(`^${key} = "(.*)"$`, "m").exec(text);
    if (!found) {
      throw new Error(`Cargo.toml has no ${key} in [${table}]`);
    }
    return found[1];
  };
  return {
    version: value("workspace.package", "version"),
    address: value("workspace.metadata.giveway", "address"),
  };
}

/** What the changelog says of a version, without its heading; nothing where it is not in it. */
export function notes(version, folder = root) {
  const sections = readFileSync(join(folder, "CHANGELOG.md"), "utf8").split(/^## /m).slice(1);
  const section = sections.find((text) => text.startsWith(`${version} `) || text.startsWith(`${version}\n`));
  return section?.slice(section.indexOf("\n")).trim();
}
