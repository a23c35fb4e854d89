// The page as it is served while somebody works on it: index.html with what its
// `data-trunk` elements name, as Trunk puts them together, but without hashes, so that
// one file can change alone.

import { cpSync, copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";

const ELEMENT = /<(link|script) data-trunk\b([^>]*)>(<\/script>)?/g;
const RELOAD = "reload.js";

/** What makes a page load itself anew; its policy lets it listen to where it comes from. */
const RELOADS = `new EventSource("./events").onmessage = () => location.reload();\n`;

/**
 * Writes the page into a folder.
 * @param {string} source the project's folder
 * @param {string} folder where it goes; the Wasm is there already, under the names of its programs
 */
export function assemble(source, folder) {
  const text = readFileSync(join(source, "index.html"), "utf8");
  const page = text.replaceAll(ELEMENT, (element, tag, rest) => {
    const of = (name) => rest.match(new RegExp(`\\b${name}="([^"]*)"`))?.[1];
    const rel = tag === "script" ? "script" : of("(?<!-)rel");
    const place = PLACES[rel];
    if (!place) {
      throw new Error(`index.html: found ${element}, expected one of ${Object.keys(PLACES).join(", ")}`);
    }
    return place({ source, folder, path: of("href") ?? of("src"), target: of("data-target-path") ?? "", of });
  });
  const served = page
    .replace(" 'nonce-trunk-nonce'", "")
    .replace("</head>", `  <script type="module" src="./${RELOAD}"></script>\n</head>`);
  writeFileSync(join(folder, "index.html"), served);
  writeFileSync(join(folder, RELOAD), RELOADS);
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
  script: (element) => `<script type="module" src="./${copy(element)}"></script>`,
  rust: ({ of }) => (of("data-type") === "main"
    ? `<link id="application" rel="modulepreload" href="./${of("data-bin")}.js" data-wasm="./${of("data-bin")}_bg.wasm">`
    : ""),
};

function copy({ source, folder, path, target }) {
  const name = join(target, basename(path));
  mkdirSync(dirname(join(folder, name)), { recursive: true });
  copyFileSync(join(source, path), join(folder, name));
  return name;
}
