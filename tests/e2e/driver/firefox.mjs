// Firefox without a window, driven over WebDriver BiDi: https://w3c.github.io/webdriver-bidi/.

import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { isThere, start } from "./process.mjs";

const WebSocket = createRequire(import.meta.url)("ws");

const PATH = process.env.GIVEWAY_FIREFOX ?? "/usr/bin/firefox-esr";

/** It asks the network for nothing, and for nothing of a person; it prepares nothing that no test opens. */
const PREFERENCES = {
  "app.normandy.enabled": false,
  "app.update.disabledForTesting": true,
  "browser.aboutwelcome.enabled": false,
  "browser.newtabpage.enabled": false,
  "browser.region.network.url": "",
  "browser.safebrowsing.malware.enabled": false,
  "browser.safebrowsing.phishing.enabled": false,
  "browser.search.update": false,
  "browser.shell.checkDefaultBrowser": false,
  "browser.startup.page": 0,
  "datareporting.policy.dataSubmissionEnabled": false,
  "dom.ipc.processPrelaunch.enabled": false,
  "extensions.enabledScopes": 0,
  "extensions.update.enabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "services.settings.server": "data:,",
  "toolkit.telemetry.enabled": false,
};

export const name = "Firefox";

/** Why the tests cannot use it; nothing if they can. */
export const missing = isThere(PATH) ? undefined : `${PATH} is not there`;

/**
 * One window in a browser of its own.
 * @param options `width`, `height`, `dark`, and `proxy`: the port of this machine that answers for every name
 */
export async function launch({ width, height, dark = false, proxy }) {
  const profile = await mkdtemp(join(tmpdir(), "giveway-firefox-"));
  const preferences = {
    ...PREFERENCES,
    "layout.css.prefers-color-scheme.content-override": dark ? 0 : 1,
    ...(proxy && { "network.proxy.type": 1, "network.proxy.http": "127.0.0.1", "network.proxy.http_port": proxy }),
  };
  const lines = Object.entries(preferences).map(([key, value]) => `user_pref("${key}", ${JSON.stringify(value)});\n`);
  await writeFile(join(profile, "user.js"), lines.join(""));
  const flags = ["--headless", "--no-remote", "--profile", profile, "--remote-debugging-port", "0"];
  const browser = await start(PATH, flags, /WebDriver BiDi listening on (ws:\S+)/);
  const end = async () => {
    await browser.end();
    await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  try {
    const socket = await Socket.open(`${browser.said[1]}/session`);
    await socket.send("session.new", { capabilities: {} });
    const { contexts } = await socket.send("browsingContext.getTree", { maxDepth: 0 });
    const { context } = contexts[0];
    await socket.send("browsingContext.setViewport", { context, viewport: { width, height } });
    return new Window(socket, context, end);
  } catch (error) {
    await end();
    throw error;
  }
}

/** The window: what every browser of these tests can. */
class Window {
  constructor(socket, context, end) {
    this.socket = socket;
    this.context = context;
    this.close = end;
  }

  #send(method, parameters) {
    return this.socket.send(method, { context: this.context, ...parameters });
  }

  goto(url) {
    return this.#send("browsingContext.navigate", { url, wait: "complete" });
  }

  reload() {
    return this.#send("browsingContext.reload", { wait: "complete" });
  }

  /** What a function gives in the page; arguments and result are plain data. */
  async run(act, ...args) {
    const { type, result, exceptionDetails } = await this.socket.send("script.evaluate", {
      expression: `Promise.resolve((${act})(...${JSON.stringify(args)})).then((it) => JSON.stringify(it ?? null))`,
      awaitPromise: true,
      target: { context: this.context },
    });
    if (type === "exception") {
      throw new Error(exceptionDetails.text);
    }
    return JSON.parse(result.value);
  }

  /** Fingers, mice and keys, as in https://w3c.github.io/webdriver/#actions. */
  input(actions) {
    return this.#send("input.performActions", { actions });
  }

  /** The page as a PNG. */
  async picture() {
    const { data } = await this.#send("browsingContext.captureScreenshot", {});
    return Buffer.from(data, "base64");
  }
}

/** Commands and their answers over a WebSocket. */
class Socket {
  #asked = new Map();
  #next = 1;

  static async open(address) {
    const socket = new WebSocket(address, { perMessageDeflate: false });
    await new Promise((resolve, reject) => socket.once("open", resolve).once("error", reject));
    return new Socket(socket);
  }

  constructor(socket) {
    this.socket = socket;
    socket.on("message", (text) => {
      const { type, id, result, error, message } = JSON.parse(text);
      const asked = this.#asked.get(id);
      this.#asked.delete(id);
      if (type === "success") {
        asked?.resolve(result);
      } else if (type === "error") {
        asked?.reject(new Error(`${asked.method}: ${error}: ${message}`));
      }
    });
    socket.on("close", () => {
      for (const { method, reject } of this.#asked.values()) {
        reject(new Error(`${method}: the browser is gone`));
      }
    });
  }

  send(method, params) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#asked.set(id, { method, resolve, reject });
      this.socket.send(JSON.stringify({ id, method, params }));
    });
  }
}
