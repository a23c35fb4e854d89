// The solver's worker: its program is fetched and compiled by the page, once for all
// workers, and comes as the page's first message.

import init from "./solver.js";

// A promise that is rejected in a worker is told to nobody, while an exception there is an
// event of the page.
addEventListener("message", ({ data }) => init({ module_or_path: data }).catch(reportError), { once: true });
