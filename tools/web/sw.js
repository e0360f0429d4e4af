// A service worker: answers without a network from what it has seen, and adds the headers that
// memory shared by threads needs, for servers that do not send them. The page works without it.
const CACHE = "gnomon-page";

const FILES = [
    "./", "page.css", "page.js", "camera.js", "contract.js", "controls.js", "difference.js", "drawers.js",
    "engine.js", "exif.js", "explain.js", "facts.js", "files.js", "found.js", "histogram.js", "maps.js",
    "messages.js", "model.js", "pixels.js", "pool.js", "presets.js", "shaders.js", "state.js", "tga.js",
    "view.js", "webgl.js", "webgl_probe.js", "why.js", "worker.js", "gnomon.wasm", "gnomon-simd.wasm",
    "pictures.txt",
];

self.addEventListener("install", (event) => {
    self.skipWaiting();
    event.waitUntil(
        // A file that is missing does not keep the others from being kept.
        caches.open(CACHE).then((cache) => Promise.allSettled(FILES.map((file) => cache.add(file))))
    );
});

self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));

function isolated(response) {
    if (response.type === "opaque" || response.type === "error" || response.type === "opaqueredirect")
        return response;
    const headers = new Headers(response.headers);
    headers.set("Cross-Origin-Opener-Policy", "same-origin");
    headers.set("Cross-Origin-Embedder-Policy", "require-corp");
    return new Response(response.body, { status: response.status, statusText: response.statusText, headers });
}

// The network first, so that a new version is seen at once.
async function answer(request) {
    try {
        const response = await fetch(request);
        if (response.ok)
            (await caches.open(CACHE)).put(request, response.clone());
        return isolated(response);
    } catch (error) {
        const kept = await caches.match(request, { ignoreSearch: true });
        if (!kept)
            throw error;
        return isolated(kept);
    }
}

self.addEventListener("fetch", (event) => {
    const { request } = event;
    if (request.method === "GET" && new URL(request.url).origin === self.location.origin)
        event.respondWith(answer(request));
});
