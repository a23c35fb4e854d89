// How the plan was found, as flows open it.

/** Three robots among four pillars: its proof, its tree and its orders are short. */
export const PILLARS = {
  giveway: 1,
  name: "four pillars",
  map: ["...#..", "#.....", "...#..", ".#...."],
  objective: ["sum-of-costs", "makespan"],
  agents: [
    { name: "A1", start: [0, 0], goal: [5, 3] },
    { name: "A2", start: [2, 2], goal: [5, 0] },
    { name: "A3", start: [4, 2], goal: [1, 1] },
  ],
};

/** Solves a scene, where one is given, and looks into a method, where one is named. */
export async function look(playground, scene, method) {
  const { page } = playground;
  if (scene) {
    await playground.open({ name: "scene.json", bytes: JSON.stringify(scene) });
    await playground.shows(scene.name);
    await playground.press("Solve");
    await playground.says(/^Optimal: sum of costs/);
  }
  if (!method) {
    return;
  }
  if (playground.isPhone()) {
    const isFound = ["PIBT", "LaCAM"].includes(method);
    await playground.act(isFound ? `How it was found: ${method}` : `How it was proved: ${method.toLowerCase()}`);
  } else {
    await page.getByRole("tab", { name: "How it was proved" }).click();
    await page.getByRole("tab", { name: method, exact: true }).click();
  }
  const shown = {
    Bounds: page.getByRole("list", { name: "Steps" }),
    "Conflict tree": page.getByRole("tree", { name: "Conflict tree" }),
    "One by one": page.getByRole("group", { name: "Lanes" }),
    PIBT: page.getByRole("group", { name: "Lanes" }),
    LaCAM: page.getByRole("group", { name: "Lanes" }),
  };
  await shown[method].waitFor();
}

/** The texts of the steps that are drawn. */
export function stepsOf({ page }) {
  const rows = page.getByRole("list", { name: "Steps" }).getByRole("button");
  return rows.evaluateAll((all) => all.map((row) => row.innerText.replaceAll(/\s+/g, " ").trim()));
}
