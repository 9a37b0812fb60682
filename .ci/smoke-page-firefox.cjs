// The page in another browser's hands: that it starts, looks as it should, hears keys and links, and breaks no rule of its own.
"use strict";
const puppeteer = require("puppeteer-core");
const { COUNT, begun, broken, check, complaints, end, pressed, same, serve, state, until, watch } = require("./smoke-page-common.cjs");

const { SCRATCH, SHOT } = process.env;

(async () => {
  const server = await serve();
  const base = `http://127.0.0.1:${server.address().port}/some/where/`;
  const browser = await puppeteer.launch({
    browser: "firefox",
    executablePath: process.env.FIREFOX || "/usr/bin/firefox-esr",
    // 0 is dark.
    extraPrefsFirefox: { "layout.css.prefers-color-scheme.content-override": 0 },
  });
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 720 });
  watch(page);
  await page.evaluateOnNewDocument(COUNT);
  await page.goto(`${base}?play=0#flip?time=0&scene-step=1`);
  await begun(page, "the flip");
  const difference = await same(page, SHOT, `${SCRATCH}/firefox.png`);

  await pressed(page, " ", (a, b) => !a.playing && b.playing && b.time > a.time);
  await pressed(page, " ", (a, b) => a.playing && !b.playing);
  const shade = await page.screenshot();
  await page.keyboard.press("t");
  check(await until(async () => Buffer.compare(shade, await page.screenshot()) !== 0), "t changes nothing on the page");

  // A link by the address, and back.
  await page.evaluate(() => { location.hash = "#t-handle?time=1"; });
  check(await until(async () => (await state(page)).title === "The T-handle"), "a link does not open");
  await page.evaluate(() => history.back());
  check(await until(async () => (await state(page)).title === "The flip"), "back does not come back");
  // One that is none: a sentence.
  await page.evaluate(() => { location.hash = "#flop"; });
  check(await until(() => page.evaluate(() => document.getElementById("live").textContent.includes("flop"))), "a bad link says nothing");

  await browser.close();
  server.close();
  console.error(`smoke: in Firefox the page differs from shot --panel by ${difference} in the mean`);
  end("Firefox");
})().catch(broken);
