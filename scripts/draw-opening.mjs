// Draws the picture of the opening scene, static/opening.svg, as the built page shows it
// at time 0: `./x opening`, whenever the board's look has changed.
// tests/e2e/opening.test.mjs holds that it is up to date.

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { launch, open } from "../tests/e2e/browser.mjs";
import { dist, root } from "../tests/e2e/dist.mjs";
import { Playground } from "../tests/e2e/page.mjs";
import { serve } from "../tests/e2e/server.mjs";
import { eventually } from "../tests/e2e/wait.mjs";

const FILE = join(root, "static/opening.svg");

/** The picture that there is. */
export function drawn() {
  return readFileSync(FILE, "utf8");
}

/** The picture as it should be, of a playground that has just been opened. */
export async function draw(playground) {
  await playground.pause();
  await playground.press("To start");
  await playground.reaches(0);
  const first = playground.board.locator(".agent").first();
  let before;
  await eventually("the robots to stand still", () => first.getAttribute("transform"), (now) => {
    const stands = now === before;
    before = now;
    return stands;
  });
  const lines = await playground.board.evaluate((board) => {
    const picture = board.cloneNode(true);
    // What is only for the pointer and the keyboard, and what would have to move too.
    const others = [".hover", ".cursor", "[role=row]", ".trail", ".ahead", ".ahead-halo", ".transit", ".beak", ".badge-at"];
    for (const other of picture.querySelectorAll(others.join())) {
      other.remove();
    }
    for (let empty; (empty = picture.querySelector("g:empty"));) {
      empty.remove();
    }
    for (const { name } of [...picture.attributes]) {
      picture.removeAttribute(name);
    }
    for (const mark of picture.querySelectorAll("[data-occupied]")) {
      mark.removeAttribute("data-occupied");
    }
    picture.setAttribute("class", "map");
    picture.setAttribute("aria-hidden", "true");
    return picture.outerHTML.replaceAll(/<!--.*?-->/g, "").replaceAll(/(<\/?(g|svg|defs)[ >])/g, "\n$1").replaceAll(/\n+/g, "\n");
  });
  return `${lines.trim()}\n`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const host = await serve(dist);
  const browser = await launch();
  const { page } = await open(browser, { serviceWorkers: "block" });
  const playground = new Playground(page);
  await playground.goto(host.url);
  writeFileSync(FILE, await draw(playground));
  await browser.close();
  await host.close();
  console.log(`written: ${FILE}`);
}
