// `./x version 1.2.3` and `./x address https://…/`: writes the version, or the address where
// the page is published, to every place where a tool needs it written out.
//
// The places that can read the workspace's Cargo.toml do so (scripts/release/settings.mjs).

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { root, settings } from "./settings.mjs";

/** The crates that are published, in dependency order. */
export const CRATES = ["giveway-model", "giveway-formats", "giveway-picture", "giveway-proof", "giveway-planners", "giveway-order", "giveway-solve", "giveway-sweep", "giveway-course", "giveway-cli"];

const VERSION = /^\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?$/;

/** Sets the version. `day` is that of the release, `2026-01-31`, for the changelog. */
export function setVersion(version, day, folder = root) {
  if (!VERSION.test(version)) {
    throw new Error(`found ${JSON.stringify(version)}, expected a version such as 1.2.3`);
  }
  edit(folder, "Cargo.toml", [
    [/(\n\[workspace\.package\]\nversion = )".*"/, `$1"${version}"`],
    // Crates of one release belong together: each asks for exactly this version.
    [/^(giveway-[a-z]+ = \{.* version = )"=.*?"/gm, `$1"=${version}"`],
  ]);
  // Packages of the workspace are those without a source; theirs is the workspace's version.
  edit(folder, "Cargo.lock", [[/^(name = "giveway-[a-z]+"\nversion = )".*"/gm, `$1"${version}"`]]);
  edit(folder, "CITATION.cff", [
    [/^version: .*$/m, `version: ${version}`],
    [/^date-released: .*\n/m, ""],
    [/^version: .*\n/m, `$&date-released: ${day}\n`],
  ]);
  edit(folder, "CHANGELOG.md", [[/^## Unreleased$/m, `## ${version} - ${day}`]], { optional: true });
}

/** Sets the address of the published page; an empty one takes it out everywhere. */
export function setAddress(given, folder = root) {
  const address = given === "" ? "" : normal(given);
  edit(folder, "Cargo.toml", [
    [/(\n\[workspace\.metadata\.giveway\]\n(?:#.*\n)*address = )".*"/, `$1"${address}"`],
    [/^homepage = ".*"\n/m, ""],
    [/^license = ".*"\n/m, address ? `$&homepage = "${address}"\n` : "$&"],
  ]);
  for (const crate of CRATES) {
    edit(folder, `crates/${crate}/Cargo.toml`, [
      [/^homepage\.workspace = true\n/m, ""],
      [/^license\.workspace = true\n/m, address ? "$&homepage.workspace = true\n" : "$&"],
    ]);
  }
  edit(folder, "CITATION.cff", [
    [/^url: .*\n/m, ""],
    [/^version: .*\n/m, address ? `url: "${address}"\n$&` : "$&"],
  ]);
  edit(folder, "README.md", [
    [/^\*\*\[Open the playground\]\(.*\)\*\*\n\n/m, ""],
    [/^!\[The playground: /m, address ? `**[Open the playground](${address})**\n\n$&` : "$&"],
  ]);
}

/** With a slash at its end, since the page is a folder of files. */
function normal(given) {
  let url;
  try {
    url = new URL(given);
  } catch {
    url = undefined;
  }
  if (url?.protocol !== "https:" || url.search || url.hash || url.username || /["'<>()\\$]/.test(given)) {
    throw new Error(`found ${JSON.stringify(given)}, expected an address such as https://example.org/giveway/`);
  }
  return url.href.endsWith("/") ? url.href : `${url.href}/`;
}

function edit(folder, path, pairs, { optional = false } = {}) {
  const file = join(folder, path);
  if (!existsSync(file)) {
    throw new Error(`${path} is not there`);
  }
  const before = readFileSync(file, "utf8");
  let text = before;
  for (const [pattern, replacement] of pairs) {
    // What is taken out where it is there is the only thing that may be missing.
    if (!optional && replacement !== "" && !pattern.test(text)) {
      throw new Error(`${path} has nothing like ${pattern}`);
    }
    pattern.lastIndex = 0;
    text = text.replace(pattern, replacement);
  }
  if (text !== before) {
    writeFileSync(file, text);
    console.log(`${path}: written`);
  }
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [what, value] = process.argv.slice(2);
  try {
    if (what === "version" && value !== undefined) {
      setVersion(value, new Date().toISOString().slice(0, 10));
    } else if (what === "address" && value !== undefined) {
      setAddress(value);
    } else if (what === "version" || what === "address") {
      console.log(settings()[what]);
    } else {
      throw new Error("expected: version [VERSION], or address [ADDRESS]");
    }
  } catch (error) {
    console.error(`stamp: ${error.message}`);
    process.exit(1);
  }
}
