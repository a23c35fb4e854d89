// Where flows take place: one browser a file, whose page goes from flow to flow, so that the
// programs are compiled once. Each flow has an address of its own, for which the browser has
// kept nothing yet, and complaints of its own.

import { launch, open } from "./browser.mjs";
import { dist } from "./dist.mjs";
import { serve } from "./server.mjs";

export class Stage {
  #browser;
  /** The pages that wait for the next flow, by what their contexts were opened with. */
  #warm = new Map();
  /** All hosts so far, by port: one that comes again would bring back what was kept. */
  #hosts = new Map();

  /**
   * A page that knows nothing of those before, and a host for it.
   * @param options those of `open` in browser.mjs, and `fresh` for a context that nothing was open in before
   * @returns {Promise<Visit>}
   */
  async visit({ fresh = false, width, height, ...options }) {
    this.#browser ??= launch();
    const browser = await this.#browser;
    const host = await this.#host();
    if (fresh) {
      return new Visit(host, await Warm.open(browser, { width, height, ...options }));
    }
    const key = JSON.stringify(options);
    const warm = this.#warm.get(key) ?? await Warm.open(browser, { width, height, ...options });
    // Only a flow that goes well gives it back.
    this.#warm.delete(key);
    await warm.prepare({ width, height, ...options });
    return new Visit(host, warm, () => this.#warm.set(key, warm));
  }

  async close() {
    await (await this.#browser)?.close();
    await Promise.all([...this.#hosts.values()].map((host) => host.close()));
  }

  async #host() {
    for (;;) {
      const host = await serve(dist);
      const { port } = new URL(host.url);
      if (!this.#hosts.has(port)) {
        this.#hosts.set(port, host);
        return host;
      }
      await host.close();
    }
  }
}

/** What a flow is given: `host`, `context`, `page`, and the `complaints` of that page. */
class Visit {
  #warm;
  #comeBack;

  constructor(host, warm, comeBack) {
    const { context, page, complaints } = warm;
    Object.assign(this, { host, context, page, complaints });
    this.#warm = warm;
    this.#comeBack = comeBack;
  }

  /** Ends it. A page with which something went wrong is not used again. */
  async end(isWell) {
    if (isWell && this.#comeBack) {
      await this.#warm.leave();
      this.#comeBack();
    } else {
      await this.#warm.close();
    }
    await this.host.close();
  }
}

/** A page in a context of its own. */
class Warm {
  complaints = [];

  static async open(browser, options) {
    const warm = new Warm();
    const heard = { push: (complaint) => warm.complaints.push(complaint) };
    // What a service worker fetches cannot be changed on its way.
    const { context, page } = await open(browser, { serviceWorkers: "block", ...options }, heard);
    return Object.assign(warm, { context, page });
  }

  /** Makes it as if it had been opened so. */
  async prepare({ width, height, theme = "light", colorScheme = theme, reducedMotion = "no-preference", forcedColors = "none" }) {
    this.complaints = [];
    await this.page.setViewportSize({ width, height });
    await this.page.emulateMedia({ colorScheme, reducedMotion, forcedColors });
  }

  /** Leaves nothing behind. */
  async leave() {
    const { context, page } = this;
    await context.unrouteAll({ behavior: "ignoreErrors" });
    await page.unrouteAll({ behavior: "ignoreErrors" });
    await Promise.all(context.pages().filter((other) => other !== page).map((other) => other.close()));
    await page.goto("about:blank");
    await page.mouse.move(0, 0);
  }

  async close() {
    await this.context.unrouteAll({ behavior: "ignoreErrors" });
    await this.context.close();
  }
}
