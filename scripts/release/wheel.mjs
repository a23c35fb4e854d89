// `node scripts/release/wheel.mjs TARGET`: builds the package for Python for one target of Rust
// into target/release-wheels/. `wheel.mjs sdist` packs its sources instead. What can run on this
// machine is installed into a new environment and asked for a plan.
//
// In JavaScript, since it also runs on Windows and macOS, where `./x` may not.

import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, dirname, join } from "node:path";

import { releaseWheels, root, settings } from "./settings.mjs";

/** What pip installs to build with; zig links for Linux as it was ten years ago. */
const TOOLS = ["maturin==1.16.0"];
const ZIG = "ziglang==0.14.1";
const OLD_LINUX = ["--zig", "--compatibility", "manylinux2014"];
const ASK = "import giveway; from giveway import *; "
  + "print(giveway.__version__, solve(Scene(map=('..',), agents=(Agent('A', (0, 0), (1, 0)),))).status)";

const [target] = process.argv.slice(2);
if (target !== "sdist" && !/^[a-z0-9_]+(-[a-z0-9_]+)+$/.test(target ?? "")) {
  console.error("wheel: expected sdist, or a target of Rust, such as x86_64-unknown-linux-gnu");
  process.exit(1);
}

const isWindows = process.platform === "win32";
const run = (command, ...args) => execFileSync(command, args, { cwd: root, stdio: ["ignore", "inherit", "inherit"] });

/** A new environment of Python, and its interpreter. */
function environment(folder, ...packages) {
  run(isWindows ? "python" : "python3", "-m", "venv", folder);
  const python = join(folder, isWindows ? "Scripts/python.exe" : "bin/python");
  run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", ...packages);
  return python;
}

const isOldLinux = target.endsWith("-linux-gnu");
const folder = mkdtempSync(join(tmpdir(), "giveway-wheel-"));
try {
  const python = environment(join(folder, "tools"), ...TOOLS, ...(isOldLinux ? [ZIG] : []));
  const out = join(folder, "out");
  if (target === "sdist") {
    run(python, "-m", "maturin", "sdist", "--out", out);
  } else {
    run("rustup", "target", "add", target);
    // Maturin asks the first Python of the path for zig.
    process.env.PATH = dirname(python) + delimiter + process.env.PATH;
    run(python, "-m", "maturin", "build", "--release", "--locked", "--target", target, "--out", out,
      ...(isOldLinux ? OLD_LINUX : []));
  }
  const [name, ...others] = readdirSync(out);
  const { version } = settings();
  // One file for all versions of Python from 3.10 on.
  const expected = target === "sdist" ? "\\.tar\\.gz" : "-cp310-abi3-[a-z0-9_.]+\\.whl";
  // Python writes 1.2.3-rc.1 as 1.2.3rc1.
  const written = version.replace(/-([a-z]+)\.(\d+)$/, "$1$2").replaceAll(".", "\\.");
  if (others.length > 0 || !new RegExp(`^giveway-${written}${expected}$`).test(name)) {
    throw new Error(`maturin made ${[name, ...others].join(", ")}`);
  }
  const host = /^host: (.*)$/m.exec(execFileSync("rustc", ["-vV"], { encoding: "utf8" }))[1];
  if (target === "sdist" || target === host) {
    run(environment(join(folder, "new"), join(out, name)), "-c", ASK);
  }
  mkdirSync(releaseWheels, { recursive: true });
  // Another file system may hold the folder of what is built.
  copyFileSync(join(out, name), join(releaseWheels, name));
  console.log(join(releaseWheels, name));
} finally {
  rmSync(folder, { recursive: true, force: true });
}
