//! What the page asks of the browser, in few words.

use wasm_bindgen::closure::Closure;
use wasm_bindgen::convert::FromWasmAbi;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{AddEventListenerOptions, Document, EventTarget, HtmlElement, Window};

/// The browser's window; none outside of a page.
pub(super) fn window() -> Option<Window> {
    web_sys::window()
}

/// The page's document.
pub(super) fn document() -> Option<Document> {
    window()?.document()
}

/// The element of this id, of this kind.
pub(super) fn element<T: JsCast>(id: &str) -> Option<T> {
    document()?.get_element_by_id(id)?.dyn_into().ok()
}

/// Makes an element of this kind.
pub(super) fn made<T: JsCast>(tag: &str) -> Option<T> {
    document()?.create_element(tag).ok()?.dyn_into().ok()
}

/// Calls for each event of this name for as long as the page lives; an event that may be prevented is not passive.
pub(super) fn listen<E: FromWasmAbi + 'static>(target: &EventTarget, name: &str, call: impl FnMut(E) + 'static) {
    listen_when(target, name, false, call);
}

/// The same, before anything else on the page hears of it where it is to be captured.
pub(super) fn listen_when<E: FromWasmAbi + 'static>(
    target: &EventTarget,
    name: &str,
    captures: bool,
    call: impl FnMut(E) + 'static,
) {
    let closure = Closure::<dyn FnMut(E)>::new(call);
    let options = AddEventListenerOptions::new();
    options.set_passive(false);
    options.set_capture(captures);
    let function = closure.as_ref().unchecked_ref();
    // Refused only where the name is none.
    let _ = target.add_event_listener_with_callback_and_add_event_listener_options(name, function, &options);
    closure.forget();
}

/// Whether a media query holds.
pub(super) fn matches(query: &str) -> bool {
    window().and_then(|window| window.match_media(query).ok().flatten()).is_some_and(|media| media.matches())
}

/// Sets a property of an element's style.
pub(super) fn style(element: &HtmlElement, name: &str, value: &str) {
    // Refused only where the style is read-only.
    let _ = element.style().set_property(name, value);
}

/// A property of a JavaScript object; undefined where there is none.
pub(super) fn property(object: &JsValue, name: &str) -> JsValue {
    js_sys::Reflect::get(object, &JsValue::from_str(name)).unwrap_or(JsValue::UNDEFINED)
}

/// Sets a property of a JavaScript object.
pub(super) fn set_property(object: &JsValue, name: &str, value: &JsValue) {
    // Refused only by frozen objects.
    let _ = js_sys::Reflect::set(object, &JsValue::from_str(name), value);
}
