// The automated audit of what a page or a frame shows now.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Fails with every violation that the page, or the frame, has as it is now. */
export async function audit({ page }, state) {
  // Through the driver: the page's own policy lets no foreign script in.
  if (!await page.evaluate(() => "axe" in window)) {
    await page.evaluate(AXE);
  }
  const violations = await page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"] });
    return violations.map(({ id, help, nodes }) => ({
      id,
      help,
      nodes: nodes.slice(0, 5).map(({ html, failureSummary }) => `${html.slice(0, 200)}: ${failureSummary}`),
    }));
  });
  assert.deepEqual(violations, [], state);
}
