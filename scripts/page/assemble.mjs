// The page under plain names: index.html with the files that its `data-build` elements name.

import { copyFileSync, cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";

import { PAGE, replaceElements, written } from "./elements.mjs";

/**
 * Writes the page into a folder.
 * @param {string} source the project's folder
 * @param {string} folder where it goes; the programs are there already, under their names
 * @throws {Error} for an element that it does not know, with its text
 */
export function assemble(source, folder) {
  const page = replaceElements(written(source), ({ text, rel, path, of }) => {
    const place = PLACES[rel];
    if (!place) {
      throw new Error(`${PAGE}: found ${text}, expected one of ${Object.keys(PLACES).join(", ")}`);
    }
    return place({ source, folder, path, target: of("data-target-path") ?? "", of });
  });
  writeFileSync(join(folder, PAGE), page);
}

/** What each kind of element leaves in the page. */
const PLACES = {
  "copy-file": (element) => {
    copy(element);
    return "";
  },
  "copy-dir": ({ source, folder, path, target }) => {
    cpSync(join(source, path), join(folder, target), { recursive: true });
    return "";
  },
  css: (element) => `<link rel="stylesheet" href="./${copy(element)}">`,
  inline: ({ source, path }) => readFileSync(join(source, path), "utf8"),
  script: (element) => `<script ${element.of("type") ? `type="${element.of("type")}" ` : ""}src="./${copy(element)}"></script>`,
  rust: ({ of }) => (of("data-type") === "main" ? application(of("data-bin")) : ""),
};

/** An inline script would start it, but the page's policy forbids that: static/boot.js finds here what to start. */
function application(name) {
  return `<link id="application" rel="modulepreload" href="./${name}.js" data-wasm="./${name}_bg.wasm">`;
}

function copy({ source, folder, path, target }) {
  const name = join(target, basename(path));
  mkdirSync(dirname(join(folder, name)), { recursive: true });
  copyFileSync(join(source, path), join(folder, name));
  return name;
}
