//! What the session leaves to the page: downloads, the clipboard, the whole screen, the choice of a file.

use js_sys::{Array, Uint8Array};
use wasm_bindgen::JsValue;
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, HtmlElement, HtmlInputElement, Url};

use super::dom;
use super::inbox::{Happening, Inbox};

/// Gives a file to the browser's downloads; false where it takes none.
pub(super) fn download(name: &str, kind: &str, bytes: &[u8]) -> bool {
    downloaded(name, kind, bytes).is_some()
}

fn downloaded(name: &str, kind: &str, bytes: &[u8]) -> Option<()> {
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    let parts = Array::of1(&Uint8Array::from(bytes));
    let blob = Blob::new_with_u8_array_sequence_and_options(&parts, &options).ok()?;
    let address = Url::create_object_url_with_blob(&blob).ok()?;
    let link: HtmlAnchorElement = dom::made("a")?;
    link.set_href(&address);
    link.set_download(name);
    link.click();
    // The browser has it by then.
    let free = wasm_bindgen::closure::Closure::once_into_js(move || {
        let _ = Url::revoke_object_url(&address);
    });
    let free = wasm_bindgen::JsCast::unchecked_ref(&free);
    let _ = dom::window()?.set_timeout_with_callback_and_timeout_and_arguments_0(free, 60_000);
    Some(())
}

/// Puts a text on the clipboard; where the browser does not let it, the text itself is said.
pub(super) fn copy(inbox: &std::rc::Rc<Inbox>, text: String) {
    let Some(window) = dom::window() else { return };
    // Browsers offer it only to pages that came by a safe way.
    let clipboard = dom::property(&window.navigator(), "clipboard");
    if clipboard.is_undefined() {
        return inbox.put(Happening::Say(format!("Over plain http the browser lets nothing be copied; it is: {text}")));
    }
    let copied = wasm_bindgen_futures::JsFuture::from(window.navigator().clipboard().write_text(&text));
    let inbox = std::rc::Rc::clone(inbox);
    wasm_bindgen_futures::spawn_local(async move {
        if copied.await.is_err() {
            inbox.put(Happening::Say(format!("The browser did not let it be copied; it is: {text}")));
        }
    });
}

/// The whole screen, or back.
pub(super) fn toggle_fullscreen() -> Result<(), &'static str> {
    let document = dom::document().ok_or("")?;
    if is_fullscreen() {
        document.exit_fullscreen();
        return Ok(());
    }
    let root: HtmlElement = dom::element("page").ok_or("")?;
    root.request_fullscreen().map_err(|_| "The browser does not let this page fill the screen.")
}

/// Whether the page fills the screen.
pub(super) fn is_fullscreen() -> bool {
    dom::document().is_some_and(|document| document.fullscreen_element().is_some())
}

/// Lets a file be chosen.
pub(super) fn choose_file() {
    if let Some(input) = dom::element::<HtmlInputElement>("file") {
        input.click();
    }
}

/// Replaces the page by a sentence that says what to do; the still picture of the start comes back behind it.
pub(super) fn fail(sentence: &str) {
    if let Some(window) = dom::window() {
        let told = dom::property(&window, "dzhanibekovFailed");
        if let Ok(tell) = wasm_bindgen::JsCast::dyn_into::<js_sys::Function>(told) {
            let _ = tell.call1(&JsValue::NULL, &JsValue::from_str(sentence));
        }
    }
}
