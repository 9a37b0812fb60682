//! What is said of a figure of vectors: how its texts and its surfaces are written.

use std::path::Path;

use clap::{Args, ValueEnum};
use dzhanibekov::headless::FigureFormat;
use dzhanibekov::render::png::Remark;
use dzhanibekov::vector::{FigureStyle, Letters, Shading};

use super::failure::Failure;

/// How texts are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Texts {
    /// As text, with the fonts in the file
    Text,
    /// As outlines, which need no font
    Outlines,
}

/// How shaded surfaces are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Surfaces {
    /// As pixels, beneath the lines
    Pixels,
    /// As areas of one colour or a gradient: all is vectors
    Flat,
}

/// Flags of `shot` for SVG and PDF.
#[derive(Args, Debug)]
pub(super) struct FigureArguments {
    /// Of an SVG or a PDF: its texts as text, with the fonts in the file, or as outlines, for programs that read none from an SVG
    #[arg(long, value_name = "text|outlines", hide_possible_values = true, help_heading = "Picture")]
    text: Option<Texts>,
    /// Of an SVG or a PDF: its shaded surfaces as pixels beneath the lines, or as flat areas, so that all is vectors
    #[arg(long, value_name = "pixels|flat", hide_possible_values = true, help_heading = "Picture")]
    surfaces: Option<Surfaces>,
}

impl FigureArguments {
    /// How a figure is written.
    pub(super) fn style(&self) -> FigureStyle {
        FigureStyle {
            letters: if self.text == Some(Texts::Outlines) { Letters::Outlines } else { Letters::Text },
            shading: if self.surfaces == Some(Surfaces::Flat) { Shading::Flat } else { Shading::Pixels },
        }
    }

    /// Has a figure's remarks, which are those of a picture, say how it is drawn again.
    pub(super) fn mark(&self, format: FigureFormat, remarks: &mut [Remark]) {
        let ending = [self.words(), vec![format!("-o picture.{}", format.ending())]].concat().join(" ");
        for (_, text) in remarks.iter_mut().filter(|(keyword, _)| *keyword == "Comment") {
            *text = text.replace("-o picture.png", &ending);
        }
    }

    /// The words of a command line that say it.
    fn words(&self) -> Vec<String> {
        let text = self.text.and_then(|text| text.to_possible_value()).map(|value| ("--text", value));
        let surfaces =
            self.surfaces.and_then(|surfaces| surfaces.to_possible_value()).map(|value| ("--surfaces", value));
        let given = text.into_iter().chain(surfaces);
        given.flat_map(|(flag, value)| [flag.to_owned(), value.get_name().to_owned()]).collect()
    }

    /// Refuses what has no meaning for a picture of pixels.
    pub(super) fn check(&self, format: Option<FigureFormat>, output: &Path) -> Result<(), Failure> {
        let words = self.words();
        match (format, &words[..]) {
            (None, [flag, value, ..]) => Err(Failure::request(format!(
                "{flag} {value} is for figures of lines and text: give a name ending in .svg or .pdf instead of {}",
                output.display()
            ))),
            _ => Ok(()),
        }
    }
}
