// Writes static/tokens-plain.css: the colours of static/tokens.css for browsers that do not
// know light-dark() (Safari before 17.5, Firefox before 120, Chromium before 123). To them a
// token that uses it is no colour, and the page has no ground and a black board.
//
//   node scripts/plain-tokens.mjs
//
// A test (tests/e2e/old-browsers.test.mjs) fails where the file is not what this writes.

import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const CALL = "light-dark(";
const HEADER = `/* Written by scripts/plain-tokens.mjs from tokens.css: change that file, then run the script.
   The colours by themselves, for browsers that do not know light-dark(). */
`;

/** The style sheet that belongs to these tokens. */
export function plainTokens(tokens) {
  const uses = declarations(tokens).filter(([, value]) => value.includes(CALL));
  const rule = (selector, choice, indent) => {
    const lines = uses.map(([name, value]) => `${indent}  ${name}: ${choose(value, choice)};\n`);
    return `${indent}${selector} {\n${lines.join("")}${indent}}\n`;
  };
  return `${HEADER}
@supports not (color: light-dark(#000, #fff)) {
${rule(":root", 0, "  ")}
${rule(':root[data-theme="dark"]', 1, "  ")}
  @media (prefers-color-scheme: dark) {
${rule(':root:not([data-theme="light"])', 1, "    ")}  }
}
`;
}

/** The custom properties of a style sheet, in order, each with its value. */
function declarations(sheet) {
  const text = sheet.replaceAll(/\/\*.*?\*\//gs, "");
  return [...text.matchAll(/(--[\w-]+):\s*([^;]+);/g)].map(([, name, value]) => [name, value.trim()]);
}

/** A value with one of the two arguments in the place of each call of light-dark(). */
function choose(value, choice) {
  const at = value.indexOf(CALL);
  if (at < 0) {
    return value;
  }
  const [parts, rest] = split(value.slice(at + CALL.length));
  if (parts.length !== 2) {
    throw new Error(`found ${parts.length} colours in ${value}, expected two`);
  }
  return value.slice(0, at) + parts[choice] + choose(rest, choice);
}

/** The arguments up to the bracket that closes a call, and what follows it. */
function split(text) {
  const parts = [""];
  let depth = 0;
  for (const [at, letter] of text.split("").entries()) {
    if (letter === ")" && depth === 0) {
      return [parts.map((part) => part.trim()), text.slice(at + 1)];
    }
    depth += { "(": 1, ")": -1 }[letter] ?? 0;
    if (letter === "," && depth === 0) {
      parts.push("");
    } else {
      parts[parts.length - 1] += letter;
    }
  }
  throw new Error(`found no end of a call in ${text}`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const file = (name) => new URL(`../static/${name}`, import.meta.url);
  writeFileSync(file("tokens-plain.css"), plainTokens(readFileSync(file("tokens.css"), "utf8")));
}
