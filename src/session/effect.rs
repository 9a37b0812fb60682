//! What only a front end can do: a window by files and the clipboard, a page by downloads and its address.

/// Something left to the front end.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Reads a scene, or a folder of them, and opens it with [`Session::open_slides`](super::Session::open_slides).
    Open(String),
    /// Writes a text to a file, then tells [`Session::saved`](super::Session::saved) where.
    SaveText {
        /// The file that is meant; a new one where there is none.
        place: Option<String>,
        /// What a new file is called after.
        title: String,
        /// The text.
        text: String,
    },
    /// Writes the picture as it is.
    WritePicture {
        /// With no background.
        transparent: bool,
    },
    /// Writes the pages that [`Session::pages`](super::Session::pages) gives.
    WriteHandout,
    /// Puts a text on the clipboard.
    CopyText(String),
    /// Puts a link on the clipboard, given from its `#` on: a page says its own address before it.
    CopyLink(String),
    /// Lets a file be chosen, and opens it.
    ChooseFile,
    /// Full screen or back.
    ToggleFullscreen,
    /// Moves the keyboard's focus into the panel.
    FocusPanel,
}
