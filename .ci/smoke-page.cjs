// What people do with the page, done by a browser with no screen: see .ci/smoke-page.
"use strict";
const { chromium } = require("playwright-core");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const { COUNT, begun, broken, check, complaints, end, fail, pressed, same, send, serve, settled, state, until, watch } = require("./smoke-page-common.cjs");

const { PROGRAM, SCRATCH, SHOT, SCENES, ONE } = process.env;
const ARGUMENTS = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
  "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

(async () => {
  const server = await serve();
  const base = `http://127.0.0.1:${server.address().port}/some/where/`;
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ARGUMENTS });
  const open = async (address, options = {}) => {
    const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, colorScheme: "dark", acceptDownloads: true, ...options });
    const page = await context.newPage();
    watch(page);
    await page.addInitScript(COUNT);
    await page.goto(base + address);
    await begun(page, address);
    return page;
  };
  const close = (page) => page.context().close();

  // The picture is the window's.
  let page = await open("?play=0#flip?time=0&scene-step=1");
  await same(page, SHOT, `${SCRATCH}/desk.png`);

  // Keys, without a click: on a scene with no steps, whose link says each thing by its key; then on one that is told in steps.
  await send(page, "#t-handle");
  await until(async () => (await state(page)).link.startsWith("#t-handle"));
  for (const [key, differs] of [
    ["Space", (a, b) => a.playing !== b.playing], ["Space", (a, b) => a.playing !== b.playing], ["ArrowRight", (a, b) => b.time > a.time], ["ArrowLeft", (a, b) => b.time < a.time],
    ["1", (a, b) => b.link.includes("spin.axis=1")], ["3", (a, b) => b.link.includes("spin.axis=3")], ["2", (a, b) => !b.link.includes("spin.axis=3")],
    ["k", (a, b) => b.link.includes("spin.omega") && b.link !== a.link], ["Control+z", (a, b) => b.link !== a.link], ["Control+Shift+z", (a, b) => b.link.includes("spin.omega") && b.link !== a.link],
    ["Shift+R", (a, b) => b.link !== a.link && !b.link.includes("spin.axis")], ["n", (a, b) => b.time > a.time], ["r", (a, b) => b.time < a.time], ["Shift+Space", (a, b) => b.time < a.time],
    ["Space", (a, b) => a.playing !== b.playing],
    ["f", (a, b) => b.link !== a.link], ["t", (a, b) => b.link.includes("view.theme=light")], ["l", (a, b) => b.link.includes("view.labels=false")],
    ["Shift+PageDown", (a, b) => b.title !== a.title], ["Shift+PageUp", (a, b) => b.title !== a.title],
  ]) await pressed(page, key, differs);
  await send(page, "#flip");
  await until(async () => (await state(page)).link.startsWith("#flip"));
  await pressed(page, "PageDown", (a, b) => b.link.includes("scene-step=2"));
  await pressed(page, "PageUp", (a, b) => b.link.includes("scene-step=1"));
  for (const key of ["s", "g", "m", "h"]) {
    const before = await page.screenshot();
    await page.keyboard.press(key);
    check(await until(async () => !before.equals(await page.screenshot())), `${key} changes nothing on the page`);
  }
  await page.keyboard.press("Escape");
  for (const key of ["F5", "F6", "F11", "F12", "Tab", "Control+r", "Control+l", "Control+t", "Control+v", "Control+0"]) {
    // Sent to the page alone: the browser's own answer would leave it.
    const [control, name] = key.startsWith("Control+") ? [true, key.slice(8)] : [false, key];
    const prevented = await page.evaluate(([ctrlKey, key]) => !window.dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey, bubbles: true, cancelable: true })), [control, name]);
    check(!prevented, `${key} is taken from the browser`);
  }
  await close(page);

  // Where it cannot run: one sentence that says what to do, and the still picture stays.
  const refused = async (what, words, stub, options = {}) => {
    const context = await browser.newContext({ viewport: { width: 800, height: 450 }, ...options });
    const page = await context.newPage();
    if (stub) await page.addInitScript(stub);
    if (options.route) await page.route("**/*.wasm", options.route);
    await page.goto(base);
    const seen = () => page.evaluate(() => [document.documentElement.dataset.state, document.getElementById("sentence").textContent, document.querySelector("#start svg").getBoundingClientRect().height > 100]);
    await until(async () => (await seen())[0] === "failed");
    const [stands, sentence, picture] = await seen();
    check(stands === "failed" && sentence.includes(words) && picture, `${what}: ${stands} “${sentence}”`);
    await context.close();
  };
  await refused("no WebAssembly", "no WebAssembly", () => { delete window.WebAssembly; });
  await refused("no SIMD", "no SIMD", () => { WebAssembly.validate = () => false; });
  await refused("no WebGL 2", "no 3D", () => { HTMLCanvasElement.prototype.getContext = () => null; });
  await refused("no memory", "not enough memory", () => { WebAssembly.instantiate = WebAssembly.instantiateStreaming = () => Promise.reject(new RangeError("no memory")); });
  await refused("no wasm at the server", "answers 404", null, { route: (route) => route.fulfill({ status: 404, body: "" }) });

  // Where it goes wrong later, in a frame or in what waits, it says so too: a page as it is published has no other words for it.
  for (const how of ["frame", "promise"]) {
    page = await open("?play=0");
    const before = complaints.length;
    await page.evaluate((how) => {
      const { exports } = new WebAssembly.Instance(new WebAssembly.Module(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 5, 1, 1, 97, 0, 0, 10, 5, 1, 3, 0, 0, 11])));
      if (how === "frame") requestAnimationFrame(() => exports.a());
      else setTimeout(() => Promise.resolve().then(() => exports.a()));
    }, how);
    check(await until(() => page.evaluate(() => document.documentElement.dataset.state === "failed" && document.getElementById("sentence").textContent.includes("load it again"))), `a fault in a ${how} is not said`);
    complaints.length = before;
    await close(page);
  }

  // Dark or light and more or less motion, as the browser has it, also while it is open; what the address says counts more.
  page = await open("?play=0#t-handle");
  const shade = async (page) => { await page.screenshot({ path: `${SCRATCH}/shade.png` }); return Number(execFileSync("convert", [`${SCRATCH}/shade.png`, "-colorspace", "gray", "-format", "%[fx:mean]", "info:"]).toString()); };
  check(await shade(page) < 0.35, "where dark is wanted the page is light");
  await page.emulateMedia({ colorScheme: "light" });
  check(await until(async () => await shade(page) > 0.65), "the page stays dark where it is to be light from now on");
  await close(page);
  page = await open("?play=0&theme=dark#t-handle", { colorScheme: "light" });
  check(await shade(page) < 0.35, "?theme=dark is light");
  // What changes in a scene leaves no steps for the browser's back.
  const steps = await page.evaluate(() => history.length);
  for (let at = 0; at < 3; at++) { await page.keyboard.press("k"); await settled(400); }
  check((await state(page)).link.includes("spin.omega") && await page.evaluate(() => history.length) === steps, "changes fill the browser's history");
  // Kept from drawing for a while, as one that is hidden, it goes on where it was.
  await page.keyboard.press("Space");
  await until(async () => (await state(page)).playing);
  const hidden = await state(page);
  await page.evaluate(() => { const end = performance.now() + 3000; while (performance.now() < end); });
  const back = await state(page);
  check(back.time - hidden.time < 2, `kept from drawing for 3 s, time goes from ${hidden.time} s to ${back.time} s`);
  await close(page);

  // By the keyboard alone, and by ear.
  page = await open("?play=0");
  const find = (words) => page.evaluate((words) => [...document.querySelectorAll("#mirror button")].some((button) => button.textContent.startsWith(words)), words);
  await until(() => find("play"));
  const names = await page.evaluate(() => [...document.querySelectorAll("#mirror button, #mirror input, #mirror p")].map((element) => element.ariaLabel || element.textContent));
  for (const wanted of ["The flip", "play", "time (s)", "Motion", "edge a"]) check(names.some((name) => name.includes(wanted)), `nothing is called “${wanted}”: ${names.join(" | ")}`);
  await page.evaluate(() => [...document.querySelectorAll("#mirror button")].find((button) => button.textContent.startsWith("play")).focus());
  await page.keyboard.press("Enter");
  check(await until(async () => (await state(page)).playing), "Enter on “play” does not play");
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Space");
  check(await until(async () => !(await state(page)).playing), "Space does nothing after a control was left");
  check(await page.evaluate(() => { window.postMessage({ dzhanibekov: "goto", time: 1.9 }, "*"); window.postMessage({ dzhanibekov: "play" }, "*"); return document.getElementById("live").ariaLive; }) === "polite", "nothing is read aloud by itself");
  check(await until(() => page.evaluate(() => document.getElementById("live").textContent.startsWith("flip at"))), "a flip is not read aloud");
  await close(page);

  // Links: of every scene, and back and forward.
  page = await open("?play=0");
  const scenes = JSON.parse(fs.readFileSync(SCENES)).map((scene) => scene.name);
  check(scenes.length > 5, "the program lists no scenes");
  for (const name of scenes) {
    const link = async (asked) => {
      await send(page, asked);
      await until(async () => (await state(page)).link.startsWith(`#${name}`));
      return (await state(page)).link;
    };
    const first = await link(`#${name}?time=0.5`);
    check(first.startsWith(`#${name}`) && first.includes("time=0.5"), `#${name} opens ${first}`);
    const again = await link(first);
    check(first === again, `${first} comes back as ${again}`);
  }
  await close(page);
  page = await open("?play=0#flip");
  await page.keyboard.press("Shift+PageDown");
  check(await until(() => !page.url().includes("#flip")), `the address stays ${page.url()}`);
  await page.goBack();
  check(await until(async () => (await state(page)).link.startsWith("#flip")), "back does not come back");
  await page.goForward();
  check(await until(async () => !(await state(page)).link.startsWith("#flip")), "forward does not go forward");
  await page.evaluate(() => { location.hash = "#flop"; });
  check(await until(() => page.evaluate(() => document.getElementById("live").textContent.includes("flop"))), "a bad link says nothing");
  // One that no scene's name is near: all names, and no command, which a page has not.
  await page.evaluate(() => { location.hash = "#qqqqq"; });
  check(await until(() => page.evaluate(() => { const said = document.getElementById("live").textContent; return said.includes("there are axis-1, ") && !said.includes("`dzhanibekov"); })), "a bad link does not say which there are");
  await close(page);

  // The motion as numbers: those of the program.
  page = await open("?play=0");
  let [numbers, others, worst] = [0, 0, 0];
  for (const { name, omega, moments, inertia, samples } of JSON.parse(fs.readFileSync("tests/harder_cases.json")).cases) {
    const body = moments ? `body.moments=${JSON.stringify(moments)}` : `body.inertia=${JSON.stringify(inertia)}`;
    const link = `#axis-1?${encodeURI(`${body}&spin.omega=${JSON.stringify(omega)}`)}&motion.method=closed-form`;
    const times = samples.map((sample) => sample.t);
    const wanted = execFileSync(PROGRAM, ["trace", link, "--quiet", `--at=${times.join(",")}`]).toString().trim().split("\n").slice(1).map((row) => row.split(",").map(Number));
    await send(page, link);
    await page.evaluate((times) => { window.answers = []; window.postMessage({ dzhanibekov: "trace", times }, "*"); }, times);
    await until(() => page.evaluate(() => window.answers.some((answer) => answer.rows || answer.error)));
    const rows = await page.evaluate(() => window.answers.filter((answer) => answer.rows).map((answer) => answer.rows.map((row) => [...row]))[0]);
    if (!rows || rows.length !== wanted.length) { fail(`${name}: the page has no numbers: ${JSON.stringify(await page.evaluate(() => window.answers))}`); continue; }
    wanted.forEach((row, at) => row.forEach((number, column) => {
      numbers++;
      if (Object.is(rows[at][column], number)) return;
      others++;
      // Columns of a kind: time, R, M, Ω, L, energy.
      const kind = [[0, 1], [1, 10], [10, 13], [13, 16], [16, 19], [19, 20]].find(([from, to]) => from <= column && column < to);
      const size = Math.max(...row.slice(...kind).map(Math.abs));
      worst = Math.max(worst, Math.abs(rows[at][column] - number) / size);
    }));
  }
  // The page has its sines, exponentials and the like from Rust's library, the program from the C library: each right to a unit in the
  // last place, not always the same one; with the same library all bits are the same. Either result is some ten roundings of numbers up
  // to 1 away from the truth, each half of 2⁻⁵², so the two are no further apart than ten times that.
  check(worst <= 10 * Number.EPSILON, `the numbers are others by ${worst} of their vector`);
  console.error(`smoke: of ${numbers} numbers of the motion ${others} are others than the program's, at most by ${worst.toExponential(1)} of their vector`);
  await close(page);

  // Files.
  page = await open("?play=0");
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(["title = \"Mine\"\n[body]\nbox = [0.3, 0.2, 0.1]\nmass = 1\n[spin]\naxis = 1\nrate = 2\n"], "mine.toml"));
    document.getElementById("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  check(await until(async () => (await state(page)).title === "Mine" && (await state(page)).link.startsWith("#scene=")), "a dropped scene does not open");
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+s")]);
  check(download.suggestedFilename() === "mine.toml" && fs.readFileSync(await download.path(), "utf8").includes("0.3"), "the scene is not downloaded");
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.setData("text/plain", "#flip?spin.rate=8");
    document.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  });
  check(await until(async () => (await state(page)).link.includes("spin.rate=8")), "a pasted link does not open");
  const long = `title = "Long"\ntext = "${"A long text about the motion. ".repeat(300)}"\n[body]\nbox = [0.3, 0.2, 0.1]\nmass = 1\n[spin]\naxis = 1\nrate = 2\n`;
  await page.evaluate((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "long.toml"));
    document.getElementById("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, long);
  check(await until(async () => (await state(page)).title === "Long" && page.url().includes("#scene=")) && page.url().length < long.length / 10, `a long scene has an address of ${page.url().length} signs`);
  await send(page, "#flip?spin.rate=8");
  await until(async () => (await state(page)).link.includes("spin.rate=8"));
  const press = async (words) => await until(() => find(words)) && page.evaluate((words) => [...document.querySelectorAll("#mirror button")].find((button) => button.textContent.startsWith(words)).click(), words);
  await press("Picture");
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), press("open a file")]);
  await chooser.setFiles({ name: "chosen.toml", mimeType: "application/toml", buffer: Buffer.from("title = \"Chosen\"\n[body]\nbox = [0.3, 0.2, 0.1]\nmass = 1\n[spin]\naxis = 1\nrate = 2\n") });
  check(await until(async () => (await state(page)).title === "Chosen"), "a chosen file does not open");
  await send(page, "#flip");
  await until(async () => (await state(page)).link.startsWith("#flip"));
  const [picture] = await Promise.all([page.waitForEvent("download"), press("write picture")]);
  check(picture.suggestedFilename() === "the-flip.png" && fs.statSync(await picture.path()).size > 10000, "the picture is not downloaded");

  // The graphics taken away, and back where it was.
  if ((await state(page)).playing) await pressed(page, "Space", (a, b) => !b.playing);
  const before = (await state(page)).link;
  complaints.length || await page.evaluate(() => document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context").loseContext());
  await settled(700);
  check(await page.evaluate(() => document.documentElement.dataset.state === "failed" && document.getElementById("sentence").textContent.includes("load it again")), "a lost context says nothing");
  complaints.length = 0;
  await page.click("#again");
  await page.waitForFunction(() => document.documentElement.dataset.state === "running", null, { timeout: 60000 });
  const after = (await state(page)).link;
  check(after === before, `after a lost context ${before} is ${after}`);

  // Without a connection.
  await settled(1500);
  await page.context().setOffline(true);
  await page.reload();
  await page.waitForFunction(() => document.documentElement.dataset.state === "running", null, { timeout: 60000 }).catch(() => fail("without a connection it does not open again"));
  await close(page);
  complaints.splice(0, complaints.length, ...complaints.filter((words) => !words.includes("ERR_INTERNET_DISCONNECTED")));

  // In another page, of another origin.
  const other = await serve({ "/slide.html": `<body style="margin:0;background:#234"><iframe id="it" width="800" height="450" src="${base}?embed&theme=light#flip?scene-step=6"></iframe></body>` });
  const context = await browser.newContext({ viewport: { width: 900, height: 500 }, reducedMotion: "reduce" });
  page = await context.newPage();
  watch(page);
  await page.addInitScript(() => { window.told = []; window.addEventListener("message", (event) => window.told.push(event.data)); });
  await page.goto(`http://localhost:${other.address().port}/slide.html`);
  await page.waitForFunction(() => window.told.some((told) => told.dzhanibekov === "ready"), null, { timeout: 60000 }).catch(() => fail("the page in another one is never ready"));
  check(await page.evaluate(() => window.told[0] && window.told[0].playing === false), "where less motion is wanted it moves at once");
  const asked = async (message) => {
    await page.evaluate((message) => { window.told = []; document.getElementById("it").contentWindow.postMessage(message, "*"); }, message);
    await page.waitForFunction(() => window.told.length > 0, null, { timeout: 10000 }).catch(() => fail(`no answer to ${JSON.stringify(message)}`));
    return page.evaluate(() => window.told[0] || {});
  };
  check((await asked({ dzhanibekov: "goto", time: 2.5 })).time === 2.5, "goto does not go");
  check((await asked({ dzhanibekov: "play" })).playing === true, "play does not play");
  check((await asked({ dzhanibekov: "pause" })).playing === false, "pause does not pause");
  check((await asked({ dzhanibekov: "open", link: "#t-handle?time=1" })).link.startsWith("#t-handle"), "open does not open");
  check((await asked({ dzhanibekov: "step", count: 3 })).time > 1, "step does not step");
  // The strip of time is there where the pointer moves, and goes where it rests.
  const bare = await page.screenshot();
  await page.mouse.move(400, 200);
  check(await until(async () => !bare.equals(await page.screenshot({ path: `${SCRATCH}/slide.png` }))), "in another page the pointer brings no strip of time");
  check(await until(async () => bare.equals(await page.screenshot())), "in another page the strip of time stays over the picture");
  await context.close();
  other.close();

  // In the hand.
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  page = await open("?play=0#flip?scene-step=6", phone);
  await settled(500);
  await page.screenshot({ path: `${SCRATCH}/upright.png` });
  const touch = await page.context().newCDPSession(page);
  const fingers = (type, points) => touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const drag = async (from, to) => {
    await fingers("touchStart", from);
    for (let part = 1; part <= 5; part++) { await fingers("touchMove", from.map(([x, y], i) => [x + (to[i][0] - x) * part / 5, y + (to[i][1] - y) * part / 5])); await settled(40); }
    await fingers("touchEnd", []);
    await settled(200);
  };
  const home = (await state(page)).link;
  await drag([[195, 330]], [[250, 350]]);
  check(await until(async () => (await state(page)).link !== home), "one finger turns nothing");
  const turned = (await state(page)).link;
  await drag([[150, 330], [240, 330]], [[110, 330], [280, 330]]);
  check(await until(async () => (await state(page)).link !== turned), "two fingers zoom nothing");
  check((await state(page)).link.indexOf("spin.omega") < 0, "two fingers start another motion");
  await page.touchscreen.tap(32, 820);
  await settled(600);
  await page.screenshot({ path: `${SCRATCH}/sheet.png` });
  check(await page.evaluate(() => window.scrollY === 0 && visualViewport.scale === 1), "the page itself scrolls or zooms");
  // What is longer than the screen is dragged: the panel, and the sheet of keys.
  for (const [name, clip, from, to] of [["panel", { x: 12, y: 470, width: 300, height: 250 }, [200, 700], [200, 500]], ["sheet of keys", { x: 60, y: 130, width: 200, height: 400 }, [250, 560], [250, 160]]]) {
    if (name !== "panel") await page.keyboard.press("h");
    await settled(1000);
    const before = await page.screenshot({ clip });
    await drag([from], [to]);
    check(await until(async () => !before.equals(await page.screenshot({ clip }))), `a finger does not move the ${name}`);
  }
  await close(page);
  page = await open("?play=0#flip?scene-step=6", { ...phone, viewport: { width: 844, height: 390 } });
  await settled(500);
  await page.screenshot({ path: `${SCRATCH}/lying.png` });
  await close(page);

  // In one file, from the disk.
  const alone = await browser.newContext({ viewport: { width: 800, height: 450 } });
  page = await alone.newPage();
  watch(page);
  await page.addInitScript(COUNT);
  const loads = [];
  page.on("request", (request) => loads.push(request.url()));
  await page.goto(`file://${ONE}`);
  await page.waitForFunction(() => document.documentElement.dataset.state === "running", null, { timeout: 60000 }).catch(() => fail("the page in one file does not run"));
  const first = await state(page);
  check(first.title === "The T-handle" && first.time >= 1 && first.playing, `the page in one file begins with ${JSON.stringify(first)}`);
  check(await until(async () => (await state(page)).time > first.time), "the page in one file stands still");
  check(loads.every((address) => address.startsWith("data:") || address === `file://${ONE}`), `the page in one file loads ${loads.join(", ").slice(0, 300)}`);
  await page.screenshot({ path: `${SCRATCH}/one.png` });
  await page.goto(`file://${ONE}?embed=0&play=0`);
  await page.waitForFunction(() => document.documentElement.dataset.state === "running", null, { timeout: 60000 }).catch(() => fail("the page in one file does not run"));
  check(await until(async () => !(await state(page)).playing), "the page in one file hears no wish");
  await alone.close();

  // How fast it is: told, and held only loosely, for machines differ.
  page = await open("#flip");
  await settled(3000);
  const times = await page.evaluate(() => window.frame_times.slice(5).sort((a, b) => a - b));
  const loaded = await page.evaluate(() => performance.getEntriesByName("first frame")[0]?.startTime ?? 0);
  console.error(`smoke: the main thread takes ${times[times.length >> 1]?.toFixed(1)} ms a frame, the first frame came after ${Math.round(loaded)} ms`);
  await close(page);
  await browser.close();

  // Twice the pixels.
  const sharp = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: [...ARGUMENTS, "--force-device-scale-factor=2"] });
  const sharpPage = await (await sharp.newContext({ viewport: null })).newPage();
  watch(sharpPage);
  await sharpPage.goto(`${base}?play=0`);
  await sharpPage.waitForFunction(() => document.documentElement.dataset.state === "running", null, { timeout: 60000 });
  await settled(300);
  check(await sharpPage.evaluate(() => { const c = document.getElementById("canvas"); return devicePixelRatio === 2 && Math.abs(c.width - 2 * c.clientWidth) <= 1; }), "on a fine screen the pixels are coarse");
  await sharp.close();
  server.close();

  end("Chromium");
})().catch(broken);
