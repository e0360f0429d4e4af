// A static file server for tests, on a free port of this machine. It can send the headers that make
// a page cross-origin isolated, or not.
import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css",
    ".js": "text/javascript",
    ".wasm": "application/wasm",
    ".txt": "text/plain; charset=utf-8",
    ".json": "application/json",
    ".png": "image/png",
};

// Returns { origin, requests, close }; `requests` are the paths that were asked for.
export async function serve(folder, { isolated = false } = {}) {
    const requests = [];
    const server = createServer(async (request, response) => {
        let path = decodeURIComponent(new URL(request.url, "http://local").pathname);
        requests.push(path);
        if (path.endsWith("/"))
            path += "index.html";
        const file = join(folder, normalize(path));
        const found = file.startsWith(normalize(folder)) && (await stat(file).catch(() => null));
        if (isolated) {
            response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
            response.setHeader("Cross-Origin-Embedder-Policy", "require-corp");
        }
        if (!found || !found.isFile()) {
            response.writeHead(404, { "Content-Type": "text/plain" }).end("not found");
            return;
        }
        response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "application/octet-stream" });
        createReadStream(file).pipe(response);
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    return {
        origin: `http://127.0.0.1:${server.address().port}`,
        requests,
        close: () => {
            server.closeAllConnections();
            return new Promise((resolve) => server.close(resolve));
        },
    };
}
