// A report on paper: its PDF, read text by text.

import { createRequire } from "node:module";

const { getDocumentProxy } = createRequire(import.meta.url)("unpdf");

/** Points in a millimetre. */
const MM = 72 / 25.4;
/** The margins of a report in millimetres, as its style sheet sets them. */
const MARGIN = { across: 16, above: 16, below: 18 };
/** The edge of a letter may stand out by so many points. */
const EDGE = 1;
/** The height of capitals, as a part of that of a line. */
const CAPITAL = 0.75;
/** The number of the page, which stands in the margin. */
const NUMBER = /^\d+ \/ \d+$/;

/** The texts of each page of a PDF, in their order, and those that stand outside of its margins. */
export async function pagesOf(pdf) {
  const document = await getDocumentProxy(new Uint8Array(pdf));
  const pages = [];
  for (let number = 1; number <= document.numPages; number += 1) {
    const page = await document.getPage(number);
    const { width, height } = page.getViewport({ scale: 1 });
    const { items } = await page.getTextContent();
    const texts = items.filter(({ str }) => str.trim());
    const [left, right] = [MARGIN.across * MM - EDGE, width - MARGIN.across * MM + EDGE];
    const [bottom, top] = [MARGIN.below * MM - EDGE, height - MARGIN.above * MM + EDGE];
    const isInside = ({ str, transform: [, , , , x, y], width: wide, height: tall }) =>
      NUMBER.test(str) || (x >= left && x + wide <= right && y >= bottom && y + CAPITAL * tall <= top);
    pages.push({
      text: joined(texts.map(({ str }) => str)),
      outside: texts.filter((text) => !isInside(text)).map(({ str, transform: [, , , , x, y] }) => `${str} at ${Math.round(x / MM)} mm, ${Math.round((height - y) / MM)} mm`),
    });
  }
  return pages;
}

/** Of a table the rows that are not whole on one page, and the pages with rows but without its heads. */
export function onPages(pages, { heads, rows }) {
  const holds = (page, cells) => page.text.includes(joined(cells));
  return {
    split: rows.filter((cells) => !pages.some((page) => holds(page, cells))),
    headless: pages.flatMap((page, index) => (rows.some((cells) => holds(page, cells)) && !holds(page, heads) ? [index + 1] : [])),
  };
}

/** Texts as one, without the spaces at which a line may end. */
function joined(texts) {
  return texts.join("").normalize("NFKC").replaceAll(/\s|\u00ad/gu, "");
}
