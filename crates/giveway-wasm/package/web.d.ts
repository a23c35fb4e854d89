export * from "./types.js";

/** Loads the solver; to be awaited before anything else is called. */
export default function init(
  options?: { module_or_path: string | URL | Request | Response | BufferSource | WebAssembly.Module },
): Promise<object>;
