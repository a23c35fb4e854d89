// What is wrong with the page as it is laid out now: things that lie over each other or
// cover what can be pressed, text that is cut off, things outside of their place, controls that are too small,
// two filled buttons at once. It looks at boxes on the screen, never at names of
// styles, but for the few places that are listed here.

/** The places that hold all there is; what is in one stays within it. */
const PLACES = ".bar, .status, .boards, .under, .tools, .insp, .dock, .transport, .tabs, .lanes, .tblwrap, .cmp, .foot";
/** What floats over the page, and hides what is below it on purpose. */
const FLOATS = "dialog, .menu, .settings, .notice, .fit, .drop, .coach, .coach-ring";
/** What scrolls sideways by design. */
const SIDEWAYS = ".boards.pair, .lanes, .tblwrap, .cols, .tools";
/** Smaller by design: the time of the ruler is also set by the buttons of the transport, and
 * whose lane it is is also chosen on the board and in the inspector. What a sentence names is as
 * high as its line. */
const SLENDER = "[role=slider], .lane .lab, .aw, .cw, .term, .quiet .link, .rule-text .zone-name, .slot-of-rule";

/** The least side of a control, in pixels: for a pointer, for a finger. */
const POINTER = 24;
const FINGER = 44;

/**
 * Everything that is wrong, a line each; none where all is well.
 * @param page a page or a frame of the browser
 * @param options `touch`: whether the page has the form that is made for fingers
 * @returns {Promise<string[]>}
 */
export function geometry(page, { touch = false } = {}) {
  return page.evaluate(look, { places: PLACES, floats: FLOATS, sideways: SIDEWAYS, slender: SLENDER, least: touch ? FINGER : POINTER });
}

/** Runs in the page: it can use nothing from outside of itself. */
function look({ places, floats, sideways, slender, least }) {
  const CONTROLS = "button, a[href], input, select, textarea, summary, [role=slider], [role=tab], svg[role=grid]";
  const found = new Set();
  // Asked of the same elements again and again; nothing changes meanwhile.
  const kept = new Map();
  const styleOf = (element) => {
    let style = kept.get(element);
    if (!style) {
      const { clipPath, opacity, display, overflowX, overflowY, position, textOverflow, fontSize, backgroundColor } = getComputedStyle(element);
      style = { clipPath, opacity, display, overflowX, overflowY, position, textOverflow, fontSize, backgroundColor };
      kept.set(element, style);
    }
    return style;
  };
  const modal = document.querySelector("dialog[open]");
  const root = modal ?? document.body;

  const name = (element) => {
    const words = (element.getAttribute("aria-label") ?? element.innerText ?? "").trim().replaceAll(/\s+/g, " ").slice(0, 40);
    const kind = element.classList.length ? `.${[...element.classList].join(".")}` : "";
    return `${element.tagName.toLowerCase()}${kind}${words ? ` "${words}"` : ""}`;
  };
  const box = ({ left, top, right, bottom }) => ({ left, top, right, bottom });
  const cut = (a, b) => ({
    left: Math.max(a.left, b.left),
    top: Math.max(a.top, b.top),
    right: Math.min(a.right, b.right),
    bottom: Math.min(a.bottom, b.bottom),
  });
  const across = (a) => a.right - a.left;
  const down = (a) => a.bottom - a.top;
  const isThere = (a) => across(a) > 0 && down(a) > 0;
  const round = (a) => `${Math.round(a.left)},${Math.round(a.top)} to ${Math.round(a.right)},${Math.round(a.bottom)}`;
  const sight = { left: 0, top: 0, right: innerWidth, bottom: innerHeight };

  // For readers only: made so small that nothing of it is seen.
  const silent = new Map();
  const isSilent = (element) => {
    if (!silent.has(element)) {
      silent.set(element, looksSilent(element));
    }
    return silent.get(element);
  };
  const looksSilent = (element) => {
    if (!element || element === document.body) {
      return false;
    }
    const { clipPath, opacity } = styleOf(element);
    return clipPath === "inset(50%)" || opacity === "0" && element.tagName !== "INPUT" || isSilent(element.parentElement);
  };
  const isShown = (element) => element.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true }) && !isSilent(element);

  // What is left of a box in all that scrolls or clips around it. `lost` is what cuts
  // it off where nobody can scroll.
  const clipped = (element, rect) => {
    let seen = rect;
    let lost = null;
    let scrolls = { x: false, y: false };
    for (let at = element.parentElement; at; at = at.parentElement) {
      const style = styleOf(at);
      if (style.display === "contents" || at instanceof SVGElement) {
        continue;
      }
      const area = at.getBoundingClientRect();
      for (const [axis, low, high] of [["x", "left", "right"], ["y", "top", "bottom"]]) {
        const overflow = axis === "x" ? style.overflowX : style.overflowY;
        if (overflow === "visible") {
          continue;
        }
        const can = overflow === "auto" || overflow === "scroll";
        if (!can && !scrolls[axis] && (rect[low] < area[low] - 1 || rect[high] > area[high] + 1)) {
          lost ??= at;
        }
        // Nobody can scroll to what lies on the left of the beginning.
        if (can && axis === "x" && !scrolls.x && rect.left + at.scrollLeft < area.left - 1) {
          lost ??= at;
        }
        scrolls[axis] ||= can;
        seen = { ...seen, [low]: Math.max(seen[low], area[low]), [high]: Math.min(seen[high], area[high]) };
      }
      if (style.position === "fixed") {
        break;
      }
    }
    return { seen: cut(seen, sight), lost, scrolls };
  };

  // The things: controls with their boxes, texts with the boxes of their lines.
  const things = [];
  for (const element of root.querySelectorAll("*")) {
    const isDrawn = element instanceof SVGElement && element.getAttribute("role") !== "grid";
    if (isDrawn || !isShown(element)) {
      continue;
    }
    if (element.matches(CONTROLS)) {
      const rect = box(element.getBoundingClientRect());
      things.push({ element, rect, isText: false, ...clipped(element, rect) });
    }
    for (const node of element.childNodes) {
      if (node.nodeType === Node.TEXT_NODE && node.data.trim() !== "") {
        const range = document.createRange();
        range.selectNodeContents(node);
        for (const line of range.getClientRects()) {
          // Its letters, without the space between lines.
          const size = Number.parseFloat(styleOf(element).fontSize);
          const spare = Math.max(0, (line.height - size) / 2);
          const letters = { left: line.left, right: line.right, top: line.top + spare, bottom: line.bottom - spare };
          things.push({ element, rect: letters, isText: true, ...within(element, letters) });
        }
      }
    }
  }

  // As `clipped`, but the element's own edge cuts its text, too.
  function within(element, rect) {
    const inner = { parentElement: element };
    return clipped(inner, rect);
  }

  const canBeRead = (element) => {
    for (let at = element, steps = 0; at && steps < 4; at = at.parentElement, steps += 1) {
      if (at.title || at.getAttribute("aria-label")) {
        return true;
      }
    }
    return false;
  };

  for (const { element, rect, isText, seen, lost, scrolls } of things) {
    if (!isThere(rect)) {
      continue;
    }
    // Cut off.
    if (lost) {
      const style = styleOf(lost);
      const isMeant = isText && style.textOverflow === "ellipsis" && canBeRead(lost);
      if (!isMeant) {
        found.add(`cut off: ${name(element)} by ${name(lost)}`);
      }
    }
    // Out of sight, where nothing scrolls to it.
    const offX = rect.left < -1 || rect.right > innerWidth + 1;
    const offY = rect.top < -1 || rect.bottom > innerHeight + 1;
    if (offX && !scrolls.x && !lost || offY && !scrolls.y && !lost) {
      found.add(`outside of the window: ${name(element)} at ${round(rect)}`);
    }
    // Out of its place.
    const place = element.closest(`${places}, ${floats}`);
    if (place && place !== element && styleOf(place).display !== "contents") {
      const area = place.getBoundingClientRect();
      const overX = rect.left < area.left - 1 || rect.right > area.right + 1;
      const overY = rect.top < area.top - 1 || rect.bottom > area.bottom + 1;
      if (overX && !scrolls.x && !lost || overY && !scrolls.y && !lost) {
        found.add(`outside of ${name(place).split(" ")[0]}: ${name(element)} at ${round(rect)}`);
      }
    }
    // Text out of its button.
    const button = isText && element.closest("button, a, summary, .badge, .chip");
    if (button) {
      const area = button.getBoundingClientRect();
      if (!lost && (rect.left < area.left - 1 || rect.right > area.right + 1 || rect.top < area.top - 1 || rect.bottom > area.bottom + 1)) {
        found.add(`sticks out of its button: ${name(element)}`);
      }
    }
  }

  // Whatever scrolls sideways without being meant to.
  for (const element of root.querySelectorAll("*")) {
    if (element instanceof SVGElement || element.matches(sideways) || !isShown(element)) {
      continue;
    }
    const { overflowX } = styleOf(element);
    if ((overflowX === "auto" || overflowX === "scroll") && element.scrollWidth > element.clientWidth + 1) {
      found.add(`scrolls sideways: ${name(element).split(" ")[0]} by ${element.scrollWidth - element.clientWidth}`);
    }
  }

  // One over the other. What is stuck to an edge of a place that scrolls lies over the rest
  // of that place, and what floats over all.
  const layer = (element) => element.closest(floats);
  const stuck = (element) => {
    for (let at = element; at && at !== root; at = at.parentElement) {
      if (styleOf(at).position === "sticky") {
        return at.closest(".lanes, .tblwrap, .scroll");
      }
    }
    return null;
  };
  const seen = things.filter((thing) => isThere(thing.seen)).map((thing) => ({ ...thing, layer: layer(thing.element), stuck: stuck(thing.element) }));
  seen.forEach((a, index) => {
    for (const b of seen.slice(index + 1)) {
      const both = cut(a.seen, b.seen);
      if (across(both) <= 2 || down(both) <= 2 || a.layer !== b.layer) {
        continue;
      }
      if (a.element === b.element && a.isText === b.isText || a.element.contains(b.element) || b.element.contains(a.element)) {
        continue;
      }
      if (a.stuck?.contains(b.element) || b.stuck?.contains(a.element)) {
        continue;
      }
      // The text of a label lies in what it labels.
      if (a.element.closest("label")?.contains(b.element)) {
        continue;
      }
      found.add(`over each other: ${name(a.element)} and ${name(b.element)}, at ${round(both)}`);
    }
  });

  // Under something else, where no press comes to it.
  for (const { element, seen, isText } of things) {
    if (isText || across(seen) < 2 || down(seen) < 2) {
      continue;
    }
    const at = document.elementFromPoint((seen.left + seen.right) / 2, (seen.top + seen.bottom) / 2);
    const label = element.closest("label");
    const isReached = at !== null && (element.contains(at) || label?.contains(at));
    const isMeant = at?.closest(floats)?.contains(element) === false || stuck(at)?.contains(element);
    if (!isReached && !isMeant) {
      found.add(`covered: ${name(element)} by ${at && name(at)}`);
    }
  }

  // Too small to be hit.
  for (const element of root.querySelectorAll(CONTROLS)) {
    if (element instanceof SVGElement || !isShown(element) && element.tagName !== "INPUT" || element.matches(slender)) {
      continue;
    }
    // A link within a sentence is as high as its line; so is a name that can be pressed, which no browser lays out inline.
    if (styleOf(element).display === "inline" || element.matches(".named")) {
      continue;
    }
    const hit = (element.closest("label") ?? element).getBoundingClientRect();
    if (hit.width === 0 || hit.height === 0) {
      continue;
    }
    // What floats covers it.
    const cover = document.elementFromPoint((hit.left + hit.right) / 2, hit.bottom - 2)?.closest(floats);
    if (cover && !cover.contains(element)) {
      continue;
    }
    const middle = { x: (hit.left + hit.right) / 2, y: (hit.top + hit.bottom) / 2 };
    const reaches = (x, y) => {
      const at = document.elementFromPoint(x, y);
      return at !== null && (element === at || element.contains(at) || element.closest("label")?.contains(at));
    };
    const half = least / 2 - 1;
    const isWide = hit.width >= least - 0.5 || reaches(middle.x - half, middle.y) && reaches(middle.x + half, middle.y);
    const isHigh = hit.height >= least - 0.5 || reaches(middle.x, middle.y - half) && reaches(middle.x, middle.y + half);
    if (!isWide || !isHigh) {
      found.add(`too small: ${name(element)} is ${Math.round(hit.width)} by ${Math.round(hit.height)}`);
    }
  }

  // One next step.
  const probe = document.createElement("i");
  root.append(probe);
  probe.style.background = "var(--ink)";
  const ink = getComputedStyle(probe).backgroundColor;
  probe.remove();
  const filled = [...root.querySelectorAll("button, a")].filter((button) =>
    isShown(button) && !button.disabled && styleOf(button).backgroundColor === ink);
  if (filled.length > 1) {
    found.add(`filled, more than one: ${filled.map(name).join(", ")}`);
  }
  return [...found];
}
