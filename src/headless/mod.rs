//! Pictures and sequences with no window and no event loop.

mod apng;
mod fault;
mod figure;
mod gif;
mod handout;
mod movie;
mod paper;
mod record;
mod rgba;
mod sheet;
mod shot;
mod y4m;

pub use apng::Apng;
pub use figure::{FigureFormat, figure};
pub use gif::Gif;
pub use handout::{page, page_as_png, page_as_svg, page_size, pages_as_pdf};
pub use movie::{Movie, MovieError};
pub use paper::{Length, POINT, PictureSize, THINNEST_LINE};
pub use record::{FrameRate, Recording, record};
pub use rgba::Rgba;
pub use sheet::Sheet;
pub use shot::{HeadlessError, ShotOptions, Studio, shot};
pub use y4m::Y4m;
