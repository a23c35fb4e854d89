// The analyst's worker: answers questions. Its program is fetched and compiled by the page
// when the first of them is asked, and comes as the page's first message.

import init from "./analyst.js";

// A promise that is rejected in a worker is told to nobody, while an exception there is an
// event of the page.
addEventListener("message", ({ data }) => init({ module_or_path: data }).catch(reportError), { once: true });
