//! The page.
/// Starts.
pub fn start() {}
