// `node scripts/release/binary.mjs TARGET`: builds the command for one target of Rust, packs it
// with its README and licences into target/release-files/, and writes the SHA-256 sum beside it.
//
// In JavaScript, since it also runs on Windows and macOS, where `./x` may not.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { built, releaseFiles, root, settings } from "./settings.mjs";

const [target] = process.argv.slice(2);
if (!/^[a-z0-9_]+(-[a-z0-9_]+)+$/.test(target ?? "")) {
  console.error("binary: expected a target of Rust, such as x86_64-unknown-linux-musl");
  process.exit(1);
}

const run = (command, args, env = {}) => execFileSync(command, args, {
  cwd: root, stdio: ["ignore", "inherit", "inherit"], env: { ...process.env, ...env },
});
const isWindows = target.includes("-windows-");
const { version } = settings();
const name = `giveway-${version}-${target}`;
const out = releaseFiles;

run("rustup", ["target", "add", target]);
// All of a library that belongs to the system is inside, so that the command runs on a bare machine.
const flags = isWindows ? { RUSTFLAGS: "-C target-feature=+crt-static" } : {};
run("cargo", ["build", "--locked", "--release", "--package", "giveway-cli", "--target", target], flags);

const folder = join(out, name);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const command = isWindows ? "giveway.exe" : "giveway";
copyFileSync(join(built, target, "release", command), join(folder, command));
copyFileSync(join(root, "crates/giveway-cli/README.md"), join(folder, "README.md"));
for (const file of ["LICENSE-MIT", "LICENSE-APACHE", "CHANGELOG.md"]) {
  copyFileSync(join(root, file), join(folder, file));
}
// The tar of Windows writes ZIP, too, which more people there can open.
const archive = `${name}.${isWindows ? "zip" : "tar.gz"}`;
const tar = isWindows ? join(process.env.SystemRoot, "System32/tar.exe") : "tar";
// That of macOS would add files of its own for attributes.
run(tar, [isWindows ? "-acf" : "-czf", join(out, archive), "-C", out, name], { COPYFILE_DISABLE: "1" });
rmSync(folder, { recursive: true });

const sum = createHash("sha256").update(readFileSync(join(out, archive))).digest("hex");
writeFileSync(join(out, `${archive}.sha256`), `${sum}  ${archive}\n`);
console.log(`${join(out, archive)}: ${sum}`);
