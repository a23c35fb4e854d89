// Starts the application, fetches the solver after it, then keeps a copy of the page for
// times without a network. A file of its own, since the page's policy allows no script
// inside the HTML.

/** What comes in 150 ms at 1.6 Mbit/s; compressed it is a third. */
const AHEAD_BYTES = 90_000;

// static/unstarted.js then says nothing: modules are loaded.
window.givewayStarts = true;

const application = document.getElementById("application");

function named(name) {
  return document.querySelector(`meta[name="giveway-${name}"]`)?.content;
}

async function start() {
  const response = await fetch(new URL(application.dataset.wasm, document.baseURI));
  if (!response.ok) {
    throw new Error(`${response.url}: ${response.status}`);
  }
  // Not earlier: on a slow network the two would share it, and the page come later.
  const solver = nearlyRead(response.clone(), application.dataset.bytes).then(() => preload(named("solver")), () => undefined);
  const [{ default: init, prepare, later }, module] = await Promise.all([import(application.href), compile(response)]);
  if (isKept()) {
    // There may be no network, and what the page was left with may need all of it at once.
    await prepare?.().catch(() => undefined);
  }
  await init({ module_or_path: module });
  await solver;
  // What the first minute does not need; where it cannot be had, the page asks for it again once it needs it.
  await later?.().catch(() => undefined);
}

function isKept() {
  try {
    return Boolean(navigator.serviceWorker?.controller);
  } catch {
    // A sandbox has no service workers.
    return false;
  }
}

async function compile(response) {
  // A host may know no type for Wasm, and then the browser compiles none that streams.
  const isWasm = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** Until little is missing; until nothing is where the size is unknown. */
async function nearlyRead(response, bytes = Infinity) {
  const reader = response.body.getReader();
  for (let left = bytes; left > AHEAD_BYTES;) {
    const { done, value } = await reader.read();
    if (done) {
      return;
    }
    left -= value.length;
  }
  // Done only when the other reader of the response is.
  reader.cancel();
}

/** Fetches what the page is going to ask for; done when it is there, or cannot be had. */
function preload(path) {
  const link = document.createElement("link");
  Object.assign(link, { rel: "preload", as: "fetch", type: "application/wasm", crossOrigin: "anonymous", href: path });
  return new Promise((resolve) => {
    link.onload = resolve;
    link.onerror = resolve;
    document.head.append(link);
  });
}

function tell(error) {
  console.error(error);
  const note = document.getElementById("boot-note");
  if (note) {
    note.textContent = `The playground could not start: ${error.message}. Reload the page; if that does not help, try a current browser.`;
    note.classList.add("failed");
  }
}

// Only a build names a service worker: while one works on the page, nothing is kept.
function keep() {
  const script = named("service-worker");
  // Inside another page nothing is kept either, and a page without an origin may not even ask.
  if (script && window.origin !== "null" && navigator.serviceWorker && !/[?&]embed(&|$)/.test(location.search)) {
    navigator.serviceWorker.register(new URL(script, document.baseURI)).catch((error) => {
      // Some hosts and some private windows allow none; the page works all the same.
      console.warn(`Giveway is not kept for offline use: ${error.message}`);
    });
  }
}

start().then(keep, tell);
