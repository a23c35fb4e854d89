// The language of the page, whichever it speaks.

/** English words that no main view may show in another language; names and units are none. */
const ENGLISH = /\b(the|and|with|robots?|steps?|moves?|waits?|of|at|costs?|is|not|from|to|open|save|share|help|scene|board|show)\b/i;

/** Chooses a language in the settings, which stay closed. */
export async function choose(playground, language) {
  const { page } = playground;
  const toggle = page.getByRole("button", { name: /^(Settings|Einstellungen):/ });
  await toggle.click();
  await page.getByRole("group", { name: /^(Settings|Einstellungen)$/ }).getByLabel(/^(Language|Sprache)$/).selectOption({ label: language });
  await toggle.click();
}

/** What is seen or heard in English on the page. */
export function english({ page }) {
  return page.evaluate(({ source, flags }) => {
    const pattern = new RegExp(source, flags);
    const found = [];
    for (const element of document.querySelectorAll("body *")) {
      if (element.closest("kbd, option")) {
        continue;
      }
      const own = [...element.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE).map((node) => node.data);
      const heard = ["aria-label", "title", "placeholder", "aria-valuetext"].map((name) => element.getAttribute(name) ?? "");
      found.push(...[...own, ...heard].filter((text) => pattern.test(text)));
    }
    return [...new Set(found)];
  }, { source: ENGLISH.source, flags: ENGLISH.flags });
}
