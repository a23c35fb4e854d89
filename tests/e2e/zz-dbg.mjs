import { launch, open } from "/work/wt/page/tests/e2e/browser.mjs";
import { dist } from "/work/wt/page/tests/e2e/dist.mjs";
import { serve } from "/work/wt/page/tests/e2e/server.mjs";
import * as E from "/work/wt/page/tests/e2e/elsewhere.mjs";
const host = await serve(dist, "/"); const browser = await launch();
for (const [name, o] of [["d", { viewport: { width: 1440, height: 900 } }], ["p", { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }]]) {
const { page, complaints } = await open(browser, { ...o, serviceWorkers: "block", colorScheme: process.argv[2] ?? "light" });
await page.goto(host.url); await page.waitForTimeout(2500);
const drop = (files) => page.evaluate((dropped) => {
    const data = new DataTransfer();
    for (const { name, bytes } of dropped) data.items.add(new File([bytes], name));
    for (const kind of ["dragover", "drop"]) document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
  }, files);
await drop([E.own("aisles.json", E.AISLES), E.plan("paths.json", E.straight(E.AISLES))]);
await page.waitForTimeout(3500);
await page.getByRole("button", { name: /, go to time \d+$/ }).nth(1).click();
await page.waitForTimeout(500);
await page.screenshot({ path: `/tmp/pagetest/${name}1.png` });
await page.getByRole("button", { name: "Find a legal plan" }).click();
await page.waitForTimeout(1500);
await page.screenshot({ path: `/tmp/pagetest/${name}2.png` });
await drop([E.own("hall.json", E.HALL), E.plan("late.json", E.LATE), E.plan("best.json", E.BEST)]);
await page.waitForTimeout(2500);
await page.screenshot({ path: `/tmp/pagetest/${name}3.png` });
if (name === "d") {
await page.getByRole("button", { name: "Save", exact: true }).click();
await page.getByRole("button", { name: "Report, other formats" }).click();
await page.getByRole("button", { name: /Map and scenario/ }).click();
await page.waitForTimeout(800);
await page.screenshot({ path: `/tmp/pagetest/${name}4.png` });
}
console.log(complaints);
}
await browser.close(); await host.close();
