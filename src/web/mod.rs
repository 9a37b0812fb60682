//! The page: the same session, panels and picture as the window's, on a browser's canvas.
//!
//! Events of the browser become commands, effects of the session become downloads, the clipboard and the address.

mod address;
mod cursor;
mod dom;
mod effects;
mod events;
mod inbox;
mod keyboard;
mod message;
mod mirror;
mod open;
mod options;
mod page;
mod remember;
mod text_input;
mod touch;

pub use open::start;
