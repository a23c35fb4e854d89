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
    // The one that has a worker, and of these the one that has worked the most:
    // others are spare ones that wait for a page, or show the browser itself.
    const tabs = renderers.map(({ id, cpuTime }) => ({ tab: new Tab(id), cpuTime }));
    const withWorker = tabs.filter(({ tab }) => tab.#threads().some(({ name }) => isWorker(name)));
    const [found] = (withWorker.length > 0 ? withWorker : tabs).sort((a, b) => b.cpuTime - a.cpuTime);
    return found.tab;
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
    return this.#seconds((_, name) => isWorker(name));
  }

  /** The tasks of the main thread in a trace of the browser. */
  tasks({ traceEvents }) {
    return traceEvents.filter(({ name, pid, tid, tdur }) =>
      name === "ThreadControllerImpl::RunTask" && pid === this.pid && tid === this.pid && tdur !== undefined);
  }

  #seconds(isIt) {
    const found = this.#threads().filter(({ task, name }) => isIt(task, name));
    return found.reduce((ticks, thread) => ticks + thread.ticks, 0) / TICKS;
  }

  /** Each thread with its name and the clock ticks that it has worked. */
  #threads() {
    const tasks = `/proc/${this.pid}/task`;
    return readdirSync(tasks).map((task) => {
      const stat = readOrNothing(`${tasks}/${task}/stat`);
      // The name stands in parentheses and may itself have some.
      const name = stat.slice(stat.indexOf("(") + 1, stat.lastIndexOf(")"));
      const fields = stat.slice(stat.lastIndexOf(")") + 2).split(" ");
      return { task, name, ticks: Number(fields[11] ?? 0) + Number(fields[12] ?? 0) };
    });
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

function isWorker(name) {
  return name.startsWith("DedicatedWorker");
}
