//! The page while it is open: what happened becomes commands, commands change the session, the session becomes a picture.
//!
//! Nothing is drawn unless something changed.

use std::cell::RefCell;
use std::rc::Rc;

use egui::{Event, OutputCommand, RawInput, Rect, Vec2, ViewportId};
use web_sys::HtmlCanvasElement;
use web_time::Instant;

use super::address::Address;
use super::inbox::{Happening, Inbox};
use super::mirror::{self, Mirror};
use super::options::{LIGHT, Options, REDUCED_MOTION};
use super::touch::{Fingers, Place};
use super::{cursor, dom, effects, keyboard, message, remember, text_input};
use crate::objects;
use crate::scene::{Scene, SceneError, Theme, link};
use crate::session::{Effect, Remembered, Session, slug};
use crate::stage::{self, Around, Pacer, Pending, Stage};
use crate::ui::{Command, Front, Panels, style};

/// What is said where the graphics device is gone.
const LOST: &str = "The graphics of this page were taken away (by the driver, or by too many pages at once): load it again, and it goes on where it was.";

/// How to go on with a finger, said once at the beginning; on a screen in the hand there is more to it.
const FIRST_WORDS: &str = "Drag to turn · two fingers zoom · the arrow at the bottom goes on";
const FIRST_WORDS_IN_HAND: &str =
    "Drag to turn · two fingers zoom · the arrow at the bottom goes on · the three lines open all else";
/// Whether a finger is what the screen is pointed at with.
const FINGERS: &str = "(pointer: coarse)";

/// The open page.
pub(super) struct Page {
    inbox: Rc<Inbox>,
    canvas: HtmlCanvasElement,
    options: Options,
    session: Session,
    panels: Panels,
    stage: Stage,
    pacer: Pacer,
    fingers: Fingers,
    address: Address,
    mirror: Mirror,
    /// The flip that comes next (s).
    next_flip: Option<f64>,
    remembered: Remembered,
    /// What was last seen of the session's jumps in time.
    jumps: u64,
    began: Instant,
    title: String,
    /// Pictures on their way back from the device, and what they are called.
    pending: Vec<(Pending, String)>,
    /// When something is to be drawn although simulated time stands.
    repaint_at: Option<Instant>,
    focused: bool,
    frames: u32,
    /// Nothing can be drawn any more.
    is_over: bool,
}

/// The session that the address asks for: a link that is none is said, with the flip behind it.
pub(super) fn session(options: Options, remembered: &Remembered) -> Result<Session, SceneError> {
    let root = dom::document().and_then(|document| document.document_element());
    let own = root.and_then(|root| root.get_attribute("data-scene")).unwrap_or_default();
    let fragment = Some(Address::read()).filter(|fragment| fragment.len() > 1).unwrap_or(own);
    let flip = || link::read("#");
    let asked = if fragment.is_empty() { flip() } else { link::read(&fragment) };
    let found = asked.and_then(|read| Ok((checked(&read)?, read)));
    let (scene, read, why): (Scene, _, _) = match found {
        Ok((scene, read)) => (scene, read, None),
        Err(why) => {
            let read = flip()?;
            (checked(&read)?, read, Some(why))
        }
    };
    let now = Instant::now();
    let mut session = Session::new(scene, Vec::new(), remembered, now);
    session.shown_by(Front::Page);
    if dom::matches(FINGERS) {
        session.say(if dom::matches(remember::SMALL) { FIRST_WORDS_IN_HAND } else { FIRST_WORDS });
    }
    if options.embed {
        session.embed();
    }
    session.set_gliding(!dom::matches(REDUCED_MOTION));
    session.prefer_theme(theme(options));
    if let Some(time) = read.time {
        session.apply(Command::GoTo(time), now);
    }
    if options.loops {
        session.apply(Command::LoopFlip, now);
    }
    if !options.play && session.is_playing() {
        session.apply(Command::PlayPause, now);
    }
    if let Some(why) = why {
        session.say(why.to_string());
    }
    Ok(session)
}

/// Dark or light, as the address asks for or else the browser.
fn theme(options: Options) -> Theme {
    options.theme.unwrap_or(if dom::matches(LIGHT) { Theme::Light } else { Theme::Dark })
}

/// The scene of a link, at its step: what is told in steps begins with the first.
fn checked(read: &link::Link) -> Result<Scene, SceneError> {
    objects::check_at(&read.file, read.step.or(read.file.first_step()))
}

impl Page {
    /// Opens it on a canvas.
    pub(super) fn new(
        inbox: Rc<Inbox>,
        canvas: HtmlCanvasElement,
        options: Options,
        (session, remembered): (Session, Remembered),
        stage: Stage,
    ) -> Self {
        let now = Instant::now();
        if dom::matches(FINGERS) {
            style::for_fingers(stage.context());
        }
        if keyboard::is_mac() {
            stage.context().set_os(egui::os::OperatingSystem::Mac);
        }
        let mut address = Address::default();
        address.follow(&session);
        Self {
            inbox,
            canvas,
            options,
            session,
            panels: Panels::default(),
            stage,
            pacer: Pacer::new(now),
            fingers: Fingers::default(),
            address,
            mirror: Mirror::default(),
            next_flip: None,
            remembered,
            jumps: 0,
            began: now,
            title: String::new(),
            pending: Vec::new(),
            repaint_at: None,
            focused: true,
            frames: 0,
            is_over: false,
        }
    }

    /// A frame: at each beat of the screen for as long as something changes.
    pub(super) fn frame(&mut self) {
        let now = Instant::now();
        let (width, height) = self.inbox.size.get();
        if width == 0 || height == 0 || self.is_over {
            return;
        }
        if self.stage.is_lost() {
            self.end();
            return effects::fail(LOST);
        }
        self.stage.resize(width, height);
        let ratio = dom::window().map_or(1.0, |window| window.device_pixel_ratio()) as f32;
        let css = Vec2::new(width as f32, height as f32) / ratio;
        let zoom = stage::zoom_on_page(css.x, css.y, self.session.text_size(), self.session.is_presenting());
        self.stage.context().set_zoom_factor(zoom);
        let place = Place { picture: self.stage.picture(), zoom, pixels_per_point: ratio * zoom };

        let mut events = vec![];
        let mut commands = vec![];
        let wait = self.receive(now, &place, (&mut events, &mut commands));
        self.apply(commands);
        self.pass_time(now);

        let title = stage::title(&self.session);
        if title != self.title {
            if let Some(document) = dom::document() {
                document.set_title(&title);
            }
            self.title = title;
        }
        let around = Around {
            title: &self.title,
            real_time_factor: self.pacer.real_time_factor(),
            fullscreen: effects::is_fullscreen(),
        };
        let input = self.input(events, css / zoom, ratio, now);
        let at = self.milliseconds(now);
        if self.mirror.is_due(at, self.session.is_moving()) {
            self.stage.context().enable_accesskit();
        } else {
            self.stage.context().disable_accesskit();
        }
        let drawn = self.stage.draw(input, &mut self.session, &mut self.panels, around, || {});
        self.follow(&drawn.platform, zoom);
        if let Some(tree) = &drawn.platform.accesskit_update {
            self.mirror.update(tree, &self.inbox, at);
        }
        self.say_aloud();
        let commands: Vec<Command> =
            drawn.commands.into_iter().filter(|command| !self.fingers.refuse(command)).collect();
        self.fingers.end_frame();
        let has_commands = !commands.is_empty();
        self.apply(commands);
        self.take_pictures();
        self.frames += 1;
        if self.frames == 1 {
            show();
            message::tell_ready(&self.session);
        }

        // When the next one is due.
        let after = |seconds: f64| now + std::time::Duration::from_secs_f64(seconds);
        self.repaint_at = drawn.repaint_after.and_then(|delay| now.checked_add(delay));
        let address = self.address.write(&self.session, at);
        if self.session.is_moving() || has_commands || !self.pending.is_empty() {
            self.inbox.request();
            return;
        }
        let waits = wait.into_iter().chain(address).map(|wait| after(wait / 1e3));
        let next = waits.chain(self.repaint_at).chain(self.session.message_ends()).min();
        match next {
            Some(at) if at <= now => self.inbox.request(),
            Some(at) => self.inbox.request_after((at - now).as_secs_f64() * 1e3),
            None => {}
        }
    }

    fn milliseconds(&self, now: Instant) -> f64 {
        (now - self.began).as_secs_f64() * 1e3
    }

    /// Takes what happened; says after how long (ms) a finger will have rested.
    fn receive(
        &mut self,
        now: Instant,
        place: &Place,
        (events, commands): (&mut Vec<Event>, &mut Vec<Command>),
    ) -> Option<f64> {
        let at = self.milliseconds(now);
        for happening in self.inbox.take() {
            match happening {
                Happening::Event(Event::WindowFocused(focused)) => {
                    self.focused = focused;
                    events.push(Event::WindowFocused(focused));
                }
                Happening::Event(event) => events.push(in_points(event, place.zoom)),
                Happening::Command(command) => commands.push(command),
                Happening::Finger(finger) => self.fingers.take(finger, at, place, (events, commands)),
                Happening::Address if self.address.is_foreign() => {
                    commands.push(Command::OpenLink(Address::read()));
                    self.apply(std::mem::take(commands));
                    self.address.follow(&self.session);
                }
                Happening::Address => {}
                Happening::Message(event) => {
                    if let Some(asked) = message::commands(&event, self.session.is_playing()) {
                        self.apply(asked);
                        message::answer(&event, &self.session);
                    }
                }
                Happening::LetGo => self.stage.context().memory_mut(|memory| {
                    if let Some(focused) = memory.focused() {
                        memory.surrender_focus(focused);
                    }
                }),
                Happening::Wishes => {
                    self.session.prefer_theme(theme(self.options));
                    self.session.set_gliding(!dom::matches(REDUCED_MOTION));
                }
                Happening::Say(sentence) => self.session.say(sentence),
            }
        }
        self.fingers.rest(at, place, (events, commands))
    }

    fn input(&self, events: Vec<Event>, size: Vec2, ratio: f32, now: Instant) -> RawInput {
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, size)),
            max_texture_side: Some(self.stage.gpu().largest_side() as usize),
            time: Some((now - self.began).as_secs_f64()),
            events,
            focused: self.focused,
            ..RawInput::default()
        };
        if let Some(viewport) = input.viewports.get_mut(&ViewportId::ROOT) {
            viewport.native_pixels_per_point = Some(ratio);
        }
        input
    }

    fn pass_time(&mut self, now: Instant) {
        if !self.session.is_playing() {
            self.session.advance(0.0, now);
            self.pacer.stand();
            return;
        }
        let passed = self.pacer.tick(now);
        self.session.advance(passed, now);
        let has_jumped = std::mem::replace(&mut self.jumps, self.session.jumps()) != self.session.jumps();
        self.pacer.measure(now, self.session.time(), has_jumped);
    }

    fn apply(&mut self, commands: Vec<Command>) {
        for command in commands {
            for effect in self.session.apply(command, Instant::now()) {
                self.take_effect(effect);
            }
        }
    }

    /// Does what the session leaves to the page.
    fn take_effect(&mut self, effect: Effect) {
        match effect {
            Effect::Open(_) => {
                self.session.say("A page reads no files by their names: drop the file here, or take “open a file”.");
            }
            Effect::SaveText { title, text, .. } => {
                let name = format!("{}.toml", slug(&title));
                self.download(&name, "application/toml", text.as_bytes());
            }
            Effect::WritePicture { transparent } => {
                let name = format!("{}.png", slug(self.session.title()));
                self.pending.push((self.stage.begin_picture(&self.session, transparent), name));
            }
            Effect::WriteHandout => match self.stage.begin_pages(&self.session) {
                Ok(pages) => {
                    let slug = slug(self.session.title());
                    let named = pages.into_iter().enumerate();
                    self.pending.extend(named.map(|(n, page)| (page, format!("{slug}-{}.png", n + 1))));
                }
                Err(why) => self.session.say(why),
            },
            Effect::CopyText(text) => effects::copy(&self.inbox, text),
            Effect::CopyLink(fragment) => {
                let address = dom::window().and_then(|window| window.location().href().ok()).unwrap_or_default();
                let page = address.split('#').next().unwrap_or_default();
                effects::copy(&self.inbox, format!("{page}{fragment}"));
            }
            Effect::ToggleFullscreen => {
                if let Err(why) = effects::toggle_fullscreen() {
                    self.session.say(why);
                }
            }
            Effect::ChooseFile => effects::choose_file(),
            Effect::FocusPanel => self.panels.take_focus(),
        }
    }

    fn download(&mut self, name: &str, kind: &str, bytes: &[u8]) {
        let is_taken = effects::download(name, kind, bytes);
        let words = if is_taken { format!("Downloaded: {name}") } else { format!("The browser did not take {name}.") };
        self.session.say(words);
    }

    /// Has a flip that has just been read aloud, and what is said to everyone.
    fn say_aloud(&mut self) {
        let look = self.session.look(None, false);
        let (time, is_backwards) = (look.sim.time(), look.sim.clock.speed < 0.0);
        let passed = self.next_flip.filter(|flip| self.session.is_playing() && (time >= *flip) != is_backwards);
        self.next_flip = look.timeline.next_flip(time, is_backwards);
        match (passed, look.message) {
            // A message that still stands there was read when it came.
            (Some(flip), _) => mirror::tell(&format!("flip at {flip:.1} {}", look.scene.view.time_unit.sign())),
            (None, Some(message)) => self.mirror.say(message),
            (None, None) => {}
        }
    }

    /// Gives pictures that have arrived to the browser.
    fn take_pictures(&mut self) {
        for (pending, name) in std::mem::take(&mut self.pending) {
            match pending.poll(&self.stage) {
                Ok(None) => self.pending.push((pending, name)),
                Ok(Some(bytes)) => self.download(&name, "image/png", &bytes),
                Err(why) => self.session.say(why),
            }
        }
    }

    /// Does what the panels ask of the system.
    fn follow(&mut self, platform: &egui::PlatformOutput, zoom: f32) {
        dom::style(&self.canvas, "cursor", cursor::name(platform.cursor_icon));
        for command in &platform.commands {
            if let OutputCommand::CopyText(text) = command {
                effects::copy(&self.inbox, text.clone());
            }
        }
        let typed = platform.ime.as_ref().map(|ime| {
            let rect = ime.rect * zoom;
            [rect.min.x, rect.min.y, rect.width(), rect.height()]
        });
        text_input::follow(typed);
    }

    /// The page may be left, and there may be no frame any more: everything is kept now.
    pub(super) fn leave(&mut self) {
        self.keep();
        self.pacer.stand();
        self.address.write_now(&self.session, self.milliseconds(Instant::now()));
    }

    /// Nothing can be drawn any more.
    pub(super) fn end(&mut self) {
        self.leave();
        self.is_over = true;
    }

    /// Keeps what is remembered.
    fn keep(&mut self) {
        let panel = self.remembered.panel;
        self.session.remember(&mut self.remembered);
        // What the address asked for is not what its reader chose.
        if self.options.panel.is_some() {
            self.remembered.panel = panel;
        }
        if !self.options.embed {
            remember::save(&self.remembered);
        }
    }
}

/// An event told in CSS pixels, in points.
fn in_points(mut event: Event, zoom: f32) -> Event {
    match &mut event {
        Event::PointerMoved(at) | Event::PointerButton { pos: at, .. } => *at = *at / zoom,
        Event::MouseWheel { delta, unit: egui::MouseWheelUnit::Point, .. } => *delta /= zoom,
        _ => {}
    }
    event
}

/// Takes the start's picture away.
fn show() {
    if let Some(performance) = dom::window().and_then(|window| window.performance()) {
        // For whoever measures it.
        let _ = performance.mark("first frame");
    }
    if let Some(root) = dom::document().and_then(|document| document.document_element()) {
        let _ = root.set_attribute("data-state", "running");
    }
}

/// The page in the place where its frames find it.
pub(super) type Slot = Rc<RefCell<Option<Page>>>;
