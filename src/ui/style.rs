//! Fonts, sizes and colours of the panels: calm, and legible from the last row.

use std::sync::Arc;

use egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, Stroke, TextStyle, Ui,
    Visuals, vec2,
};

use crate::scene;
use crate::typeface;

/// Width of the panel (points).
pub const PANEL_WIDTH: f32 = 316.0;

/// Sets fonts and sizes; once, at the start.
pub fn install(ctx: &Context) {
    let mut fonts = FontDefinitions::empty();
    let [sans, mono] = ["Sans", "Mono"].map(str::to_owned);
    for (name, font) in [(&sans, typeface::SANS), (&mono, typeface::MONO)] {
        fonts.font_data.insert(name.clone(), Arc::new(FontData::from_static(font)));
    }
    // The proportional font has no arrows; the monospaced one has.
    fonts.families.insert(FontFamily::Proportional, vec![sans.clone(), mono.clone()]);
    fonts.families.insert(FontFamily::Monospace, vec![mono, sans]);
    ctx.set_fonts(fonts);
    // The keys for the size of text are in the table of keys.
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
    for theme in [egui::Theme::Dark, egui::Theme::Light] {
        ctx.style_mut_of(theme, |style| {
            style.text_styles = [
                (TextStyle::Small, FontId::new(14.5, FontFamily::Proportional)),
                (TextStyle::Body, FontId::new(15.0, FontFamily::Proportional)),
                (TextStyle::Button, FontId::new(15.0, FontFamily::Proportional)),
                (TextStyle::Heading, FontId::new(20.0, FontFamily::Proportional)),
                (TextStyle::Monospace, FontId::new(14.0, FontFamily::Monospace)),
            ]
            .into();
            let spacing = &mut style.spacing;
            spacing.item_spacing = vec2(8.0, 6.0);
            spacing.button_padding = vec2(8.0, 4.0);
            spacing.interact_size = vec2(32.0, 24.0);
            spacing.slider_rail_height = 4.0;
            spacing.combo_width = 60.0;
            spacing.window_margin = Margin::same(18);
            style.interaction.selectable_labels = false;
            style.visuals = visuals(theme);
        });
    }
}

/// Least side of what a finger meets (points).
pub const FINGER: f32 = 44.0;

/// Whether everything is as large as fingers want it.
#[must_use]
pub fn is_for_fingers(ui: &Ui) -> bool {
    ui.spacing().interact_size.y >= FINGER
}

/// Makes everything as large as fingers want it.
pub fn for_fingers(ctx: &Context) {
    for theme in [egui::Theme::Dark, egui::Theme::Light] {
        ctx.style_mut_of(theme, |style| {
            let spacing = &mut style.spacing;
            spacing.interact_size = vec2(FINGER, FINGER);
            spacing.button_padding = vec2(10.0, 8.0);
            spacing.icon_width = 22.0;
            spacing.icon_width_inner = 12.0;
            spacing.slider_rail_height = 6.0;
        });
    }
}

/// Switches the colours.
pub fn set_theme(ctx: &Context, theme: scene::Theme) {
    ctx.set_theme(match theme {
        scene::Theme::Dark => egui::Theme::Dark,
        scene::Theme::Light => egui::Theme::Light,
    });
}

/// Colour of what is chosen and of what is filled.
#[must_use]
pub fn accent(is_dark: bool) -> Color32 {
    if is_dark { Color32::from_rgb(0x5b, 0x9d, 0xf0) } else { Color32::from_rgb(0x1f, 0x62, 0xc4) }
}

/// Colour of what is as it should be.
#[must_use]
pub fn good(is_dark: bool) -> Color32 {
    if is_dark { Color32::from_rgb(0x7b, 0xd1, 0x9f) } else { Color32::from_rgb(0x0b, 0x6b, 0x3f) }
}

/// Colour of a warning.
#[must_use]
pub fn warning(is_dark: bool) -> Color32 {
    if is_dark { Color32::from_rgb(0xf0, 0xb4, 0x55) } else { Color32::from_rgb(0x9a, 0x56, 0x00) }
}

fn visuals(theme: egui::Theme) -> Visuals {
    let is_dark = theme == egui::Theme::Dark;
    let mut visuals = theme.default_visuals();
    let grey = Color32::from_gray;
    let (ground, raised, rail, hover, line, text, soft) = if is_dark {
        (
            Color32::from_rgb(0x17, 0x1a, 0x20),
            Color32::from_rgb(0x25, 0x2a, 0x33),
            Color32::from_rgb(0x36, 0x3c, 0x48),
            Color32::from_rgb(0x32, 0x39, 0x45),
            Color32::from_rgb(0x2c, 0x31, 0x3a),
            Color32::from_rgb(0xec, 0xee, 0xf2),
            Color32::from_rgb(0xc2, 0xc8, 0xd2),
        )
    } else {
        (
            Color32::from_rgb(0xf6, 0xf7, 0xf9),
            Color32::from_rgb(0xe6, 0xe9, 0xee),
            Color32::from_rgb(0xcb, 0xd1, 0xda),
            Color32::from_rgb(0xd9, 0xde, 0xe6),
            Color32::from_rgb(0xd8, 0xdc, 0xe2),
            Color32::from_rgb(0x17, 0x1a, 0x20),
            Color32::from_rgb(0x40, 0x47, 0x52),
        )
    };
    let accent = accent(is_dark);
    visuals.panel_fill = ground;
    visuals.window_fill = ground;
    visuals.window_stroke = Stroke::new(1.0, line);
    visuals.extreme_bg_color = if is_dark { Color32::from_rgb(0x0f, 0x11, 0x15) } else { grey(0xff) };
    visuals.faint_bg_color = raised;
    visuals.weak_text_color = Some(soft);
    visuals.selection.bg_fill = accent;
    visuals.selection.stroke =
        Stroke::new(1.5, if is_dark { Color32::from_rgb(0x08, 0x12, 0x20) } else { Color32::WHITE });
    visuals.slider_trailing_fill = true;
    visuals.window_corner_radius = CornerRadius::same(10);
    visuals.popup_shadow = egui::Shadow::NONE;
    let widgets = &mut visuals.widgets;
    for widget in [
        &mut widgets.noninteractive,
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.active,
        &mut widgets.open,
    ] {
        widget.corner_radius = CornerRadius::same(5);
        widget.expansion = 0.0;
        widget.fg_stroke = Stroke::new(1.5, text);
        widget.bg_stroke = Stroke::NONE;
    }
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, line);
    widgets.noninteractive.bg_fill = ground;
    widgets.inactive.weak_bg_fill = raised;
    widgets.inactive.bg_fill = rail;
    for widget in [&mut widgets.hovered, &mut widgets.active, &mut widgets.open] {
        widget.weak_bg_fill = hover;
        widget.bg_fill = hover;
    }
    widgets.active.bg_stroke = Stroke::new(1.5, accent);
    visuals
}
