// The crates that are published: which they are, what they say of themselves, what they hold.

import assert from "node:assert/strict";
import { describe, test } from "node:test";

import { CRATES } from "../../scripts/release/stamp.mjs";
import { expectFile, metadata, output, read } from "./house.mjs";

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
