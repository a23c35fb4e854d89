// The same in TypeScript, with the worker of a page: types tell what comes back.

import { type Costs, type ExplainAnswer, type GivewayError, type Progress, type Scene, schema } from "giveway";
import { Giveway } from "giveway/worker";

const scene: Scene = {
  giveway: 1,
  map: ["....", "#.##"],
  agents: [
    { name: "a", start: [0, 0], goal: [3, 0] },
    { name: "b", start: [3, 0], goal: [0, 0], battery: { capacity: 9, initial: 9 } },
  ],
};

export const definitions: string[] = Object.keys(schema().$defs);

function words(event: Progress): string {
  switch (event.event) {
    case "bound": return `${event.cost} is at least ${event.at_least}`;
    case "plan": return `a plan of makespan ${event.costs.makespan}`;
    case "size": return `${event.conflicts} conflicts`;
    case "explained": return event.answer.words;
    case "freedom": return `${event.answer.plans?.count ?? 0} best plans so far`;
    case "priced": return event.answer.words;
    case "delays": return event.answer.words;
    case "sized": return `${event.point.robots} robots: ${event.point.status}`;
    case "traced": return event.events.map((step) => step.text).join(" ");
    case "certifying": return event.claim;
    case "exporting": return `${event.done} of ${event.of} certificates`;
  }
}

/** The VDA 5050 orders of a plan, as a text. */
export async function orders(giveway: Giveway): Promise<string | undefined> {
  const { files, order } = await giveway.order({ scene, to: ["vda5050"], late: [{ agent: "a", cell: [1, 0], steps: 2 }] });
  return order ? files?.[0]?.text : undefined;
}

export async function whyNotSooner(signal: AbortSignal): Promise<ExplainAnswer | GivewayError> {
  const giveway = new Giveway();
  try {
    const front = await giveway.solve({ scene, pareto: true, objective: ["makespan", "sum-of-costs"] }, { signal });
    const costs: Costs | null | undefined = front.front[0]?.costs;
    const { plan } = await giveway.solve({ scene, within: costs?.makespan, limits: { seconds: 5 } }, { signal });
    return await giveway.explain(
      { scene, plan: plan ?? undefined, question: { kind: "arrival", agent: "a" } },
      { signal, onProgress: (event) => console.log(words(event)) },
    );
  } catch (error) {
    return error as GivewayError;
  } finally {
    giveway.close();
  }
}
