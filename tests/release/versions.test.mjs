// The version and the address of the published page stand in one place each; what must repeat
// them is written from there, and equals it.

import assert from "node:assert/strict";
import { cpSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, relative } from "node:path";
import { after, beforeEach, describe, test } from "node:test";

import { PICTURE, withAddress } from "../../scripts/release/head.mjs";
import { notes, settings } from "../../scripts/release/settings.mjs";
import { CRATES, setAddress, setVersion } from "../../scripts/release/stamp.mjs";
import { metadata, read, root, tool } from "./house.mjs";

const DAY = "2031-02-03";
const { version, address } = settings();

const { packages } = metadata(["--no-deps"]);

describe("the version of the workspace", () => {
  test("is that of every package", () => {
    assert.deepEqual([...new Set(packages.map((one) => one.version))], [version]);
  });

  test("is what published crates ask of each other", () => {
    const asked = packages.filter(({ publish }) => publish === null)
      .flatMap(({ name, dependencies }) => dependencies.filter(({ path }) => path).map((needed) => ({ name, ...needed })));
    assert.ok(asked.length >= 6, "no crate needs another");
    for (const { name, req } of asked) {
      assert.equal(req, `=${version}`, name);
    }
  });

  test("is that of the citation, and of the changelog where it is not of what comes next", () => {
    assert.equal(tool("yaml").parse(read("CITATION.cff")).version, version);
    const top = /^## (.*)$/m.exec(read("CHANGELOG.md"))[1];
    assert.ok(top === "Unreleased" || top.startsWith(`${version} - `), `CHANGELOG.md begins with ${top}`);
  });
});

describe("the address of the published page", () => {
  test("stands wherever it must be written out, or nowhere", () => {
    for (const crate of packages.filter(({ publish }) => publish === null)) {
      assert.equal(crate.homepage ?? "", address, crate.name);
    }
    assert.equal(tool("yaml").parse(read("CITATION.cff")).url ?? "", address);
    const link = /^\*\*\[Open the playground\]\((.*)\)\*\*$/m.exec(read("README.md"));
    assert.equal(link?.[1] ?? "", address);
  });

  test("is in the head of the page, which says nothing without it", () => {
    const page = read("index.html");
    assert.equal(withAddress(page, ""), page);
    const told = withAddress(page, "https://example.org/giveway/");
    assert.match(told, /<link rel="canonical" href="https:\/\/example\.org\/giveway\/">/);
    assert.match(told, /<meta property="og:title" content="Giveway: [^"]+">/);
    assert.match(told, new RegExp(`<meta property="og:image" content="https://example\\.org/giveway/${PICTURE}">`));
    assert.ok(readFileSync(join(root, "docs", PICTURE)).length > 0);
  });
});

describe("x version and x address", () => {
  const copy = mkdtempSync(join(tmpdir(), "giveway-stamp-"));
  const FILES = ["Cargo.toml", "Cargo.lock", "CITATION.cff", "CHANGELOG.md", "README.md", ...CRATES.map((crate) => `crates/${crate}/Cargo.toml`)];
  const content = (path) => readFileSync(join(copy, path), "utf8");
  const quietly = (step) => {
    const { log } = console;
    console.log = () => {};
    try {
      step();
    } finally {
      console.log = log;
    }
  };

  // Every manifest, with the sources that Cargo looks for as links.
  beforeEach(() => {
    rmSync(copy, { recursive: true, force: true });
    const manifests = packages.map((one) => relative(root, one.manifest_path));
    for (const path of new Set([...FILES, ...manifests])) {
      cpSync(join(root, path), join(copy, path));
      if (dirname(path) !== ".") {
        symlinkSync(join(root, dirname(path), "src"), join(copy, dirname(path), "src"));
      }
    }
  });
  after(() => rmSync(copy, { recursive: true, force: true }));

  test("set the version everywhere, so that Cargo takes the lock file as it is", () => {
    quietly(() => setVersion("9.8.7-rc.1", DAY, copy));
    assert.equal(settings(copy).version, "9.8.7-rc.1");
    const stamped = metadata(["--no-deps"], copy).packages;
    assert.deepEqual([...new Set(stamped.map((one) => one.version))], ["9.8.7-rc.1"]);
    metadata([], copy);
    assert.equal(tool("yaml").parse(content("CITATION.cff")).version, "9.8.7-rc.1");
    assert.match(content("CITATION.cff"), new RegExp(`^date-released: ${DAY}$`, "m"));
    const left = FILES.flatMap((path) => content(path).split("\n").filter((line) => (
      line.includes("giveway") && line.includes(`"=${version}"`))));
    assert.deepEqual(left, []);
    quietly(() => setVersion("9.8.8", DAY, copy));
    assert.equal(content("CITATION.cff").match(/^date-released/gm).length, 1);
  });

  test("give what is unreleased its name", () => {
    if (!/^## Unreleased$/m.test(content("CHANGELOG.md"))) {
      return;
    }
    assert.equal(notes("9.8.7", copy), undefined);
    quietly(() => setVersion("9.8.7", DAY, copy));
    assert.match(content("CHANGELOG.md"), new RegExp(`^## 9\\.8\\.7 - ${DAY}$`, "m"));
    assert.ok(notes("9.8.7", copy).startsWith("### "));
    assert.equal(notes("9.8", copy), undefined);
  });

  test("set the address everywhere, and take it out without a trace", () => {
    quietly(() => setAddress("", copy));
    const without = FILES.map(content);
    quietly(() => setAddress("https://example.org/giveway", copy));
    assert.equal(settings(copy).address, "https://example.org/giveway/");
    for (const crate of metadata(["--no-deps"], copy).packages.filter(({ publish }) => publish === null)) {
      assert.equal(crate.homepage, "https://example.org/giveway/", crate.name);
    }
    assert.equal(tool("yaml").parse(content("CITATION.cff")).url, "https://example.org/giveway/");
    assert.match(content("README.md"), /^\*\*\[Open the playground\]\(https:\/\/example\.org\/giveway\/\)\*\*$/m);
    const once = FILES.map(content);
    quietly(() => setAddress("https://example.org/giveway/", copy));
    assert.deepEqual(FILES.map(content), once);
    quietly(() => setAddress("", copy));
    assert.deepEqual(FILES.map(content), without);
  });

  test("refuse what is no version and no address", () => {
    for (const wrong of ["", "1.2", "v1.2.3", "1.2.3\n"]) {
      assert.throws(() => setVersion(wrong, DAY, copy), /expected a version/, wrong);
    }
    for (const wrong of ["giveway", "http://example.org/", "https://example.org/#a", "https://example.org/\"x", "https://example.org/$&"]) {
      assert.throws(() => setAddress(wrong, copy), /expected an address/, wrong);
    }
  });
});
