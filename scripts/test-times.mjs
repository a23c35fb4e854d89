// A reporter for Node's test runner: the seconds of each test file, a line each, as
// scripts/times.mjs reads them.

import { relative } from "node:path";

/** What a run of the tests tells, in order. */
export default async function* times(events) {
  const seconds = new Map();
  for await (const { type, data } of events) {
    // What stands inside of another test is part of that one's time.
    if ((type === "test:pass" || type === "test:fail") && data.nesting === 0 && data.file) {
      const file = relative(process.cwd(), data.file);
      seconds.set(file, (seconds.get(file) ?? 0) + data.details.duration_ms / 1000);
    }
  }
  for (const [file, time] of seconds) {
    yield `${time.toFixed(1)}\t${file}\n`;
  }
}
