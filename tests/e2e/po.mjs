// What the page says in another language, from its catalogues.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { root } from "./dist.mjs";

const ENTRY = /^(?:msgctxt "(?<context>.*)"\n)?msgid "(?<text>.*)"\nmsgstr "(?<other>.*)"$/gm;

const unescaped = (text) => text.replaceAll(/\\(.)/g, (_, sign) => (sign === "n" ? "\n" : sign));

/** Gives the words of a language for English ones, those of the page and of its course. */
export function words(tag) {
  const found = new Map();
  for (const path of [`static/languages/${tag}.po`, `static/languages/course/${tag}.po`]) {
    for (const { groups: { context = "", text, other } } of readFileSync(join(root, path), "utf8").matchAll(ENTRY)) {
      found.set(`${context}\n${unescaped(text)}`, unescaped(other));
    }
  }
  return (text, context = "") => {
    const other = found.get(`${context}\n${text}`);
    if (!other) {
      throw new Error(`no words in ${tag} for: ${text}`);
    }
    return other;
  };
}
