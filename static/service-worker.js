// Keeps the page for times without a network. scripts/finish-page.mjs puts the version
// and the files of the build in.
//
// While there is a network, the page is always the newest one. All that it is made of has
// the hash of what it holds in its path, so what is kept under a path is what the page
// means, whichever version's page and keeper meet; what is not kept is fetched. A new
// keeper waits until no page of the old one is open: so no page ever loses its files.

const VERSION = "{version}";
const FILES = ["{files}"];
/** A path that says what it holds. */
const HASHED = /-[0-9a-f]{8,16}[._/]/;
/** How long a page waits for a network that does not answer, milliseconds. */
const PATIENCE = 3000;

const PAGE = new URL("./", self.registration.scope);
const PREFIX = `giveway ${PAGE.pathname} `;

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(activate()));

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const url = new URL(request.url);
  const ours = url.origin === PAGE.origin && url.pathname.startsWith(PAGE.pathname);
  if (request.method === "GET" && ours) {
    event.respondWith(HASHED.test(url.pathname) ? fromCache(request) : fromNetwork(request, url));
  }
});

// The whole version or nothing; what an older one has too is not fetched again.
async function install() {
  const cache = await caches.open(PREFIX + VERSION);
  await Promise.all(FILES.map(async (path) => {
    const url = new URL(path, PAGE);
    const hashed = HASHED.test(path);
    // What has no hash may stand in the browser's own cache in an older state.
    const response = (hashed && (await caches.match(url))) || (await fetch(url, { cache: hashed ? "default" : "no-cache" }));
    if (!response.ok) {
      throw new Error(`${path}: ${response.status}`);
    }
    await cache.put(url, response);
  }));
}

async function activate() {
  const versions = (await caches.keys()).filter((name) => name.startsWith(PREFIX));
  const older = versions.filter((name) => name !== PREFIX + VERSION);
  await Promise.all(older.map((name) => caches.delete(name)));
  // The page of the first visit was there before its keeper.
  await self.clients.claim();
}

async function fromCache(request) {
  const cache = await caches.open(PREFIX + VERSION);
  return (await cache.match(request.url)) ?? fetch(request);
}

async function fromNetwork(request, url) {
  const cache = await caches.open(PREFIX + VERSION);
  const isPage = url.pathname === PAGE.pathname || url.pathname === `${PAGE.pathname}index.html`;
  const kept = await cache.match(isPage ? PAGE : url);
  if (!kept) {
    return fetch(request);
  }
  try {
    const fetched = await fetch(kept.url, { cache: "no-cache", signal: AbortSignal.timeout(PATIENCE) });
    // A host in trouble, or a network that wants a login first, is no better than none.
    return fetched.ok && !fetched.redirected ? fetched : kept;
  } catch {
    return kept;
  }
}
