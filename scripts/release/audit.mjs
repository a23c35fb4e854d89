// Whether all that is depended on may be, and has no known fault: cargo-deny for the crates,
// `npm audit` for the packages of the tools.
//
// Licences and sources need nothing from outside. Advisories come over the network: where they
// cannot be had, that is said, and is a failure only under GIVEWAY_NEED_ADVISORIES=1.

import { spawnSync } from "node:child_process";
import { pathToFileURL } from "node:url";

import { root } from "./settings.mjs";

/**
 * What `npm audit --json` says: that there are `faults`, that there are none, or why the
 * registry has not answered.
 */
export function verdict(output) {
  let report;
  try {
    report = JSON.parse(output);
  } catch {
    return { missing: "npm gave no report" };
  }
  const counts = report.metadata?.vulnerabilities;
  if (typeof counts?.total !== "number") {
    return { missing: String(report.message ?? report.error?.summary ?? "npm gave no report").trim() };
  }
  return { faults: counts.total };
}

/** The last line that says something. */
export function reason(text) {
  const lines = text.split("\n").map((line) => line.trim()).filter((line) => line !== "");
  return lines.at(-1) ?? "no reason was given";
}

function run(command, ...args) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd: root, encoding: "utf8" });
  return { isFine: status === 0, stdout: stdout ?? "", stderr: stderr ?? "" };
}

function main() {
  let isFine = true;
  const missed = (what, why) => {
    console.log(`${what}: skipped, since they could not be fetched (${why}).`);
    isFine &&= process.env.GIVEWAY_NEED_ADVISORIES !== "1";
  };
  const told = (what, { isFine: passed, stdout, stderr }) => {
    console.log(passed ? `${what}: nothing found.` : `${stdout}${stderr}`);
    isFine &&= passed;
  };

  told("Licences and sources of the crates", run("cargo", "deny", "--locked", "check", "licenses", "bans", "sources"));
  const fetched = run("cargo", "deny", "--locked", "fetch", "db");
  if (fetched.isFine) {
    told("Advisories about the crates", run("cargo", "deny", "--locked", "check", "advisories"));
  } else {
    missed("Advisories about the crates", reason(fetched.stderr));
  }
  const npm = run("npm", "audit", "--package-lock-only", "--json");
  const { missing, faults } = verdict(npm.stdout);
  if (missing === undefined) {
    told("Advisories about the packages of the tools", { ...npm, isFine: faults === 0 });
  } else {
    missed("Advisories about the packages of the tools", missing);
  }
  process.exitCode = isFine ? 0 : 1;
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  main();
}
