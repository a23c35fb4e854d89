// Starts the application, then keeps a copy of the page for times without a network.
// A file of its own, since the page's policy allows no script inside the HTML.

const application = document.getElementById("application");

async function start() {
  const { default: init } = await import(application.href);
  await init({ module_or_path: new URL(application.dataset.wasm, document.baseURI) });
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
  const script = document.querySelector('meta[name="giveway-service-worker"]')?.content;
  // Inside another page nothing is kept either.
  if (script && navigator.serviceWorker && !/[?&]embed(&|$)/.test(location.search)) {
    navigator.serviceWorker.register(new URL(script, document.baseURI)).catch((error) => {
      // Some hosts and some private windows allow none; the page works all the same.
      console.warn(`Giveway is not kept for offline use: ${error.message}`);
    });
  }
}

start().then(keep, tell);
