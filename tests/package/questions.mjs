// The questions of the benchmark, answered by the package's worker in Chromium, beside the
// command's times: ./x bench --questions && ./x package && node tests/package/questions.mjs
// The numbers go to docs/package.md by hand.

import { symlinkSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { launch, open } from "../e2e/browser.mjs";
import { serve } from "../e2e/server.mjs";
import { Tab } from "../measure/process.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = process.env.GIVEWAY_PACKAGE ?? join(root, "target/package");
const asked = JSON.parse(readFileSync(join(root, "target/questions.json"), "utf8"));

const site = mkdtempSync(join(tmpdir(), "giveway-questions-"));
symlinkSync(folder, join(site, "giveway"));
writeFileSync(join(site, "ask.html"), `<!doctype html><title>Questions</title>
<script type="module">
  import { Giveway } from "./giveway/worker/client.js";
  const giveway = new Giveway();
  window.ask = async (request) => {
    const begin = performance.now();
    let verdict;
    const answer = await giveway.explain(request, { onProgress: (now) => {
      if (now.event === "explained" && !now.answer.pending.includes("verdict")) verdict ??= performance.now();
    } });
    const end = performance.now();
    return { answer: answer.verdict, seconds: [(verdict ?? end) - begin, end - begin].map((ms) => ms / 1000) };
  };
  await giveway.schema();
  window.ready = true;
</script>`);

const host = await serve(site);
const browser = await launch();
const rows = { native: [[], []], browser: [[], []], cpu: [] };
try {
  const { page } = await open(browser);
  await page.goto(`${host.url}/ask.html`);
  await page.waitForFunction(() => window.ready);
  const tab = await Tab.of(browser);
  for (const { about, request, verdict, seconds } of asked) {
    const before = tab.workerSeconds();
    const found = await page.evaluate((request) => window.ask(request), request);
    const cpu = tab.workerSeconds() - before;
    const same = found.answer === verdict ? "" : `   another verdict: ${found.answer}, natively ${verdict}`;
    console.log(`${about}: ${found.seconds.map(told).join(" ")} (CPU ${told(cpu)}), natively ${seconds.map(told).join(" ")}${same}`);
    process.exitCode ||= Number(same !== "");
    seconds.forEach((s, i) => rows.native[i].push(s));
    found.seconds.forEach((s, i) => rows.browser[i].push(s));
    rows.cpu.push(cpu);
  }
} finally {
  await browser.close();
  await host.close();
  rmSync(site, { recursive: true, force: true });
}

console.log(`\n${asked.length} questions, in seconds`);
console.log("                      median    95 %    together");
line("verdict, native CPU", rows.native[0]);
line("verdict, browser wall", rows.browser[0]);
line("whole, native CPU", rows.native[1]);
line("whole, browser CPU", rows.cpu);
line("whole, browser wall", rows.browser[1]);

function line(name, values) {
  const sorted = values.toSorted((a, b) => a - b);
  const share = (percent) => sorted[Math.ceil((sorted.length * percent) / 100) - 1];
  const sum = values.reduce((a, b) => a + b, 0);
  console.log(`${name.padEnd(22)}${told(share(50))} ${told(share(95))}   ${told(sum)}`);
}

function told(seconds) {
  return seconds.toFixed(3).padStart(7);
}
