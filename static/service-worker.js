// Keeps the page for times without a network. scripts/finish-page.mjs puts the version
// and the files of the build in.
//
// A version's files are kept together, and all but the page itself have the hash of what
// they hold in their names. So a page always gets what belongs to it: one that was open
// while a new version arrived still finds its own files in the older copy.

const VERSION = "{version}";
const FILES = ["{files}"];

const PREFIX = `giveway ${new URL(self.registration.scope).pathname} `;
const PAGE = new URL("./", self.registration.scope);

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(activate()));

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const url = new URL(request.url);
  const ours = url.origin === PAGE.origin && url.pathname.startsWith(PAGE.pathname);
  if (request.method === "GET" && ours) {
    event.respondWith(answer(request, url));
  }
});

// The whole version or nothing; what an older one has too is not fetched again.
async function install() {
  const cache = await caches.open(PREFIX + VERSION);
  await Promise.all(FILES.map(async ({ path, hashed }) => {
    const url = new URL(path, PAGE);
    const kept = hashed ? await caches.match(url) : undefined;
    // What has no hash in its name may stand in the browser's own cache in an older state.
    const response = kept ?? (await fetch(url, { cache: hashed ? "default" : "no-cache" }));
    if (!response.ok) {
      throw new Error(`${path}: ${response.status}`);
    }
    await cache.put(url, response);
  }));
  // The next navigation gets the new version; pages that are open keep their own files.
  await self.skipWaiting();
}

// Pages of the version before may still be open; of those before that, hardly.
async function activate() {
  const versions = (await caches.keys()).filter((name) => name.startsWith(PREFIX));
  const older = versions.filter((name) => name !== PREFIX + VERSION);
  await Promise.all(older.slice(0, -1).map((name) => caches.delete(name)));
  // Pages of an older version have been handed over already; the first has no keeper yet.
  if (older.length === 0) {
    await self.clients.claim();
  }
}

async function answer(request, url) {
  const isPage = url.pathname === PAGE.pathname || url.pathname === `${PAGE.pathname}index.html`;
  const current = await caches.open(PREFIX + VERSION);
  const kept = (await current.match(isPage ? PAGE : url)) ?? (await caches.match(url));
  return kept ?? fetch(request);
}
