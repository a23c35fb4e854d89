// A page that is left, as when its tab is closed, and stays to be looked at.

/**
 * The page is told that it is hidden and left, and then that it is shown again.
 * @param {import("playwright-core").Page} page
 */
export async function leaveAndComeBack(page) {
  await page.evaluate(() => {
    const show = (visibilityState) => {
      Object.defineProperty(document, "visibilityState", { configurable: true, value: visibilityState });
      Object.defineProperty(document, "hidden", { configurable: true, value: visibilityState === "hidden" });
      document.dispatchEvent(new Event("visibilitychange"));
    };
    show("hidden");
    dispatchEvent(new PageTransitionEvent("pagehide"));
    show("visible");
    dispatchEvent(new PageTransitionEvent("pageshow"));
  });
}
