// WebKitGTK in a window of a display in memory, driven over WebDriver:
// https://w3c.github.io/webdriver/.

import { existsSync, readdirSync } from "node:fs";
import { createServer } from "node:net";

import { isThere, start } from "./process.mjs";

const DRIVER = "/usr/bin/WebKitWebDriver";
const DISPLAY = "/usr/bin/Xvfb";
/** Where Debian puts the browser, for each processor and version. */
const LIBRARIES = "/usr/lib";

/** How long a command may take, in milliseconds: less than a flow, so that the flow tells which it was. */
const PATIENCE = 60_000;

const browser = process.env.GIVEWAY_MINIBROWSER ?? miniBrowser();

function miniBrowser() {
  const folders = existsSync(LIBRARIES) ? readdirSync(LIBRARIES) : [];
  const versions = ["4.1", "6.0", "4.0"];
  const paths = folders.filter((folder) => folder.endsWith("-linux-gnu"))
    .flatMap((folder) => versions.map((version) => `${LIBRARIES}/${folder}/webkit2gtk-${version}/MiniBrowser`));
  return paths.find(isThere);
}

export const name = "WebKitGTK";

/** Why the tests cannot use it; nothing if they can. */
export const missing = [DRIVER, DISPLAY].find((path) => !isThere(path))?.concat(" is not there")
  ?? (browser ? undefined : "WebKitGTK's MiniBrowser is not there");

/**
 * One window in a browser of its own.
 * @param options `width`, `height`, `dark`, and `proxy`: the port of this machine that answers for every name
 */
export async function launch({ width, height, dark = false, proxy }) {
  const display = await start(DISPLAY, ["-displayfd", "1", "-screen", "0", `${width + 100}x${height + 300}x24`, "-nolisten", "tcp"], /^(\d+)\n/);
  let driver;
  const end = async () => {
    await driver?.end();
    await display.end();
  };
  try {
    const port = await freePort();
    driver = await start(DRIVER, ["--host=127.0.0.1", `--port=${port}`], undefined, {
      DISPLAY: `:${display.said[1]}`,
      GDK_BACKEND: "x11",
      GTK_THEME: dark ? "Adwaita:dark" : "Adwaita",
      // A display in memory has no graphics card.
      LIBGL_ALWAYS_SOFTWARE: "1",
      WEBKIT_DISABLE_DMABUF_RENDERER: "1",
    });
    return await Window.open(`http://127.0.0.1:${port}`, end, { width, height, proxy });
  } catch (error) {
    await end();
    throw error;
  }
}

/** The window: what every browser of these tests can. */
class Window {
  static async open(address, end, { width, height, proxy }) {
    const args = ["--automation", ...(proxy ? [`--proxy=http://127.0.0.1:${proxy}`] : [])];
    const capabilities = { alwaysMatch: { "webkitgtk:browserOptions": { binary: browser, args } } };
    const { sessionId } = await send("POST", `${address}/session`, { capabilities }, true);
    const window = new Window(`${address}/session/${sessionId}`, end);
    await window.#fit(width, height);
    return window;
  }

  constructor(session, end) {
    this.session = session;
    this.end = end;
  }

  #send(command, body) {
    return send(body === undefined ? "GET" : "POST", `${this.session}/${command}`, body);
  }

  /** The window is larger than the page in it. */
  async #fit(width, height) {
    await this.#send("window/rect", { width, height });
    const inner = await this.run(() => [innerWidth, innerHeight]);
    await this.#send("window/rect", { width: 2 * width - inner[0], height: 2 * height - inner[1] });
  }

  goto(url) {
    return this.#send("url", { url });
  }

  reload() {
    return this.#send("refresh", {});
  }

  /** What a function gives in the page; arguments and result are plain data. */
  run(act, ...args) {
    return this.#send("execute/sync", { script: `return (${act})(...arguments);`, args });
  }

  /** Fingers, mice and keys, as in https://w3c.github.io/webdriver/#actions. */
  input(actions) {
    return this.#send("actions", { actions });
  }

  /** The page as a PNG. */
  async picture() {
    return Buffer.from(await this.#send("screenshot"), "base64");
  }

  async close() {
    await send("DELETE", this.session).catch(() => undefined);
    await this.end();
  }
}

/** A command, again as long as the driver is not there yet. */
async function send(method, address, body, waits = false) {
  for (let tries = 0; ; tries += 1) {
    try {
      const response = await fetch(address, {
        method,
        body: body && JSON.stringify(body),
        signal: AbortSignal.timeout(PATIENCE),
      });
      const { value } = await response.json();
      if (!response.ok) {
        throw new Error(`${method} ${address}: ${value.error}: ${value.message}`);
      }
      return value;
    } catch (error) {
      if (!waits || error.cause?.code !== "ECONNREFUSED" || tries > 100) {
        throw error;
      }
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
}

function freePort() {
  return new Promise((resolve, reject) => {
    const server = createServer().once("error", reject);
    server.listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}
