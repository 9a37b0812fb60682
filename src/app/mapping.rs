//! Whether an X11 window is on the screen: on another desktop it is taken off ("unmapped"), and winit has no event for that.

use winit::window::Window;

#[cfg(all(unix, not(target_vendor = "apple")))]
pub(super) use x11::Mapping;

/// A connection of its own to ask by; none elsewhere than on X11.
#[cfg(all(unix, not(target_vendor = "apple")))]
mod x11 {
    use winit::raw_window_handle::{HasWindowHandle, RawWindowHandle};
    use x11rb::protocol::xproto::{ConnectionExt, MapState};
    use x11rb::rust_connection::RustConnection;

    use super::Window;

    /// Asks the X server.
    #[derive(Debug)]
    pub(in crate::app) struct Mapping {
        connection: RustConnection,
        window: u32,
    }

    impl Mapping {
        /// Of a window on X11.
        pub(in crate::app) fn of(window: &Window) -> Option<Self> {
            let window = match window.window_handle().ok()?.as_raw() {
                RawWindowHandle::Xlib(handle) => u32::try_from(handle.window).ok()?,
                RawWindowHandle::Xcb(handle) => handle.window.get(),
                _ => return None,
            };
            let (connection, _) = x11rb::connect(None).ok()?;
            Some(Self { connection, window })
        }

        /// Whether it is on the screen; also where the server does not say.
        pub(in crate::app) fn is_mapped(&self) -> bool {
            let asked = self.connection.get_window_attributes(self.window).ok();
            let answer = asked.and_then(|cookie| cookie.reply().ok());
            answer.is_none_or(|attributes| attributes.map_state != MapState::UNMAPPED)
        }
    }
}

/// Where events tell all there is to know.
#[cfg(not(all(unix, not(target_vendor = "apple"))))]
#[derive(Debug)]
pub(super) struct Mapping;

#[cfg(not(all(unix, not(target_vendor = "apple"))))]
impl Mapping {
    /// Nothing to ask.
    pub(super) fn of(_: &Window) -> Option<Self> {
        None
    }

    /// Never asked.
    pub(super) fn is_mapped(&self) -> bool {
        true
    }
}
