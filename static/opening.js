// The opening scene moves before the application is there: its picture stands in the HTML
// (static/opening.svg), its plan beside it. The application takes both over at the same
// time (web/src/opening.rs). All this only where a person has nothing of their own: no page
// that the browser kept, no link.

/** One step at speed 1, and the longest time between two frames that is believed: as in web/src/clock.rs. */
const STEP_MS = 480;
const LONGEST_FRAME_MS = 100;
/** Units of the map: a cell, and the room for its numbers left and above, right and below. */
const CELL = 100;
const AXIS = [34, 10];
/** The side of a cell, in pixels: from here on there are numbers, and the largest. */
const NUMBERED_PX = 48;
const LARGEST_PX = 148;
/** How near to the middle of a cell a robot hides what is there, in cells: as in giveway-picture/src/occupied.rs. */
const REACH = 0.75;

const page = document.getElementById("page");
const picture = page.querySelector(".map");

if (isNew()) {
  const { width, height } = picture.querySelector(".floor");
  const cells = [width, height].map((side) => side.baseVal.value / CELL);
  fit(cells);
  addEventListener("resize", () => fit(cells));
  picture.classList.add("shown");
  play().catch(console.error);
}

function isNew() {
  if (/^#g|giveway/i.test(location.hash) || /[?&]embed(&|$)/.test(location.search)) {
    return false;
  }
  try {
    // As in web/src/keep/tabs.rs; the first name is that of the version before.
    return ["giveway.page", "giveway.tabs"].every((name) => localStorage.getItem(name) === null);
  } catch {
    // It keeps nothing at all.
    return true;
  }
}

/** All of the map is in sight, as the application has it (giveway-page/src/board/camera.rs). */
function fit([columns, rows]) {
  const board = picture.parentElement;
  board.style.setProperty("--columns", columns);
  board.style.setProperty("--rows", rows);
  const screen = board.getBoundingClientRect();
  const side = (space, rim) => Math.min((screen.width - rim) / (columns + space), (screen.height - rim) / (rows + space), LARGEST_PX);
  const [before, after] = AXIS;
  const numbered = side((before + after) / CELL, 0);
  const isNumbered = numbered >= NUMBERED_PX;
  picture.classList.toggle("d-all", isNumbered);
  picture.classList.toggle("d-plain", !isNumbered);
  const unit = CELL / (isNumbered ? numbered : Math.min(side(0, 6), NUMBERED_PX - 0.1));
  const shift = isNumbered ? (after - before) / 2 : 0;
  const [x, y] = [[columns, screen.width], [rows, screen.height]].map(([count, px]) => (count * CELL - px * unit) / 2 + shift);
  picture.setAttribute("viewBox", `${x} ${y} ${screen.width * unit} ${screen.height * unit}`);
}

async function play() {
  const response = await fetch("static/opening.json");
  const { costs, plan } = await response.json();
  const robots = [...picture.querySelectorAll(".agent")];
  const paths = robots.map((robot) => plan.paths[robot.querySelector(".name").textContent]);
  const marks = [...picture.querySelectorAll(".flag, .star")].map((mark) => {
    const { e, f } = mark.transform.baseVal.consolidate().matrix;
    return { mark, cell: [Math.floor(e / CELL), Math.floor(f / CELL)] };
  });
  const isCalm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  let time = 0;
  let before;
  const move = (now) => {
    // The application has taken the place over.
    if (!picture.isConnected) {
      return;
    }
    time = Math.min(time + Math.min(now - (before ?? now), LONGEST_FRAME_MS) / STEP_MS, costs.makespan);
    before = now;
    page.dataset.time = time;
    const places = paths.map((path) => place(path, isCalm ? Math.floor(time) : time));
    robots.forEach((robot, index) => {
      const [x, y] = places[index].map((at) => ((at + 0.5) * CELL).toFixed(1));
      robot.setAttribute("transform", `translate(${x} ${y})`);
    });
    for (const { mark, cell } of marks) {
      const isReached = (at) => at.every((middle, axis) => Math.abs(middle - cell[axis]) < REACH);
      mark.toggleAttribute("data-occupied", places.some(isReached));
    }
    if (time < costs.makespan) {
      requestAnimationFrame(move);
    }
  };
  requestAnimationFrame(move);
}

/** Where a robot is: it goes evenly from cell to cell; a slow move takes two steps, with none between. */
function place(path, time) {
  const stops = path.flatMap((cell, at) => (cell ? [{ cell, at }] : []));
  const next = stops.findIndex(({ at }) => at > time);
  if (next < 0) {
    return stops.at(-1).cell;
  }
  const [from, to] = [stops[next - 1], stops[next]];
  const share = (time - from.at) / (to.at - from.at);
  return from.cell.map((begin, axis) => begin + (to.cell[axis] - begin) * share);
}
