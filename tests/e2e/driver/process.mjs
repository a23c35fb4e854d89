// A program that a browser needs: started, waited for, ended.

import { spawn } from "node:child_process";
import { accessSync, constants } from "node:fs";

/** How long a program may take to start, in milliseconds. */
const PATIENCE = 60_000;

/** Whether there is such a program. */
export function isThere(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/**
 * Starts a program, and waits until what it prints matches; without a pattern, not at all.
 * @returns {Promise<{ said: RegExpMatchArray, end: () => Promise<void> }>}
 */
export async function start(path, args, ready, env = {}) {
  const child = spawn(path, args, { env: { ...process.env, ...env }, stdio: ["ignore", "pipe", "pipe"] });
  const ended = new Promise((resolve) => child.once("exit", resolve).once("error", resolve));
  const end = async () => {
    child.kill();
    // One that does not heed is not waited for.
    const hard = setTimeout(() => child.kill("SIGKILL"), 5000);
    await ended;
    clearTimeout(hard);
    // Programs that it has started may outlive it, and hold these open.
    child.stdout.destroy();
    child.stderr.destroy();
  };
  let text = "";
  let timer;
  try {
    const said = await new Promise((resolve, reject) => {
      const fail = (why) => reject(new Error(`${path} ${why}:\n${text}`));
      timer = setTimeout(() => fail("did not get ready"), PATIENCE);
      child.once("error", (error) => fail(error.message));
      child.once("close", () => fail("ended"));
      if (!ready) {
        child.once("spawn", () => resolve([]));
      }
      for (const stream of [child.stdout, child.stderr]) {
        stream.on("data", (data) => {
          text += data;
          const found = ready && text.match(ready);
          if (found) {
            resolve(found);
          }
        });
      }
    });
    return { said, end };
  } catch (error) {
    await end();
    throw error;
  } finally {
    clearTimeout(timer);
  }
}
