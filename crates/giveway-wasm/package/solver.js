// The worker's end: runs in a worker, calls what it is told to, posts what comes of it.

import init, * as giveway from "../web/giveway_wasm.js";

const ready = init();

addEventListener("message", async ({ data: { id, call, request } }) => {
  try {
    await ready;
    const onProgress = (event) => postMessage({ id, event });
    const given = call === "readFiles" ? request : request === undefined ? [] : [request, { onProgress }];
    const answer = giveway[call](...given);
    postMessage({ id, answer });
  } catch (thrown) {
    // A copy of an error loses what makes it one of ours.
    const { name, message, code, place, found, expected, faults } = thrown ?? {};
    postMessage({ id, error: { name, message: message ?? String(thrown), code, place, found, expected, faults } });
  }
});
