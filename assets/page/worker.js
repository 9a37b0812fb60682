// Keeps the page's own files, so that it opens without a connection; with one, what the server has goes first.
"use strict";
const NAME = "dzhanibekov @STAMP@";
const FILES = ["./", "page.css", "page.js", "dzhanibekov.js", "dzhanibekov_bg.wasm", "icon.svg", "manifest.json"];

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(NAME).then((cache) => cache.addAll(FILES)).then(() => self.skipWaiting()));
});
self.addEventListener("activate", (event) => {
  const others = (names) => names.filter((name) => name.startsWith("dzhanibekov ") && name !== NAME);
  event.waitUntil(caches.keys().then((names) => Promise.all(others(names).map((name) => caches.delete(name)))).then(() => self.clients.claim()));
});
self.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || new URL(event.request.url).origin !== location.origin) return;
  event.respondWith(fetch(event.request).catch(async () => {
    const kept = await caches.match(event.request, { ignoreSearch: true });
    return kept || Response.error();
  }));
});
