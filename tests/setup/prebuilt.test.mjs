// A tool that was built before is taken only as it is pinned; whatever else happens, it
// is built from source, and nothing is left behind.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

const SCRIPT = "scripts/prebuilt.mjs";
const MACHINE = `${process.platform}-${process.arch}`;

let work;
let archive;
let host;
let base;

before(async () => {
  work = mkdtempSync(join(tmpdir(), "giveway-tools-"));
  mkdirSync(join(work, "made/bin"), { recursive: true });
  writeFileSync(join(work, "made/bin/hammer"), "#!/bin/sh\necho hammer 1.2.3\n");
  chmodSync(join(work, "made/bin/hammer"), 0o755);
  execFileSync("tar", ["-czf", join(work, "hammer.tar.gz"), "-C", join(work, "made"), "bin"]);
  archive = readFileSync(join(work, "hammer.tar.gz"));
  host = createServer((request, response) => {
    if (request.url === "/tools/hammer.tar.gz") {
      response.end(archive);
    } else if (request.url === "/tools/cut.tar.gz") {
      response.writeHead(200, { "Content-Length": archive.length });
      response.write(archive.subarray(0, 20));
      response.destroy();
    } else if (request.url !== "/tools/silent.tar.gz") {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => host.listen(0, "127.0.0.1", resolve));
  base = `http://127.0.0.1:${host.address().port}/tools`;
});

after(() => {
  host.closeAllConnections();
  host.close();
  rmSync(work, { recursive: true });
});

const right = () => createHash("sha256").update(archive).digest("hex");

/** Asks for hammer 1.2.3 where the list has these rows. */
async function ask(rows, environment = {}) {
  const folder = join(mkdtempSync(join(work, "cache-")), "hammer-1.2.3");
  const list = join(work, "list.txt");
  writeFileSync(list, `# a remark\n${rows.join("\n")}\n`);
  const env = { ...process.env, GIVEWAY_TOOLS_LIST: list, GIVEWAY_TOOLS_URL: base, GIVEWAY_TOOLS_SILENCE: "2000", ...environment };
  const child = spawn(process.execPath, [SCRIPT, "hammer", "1.2.3", folder], { env, stdio: ["ignore", "ignore", "pipe"] });
  let told = "";
  child.stderr.on("data", (text) => { told += text; });
  const status = await new Promise((resolve) => child.on("close", resolve));
  return { status, told, folder, left: readdirSync(join(folder, "..")) };
}

const row = (sha256, file, machine = MACHINE, version = "1.2.3") => `hammer ${version} ${machine} ${sha256} ${file}`;

test("what is pinned is fetched and runs", async () => {
  const { status, told, folder, left } = await ask([row(right(), "hammer.tar.gz")]);
  assert.equal(status, 0, told);
  assert.deepEqual(left, ["hammer-1.2.3"]);
  assert.equal(execFileSync(join(folder, "bin/hammer")).toString(), "hammer 1.2.3\n");
});

for (const [what, rows, pattern, environment] of [
  ["another content", () => [row("0".repeat(64), "hammer.tar.gz")], /expected 0{64}/],
  ["a file that is not there", () => [row(right(), "gone.tar.gz")], /404/],
  ["an answer that is cut off", () => [row(right(), "cut.tar.gz")], /./],
  ["a host that says nothing", () => [row(right(), "silent.tar.gz")], /said nothing/],
  ["no host at all", () => [row(right(), "hammer.tar.gz")], /./, { GIVEWAY_TOOLS_URL: "http://127.0.0.1:1/" }],
  ["another machine", () => [row(right(), "hammer.tar.gz", "none-none")], /no hammer 1\.2\.3 for .* is published/],
  ["another version", () => [row(right(), "hammer.tar.gz", MACHINE, "1.2.4")], /no hammer 1\.2\.3 for .* is published/],
  ["no address", () => [row(right(), "hammer.tar.gz")], /no address of published tools/, { GIVEWAY_TOOLS_URL: "" }],
]) {
  test(`${what}: nothing is taken, and why is said`, async () => {
    const { status, told, left } = await ask(rows(), environment);
    assert.equal(status, 1);
    assert.match(told, /^prebuilt: /);
    assert.match(told, pattern);
    assert.deepEqual(left, []);
  });
}
