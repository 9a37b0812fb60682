//! How large a picture is to be, as it is said.

use clap::Args;
use dzhanibekov::headless::{Length, PictureSize};
use dzhanibekov::scene::one_number;

use super::arguments::size;
use super::times::rough;

/// The size where none is said.
const USUAL: [u32; 2] = [1280, 720];
/// Dots an inch between which any resolution lies.
const DENSITIES: std::ops::RangeInclusive<f64> = 1.0..=100_000.0;

/// Flags of the size of a picture.
#[derive(Args, Debug)]
pub(super) struct SizeArguments {
    /// Size in pixels (1280x720 where nothing is said); with --width or --height its aspect alone counts
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = size, help_heading = "Picture")]
    size: Option<[u32; 2]>,
    /// Width on paper (mm, cm, in, pt), which sets type in points of paper: 8 pt for captions; or in pixels (px)
    #[arg(long, value_name = "86mm", allow_hyphen_values = true, value_parser = str::parse::<Length>, help_heading = "Picture")]
    width: Option<Length>,
    /// Height likewise, where the aspect of --size is not the one wanted
    #[arg(long, value_name = "50mm", allow_hyphen_values = true, value_parser = str::parse::<Length>, help_heading = "Picture")]
    height: Option<Length>,
    /// Pixels an inch of paper (300 where only a width is said), with which PNG files are marked
    #[arg(long, value_name = "DPI", allow_hyphen_values = true, value_parser = density, help_heading = "Picture")]
    dpi: Option<f64>,
}

impl SizeArguments {
    /// What they come to.
    pub(super) fn get(&self) -> PictureSize {
        let (size, width, height, density) = self.said();
        PictureSize::new(size, width, height, density)
    }

    /// Refuses a size on paper of which no picture has so many pixels, with what was said.
    pub(super) fn check(&self) -> Result<(), String> {
        let (size, width, height, density) = self.said();
        let [wide, high] = PictureSize::dots(size, width, height, density);
        if wide.max(high) <= f64::from(u32::MAX) {
            return Ok(());
        }
        Err(format!(
            "{} is {} x {} pixels, more than any picture has: take a shorter length or fewer --dpi",
            self.words().join(" "),
            rough(wide),
            rough(high)
        ))
    }

    /// They themselves: size, width, height, dots an inch.
    pub(super) fn said(&self) -> ([u32; 2], Option<Length>, Option<Length>, Option<f64>) {
        (self.size.unwrap_or(USUAL), self.width, self.height, self.dpi)
    }

    /// Those of the flags that are given.
    pub(super) fn flags(&self) -> impl Iterator<Item = &'static str> {
        let given = [
            ("--size", self.size.is_some()),
            ("--width", self.width.is_some()),
            ("--height", self.height.is_some()),
            ("--dpi", self.dpi.is_some()),
        ];
        given.into_iter().filter_map(|(flag, is_given)| is_given.then_some(flag))
    }

    /// The words of a command line that say the same.
    pub(super) fn words(&self) -> Vec<String> {
        let mut words = vec![];
        let mut say = |flag: &str, value: String| words.extend([flag.to_owned(), value]);
        let is_plain = self.width.is_none() && self.height.is_none();
        if let Some([width, height]) = self.size.or(is_plain.then_some(USUAL)) {
            say("--size", format!("{width}x{height}"));
        }
        for (flag, length) in [("--width", self.width), ("--height", self.height)] {
            if let Some(length) = length {
                say(flag, length.to_string());
            }
        }
        if let Some(density) = self.dpi {
            say("--dpi", density.to_string());
        }
        words
    }
}

/// Reads dots an inch.
fn density(text: &str) -> Result<f64, String> {
    let density = one_number(text).ok().filter(|density| DENSITIES.contains(density));
    density.ok_or_else(|| "a resolution is a number of pixels an inch between 1 and 100000, as in 600".to_owned())
}

#[cfg(test)]
mod tests {
    use super::SizeArguments;

    #[test]
    fn a_size_past_all_bounds_is_refused_as_it_was_said() {
        let size = |width: &str, dpi| SizeArguments { size: None, width: width.parse().ok(), height: None, dpi };
        assert_eq!(size("86mm", Some(600.0)).check(), Ok(()));
        let said =
            "--width 1e9mm is 1.2e10 x 6.6e9 pixels, more than any picture has: take a shorter length or fewer --dpi";
        assert_eq!(size("1e9mm", None).check(), Err(said.to_owned()));
        assert!(size("1e308in", Some(600.0)).check().is_err_and(|why| why.contains("more than 1e308 x")));
    }
}
