// The solver's worker: runs the Wasm that the page has compiled. The page's first message
// brings it, with the address of the script that belongs to it.

async function start({ script, module }) {
  const { default: init } = await import(script);
  await init({ module_or_path: module });
}

// A promise that is rejected in a worker is told to nobody, while an exception there is an
// event of the page.
addEventListener("message", ({ data }) => start(data).catch(reportError), { once: true });
