// What the system says of the process of a tab: processor time by thread, memory.
// Linux only: the browser itself tells neither of a worker.

import { readFileSync, readdirSync } from "node:fs";

/** Clock ticks in a second, on every Linux that Debian runs on. */
const TICKS = 100;

/** The process of the only page of a browser. */
export class Tab {
  static async of(browser) {
    const session = await browser.newBrowserCDPSession();
    const { processInfo } = await session.send("SystemInfo.getProcessInfo");
    await session.detach();
    const renderers = processInfo.filter(({ type }) => type === "renderer");
    // The one that has worked the most: others are spare ones that wait for a page.
    renderers.sort((a, b) => b.cpuTime - a.cpuTime);
    return new Tab(renderers[0].id);
  }

  constructor(pid) {
    this.pid = pid;
  }

  /** Processor seconds so far of the main thread, which runs the page. */
  mainSeconds() {
    return this.#seconds((task) => Number(task) === this.pid);
  }

  /** Processor seconds so far of all workers that are there. */
  workerSeconds() {
    return this.#seconds((_, name) => name.startsWith("DedicatedWorker"));
  }

  /** The tasks of the main thread in a trace of the browser. */
  tasks({ traceEvents }) {
    return traceEvents.filter(({ name, pid, tid, tdur }) =>
      name === "ThreadControllerImpl::RunTask" && pid === this.pid && tid === this.pid && tdur !== undefined);
  }

  #seconds(isIt) {
    const tasks = `/proc/${this.pid}/task`;
    let ticks = 0;
    for (const task of readdirSync(tasks)) {
      const stat = readOrNothing(`${tasks}/${task}/stat`);
      // The name stands in parentheses and may itself have some.
      const name = stat.slice(stat.indexOf("(") + 1, stat.lastIndexOf(")"));
      if (isIt(task, name)) {
        const fields = stat.slice(stat.lastIndexOf(")") + 2).split(" ");
        ticks += Number(fields[11]) + Number(fields[12]);
      }
    }
    return ticks / TICKS;
  }

  /** Memory that is its own, in bytes: neither files nor what it shares. */
  bytes() {
    const [, kilobytes] = readOrNothing(`/proc/${this.pid}/status`).match(/^RssAnon:\s+(\d+) kB$/m) ?? [];
    return Number(kilobytes ?? 0) * 1024;
  }
}

/** A thread may end while it is looked at. */
function readOrNothing(path) {
  try {
    return readFileSync(path, "utf8");
  } catch {
    return "";
  }
}
