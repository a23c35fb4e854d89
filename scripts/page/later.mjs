// A program in two parts: what a first visit runs, and what comes after it.
//
// `giveway-bind split` takes the functions of scripts/page/later/NAME.txt out of the program; what the first part has in
// their place asks for the later part before it calls one of them. `./x visit` writes those lists.

import { join } from "node:path";

/**
 * Where the paths and functions of a program are listed that come later. A program without a list stays whole.
 * @param {string} source the project's folder
 * @param {string} name of the program
 */
export function listOf(source, name) {
  return join(source, "scripts/page/later", `${name}.txt`);
}

/**
 * Bindings that load the later part: `later()` ahead of time, or the program itself as soon as it needs it. It then waits,
 * and the page with it: what a person did at that moment cannot be half done. A request that waits is not answered by the
 * page's keeper, though, so a page that may be without a network calls `prepare()` before it begins.
 * @param {string} bindings as wasm-bindgen wrote them
 * @param {string} path of the later part, from the bindings
 * @throws {Error} where they are not as expected
 */
export function withLater(bindings, path) {
  const handed = every(bindings, "const imports = __wbg_get_imports();", "const imports = { ...__wbg_get_imports(), later: { load: loadLater } };");
  return `${handed}
const LATER = new URL("${path}", import.meta.url);
let isWhole = false;
let prepared;
// The style of what the later part shows takes the place that the page's head keeps for it; a worker has no page.
function dress() {
  const meta = globalThis.document?.querySelector('meta[name="giveway-later-style"]');
  if (meta) {
    const link = document.createElement("link");
    link.rel = "stylesheet";
    link.href = meta.content;
    // Asked for again as soon as it is needed.
    link.addEventListener("error", () => link.replaceWith(meta), { once: true });
    meta.replaceWith(link);
  }
}
function join(module) {
  if (!isWhole) {
    new WebAssembly.Instance(module, { first: wasm });
    isWhole = true;
  }
}
function loadLater() {
  dress();
  if (prepared) {
    join(prepared);
    return;
  }
  const request = new XMLHttpRequest();
  request.open("GET", LATER, false);
  request.overrideMimeType("text/plain; charset=x-user-defined");
  try {
    request.send();
  } catch {
    // No network: the status is 0.
  }
  if (request.status !== 200) {
    throw new WebAssembly.RuntimeError(\`\${LATER}: \${request.status}\`);
  }
  join(new WebAssembly.Module(Uint8Array.from(request.responseText, (letter) => letter.charCodeAt(0))));
}
export async function prepare() {
  dress();
  const response = await fetch(LATER);
  if (response.ok) {
    prepared = await WebAssembly.compile(await response.arrayBuffer());
  }
}
export async function later() {
  if (!isWhole && !prepared) {
    await prepare();
  }
  if (prepared) {
    join(prepared);
    prepared = undefined;
  }
}
`;
}

/** Bindings that leave the exports of the program, which note what ran, to whoever looks. */
export function told(bindings) {
  return every(bindings, "wasm = instance.exports;", "wasm = instance.exports; globalThis.givewayProgram = wasm;");
}

function every(text, from, to) {
  if (!text.includes(from)) {
    throw new Error(`expected ${JSON.stringify(from)} in the bindings of wasm-bindgen`);
  }
  return text.replaceAll(from, to);
}
