// The workflows of the forge: they run nothing but what is in the repository, ask for few
// permissions, and name the exact version of each action.

import assert from "node:assert/strict";
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";

import { read, root, tool } from "./house.mjs";

const FOLDER = ".github/workflows";
const EXPECTED = ["long.yml", "release.yml", "test.yml"];
/** What jobs may ask for beyond reading, and why. */
const ALLOWED = {
  files: { contents: "write" }, // to make the release
  deploy: { pages: "write", "id-token": "write" }, // to put the page on the forge's host
};
/** Where secrets are seen: by the step that publishes, and by nothing else in its job. */
const SECRETS = ["CARGO_REGISTRY_TOKEN", "NPM_TOKEN", "PYPI_TOKEN"];

const { parse } = tool("yaml");
const commands = [...read("x").matchAll(/^ {4}([a-z |-]+)\)$/gm)].flatMap(([, names]) => names.split(" | "));
const parts = /^const PARTS = \{ (.*) \};$/m.exec(read("scripts/release/publish.mjs"))[1].split(", ");

const workflows = readdirSync(join(root, FOLDER)).sort().map((name) => {
  const text = read(`${FOLDER}/${name}`);
  return { ...parse(text), name, text };
});
const steps = workflows.flatMap(({ name, jobs }) => Object.entries(jobs).flatMap(([job, { steps: all }]) => (
  all.map((step) => ({ ...step, where: `${name}, ${job}` })))));

test("there are the workflows that docs/release.md tells of", () => {
  assert.deepEqual(workflows.map(({ name }) => name), EXPECTED);
  for (const { name } of workflows) {
    assert.match(read("docs/release.md"), new RegExp(`\`${name.replace(".", "\\.")}\``));
  }
});

describe("every step", () => {
  test("runs a command of ./x or a script of the repository, with nothing beside it", () => {
    assert.ok(commands.includes("test") && commands.includes("version"), commands.join());
    for (const { run, where } of steps.filter((step) => "run" in step)) {
      const [, command] = /^\.\/x ([a-z-]+)(?: --long)?$/.exec(run) ?? [];
      const [, script, argument] = /^node (scripts\/[a-z/-]+\.mjs) (\S+|\$\{\{ matrix\.target \}\})$/.exec(run) ?? [];
      assert.ok(command || script, `${where}: ${JSON.stringify(run)}`);
      assert.ok(!command || commands.includes(command), `${where}: ./x has no ${command}`);
      assert.ok(!script || existsSync(join(root, script)), `${where}: there is no ${script}`);
      assert.ok(!script?.endsWith("publish.mjs") || parts.includes(argument), `${where}: publish.mjs has no ${argument}`);
    }
  });

  test("names the commit of its action, and the version in words", () => {
    const uses = workflows.flatMap(({ text }) => text.split("\n").filter((line) => /\buses:/.test(line)));
    assert.equal(uses.length, steps.filter((step) => "uses" in step).length);
    const versions = new Map();
    for (const line of uses) {
      const [, action, commit, version] = /uses: (actions\/[a-z-]+)@([0-9a-f]{40}) # (v\d+\.\d+\.\d+)$/.exec(line) ?? [];
      assert.ok(action, line);
      assert.equal(versions.get(action) ?? `${commit} ${version}`, `${commit} ${version}`, "two versions of one action");
      versions.set(action, `${commit} ${version}`);
    }
  });

  test("sees a secret only where it publishes", () => {
    const seen = steps.flatMap(({ where, ...step }) => {
      const secrets = [...JSON.stringify(step).matchAll(/secrets\.([A-Z_]+)/g)].map(([, name]) => name);
      assert.ok(secrets.length === 0 || /^node scripts\/release\/publish\.mjs /.test(step.run), where);
      return secrets;
    });
    assert.deepEqual(seen.sort(), SECRETS);
    const all = workflows.flatMap(({ text }) => text.match(/secrets\./g) ?? []);
    assert.equal(all.length, SECRETS.length, "a secret beside the steps");
    for (const secret of SECRETS) {
      assert.match(read("scripts/release/publish.mjs"), new RegExp(`process\\.env\\.${secret}\\b`));
      assert.match(read("docs/release.md"), new RegExp(`\`${secret}\``));
    }
  });
});

test("no job may do more than it must", () => {
  for (const { name, permissions, jobs } of workflows) {
    assert.deepEqual(permissions, { contents: "read" }, name);
    for (const [job, { permissions: own, "timeout-minutes": minutes }] of Object.entries(jobs)) {
      assert.deepEqual(own, name === "release.yml" ? ALLOWED[job] : undefined, `${name}, ${job}`);
      assert.ok(minutes > 0, `${name}, ${job} may run for ever`);
    }
  }
});

test("every job waits for jobs that there are", () => {
  for (const { name, jobs } of workflows) {
    for (const [job, { needs = [] }] of Object.entries(jobs)) {
      for (const needed of [needs].flat()) {
        assert.ok(Object.hasOwn(jobs, needed), `${name}, ${job} needs ${needed}`);
      }
    }
  }
});

test("what is published waits for the tests", () => {
  const { jobs } = workflows.find(({ name }) => name === "release.yml");
  const waitsFor = (job) => [jobs[job].needs ?? []].flat().flatMap((needed) => [needed, ...waitsFor(needed)]);
  for (const job of Object.keys(jobs)) {
    assert.ok(job === "test" || waitsFor(job).includes("test"), job);
  }
  for (const job of ["npm", "crates", "pypi"]) {
    assert.ok(waitsFor(job).includes("files"), `${job} cannot be taken back: it comes last`);
  }
});

test("wheels are built for each system that the command is built for, and the sources are tried", () => {
  const { jobs } = workflows.find(({ name }) => name === "release.yml");
  const targets = (job) => jobs[job].strategy.matrix.include.map(({ target }) => target);
  // For Linux a wheel goes with the C library of each distribution, the command with none.
  const linked = targets("binaries").map((target) => target.replace("-musl", "-gnu"));
  assert.deepEqual(linked.filter((target) => !targets("wheels").includes(target)), []);
  assert.ok(targets("wheels").includes("sdist") && targets("wheels").includes("aarch64-unknown-linux-gnu"));
  assert.ok(jobs.files.needs.includes("wheels"), "nothing is released where a wheel cannot be built");
});
