// What runs inside of the page to watch it: added before the page's own scripts.

/** Notes when the page is first painted, when an agent first moves, and long tasks. */
export function watch() {
  const seen = { moving: undefined, longTasks: [] };
  window.seen = seen;
  new PerformanceObserver((list) => {
    seen.longTasks.push(...list.getEntries().map(({ startTime, duration }) => ({ startTime, duration })));
  }).observe({ type: "longtask", buffered: true });

  const places = () => [...document.querySelectorAll(".agent")].map((agent) => agent.getAttribute("transform")).join();
  let first;
  const look = (now) => {
    const found = places();
    first ||= found;
    if (found === first) {
      requestAnimationFrame(look);
    } else {
      seen.moving = now;
    }
  };
  requestAnimationFrame(look);
}

/** The time of every frame of some seconds, in milliseconds. */
export function frames(seconds) {
  return new Promise((resolve) => {
    const times = [];
    const note = (now) => {
      times.push(now);
      if (now - times[0] < seconds * 1000) {
        requestAnimationFrame(note);
      } else {
        resolve(times);
      }
    };
    requestAnimationFrame(note);
  });
}

/** Milliseconds from a click on `Solve` until the page tells what fits a pattern. */
export function solveUntil(pattern) {
  return new Promise((resolve) => {
    const status = document.querySelector("[role=status]");
    const begin = performance.now();
    const observer = new MutationObserver(() => {
      if (new RegExp(pattern).test(status.textContent)) {
        observer.disconnect();
        // Seen with the next frame.
        requestAnimationFrame(() => resolve(performance.now() - begin));
      }
    });
    observer.observe(status, { childList: true, characterData: true, subtree: true });
    const buttons = [...document.querySelectorAll("button")];
    buttons.find((button) => button.textContent.trim() === "Solve").click();
  });
}

/** Milliseconds from a click on `Cancel` until `Go on` is seen. */
export function cancelUntilGoOn() {
  const button = (name) => [...document.querySelectorAll("button")].find((button) => button.textContent.trim() === name);
  return new Promise((resolve) => {
    const begin = performance.now();
    button("Cancel").click();
    const look = () => {
      if (button("Go on")) {
        resolve(performance.now() - begin);
      } else {
        requestAnimationFrame(look);
      }
    };
    requestAnimationFrame(look);
  });
}

/**
 * Presses `Solve` as soon as it is there, and notes when the solver has answered: added
 * before the page's own scripts.
 */
export function solveAtOnce() {
  const solve = () => [...document.querySelectorAll("button")].find((button) => button.textContent.trim() === "Solve");
  const isSolved = () => document.querySelector("[role=status]")?.textContent.startsWith("Optimal: ");
  const steps = [
    (now) => {
      const button = solve();
      button?.click();
      window.seen.running = button && now;
      return button;
    },
    () => !solve(),
    (now) => {
      const isThere = solve() && isSolved();
      window.seen.solved = isThere ? now : undefined;
      return isThere;
    },
  ];
  const look = (now) => {
    if (steps[0](now)) {
      steps.shift();
    }
    if (steps.length > 0) {
      requestAnimationFrame(look);
    }
  };
  requestAnimationFrame(look);
}

/** Milliseconds from a click on `Solve` until the plan that plays has come to its first step. */
export function solveUntilPlaying() {
  const hasMoved = () => !["0", undefined].includes(document.querySelector(".clock input")?.value);
  return new Promise((resolve) => {
    const begin = performance.now();
    const buttons = [...document.querySelectorAll("button")];
    buttons.find((button) => button.textContent.trim() === "Solve").click();
    const look = (now) => {
      if (hasMoved()) {
        resolve(now - begin);
      } else {
        requestAnimationFrame(look);
      }
    };
    requestAnimationFrame(look);
  });
}
