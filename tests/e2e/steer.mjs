// A plan of one's own, as far as flows have it in common.

/** Two rows: A1 goes along the upper one, A2 along the lower one, the other way. */
const ROWS = {
  giveway: 1,
  name: "two rows",
  map: ["....", "....", "####"],
  agents: [
    { name: "A1", start: [0, 0], goal: [3, 0] },
    { name: "A2", start: [3, 1], goal: [0, 1] },
  ],
};

/** That scene, solved, at time 0. */
export async function rows(playground) {
  await playground.open({ name: "rows.json", bytes: Buffer.from(JSON.stringify(ROWS)) });
  await playground.shows("two rows");
  await playground.press("Solve");
  await playground.says(/^Optimal: makespan 3/);
  await playground.press("To start");
  await playground.reaches(0);
}

/** An agent is led by hand from its start, which is this cell. */
export async function lead(playground, name, ...cell) {
  await playground.showTab("Inspector");
  // Not on the board: there it is pressed where it is seen, which may be on its way.
  await playground.inspector.getByRole("button", { name: new RegExp(`^${name}\\b`) }).first().click();
  await playground.inspector.getByRole("button", { name: `Lead ${name} by hand` }).click();
  await playground.says(new RegExp(`^${name} is at \\(${cell.join(", ?")}\\) at time`));
}

/** Presses the buttons of the inspector that lead. */
export async function steps(playground, ...names) {
  for (const name of names) {
    await playground.inspector.getByRole("button", { name, exact: true }).click();
  }
}
