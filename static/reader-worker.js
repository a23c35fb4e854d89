// The reader's worker: reads and writes other people's files. Its program is fetched and
// compiled by the page when such a file is opened first, and comes as the first message.

import init from "./reader.js";

// A promise that is rejected in a worker is told to nobody, while an exception there is an
// event of the page.
addEventListener("message", ({ data }) => init({ module_or_path: data }).catch(reportError), { once: true });
