// Notices when the page writes into text that something else has replaced: a browser's translator, an extension.
//
// Yew keeps the nodes that it made, and changes only what differs. Where a node was taken out of the page meanwhile, the
// change is not seen and an old answer stays; inserting before such a node breaks the program off. Both are noticed
// here, and the programs build their elements anew from their state (web/src/foreign.rs): at once, or when what is being
// pressed is released, since a stroke or a press ends only where its element is still there.
// A page that nobody else changes pays for a comparison at each write.

const EVENT = "giveway-foreign";

const { insertBefore, removeChild } = Node.prototype;
const { get, set } = Object.getOwnPropertyDescriptor(Node.prototype, "nodeValue");
/** The nodes that the page has inserted. */
const own = new WeakSet();
/** The pointers that are down, by their ids. */
const pressed = new Set();
let isWaiting = false;

/** Announces a foreign change, when the program has come to the end of what it is doing. */
function announce() {
  if (!isWaiting) {
    isWaiting = true;
    queueMicrotask(tell);
  }
}

function tell() {
  if (isWaiting && pressed.size === 0) {
    isWaiting = false;
    // Tests read how often it happened.
    performance.mark(EVENT);
    dispatchEvent(new Event(EVENT));
  }
}

addEventListener("pointerdown", ({ pointerId }) => pressed.add(pointerId), true);
// A release that the page is not told of, such as one of a scroll bar, is seen at the next movement.
for (const kind of ["pointerup", "pointercancel", "pointermove"]) {
  addEventListener(kind, ({ pointerId, buttons }) => {
    if (buttons === 0 && pressed.delete(pointerId) && isWaiting) {
      // After the click that a press ends with.
      setTimeout(tell);
    }
  }, true);
}

/** Whether a neighbour is text that somebody else has added: a part of what stood here. */
function isForeign(node) {
  return node && !own.has(node) && node.textContent.trim() !== "";
}

Node.prototype.insertBefore = function (node, next) {
  const isThere = !next || next.parentNode === this;
  if (!isThere) {
    announce();
  }
  own.add(node);
  return insertBefore.call(this, node, isThere ? next : null);
};

Node.prototype.removeChild = function (node) {
  if (node.parentNode !== this) {
    announce();
  }
  return removeChild.call(this, node);
};

Object.defineProperty(Node.prototype, "nodeValue", {
  configurable: true,
  enumerable: true,
  get,
  set(text) {
    if (!this.parentNode || isForeign(this.previousSibling) || isForeign(this.nextSibling)) {
      announce();
    }
    set.call(this, text);
  },
});
