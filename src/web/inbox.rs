//! What happened since the last frame, and the wish for the next one. Listeners only put things here: whatever a frame asks of
//! the browser may call them back.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;

use super::dom;
use crate::ui::Command;

/// Something that happened.
#[derive(Debug)]
pub(super) enum Happening {
    /// To the panels.
    Event(egui::Event),
    /// What is asked for by a command.
    Command(Command),
    /// A finger, in CSS pixels of the canvas.
    Finger(super::touch::Finger),
    /// The address is another one.
    Address,
    /// A message of another page, and who sent it.
    Message(web_sys::MessageEvent),
    /// What had the keyboard in the page has it no more.
    LetGo,
    /// What people want of all pages is another thing now: dark or light, less motion.
    Wishes,
    /// A sentence to be said.
    Say(String),
}

/// What happened, and whether a frame is to come.
pub(super) struct Inbox {
    happened: RefCell<Vec<Happening>>,
    /// The canvas in device pixels.
    pub(super) size: Cell<(u32, u32)>,
    is_requested: Cell<bool>,
    timer: Cell<Option<i32>>,
    frame: RefCell<Option<Closure<dyn FnMut()>>>,
    wake: RefCell<Option<Closure<dyn FnMut()>>>,
}

impl Inbox {
    /// An empty one; `frame` is called at the next beat of the screen whenever one is asked for.
    pub(super) fn new() -> Rc<Self> {
        Rc::new(Self {
            happened: RefCell::default(),
            size: Cell::default(),
            is_requested: Cell::default(),
            timer: Cell::default(),
            frame: RefCell::default(),
            wake: RefCell::default(),
        })
    }

    /// What a frame is.
    pub(super) fn set_frame(self: &Rc<Self>, mut frame: impl FnMut() + 'static) {
        let inbox = Rc::clone(self);
        *self.frame.borrow_mut() = Some(Closure::new(move || {
            inbox.is_requested.set(false);
            frame();
        }));
        let inbox = Rc::clone(self);
        *self.wake.borrow_mut() = Some(Closure::new(move || {
            inbox.timer.set(None);
            inbox.request();
        }));
    }

    /// Notes something, and asks for a frame.
    pub(super) fn put(&self, happening: Happening) {
        self.happened.borrow_mut().push(happening);
        self.request();
    }

    /// What happened since it was asked last.
    pub(super) fn take(&self) -> Vec<Happening> {
        self.happened.take()
    }

    /// Asks for a frame at the next beat of the screen.
    pub(super) fn request(&self) {
        if self.is_requested.replace(true) {
            return;
        }
        let frame = self.frame.borrow();
        let asked = frame
            .as_ref()
            .and_then(|frame| dom::window()?.request_animation_frame(frame.as_ref().unchecked_ref()).ok());
        if asked.is_none() {
            self.is_requested.set(false);
        }
    }

    /// Asks for a frame after so many milliseconds, and for no other later one.
    pub(super) fn request_after(&self, milliseconds: f64) {
        let Some(window) = dom::window() else { return };
        if let Some(timer) = self.timer.take() {
            window.clear_timeout_with_handle(timer);
        }
        let wake = self.wake.borrow();
        let Some(wake) = wake.as_ref() else { return };
        let function = wake.as_ref().unchecked_ref();
        let wait = milliseconds.ceil().clamp(0.0, 1e9) as i32;
        self.timer.set(window.set_timeout_with_callback_and_timeout_and_arguments_0(function, wait).ok());
    }
}
