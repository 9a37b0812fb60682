//! What every format of moving pictures does.

use std::io;

use crate::render::Pixels;

/// A file of moving pictures under way. Frames come in order; the file is whole only after [`Movie::finish`].
pub trait Movie: Send {
    /// Adds a frame.
    ///
    /// # Errors
    /// What the format or the writer refuses.
    fn frame(&mut self, pixels: &Pixels) -> Result<(), MovieError>;

    /// Writes what belongs behind the last frame.
    ///
    /// # Errors
    /// What the format or the writer refuses.
    fn finish(self: Box<Self>) -> Result<(), MovieError>;
}

/// Why a film is not whole.
#[derive(Debug, thiserror::Error)]
pub enum MovieError {
    /// The writer refused.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The format cannot hold this.
    #[error("{0}")]
    Format(String),
}

impl From<png::EncodingError> for MovieError {
    fn from(error: png::EncodingError) -> Self {
        match error {
            png::EncodingError::IoError(error) => Self::Io(error),
            other => Self::Format(other.to_string()),
        }
    }
}

impl From<gif::EncodingError> for MovieError {
    fn from(error: gif::EncodingError) -> Self {
        match error {
            gif::EncodingError::Io(error) => Self::Io(error),
            other => Self::Format(other.to_string()),
        }
    }
}
