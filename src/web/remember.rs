//! Where the page keeps what it remembers: in the browser, for this address alone.

use super::dom;
use crate::session::Remembered;

/// The name under which it is kept.
const NAME: &str = "dzhanibekov";
/// Screens in the hand, on which the drawer is closed at first: the picture comes first there.
pub(super) const SMALL: &str = "(max-width: 639px), (max-height: 399px)";

/// Reads it; as if it were the first time where there is nothing to read, or the browser keeps nothing.
pub(super) fn load() -> Remembered {
    let text = dom::window().and_then(|window| window.local_storage().ok()??.get_item(NAME).ok()?);
    let first = || Remembered { panel: !dom::matches(SMALL), ..Remembered::default() };
    text.map_or_else(first, |text| Remembered::read(&text))
}

/// Keeps it. Where that cannot be done the next time starts as the first: nobody need be told.
pub(super) fn save(remembered: &Remembered) {
    if let Some(storage) = dom::window().and_then(|window| window.local_storage().ok()?) {
        let _ = storage.set_item(NAME, &remembered.text());
    }
}
