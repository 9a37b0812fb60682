//! A report as files, one format each.

pub mod csv;
pub mod format;
pub mod json;
pub mod summary;
pub mod terminal;
