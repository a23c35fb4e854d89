// What presenting takes beside the page (web/src/present.rs), fetched when it begins first: its style sheet, the full
// screen, buttons that fade. Whether the page is presented is an attribute of its root.

const IDLE_MS = 3000;
/** A browser leaves the full screen so long after the key at most. */
const SAME_KEY_MS = 700;
const FADED = "data-idle";
const root = document.documentElement;
const page = document.getElementById("page");
let isOn = false;
let wasFull = false;
let closedAt = -SAME_KEY_MS;
let idle;

/** Fetches the style sheet; while one works on the page, it is there already. */
function dress() {
  const meta = document.querySelector('meta[name="giveway-present-style"]');
  if (meta) {
    document.head.append(Object.assign(document.createElement("link"), { rel: "stylesheet", href: meta.content }));
  }
}

function isPresented() {
  return Boolean(page.querySelector("[data-presents]"));
}

/** Begins and ends with the page. The full screen is asked for, and not needed. */
function follow() {
  if (isPresented() === isOn) {
    return;
  }
  isOn = !isOn;
  if (isOn) {
    root.requestFullscreen?.().catch(() => undefined);
    stir();
  } else {
    clearTimeout(idle);
    root.removeAttribute(FADED);
    if (document.fullscreenElement) {
      document.exitFullscreen().catch(() => undefined);
    }
  }
}

/** Somebody moves: the buttons are there for a while. */
function stir() {
  if (isOn) {
    clearTimeout(idle);
    root.removeAttribute(FADED);
    idle = setTimeout(() => root.setAttribute(FADED, ""), IDLE_MS);
  }
}

/**
 * A browser takes Escape for itself to leave the full screen: that ends the presentation, too. Where a dialog is open, or
 * was closed by the same key, it closes the dialog alone.
 */
function leave() {
  const isFull = Boolean(document.fullscreenElement);
  if (wasFull && !isFull && isOn) {
    const dialog = document.querySelector("dialog[open]");
    if (dialog) {
      dialog.close();
    } else if (performance.now() - closedAt > SAME_KEY_MS) {
      document.getElementById("present-end")?.click();
    }
  }
  wasFull = isFull;
}

/** What was pressed by hand gives the keys back: Space plays then, whatever was pressed. */
function release({ detail, target }) {
  if (isOn && detail > 0) {
    target.closest("button, input")?.blur();
  }
}

dress();
new MutationObserver(follow).observe(page, { attributeFilter: ["data-presents"], subtree: true });
for (const kind of ["pointermove", "pointerdown"]) {
  addEventListener(kind, stir, { passive: true });
}
addEventListener("click", release);
// The event of a dialog does not bubble.
addEventListener("close", () => (closedAt = performance.now()), true);
document.addEventListener("fullscreenchange", leave);
follow();
