// What the trials of the page share, whichever browser they drive: see .ci/smoke-page.
"use strict";
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const http = require("node:http");
const path = require("node:path");

const { PAGE } = process.env;
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml", ".json": "application/json" };
let failed = 0;
const fail = (words) => { console.error(`smoke: ${words}`); failed = 1; };
const check = (holds, words) => holds || fail(words);
const settled = (ms) => new Promise((done) => setTimeout(done, ms));
// Whatever takes its time is asked for until it is there.
const until = async (ask, ms = 8000) => {
  for (const end = Date.now() + ms; Date.now() < end; await settled(50)) if (await ask()) return true;
  return false;
};

// The page from a path of its own, as any server has it, and another page that shows it.
const serve = (extra) => new Promise((done) => {
  const server = http.createServer((request, response) => {
    let name = decodeURIComponent(new URL(request.url, "http://x").pathname);
    if (name === "/favicon.ico") return response.writeHead(204).end();
    if (extra && extra[name]) return response.writeHead(200, { "content-type": "text/html" }).end(extra[name]);
    if (!name.startsWith("/some/where/")) return response.writeHead(404).end();
    name = name.slice("/some/where/".length) || "index.html";
    const file = path.join(PAGE, path.normalize(name));
    if (!file.startsWith(PAGE) || !fs.existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": TYPES[path.extname(file)] || "application/octet-stream" }).end(fs.readFileSync(file));
  });
  server.listen(0, "127.0.0.1", () => done(server));
});

const complaints = [];
const watch = (page) => {
  page.on("console", (message) => { if (message.type() === "error") complaints.push(message.text()); });
  page.on("pageerror", (error) => complaints.push(String(error)));
};
// Runs in the page before all else.
const COUNT = () => {
  window.frames_seen = 0;
  const ask = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (call) => ask((time) => { window.frames_seen++; const from = performance.now(); call(time); (window.frame_times ||= []).push(performance.now() - from); });
  window.answers = [];
  window.addEventListener("message", (event) => { if (event.data && event.data.dzhanibekov === "is") window.answers.push(event.data); });
  document.addEventListener("securitypolicyviolation", (event) => console.error(`CSP: ${event.violatedDirective} ${event.blockedURI}`));
};

// Until it runs; what it says where it does not.
const begun = async (page, address) => {
  await until(() => page.evaluate(() => document.documentElement.dataset.state !== "loading"), 60000);
  const state = await page.evaluate(() => `${document.documentElement.dataset.state} ${document.getElementById("sentence").textContent}`);
  check(state.trim() === "running", `${address}: the page says: ${state}`);
};
const state = (page) => page.evaluate(() => new Promise((done, late) => {
  const hear = (event) => {
    if (!event.data || event.data.dzhanibekov !== "is") return;
    window.removeEventListener("message", hear);
    done(event.data);
  };
  window.addEventListener("message", hear);
  setTimeout(() => late(new Error("the page does not answer")), 10000);
  window.postMessage({ dzhanibekov: "state" }, "*");
}));
const pressed = async (page, key, differs) => {
  const before = await state(page);
  await page.keyboard.press(key);
  let after;
  if (!await until(async () => differs(before, after = await state(page)))) fail(`${key} does not do what it should: ${JSON.stringify(before)} → ${JSON.stringify(after)}`);
};
// Opened with another scene by a message, as other pages do.
const send = (page, link) => page.evaluate((link) => window.postMessage({ dzhanibekov: "open", link }, "*"), link);

// Paused, nothing is drawn, and what stands there is the window's picture.
const same = async (page, shot, name) => {
  await settled(9000);
  const seen = await page.evaluate(() => window.frames_seen);
  await settled(5000);
  check(await page.evaluate(() => window.frames_seen) === seen, "paused, the page draws on");
  await page.screenshot({ path: name });
  const compared = (() => {
    try { return execFileSync("compare", ["-metric", "MAE", shot, name, "null:"], { stdio: ["ignore", "pipe", "pipe"] }).toString(); } catch (error) { return error.stderr.toString(); }
  })();
  const difference = Number((/\(([^)]*)\)/.exec(compared) || [])[1]);
  // Edges are smoothed by another device: a few in a thousand of the whole range, in the mean.
  check(difference < 0.005, `the page and shot --panel differ by ${compared}`);
  return difference;
};

// The end: whether all held.
const end = (name) => {
  check(complaints.length === 0, `the browser complains: ${complaints.join("; ")}`);
  if (failed) process.exit(1);
  console.error(`smoke: the page holds in ${name}`);
};
const broken = (error) => { console.error(`smoke: ${error.stack}`); process.exit(1); };

module.exports = { COUNT, begun, broken, check, complaints, end, fail, pressed, same, send, serve, settled, state, until, watch };
