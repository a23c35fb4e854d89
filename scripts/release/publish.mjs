// `node scripts/release/publish.mjs PART`: one step of a release, as the workflow takes it
// (.github/workflows/release.yml). A step whose secret is not set says so and does nothing;
// what has been published before is left alone, so that a release can be taken up again.

import { execFileSync, spawnSync } from "node:child_process";
import { appendFileSync, existsSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { notes, releaseFiles, releaseWheels, root, settings } from "./settings.mjs";
import { CRATES } from "./stamp.mjs";

const { version, address } = settings();
const PARTS = { tag, page, files, npm, crates, pypi };

const [part] = process.argv.slice(2);
if (!Object.hasOwn(PARTS, part ?? "")) {
  fail(`expected one of ${Object.keys(PARTS).join(", ")}`);
}
PARTS[part]();

function fail(message) {
  console.error(`publish: ${message}`);
  process.exit(1);
}

/** The tag, the version and the changelog say the same, or nothing is released. */
function tag() {
  const name = process.env.GITHUB_REF_NAME ?? "";
  if (name !== `v${version}`) {
    fail(`found the tag ${JSON.stringify(name)}, expected v${version}, the version in Cargo.toml`);
  }
  if (!notes(version)) {
    fail(`CHANGELOG.md says nothing of ${version}: ./x version ${version} gives "Unreleased" its name`);
  }
  console.log(`This is ${version}.`);
}

/** Tells the workflow where the page goes. */
function page() {
  if (!address) {
    console.log("The page is not deployed: no address is set (./x address).");
  }
  if (process.env.GITHUB_OUTPUT) {
    appendFileSync(process.env.GITHUB_OUTPUT, `address=${address}\n`);
  }
}

/** The crates, each after those that it needs. */
function crates() {
  if (!process.env.CARGO_REGISTRY_TOKEN) {
    console.log("The crates are not published: the secret CARGO_REGISTRY_TOKEN is not set.");
    return;
  }
  for (const name of CRATES) {
    // Cargo waits until the registry has it.
    const { status, stderr } = spawnSync("cargo", ["publish", "--locked", "--package", name], {
      cwd: root, encoding: "utf8", stdio: ["ignore", "inherit", "pipe"],
    });
    process.stderr.write(stderr);
    if (status !== 0 && !/already (exists|uploaded)/.test(stderr)) {
      fail(`cargo could not publish ${name}`);
    }
  }
}

/** The package for JavaScript, as `./x package` has built it. */
function npm() {
  if (!process.env.NPM_TOKEN) {
    console.log("The package is not published: the secret NPM_TOKEN is not set.");
    return;
  }
  const config = mkdtempSync(join(tmpdir(), "giveway-npm-"));
  const userconfig = join(config, "npmrc");
  try {
    const ask = (...args) => execFileSync("npm", args, { cwd: config, encoding: "utf8" }).trim();
    const registry = new URL(ask("config", "get", "registry"));
    // npm itself puts the secret in.
    writeFileSync(userconfig, `//${registry.host}${registry.pathname}:_authToken=\${NPM_TOKEN}\n`);
    const known = spawnSync("npm", ["view", `giveway@${version}`, "version"], { encoding: "utf8" });
    if (known.stdout.trim() === version) {
      console.log(`giveway ${version} is there already.`);
      return;
    }
    execFileSync("npm", ["publish", join(root, "target/package"), "--access", "public"], {
      stdio: ["ignore", "inherit", "inherit"], env: { ...process.env, NPM_CONFIG_USERCONFIG: userconfig },
    });
  } finally {
    rmSync(config, { recursive: true });
  }
}

/** The package for Python: wheels, and the sources for other systems. */
function pypi() {
  if (!process.env.PYPI_TOKEN) {
    console.log("The package for Python is not published: the secret PYPI_TOKEN is not set.");
    return;
  }
  const names = existsSync(releaseWheels) ? readdirSync(releaseWheels) : [];
  const paths = names.sort().map((name) => join(releaseWheels, name));
  if (paths.length === 0) {
    fail(`there is nothing in ${releaseWheels}`);
  }
  const folder = mkdtempSync(join(tmpdir(), "giveway-pypi-"));
  try {
    const run = (command, ...args) => execFileSync(command, args, {
      stdio: ["ignore", "inherit", "inherit"],
      // The environment alone has the secret; no command line shows it.
      env: { ...process.env, TWINE_USERNAME: "__token__", TWINE_PASSWORD: process.env.PYPI_TOKEN },
    });
    run("python3", "-m", "venv", folder);
    const python = join(folder, "bin/python");
    run(python, "-m", "pip", "install", "--quiet", "twine==6.2.0");
    run(python, "-m", "twine", "upload", "--non-interactive", "--skip-existing", ...paths);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The forge's release, with the binaries and their sums. */
function files() {
  const names = existsSync(releaseFiles) ? readdirSync(releaseFiles) : [];
  const paths = names.sort().map((name) => join(releaseFiles, name));
  if (paths.length === 0) {
    fail(`there is nothing in ${releaseFiles}`);
  }
  const gh = (...args) => execFileSync("gh", args, { cwd: root, stdio: ["ignore", "inherit", "inherit"] });
  const isThere = spawnSync("gh", ["release", "view", `v${version}`], { cwd: root }).status === 0;
  if (isThere) {
    gh("release", "upload", `v${version}`, "--clobber", ...paths);
    return;
  }
  const before = version.includes("-") ? ["--prerelease"] : [];
  gh("release", "create", `v${version}`, "--verify-tag", "--title", `Giveway ${version}`,
    "--notes", notes(version) ?? "", ...before, ...paths);
}
