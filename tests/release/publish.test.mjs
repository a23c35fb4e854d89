// The steps of a release, with commands in the place of Cargo, npm and the forge's own that
// write down what they are asked for: nothing is built and nothing is published.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, beforeEach, describe, test } from "node:test";

import { reason, verdict } from "../../scripts/release/audit.mjs";
import { settings } from "../../scripts/release/settings.mjs";
import { CRATES } from "../../scripts/release/stamp.mjs";
import { output, root } from "./house.mjs";

const { version, address } = settings();
const folder = mkdtempSync(join(tmpdir(), "giveway-release-"));
const bin = join(folder, "bin");
const log = join(folder, "asked");
const target = join(folder, "target");

beforeEach(() => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(bin, { recursive: true });
  writeFileSync(log, "");
});
after(() => rmSync(folder, { recursive: true, force: true }));

/** Puts a command on the PATH that writes down its arguments, then does what is given. */
function stand(name, then = "") {
  writeFileSync(join(bin, name), `#!/bin/sh\necho "${name} $*" >> "${log}"\n${then}\n`, { mode: 0o755 });
}

const asked = () => readFileSync(log, "utf8").trim().split("\n").filter((line) => line !== "");

function run(script, args, env = {}) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [join(root, "scripts/release", script), ...args], {
    encoding: "utf8", env: { PATH: `${bin}:${process.env.PATH}`, CARGO_TARGET_DIR: target, ...env },
  });
  return { isFine: status === 0, told: stdout + stderr };
}
const publish = (part, env) => run("publish.mjs", [part], env);

test("a tag that is not that of the version is refused", () => {
  for (const [tag, env] of [["v0.0.0", { GITHUB_REF_NAME: "v0.0.0" }], ["", {}]]) {
    const { isFine, told } = publish("tag", env);
    assert.ok(!isFine && told.includes(`found the tag "${tag}", expected v${version}`), told);
  }
  assert.ok(!publish("all").isFine);
});

test("what has no secret or address says so and is not published", () => {
  ["cargo", "npm", "python3"].forEach((name) => stand(name));
  assert.match(publish("crates").told, /^The crates are not published: the secret CARGO_REGISTRY_TOKEN is not set\.$/m);
  assert.match(publish("npm").told, /^The package is not published: the secret NPM_TOKEN is not set\.$/m);
  assert.match(publish("pypi").told, /^The package for Python is not published: the secret PYPI_TOKEN is not set\.$/m);
  const outputs = join(folder, "outputs");
  const { told } = publish("page", { GITHUB_OUTPUT: outputs });
  assert.match(told, address ? /^$/ : /^The page is not deployed: no address is set/);
  assert.equal(readFileSync(outputs, "utf8"), `address=${address}\n`);
  assert.deepEqual(asked(), []);
});

describe("the crates", () => {
  const token = { CARGO_REGISTRY_TOKEN: "secret" };

  test("are published each after those that it needs", () => {
    stand("cargo");
    assert.ok(publish("crates", token).isFine);
    assert.deepEqual(asked(), CRATES.map((name) => `cargo publish --locked --package ${name}`));
  });

  test("are left alone where they are there already, and a fault ends it", () => {
    stand("cargo", 'echo "error: crate is already uploaded" >&2; exit 101');
    assert.ok(publish("crates", token).isFine);
    assert.equal(asked().length, CRATES.length);
    writeFileSync(log, "");
    stand("cargo", 'echo "error: no network" >&2; exit 101');
    const { isFine, told } = publish("crates", token);
    assert.ok(!isFine && told.includes(`could not publish ${CRATES[0]}`), told);
    assert.equal(asked().length, 1);
  });
});

test("the package is published once, with a secret that no command line shows", () => {
  const npm = (known) => stand("npm", `case $1 in
    config) echo https://registry.example.org/npm/ ;;
    view) echo "${known}" ;;
    publish) cat "$NPM_CONFIG_USERCONFIG" >> "${log}" ;;
  esac`);
  npm("");
  const { isFine, told } = publish("npm", { NPM_TOKEN: "a-secret" });
  assert.ok(isFine, told);
  assert.match(asked().at(-2), /^npm publish \S*target\S*package --access public$/);
  assert.equal(asked().at(-1), "//registry.example.org/npm/:_authToken=${NPM_TOKEN}");
  assert.doesNotMatch(asked().join() + told, /a-secret/);
  writeFileSync(log, "");
  npm(version);
  assert.match(publish("npm", { NPM_TOKEN: "a-secret" }).told, /is there already/);
  assert.ok(!asked().some((line) => line.startsWith("npm publish")));
});

test("a binary is packed with its licences, and its sum is right", () => {
  stand("rustup");
  stand("cargo", `mkdir -p "${target}/some-linux-target/release"; echo command > "${target}/some-linux-target/release/giveway"`);
  const { isFine, told } = run("binary.mjs", ["some-linux-target"]);
  assert.ok(isFine, told);
  const name = `giveway-${version}-some-linux-target`;
  const files = join(target, "release-files");
  assert.deepEqual(readdirSync(files).sort(), [`${name}.tar.gz`, `${name}.tar.gz.sha256`]);
  const held = output("tar", ["-tzf", join(files, `${name}.tar.gz`)]).trim().split("\n").sort();
  assert.deepEqual(held, ["", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT", "README.md", "giveway"].map((file) => `${name}/${file}`));
  const sum = createHash("sha256").update(readFileSync(join(files, `${name}.tar.gz`))).digest("hex");
  assert.equal(readFileSync(join(files, `${name}.tar.gz.sha256`), "utf8"), `${sum}  ${name}.tar.gz\n`);
  assert.deepEqual(asked(), [
    "rustup target add some-linux-target",
    "cargo build --locked --release --package giveway-cli --target some-linux-target",
  ]);
  assert.ok(!run("binary.mjs", []).isFine);
});

/** A Python that makes environments of itself, whose maturin and pip only write down what they are asked. */
function standPython(made) {
  stand("rustup");
  stand("rustc", "echo 'host: x86_64-unknown-linux-gnu'");
  stand("python3", `case "$2" in
    venv) mkdir -p "$3/bin"; cp "$0" "$3/bin/python" ;;
    maturin) for last; do [ "$before" = --out ] && mkdir -p "$last" && touch ${made.map((name) => `"$last/${name}"`).join(" ")}; before=$last; done ;;
    twine) echo "$TWINE_USERNAME" >> "${log}" ;;
  esac; exit 0`);
}

test("a wheel is one for all versions of Python, and is tried where it can run", () => {
  const wheel = `giveway-${version}-cp310-abi3-manylinux2014_x86_64.whl`;
  standPython([wheel]);
  const { isFine, told } = run("wheel.mjs", ["x86_64-unknown-linux-gnu"]);
  assert.ok(isFine, told);
  assert.deepEqual(readdirSync(join(target, "release-wheels")), [wheel]);
  const all = asked().join("\n");
  assert.match(all, /maturin build --release --locked --target x86_64-unknown-linux-gnu --out \S+ --zig --compatibility manylinux2014/);
  assert.match(all, /pip install .*\.whl\npython3 -c import giveway/, "it is installed into a new environment");
  writeFileSync(log, "");
  assert.ok(run("wheel.mjs", ["aarch64-apple-darwin"]).isFine);
  assert.doesNotMatch(asked().join("\n"), /import giveway|zig/, "it cannot run here");
  standPython([`giveway-${version}-cp313-cp313-manylinux2014_x86_64.whl`]);
  assert.match(run("wheel.mjs", ["x86_64-unknown-linux-gnu"]).told, /maturin made giveway-\S*cp313/);
  standPython([`giveway-${version}.tar.gz`]);
  assert.ok(run("wheel.mjs", ["sdist"]).isFine);
  assert.match(asked().join("\n"), /maturin sdist --out \S+\n[^]*pip install .*\.tar\.gz\npython3 -c import giveway/);
  assert.ok(!run("wheel.mjs", []).isFine);
});

test("the package for Python is published with a secret that no command line shows", () => {
  standPython([]);
  const env = { PYPI_TOKEN: "a-secret" };
  assert.match(publish("pypi", env).told, /there is nothing in/);
  mkdirSync(join(target, "release-wheels"), { recursive: true });
  const wheel = join(target, "release-wheels/a.whl");
  writeFileSync(wheel, "");
  const { isFine, told } = publish("pypi", env);
  assert.ok(isFine, told);
  assert.equal(asked().at(-2), `python3 -m twine upload --non-interactive --skip-existing ${wheel}`);
  assert.equal(asked().at(-1), "__token__");
  assert.doesNotMatch(asked().join() + told, /a-secret/);
});

test("the files go to a new release, or to the one that is there", () => {
  stand("gh", 'case $2 in view) exit "${GONE:-0}" ;; esac');
  assert.match(publish("files").told, /there is nothing in/);
  mkdirSync(join(target, "release-files"), { recursive: true });
  const file = join(target, "release-files/a.tar.gz");
  writeFileSync(file, "");
  assert.ok(publish("files").isFine);
  assert.equal(asked().at(-1), `gh release upload v${version} --clobber ${file}`);
  assert.ok(publish("files", { GONE: "1" }).isFine);
  const made = asked().join("\n");
  assert.ok(made.includes(`gh release create v${version} --verify-tag --title Giveway ${version} --notes `), made);
  assert.ok(made.endsWith(file), made);
  assert.ok(existsSync(file));
});

test("an audit tells faults from a registry that does not answer", () => {
  assert.deepEqual(verdict('{"metadata":{"vulnerabilities":{"total":0}}}'), { faults: 0 });
  assert.deepEqual(verdict('{"metadata":{"vulnerabilities":{"total":3}}}'), { faults: 3 });
  assert.deepEqual(verdict('{"message":"405 Method Not Allowed"}'), { missing: "405 Method Not Allowed" });
  assert.deepEqual(verdict(""), { missing: "npm gave no report" });
  assert.equal(reason("error: a\n\nCaused by: b\n"), "Caused by: b");
});
