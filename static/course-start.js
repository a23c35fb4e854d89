// Starts the course, a program of its own: the page loads this when the course is opened
// first.

import init from "./course.js";

const place = document.getElementById("course");

async function start() {
  await dress();
  const { content } = document.querySelector('meta[name="giveway-course"]');
  const response = await fetch(new URL(content, document.baseURI));
  if (!response.ok) {
    throw new Error(`${response.url}: ${response.status}`);
  }
  await init({ module_or_path: await compile(response) });
}

/** Fetches the style sheet of the course; while one works on the page, it is there already. */
function dress() {
  const meta = document.querySelector('meta[name="giveway-course-style"]');
  if (!meta) {
    return undefined;
  }
  const link = Object.assign(document.createElement("link"), { rel: "stylesheet", href: meta.content });
  return new Promise((resolve, reject) => {
    link.onload = resolve;
    link.onerror = () => reject(new Error(`${link.href} did not arrive.`));
    document.head.append(link);
  });
}

async function compile(response) {
  // A host may know no type for Wasm, and then the browser compiles none that streams.
  const isWasm = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

// The page tells a person of it.
start().catch((error) => place.dispatchEvent(new CustomEvent("giveway-course-failed", { detail: error.message })));
