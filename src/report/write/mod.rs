//! A report as files, one format each.

pub mod bars;
pub mod csv;
pub mod format;
pub mod html;
pub mod json;
pub mod labels;
pub mod plots;
mod sections;
pub mod summary;
pub mod svg;
pub mod terminal;
