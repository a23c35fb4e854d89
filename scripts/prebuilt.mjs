// Fetches a tool that somebody built before: `node scripts/prebuilt.mjs PACKAGE VERSION FOLDER`.
// Ends with 0 when the folder holds it, with 1 and a sentence when it has to be built
// from source.
//
// scripts/prebuilt.txt pins what may be taken, by SHA-256. Where it is fetched from is
// GIVEWAY_TOOLS_URL, or else `tools-address` in the workspace's manifest, which is empty
// until somebody publishes the tools.

import { createHash } from "node:crypto";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const PROJECT = fileURLToPath(new URL("..", import.meta.url));
/** A host that says nothing for so long is given up, milliseconds. */
const SILENCE = 15_000;
/** No tool is as large, bytes. */
const LARGEST = 100_000_000;

const [name, version, folder] = process.argv.slice(2);
if (!folder) {
  giveUp("expected PACKAGE VERSION FOLDER");
}
try {
  await install(entry(), address());
} catch (error) {
  giveUp(error.cause?.message ?? error.message);
}

function giveUp(why) {
  console.error(`prebuilt: ${why}`);
  process.exit(1);
}

/** The line of the list for this tool and this machine. */
function entry() {
  const machine = `${process.platform}-${process.arch}`;
  const list = process.env.GIVEWAY_TOOLS_LIST ?? join(PROJECT, "scripts/prebuilt.txt");
  const rows = readFileSync(list, "utf8").split("\n").filter((line) => line && !line.startsWith("#"));
  const found = rows.map((row) => row.split(/\s+/)).find((row) => row[0] === name && row[1] === version && row[2] === machine);
  if (!found) {
    throw new Error(`no ${name} ${version} for ${machine} is published`);
  }
  const [, , , sha256, file] = found;
  return { sha256, file };
}

function address() {
  const manifest = readFileSync(join(PROJECT, "Cargo.toml"), "utf8");
  const found = process.env.GIVEWAY_TOOLS_URL ?? manifest.match(/^tools-address = "([^"]*)"$/m)?.[1];
  if (!found) {
    throw new Error("no address of published tools is set (tools-address in Cargo.toml)");
  }
  return found.endsWith("/") ? found : `${found}/`;
}

async function install({ sha256, file }, base) {
  const archive = await fetched(new URL(file, base));
  const found = createHash("sha256").update(archive).digest("hex");
  if (found !== sha256) {
    throw new Error(`${file}: found the SHA-256 ${found}, expected ${sha256}`);
  }
  mkdirSync(dirname(folder), { recursive: true });
  const part = mkdtempSync(`${folder}.`);
  try {
    const path = join(part, "archive.tar.gz");
    writeFileSync(path, archive);
    execFileSync("tar", ["-xzf", path, "-C", part], { stdio: ["ignore", "ignore", "pipe"] });
    rmSync(path);
    renameSync(part, folder);
  } finally {
    rmSync(part, { recursive: true, force: true });
  }
}

/** All bytes of an address, as long as some keep coming. */
async function fetched(url) {
  const stop = new AbortController();
  let timer;
  const wait = () => {
    clearTimeout(timer);
    timer = setTimeout(() => stop.abort(new Error(`${url.host} said nothing for ${SILENCE / 1000} s`)), silence());
  };
  wait();
  try {
    const response = await fetch(url, { signal: stop.signal });
    if (!response.ok) {
      throw new Error(`${url.pathname}: ${response.status} ${response.statusText}`);
    }
    const pieces = [];
    let bytes = 0;
    for await (const piece of response.body) {
      wait();
      bytes += piece.length;
      if (bytes > LARGEST) {
        throw new Error(`${url.pathname}: over ${LARGEST} bytes`);
      }
      pieces.push(piece);
    }
    return Buffer.concat(pieces);
  } finally {
    clearTimeout(timer);
  }
}

function silence() {
  return Number(process.env.GIVEWAY_TOOLS_SILENCE ?? SILENCE);
}
