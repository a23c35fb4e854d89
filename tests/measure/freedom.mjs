// What all best plans share: ten robots on 10 x 10 cells.

import { join } from "node:path";

import { root } from "../e2e/dist.mjs";
import { SOLVED, figure, inPage } from "./figure.mjs";
import { Tab } from "./process.mjs";

/** Scenes of ten robots with waypoints, batteries and slow zones: the slowest there are but for dense ones. */
const SCENES = ["A05_mm_10x10_o10_a10", "A06_mm_10x10_o20_a10"];
/** Seconds of the worker's processor time: twice those of the command. */
const [BACKBONE, CRITICAL] = [4, 20];

/** How long the worker takes until each part is known. */
export async function mustBeSo(url) {
  const figures = [];
  for (const scene of SCENES) {
    figures.push(...await inPage(url, async (playground, browser) => {
      await playground.says(SOLVED);
      await playground.open(join(root, `tests/data/mmapf/${scene}.json`));
      await playground.says(/^No plan yet/);
      await playground.press("Solve");
      await playground.says(/^Optimal: /);
      await playground.board.focus();
      // A worker of its own answers it, and has worked nothing yet.
      await playground.key("m");
      const { inspector } = playground;
      await inspector.getByText(/the same in every best plan/).waitFor({ timeout: 60_000 });
      const backbone = await worked(browser);
      // The plan that differs most comes after all cells.
      await inspector.getByText(/ differs? in more\./).waitFor({ timeout: 120_000 });
      const critical = await worked(browser);
      const what = `ten robots on 10 x 10 (${scene.slice(0, 3)}), worker`;
      return [
        figure(`what is in every best plan: ${what}`, backbone, "s", { most: BACKBONE, digits: 2 }),
        figure(`what closing each cell costs: ${what}`, critical, "s", { most: CRITICAL, digits: 1 }),
      ];
    }));
  }
  return figures;
}

async function worked(browser) {
  return (await Tab.of(browser)).workerSeconds();
}
