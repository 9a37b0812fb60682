//! How the page opens: the device is there when it is there, and nothing waits for it.

use std::rc::Rc;

use web_sys::{Event, EventTarget, HtmlCanvasElement, HtmlInputElement};

use super::inbox::Inbox;
use super::options::Options;
use super::page::{Page, Slot, session};
use super::{dom, effects, events, remember, text_input};
use crate::session::Remembered;
use crate::stage::Stage;

/// What is said where nothing can be drawn.
const NO_GRAPHICS: &str = "This browser draws no 3D here (WebGL 2 is off or missing): take a current browser, or switch on its graphics acceleration";

/// Opens the page on the canvas of this document; called once, when everything is loaded.
pub fn start() {
    // Not in the page as it is published, which has no words about a panic (see .ci/page): there page.js alone says the sentence.
    std::panic::set_hook(Box::new(|info| {
        web_sys::console::error_1(&info.to_string().into());
        effects::fail("Something went wrong in this page: load it again");
    }));
    wasm_bindgen_futures::spawn_local(async {
        if let Err(sentence) = open().await {
            effects::fail(&sentence);
        }
    });
}

async fn open() -> Result<(), String> {
    let canvas: HtmlCanvasElement = dom::element("canvas").ok_or("The page has no canvas: load it again")?;
    let options = Options::read();
    let kept = remember::load();
    let remembered = Remembered { panel: options.panel.unwrap_or(kept.panel), ..kept };
    let session = session(options, &remembered).map_err(|error| error.to_string())?;
    let inbox = Inbox::new();
    events::listen(&inbox, &canvas);
    text_input::listen(&inbox);
    if let Some(input) = dom::element::<HtmlInputElement>("file") {
        events::listen_to_choice(&inbox, &input);
    }
    let ratio = dom::window().map_or(1.0, |window| window.device_pixel_ratio());
    let size = (f64::from(canvas.client_width()) * ratio, f64::from(canvas.client_height()) * ratio);
    let size = (size.0.round() as u32, size.1.round() as u32);
    inbox.size.set(size);
    let stage = stage(&canvas, size, options.webgpu).await?;
    let page = Page::new(Rc::clone(&inbox), canvas, options, (session, kept), stage);
    let slot: Slot = Rc::default();
    *slot.borrow_mut() = Some(page);
    let own = Rc::clone(&slot);
    inbox.set_frame(move || {
        if let Some(page) = own.borrow_mut().as_mut() {
            page.frame();
        }
    });
    leavings(&slot);
    inbox.request();
    Ok(())
}

/// Keeps everything when the page may be left: at once, for there may be no frame after it.
fn leavings(slot: &Slot) {
    let (Some(window), Some(document)) = (dom::window(), dom::document()) else { return };
    let on = |target: &EventTarget, name: &str, call: fn(&mut Page)| {
        let slot = Rc::clone(slot);
        dom::listen(target, name, move |_: Event| {
            if let Ok(mut page) = slot.try_borrow_mut()
                && let Some(page) = page.as_mut()
            {
                call(page);
            }
        });
    };
    on(&document, "visibilitychange", Page::leave);
    on(&window, "pagehide", Page::leave);
    // Told by the script that loaded the page.
    on(&window, "dzhanibekov-over", Page::end);
}

/// A device that draws on the canvas: by WebGPU where that is asked for and there, else by WebGL 2.
#[cfg(target_arch = "wasm32")]
async fn stage(canvas: &HtmlCanvasElement, size: (u32, u32), webgpu: bool) -> Result<Stage, String> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    // Asked for twice, a canvas stays with what it was asked for first.
    descriptor.backends = if webgpu { wgpu::Backends::BROWSER_WEBGPU | wgpu::Backends::GL } else { wgpu::Backends::GL };
    let instance = wgpu::util::new_instance_with_webgpu_detection(descriptor).await;
    let surface = instance.create_surface(wgpu::SurfaceTarget::Canvas(canvas.clone())).map_err(|_| NO_GRAPHICS)?;
    Stage::open(&instance, surface, None, size, || {}).await.map_err(|error| format!("{NO_GRAPHICS} ({error})"))
}

/// Only browsers have canvases.
#[cfg(not(target_arch = "wasm32"))]
async fn stage(_: &HtmlCanvasElement, _: (u32, u32), _: bool) -> Result<Stage, String> {
    std::future::ready(Err(NO_GRAPHICS.to_owned())).await
}
