// Loads the program and tells how far it is; where it cannot run, one sentence says what to do.
// A copy in one file holds the wasm in <script id="wasm" type="text/plain" data-packing="deflate"> as base64, packed or not: then
// nothing is fetched.
(() => {
  "use strict";
  const root = document.documentElement;
  const element = (id) => document.getElementById(id);
  const script = document.currentScript;

  const fail = (sentence) => {
    if (root.dataset.state === "failed") return;
    root.dataset.state = "failed";
    element("sentence").textContent = sentence;
    element("again").hidden = false;
  };
  window.dzhanibekovFailed = fail;
  element("again").addEventListener("click", () => location.reload());
  window.addEventListener("error", (event) => {
    if (event.error instanceof WebAssembly.RuntimeError) fail("Something went wrong in this page: load it again.");
  });
  window.addEventListener("unhandledrejection", (event) => {
    if (event.reason instanceof WebAssembly.RuntimeError) fail("Something went wrong in this page: load it again.");
  });
  element("canvas").addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    window.dispatchEvent(new Event("dzhanibekov-over"));
    fail("The graphics of this page were taken away (by the driver, or by too many pages at once): load it again, and it goes on where it was.");
  });

  // Where it is told, over the bytes as they come.
  const counted = (response) => {
    const bytes = Number(script.dataset.bytes) || 1;
    let got = 0;
    const count = new TransformStream({
      transform(chunk, to) {
        got += chunk.byteLength;
        element("progress").value = Math.min(got / bytes, 1);
        to.enqueue(chunk);
      },
    });
    // Some servers know no type for wasm, and only that type is compiled while it comes.
    return new Response(response.body.pipeThrough(count), { headers: { "Content-Type": "application/wasm" } });
  };

  const load = async () => {
    const inline = element("wasm");
    if (inline) {
      const bytes = Uint8Array.from(atob(inline.textContent.trim()), (sign) => sign.charCodeAt(0));
      const packing = inline.dataset.packing;
      if (!packing) return bytes;
      const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(packing));
      return new Response(unpacked, { headers: { "Content-Type": "application/wasm" } });
    }
    const response = await fetch("dzhanibekov_bg.wasm");
    if (!response.ok) throw new Error(`the server answers ${response.status}`);
    return counted(response);
  };

  // The first picture goes before what keeps every processor busy; a page that nobody looks at waits for none.
  const seen = () => new Promise((done) => {
    requestAnimationFrame(() => requestAnimationFrame(done));
    setTimeout(done, 300);
  });

  const begin = async () => {
    if (typeof WebAssembly !== "object") return fail("This browser runs no WebAssembly: take a current one.");
    // The smallest module that uses a register of 128 bits.
    const wide = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];
    if (!WebAssembly.validate(new Uint8Array(wide))) return fail("This browser is too old for this page (its WebAssembly has no SIMD): take a current one.");
    if (typeof WebGL2RenderingContext === "undefined") {
      return fail("This browser draws no 3D (it has no WebGL 2): take a current one, or switch on its graphics acceleration.");
    }
    let source;
    try {
      source = await load();
      await seen();
    } catch (cause) {
      return fail(`The page could not be loaded (${cause.message}): is the connection there?`);
    }
    try {
      await wasm_bindgen({ module_or_path: source });
    } catch (cause) {
      if (cause instanceof RangeError) return fail("There is not enough memory for this page: close others, and load it again.");
      console.error(cause);
      fail(`The page could not be started (${cause.message}): load it again, or take a current browser.`);
    }
  };
  begin();

  // Kept by the browser, it opens without a connection too.
  if ("serviceWorker" in navigator && location.protocol.startsWith("http") && !element("wasm")) {
    navigator.serviceWorker.register("worker.js").catch(() => {});
  }
})();
