// The elements of index.html with `data-build`: what the page is made of.

import { readFileSync } from "node:fs";
import { join } from "node:path";

/** The page as it is written, and as it is served. */
export const PAGE = "index.html";
const ELEMENT = /<(link|script) data-build\b([^>]*)>(<\/script>)?/g;

/**
 * The page's HTML.
 * @param {string} source the project's folder
 * @returns {string}
 */
export function written(source) {
  return readFileSync(join(source, PAGE), "utf8");
}

/**
 * The HTML with each element replaced.
 * @param {string} html
 * @param {(element: { text: string, rel: string, path: string, of: (name: string) => string | undefined }) => string} replacement
 * @returns {string}
 */
export function replaceElements(html, replacement) {
  return html.replaceAll(ELEMENT, (text, tag, rest) => {
    const of = (name) => rest.match(new RegExp(`(?<!-)\\b${name}="([^"]*)"`))?.[1];
    return replacement({ text, rel: tag === "script" ? "script" : of("rel"), path: of("href") ?? of("src"), of });
  });
}

/**
 * The programs: the page, what its workers run, and the course.
 * @param {string} source the project's folder
 * @returns {{ name: string, optimise: string[] }[]} with the options of wasm-opt
 */
export function programs(source) {
  const found = [];
  replaceElements(written(source), ({ rel, of }) => {
    if (rel === "rust") {
      found.push({ name: of("data-bin"), optimise: of("data-wasm-opt").split(" ") });
    }
    return "";
  });
  return found;
}
