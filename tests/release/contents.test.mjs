// The crates that are published: which they are, what they say of themselves, what they hold.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, test } from "node:test";

import { CRATES } from "../../scripts/release/stamp.mjs";
import { cargo, expectFile, metadata, output, read } from "./house.mjs";

const { packages } = metadata(["--no-deps"]);
// An empty list of registries is what `publish = false` becomes.
const published = packages.filter(({ publish }) => publish === null);

describe("the published crates", () => {
  test("are those of the scripts, each after those that it needs", () => {
    assert.deepEqual(published.map(({ name }) => name).sort(), [...CRATES].sort());
    assert.match(read("scripts/release.sh"), new RegExp(`^readonly published=\\(${CRATES.join(" ")}\\)$`, "m"));
    for (const { name, dependencies } of published) {
      for (const needed of dependencies.filter(({ path }) => path)) {
        assert.ok(CRATES.indexOf(needed.name) < CRATES.indexOf(name), `${name} needs ${needed.name}`);
        assert.ok(CRATES.includes(needed.name), `${name} needs ${needed.name}, which is not published`);
      }
    }
  });

  // Building what was packed takes minutes: ./x test --long does it.
  test("are packed, and ask for each other by version in what is packed", () => {
    const folder = mkdtempSync(join(tmpdir(), "giveway-packed-"));
    try {
      const chosen = CRATES.map((name) => `--package=${name}`);
      cargo(["package", "--locked", "--no-verify", "--allow-dirty", `--target-dir=${folder}`, ...chosen]);
      for (const { name, version, dependencies } of published) {
        const packed = join(folder, "package", `${name}-${version}`);
        output("tar", ["-xzf", `${packed}.crate`], join(folder, "package"));
        const manifest = readFileSync(join(packed, "Cargo.toml"), "utf8");
        for (const needed of dependencies.filter(({ path }) => path)) {
          assert.ok(manifest.includes(`[dependencies.${needed.name}]\nversion = "=${version}"`), `${name} and ${needed.name}`);
        }
        assert.doesNotMatch(manifest, /^path = "\.\./m, name);
        assert.ok(readFileSync(join(packed, "LICENSE-MIT"), "utf8").startsWith("Copyright"), `${name} has a link for a licence`);
      }
    } finally {
      rmSync(folder, { recursive: true });
    }
  });

  for (const crate of published) {
    test(`${crate.name} says what it is`, () => {
      assert.ok(crate.description.length > 40, crate.description);
      assert.equal(crate.license, "MIT OR Apache-2.0");
      assert.equal(crate.readme, "README.md");
      assert.ok(crate.keywords.length >= 3 && crate.keywords.length <= 5, "from 3 to 5 keywords");
      assert.ok(crate.keywords.every((word) => /^[a-z][a-z0-9_+-]{0,19}$/.test(word)), crate.keywords.join());
      assert.ok(crate.categories.length > 0, "no category");
    });

    // Sources are told as one line: all of them belong to it, and their number says nothing.
    test(`${crate.name} holds what is listed`, () => {
      const listed = output("cargo", ["package", "--list", "--allow-dirty", "--offline", "--package", crate.name]);
      const files = listed.trim().split("\n").filter((file) => file !== ".cargo_vcs_info.json");
      const isSource = (file) => /^src\/.*\.rs$/.test(file);
      const kept = [...files.filter((file) => !isSource(file)), "src/**/*.rs"].sort();
      assert.ok(files.includes("src/lib.rs") || files.includes("src/main.rs"), "no sources");
      for (const needed of ["LICENSE-APACHE", "LICENSE-MIT", "README.md"]) {
        assert.ok(kept.includes(needed), `${needed} is missing`);
      }
      expectFile(`tests/release/contents/${crate.name}.txt`, `${kept.join("\n")}\n`);
    });
  }
});
