// The licences of all that is depended on are among those that deny.toml allows.

import assert from "node:assert/strict";
import { describe, test } from "node:test";

import { metadata, read } from "./house.mjs";

/** Of what only tools are made of; nothing of it is in the page, the package or the command. */
const TOOLS = ["ISC", "MPL-2.0"];

const list = /^allow = \[([^\]]*)\]/m.exec(read("deny.toml"))[1];
const allowed = [...list.matchAll(/"([^"]+)"/g)].map(([, name]) => name);

/** Whether an SPDX expression can be met with some licences alone; `/` is an older "OR". */
function isMet(expression, licences) {
  const tokens = expression.replaceAll("/", " OR ").replaceAll(/([()])/g, " $1 ").trim().split(/\s+/);
  const result = either();
  assert.equal(tokens.length, 0, `${expression} is not understood`);
  return result;

  function either() {
    let isFine = both();
    while (tokens[0] === "OR") {
      tokens.shift();
      isFine = both() || isFine;
    }
    return isFine;
  }
  function both() {
    let isFine = one();
    while (tokens[0] === "AND") {
      tokens.shift();
      isFine = one() && isFine;
    }
    return isFine;
  }
  function one() {
    if (tokens[0] === "(") {
      tokens.shift();
      const inner = either();
      assert.equal(tokens.shift(), ")", expression);
      return inner;
    }
    let name = tokens.shift();
    if (tokens[0] === "WITH") {
      name += ` ${tokens.shift()} ${tokens.shift()}`;
    }
    return licences.includes(name);
  }
}

describe("licences", () => {
  test("an expression is met by what it allows", () => {
    const mit = ["MIT"];
    for (const [expression, expected] of [
      ["MIT", true], ["GPL-3.0", false], ["GPL-3.0 OR MIT", true], ["GPL-3.0/MIT", true], ["MIT AND GPL-3.0", false],
      ["(MIT OR GPL-3.0) AND Zlib", false], ["Zlib AND GPL-3.0 OR MIT", true], ["GPL-2.0 WITH some-exception", false],
    ]) {
      assert.equal(isMet(expression, mit), expected, expression);
    }
    assert.throws(() => isMet("MIT GPL-3.0", mit));
  });

  test("every crate's is allowed", () => {
    const { packages } = metadata();
    assert.ok(packages.length > 100, "the dependencies were not found");
    const wrong = packages.filter(({ license }) => !license || !isMet(license, allowed));
    assert.deepEqual(wrong.map(({ name, license }) => `${name}: ${license}`), []);
  });

  test("every package's of the tools is allowed", () => {
    const packages = Object.entries(JSON.parse(read("package-lock.json")).packages);
    assert.ok(packages.length > 4);
    const wrong = packages.filter(([, { license }]) => !license || !isMet(license, [...allowed, ...TOOLS]));
    assert.deepEqual(wrong.map(([name, { license }]) => `${name}: ${license}`), []);
  });
});
