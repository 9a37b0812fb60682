//! Text files read with a bound on their length.

use std::fs::File;
use std::io::Read;
use std::path::Path;

/// The text of a file, or of a pipe, that is UTF-8 and at most `most` bytes long; or why it cannot be had.
pub(super) fn read_text(path: &Path, most: u64) -> Result<String, String> {
    let refused = |error: std::io::Error| format!("could not be read: {error}");
    let file = File::open(path).map_err(refused)?;
    let length = file.metadata().map_err(refused)?.len();
    if length > most {
        return Err(format!("is {length} bytes long, and at most {most} are read"));
    }
    // A device has no length beforehand, and some have no end.
    let mut bytes = vec![];
    file.take(most + 1).read_to_end(&mut bytes).map_err(refused)?;
    if bytes.len() as u64 > most {
        return Err(format!("is more than {most} bytes long, and no more are read"));
    }
    String::from_utf8(bytes)
        .map_err(|error| format!("is no UTF-8 text: byte {} is not valid", error.utf8_error().valid_up_to()))
}
