// Keeps the page for times without a network. scripts/page/finish.mjs puts the version
// and the files of the build in.
//
// While there is a network, the page is always the newest one. All that it is made of has
// the hash of what it holds in its path, so what is kept under a path is what the page
// means, whichever version's page and keeper meet; what is not kept is fetched. A new
// keeper waits until no page of the old one is open: so no page ever loses its files.
//
// Without a network, the page is the newest that is kept whole, not the one of the keeper
// at work: while that keeper waits for its end, a newer page has been shown already, and may
// have written data that an older page cannot read. One case is left: a newer page was
// fetched, and its keeper never came to keep it. Then there is only the older page, which has
// to leave newer data alone; that is the page's own business.

const VERSION = "{version}";
const FILES = ["{files}"];
/** A path that says what it holds. */
const HASHED = /-[0-9a-f]{8,16}[._/]/;
/** Where the catalogues of languages are. */
const LANGUAGES = /\/static\/languages\//;
/** How long a page waits for a network to answer, milliseconds: until the headers are
 * there. What follows them may take its time, as a slow network is better than none. */
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

// The whole version or nothing. The page itself comes last: a cache that has it has all of
// its version.
async function install() {
  const cache = await caches.open(PREFIX + VERSION);
  const keep = async (path) => cache.put(new URL(path, PAGE), await current(path));
  const [page] = await Promise.all([current("./"), ...FILES.filter((path) => path !== "./").map(keep)]);
  await cache.put(PAGE, page);
}

/** A file of this version; what an older one has too is not fetched again. */
async function current(path) {
  const url = new URL(path, PAGE);
  const hashed = HASHED.test(path);
  // What has no hash may stand in the browser's own cache in an older state.
  const response = (hashed && (await caches.match(url))) || (await fetch(url, { cache: hashed ? "default" : "no-cache" }));
  if (!response.ok) {
    throw new Error(`${path}: ${response.status}`);
  }
  return response;
}

async function activate() {
  const versions = (await caches.keys()).filter((name) => name.startsWith(PREFIX));
  const older = versions.filter((name) => name !== PREFIX + VERSION);
  await Promise.all(older.map((name) => caches.delete(name)));
  // The page of the first visit was there before its keeper.
  await self.clients.claim();
}

/** The newest version that is kept whole: a browser lists caches in the order of their making. */
async function newest() {
  const versions = (await caches.keys()).filter((name) => name.startsWith(PREFIX));
  for (const version of versions.reverse()) {
    const cache = await caches.open(version);
    if (await cache.match(PAGE)) {
      return cache;
    }
  }
  return caches.open(PREFIX + VERSION);
}

async function fromCache(request) {
  const cache = await caches.open(PREFIX + VERSION);
  return (await cache.match(request.url)) ?? (await caches.match(request.url)) ?? fetch(request);
}

async function fromNetwork(request, url) {
  const cache = await newest();
  const isPage = url.pathname === PAGE.pathname || url.pathname === `${PAGE.pathname}index.html`;
  const kept = await cache.match(isPage ? PAGE : url);
  if (!kept) {
    const fetched = await fetch(request);
    // Of the languages the one that is spoken is kept, and no other.
    if (fetched.ok && LANGUAGES.test(url.pathname)) {
      await cache.put(url, fetched.clone());
    }
    return fetched;
  }
  try {
    const fetched = await answered(kept.url);
    // A host in trouble, or a network that wants a login first, is no better than none.
    return fetched.ok && !fetched.redirected ? fetched : kept;
  } catch {
    return kept;
  }
}

/** What the network answers, if its headers come in time. */
async function answered(url) {
  const impatience = new AbortController();
  const timer = setTimeout(() => impatience.abort(), PATIENCE);
  try {
    return await fetch(url, { cache: "no-cache", signal: impatience.signal });
  } finally {
    clearTimeout(timer);
  }
}
