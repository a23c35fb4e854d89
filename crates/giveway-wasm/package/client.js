// The page's end: promises instead of messages. The worker hears nothing while it works,
// so what is aborted is ended with its worker, and the next has another.

const startWorker = () => new Worker(new URL("./solver.js", import.meta.url), { type: "module" });

export class Giveway {
  #start;
  #worker;
  /** What is asked for and not answered, in order; only the first is with the worker. */
  #queue = [];
  #last = 0;

  constructor(start = startWorker) {
    this.#start = start;
    for (const call of [
      "solve", "check", "explain", "change", "audit", "freedom", "price", "delays", "order", "sizing", "plan", "together", "compare", "certify",
      "exportCertificates", "verify", "convert",
    ]) {
      this[call] = (request, waiting) => this.#ask(call, request ?? null, waiting);
    }
    this.readFiles = (files, options, waiting) => this.#ask("readFiles", [files, options], waiting);
    this.schema = (waiting) => this.#ask("schema", undefined, waiting);
  }

  close() {
    this.#end();
    for (const job of this.#queue.splice(0)) {
      job.leave();
      job.reject(new DOMException("The solver was closed.", "AbortError"));
    }
  }

  #ask(call, request, { signal, onProgress } = {}) {
    return new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      const job = { id: ++this.#last, call, request, onProgress, resolve, reject };
      const abort = () => {
        const isFirst = this.#take(job);
        reject(signal.reason);
        if (isFirst) {
          this.#end();
        }
        this.#next();
      };
      job.leave = () => signal?.removeEventListener("abort", abort);
      signal?.addEventListener("abort", abort);
      this.#queue.push(job);
      this.#next();
    });
  }

  /** Takes a job off the queue; whether the worker was at it. */
  #take(job) {
    const place = this.#queue.indexOf(job);
    this.#queue.splice(place, 1);
    job.leave();
    return place === 0 && job.posted;
  }

  /** Has the first of the queue done. */
  #next() {
    const [job] = this.#queue;
    if (!job || job.posted) {
      return;
    }
    job.posted = true;
    try {
      this.#worker ??= this.#hire();
      this.#worker.postMessage({ id: job.id, call: job.call, request: job.request });
    } catch (error) {
      // What cannot be copied cannot be asked for.
      this.#take(job);
      job.reject(error);
      this.#next();
    }
  }

  #hire() {
    const worker = this.#start();
    worker.addEventListener("message", ({ data }) => this.#hear(data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.#fail(Object.assign(new Error(event.message || "The solver could not be started."), {
        name: "GivewayError", code: "broken", place: "", faults: [],
      }));
    });
    return worker;
  }

  #hear({ id, event, answer, error }) {
    const [job] = this.#queue;
    if (job?.id !== id) {
      return;
    }
    if (event) {
      job.onProgress?.(event);
    } else if (error?.code === "broken" || (error && error.name !== "GivewayError")) {
      this.#fail(Object.assign(new Error(error.message), error, { code: "broken" }));
    } else {
      this.#take(job);
      if (error) {
        job.reject(Object.assign(new Error(error.message), error));
      } else {
        job.resolve(answer);
      }
      this.#next();
    }
  }

  /** A worker that broke is of no more use; the next job has another. */
  #fail(error) {
    this.#end();
    const [job] = this.#queue;
    if (job) {
      this.#take(job);
      job.reject(error);
    }
    this.#next();
  }

  #end() {
    this.#worker?.terminate();
    this.#worker = undefined;
  }
}
