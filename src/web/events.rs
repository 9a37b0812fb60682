//! What the browser tells of: pointers, keys, drops, the address, other pages.

use std::rc::Rc;

use egui::{Event, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, TouchPhase, Vec2};
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{
    ClipboardEvent, DataTransfer, DragEvent, File, FileList, HtmlCanvasElement, HtmlInputElement, KeyboardEvent,
    MessageEvent, PointerEvent, ResizeObserver, ResizeObserverBoxOptions, ResizeObserverEntry, ResizeObserverOptions,
    ResizeObserverSize, WheelEvent,
};

use super::inbox::{Happening, Inbox};
use super::options::{LIGHT, REDUCED_MOTION};
use super::touch::{Finger, Phase};
use super::{dom, keyboard, text_input};
use crate::scene::{carried, link};
use crate::ui::Command;

/// Largest scene that is read, as large as one on the desktop, and largest picture of one (bytes).
const LARGEST_SCENE: usize = 1 << 20;
const LARGEST_FILE: f64 = (1 << 26) as f64;

/// Listens to everything for as long as the page lives.
pub(super) fn listen(inbox: &Rc<Inbox>, canvas: &HtmlCanvasElement) {
    pointers(inbox, canvas);
    keys(inbox);
    clipboard(inbox);
    drops(inbox);
    size(inbox, canvas);
    surroundings(inbox);
}

fn pointers(inbox: &Rc<Inbox>, canvas: &HtmlCanvasElement) {
    for name in ["pointerdown", "pointermove", "pointerup", "pointercancel", "pointerleave"] {
        let (inbox, own) = (Rc::clone(inbox), canvas.clone());
        dom::listen(canvas, name, move |event: PointerEvent| {
            let at = [event.offset_x() as f32, event.offset_y() as f32];
            if name == "pointerdown" {
                // A drag goes on past the edge of the canvas, and what had the keyboard in the page around it lets go.
                let _ = own.set_pointer_capture(event.pointer_id());
                text_input::leave_controls();
            }
            if event.pointer_type() == "touch" {
                let phase = match name {
                    "pointerdown" => Phase::Down,
                    "pointermove" => Phase::Moved,
                    _ => Phase::Up,
                };
                inbox.put(Happening::Finger(Finger { id: event.pointer_id(), at, phase }));
                return;
            }
            let pos = Pos2::new(at[0], at[1]);
            let modifiers =
                keyboard::modifiers([event.shift_key(), event.ctrl_key(), event.alt_key(), event.meta_key()]);
            let button = match event.button() {
                1 => PointerButton::Middle,
                2 => PointerButton::Secondary,
                _ => PointerButton::Primary,
            };
            let told = match name {
                "pointerdown" => Event::PointerButton { pos, button, pressed: true, modifiers },
                "pointerup" => Event::PointerButton { pos, button, pressed: false, modifiers },
                "pointermove" => Event::PointerMoved(pos),
                _ => Event::PointerGone,
            };
            inbox.put(Happening::Event(told));
        });
    }
    let to = Rc::clone(inbox);
    dom::listen(canvas, "wheel", move |event: WheelEvent| {
        event.prevent_default();
        let unit = match event.delta_mode() {
            WheelEvent::DOM_DELTA_LINE => MouseWheelUnit::Line,
            WheelEvent::DOM_DELTA_PAGE => MouseWheelUnit::Page,
            _ => MouseWheelUnit::Point,
        };
        let delta = -Vec2::new(event.delta_x() as f32, event.delta_y() as f32);
        let modifiers = keyboard::modifiers([event.shift_key(), event.ctrl_key(), event.alt_key(), event.meta_key()]);
        // Fingers that pinch a touchpad are told as a wheel with Ctrl.
        let told = if event.ctrl_key() {
            Event::Zoom((delta.y / 200.0).exp())
        } else {
            let source = MouseWheelSource::Unknown;
            Event::MouseWheel { unit, delta, phase: TouchPhase::Move, source, modifiers }
        };
        to.put(Happening::Event(told));
    });
    dom::listen(canvas, "contextmenu", |event: web_sys::Event| event.prevent_default());
}

fn keys(inbox: &Rc<Inbox>) {
    let Some(window) = dom::window() else { return };
    for (name, pressed) in [("keydown", true), ("keyup", false)] {
        let inbox = Rc::clone(inbox);
        dom::listen(&window, name, move |event: KeyboardEvent| {
            if event.is_composing() || event.default_prevented() {
                return;
            }
            let is_typing = text_input::is_typing();
            // What has the keyboard among the page's own controls answers to its keys itself.
            if text_input::control_wants(&event) {
                return;
            }
            if let Some(told) = keyboard::key_event(&event, pressed, is_typing) {
                // Signs come by the field that is typed in.
                let is_sign = keyboard::text_of(&event).is_some();
                if !(is_typing && is_sign) {
                    event.prevent_default();
                }
                inbox.put(Happening::Event(told));
            }
        });
    }
}

fn clipboard(inbox: &Rc<Inbox>) {
    let Some(document) = dom::document() else { return };
    for (name, told) in [("copy", Event::Copy), ("cut", Event::Cut)] {
        let inbox = Rc::clone(inbox);
        dom::listen(&document, name, move |event: ClipboardEvent| {
            // What is marked in the words of the page is copied as anywhere.
            let selected = dom::window().and_then(|window| window.get_selection().ok().flatten());
            if selected.is_some_and(|selection| !selection.is_collapsed()) && !text_input::is_typing() {
                return;
            }
            event.prevent_default();
            inbox.put(Happening::Event(told.clone()));
        });
    }
    let inbox = Rc::clone(inbox);
    dom::listen(&document, "paste", move |event: ClipboardEvent| {
        event.prevent_default();
        take(&inbox, event.clipboard_data(), |text| Happening::Event(Event::Paste(text)));
    });
}

fn drops(inbox: &Rc<Inbox>) {
    let Some(window) = dom::window() else { return };
    let to = Rc::clone(inbox);
    dom::listen(&window, "dragover", move |event: DragEvent| {
        event.prevent_default();
        if let Some(data) = event.data_transfer() {
            data.set_drop_effect("copy");
        }
    });
    dom::listen(&window, "dragenter", move |event: DragEvent| {
        event.prevent_default();
        to.put(Happening::Say("Let go to open the scene".to_owned()));
    });
    let inbox = Rc::clone(inbox);
    dom::listen(&window, "drop", move |event: DragEvent| {
        event.prevent_default();
        take(&inbox, event.data_transfer(), |text| Happening::Command(Command::Paste(text)));
    });
}

/// Opens the files that are handed over, or else makes of their text what happens.
fn take(inbox: &Rc<Inbox>, data: Option<DataTransfer>, told: impl Fn(String) -> Happening) {
    let Some(data) = data else { return };
    if let Some(files) = data.files().filter(|files| files.length() > 0) {
        return open_files(inbox, &files);
    }
    if let Ok(text) = data.get_data("text") {
        inbox.put(told(text));
    }
}

/// Opens what a file button chose.
pub(super) fn listen_to_choice(inbox: &Rc<Inbox>, input: &HtmlInputElement) {
    let (inbox, own) = (Rc::clone(inbox), input.clone());
    dom::listen(input, "change", move |_: web_sys::Event| {
        if let Some(files) = own.files() {
            open_files(&inbox, &files);
        }
        // The same file may be chosen again.
        own.set_value("");
    });
}

/// Opens the first of some files.
fn open_files(inbox: &Rc<Inbox>, files: &FileList) {
    if let Some(file) = files.get(0) {
        open_file(inbox, &file);
    }
}

fn open_file(inbox: &Rc<Inbox>, file: &File) {
    let name = file.name();
    if file.size() > LARGEST_FILE {
        let sentence = format!("{name} is too large: a scene has at most 1 MiB, and a picture of one 64 MiB here");
        return inbox.put(Happening::Say(sentence));
    }
    let inbox = Rc::clone(inbox);
    let bytes = wasm_bindgen_futures::JsFuture::from(file.array_buffer());
    wasm_bindgen_futures::spawn_local(async move {
        inbox.put(match bytes.await {
            Ok(bytes) => opened(name, js_sys::Uint8Array::new(&bytes).to_vec()),
            Err(_) => Happening::Say(format!("{name} could not be read")),
        });
    });
}

/// What a file of this name comes to: a scene's text, or a picture that carries the scene that drew it.
fn opened(name: String, bytes: Vec<u8>) -> Happening {
    if carried::kind_of_picture(&bytes).is_some() {
        return match carried::read(&bytes) {
            Ok(read) => Happening::Command(Command::OpenLink(link::write_at(None, &read.file, read.step, read.time))),
            Err(why) => Happening::Say(format!("{name} {why}")),
        };
    }
    if bytes.len() > LARGEST_SCENE {
        return Happening::Say(format!("{name} is larger than a scene: at most 1 MiB is read"));
    }
    match String::from_utf8(bytes) {
        Ok(text) => Happening::Command(Command::OpenText { name, text }),
        Err(_) => Happening::Say(format!("{name} is no text, and so no scene")),
    }
}

/// Follows the size of the canvas in device pixels.
fn size(inbox: &Rc<Inbox>, canvas: &HtmlCanvasElement) {
    let to = Rc::clone(inbox);
    let seen = Closure::<dyn FnMut(js_sys::Array)>::new(move |entries: js_sys::Array| {
        let Some(entry) = entries.iter().next().map(JsCast::unchecked_into::<ResizeObserverEntry>) else { return };
        let ratio = dom::window().map_or(1.0, |window| window.device_pixel_ratio());
        // Safari does not tell device pixels.
        let exact = dom::property(&entry, "devicePixelContentBoxSize");
        let exact = exact.dyn_into::<js_sys::Array>().ok().and_then(|sizes| sizes.iter().next());
        let size = if let Some(exact) = exact.map(JsCast::unchecked_into::<ResizeObserverSize>) {
            (exact.inline_size(), exact.block_size())
        } else {
            let rect = entry.content_rect();
            ((rect.width() * ratio).round(), (rect.height() * ratio).round())
        };
        to.size.set((size.0 as u32, size.1 as u32));
        to.request();
    });
    if let Ok(observer) = ResizeObserver::new(seen.as_ref().unchecked_ref()) {
        let options = ResizeObserverOptions::new();
        options.set_box(ResizeObserverBoxOptions::DevicePixelContentBox);
        observer.observe_with_options(canvas, &options);
    }
    seen.forget();
}

fn surroundings(inbox: &Rc<Inbox>) {
    let (Some(window), Some(document)) = (dom::window(), dom::document()) else { return };
    let on = |name: &'static str, happening: fn() -> Happening| {
        let inbox = Rc::clone(inbox);
        dom::listen(&window, name, move |_: web_sys::Event| inbox.put(happening()));
    };
    on("focus", || Happening::Event(Event::WindowFocused(true)));
    on("blur", || Happening::Event(Event::WindowFocused(false)));
    on("popstate", || Happening::Address);
    on("hashchange", || Happening::Address);
    on("resize", || Happening::Event(Event::WindowFocused(true)));
    for query in [LIGHT, REDUCED_MOTION] {
        let to = Rc::clone(inbox);
        if let Ok(Some(media)) = window.match_media(query) {
            dom::listen(&media, "change", move |_: web_sys::Event| to.put(Happening::Wishes));
        }
    }
    let to = Rc::clone(inbox);
    dom::listen(&document, "fullscreenchange", move |_: web_sys::Event| to.request());
    let to = Rc::clone(inbox);
    dom::listen(&window, "message", move |event: MessageEvent| to.put(Happening::Message(event)));
}
