//! What is measured, live: what kind of motion it is, and how far each method strays.

use egui::{Align, Grid, Layout, RichText, Sense, Stroke, Ui};

use super::widgets::{named, note, section};
use super::{Look, numbers, style};
use crate::physics::{MotionClass, poinsot, so3};
use crate::sim::Errors;

/// Drift that reaches the edge of an invariant's frame (relative).
const FRAME: f64 = 0.01;
/// Digits that a number has for certain.
const DIGITS: f64 = 15.0;
/// Drift below which nobody would speak of one (relative).
const STEADY: f64 = 1e-9;

/// What stays the same and what turns.
pub(super) fn motion(ui: &mut Ui, look: &Look<'_>) {
    let scene = look.scene;
    let start = &scene.start;
    section(ui, "Motion");
    // Where energy is lost the motion goes from one kind to another.
    let loses = look.loses_energy();
    let class = poinsot::class_of(&scene.body, if loses { look.sim.state() } else { start });
    let flips = look.timeline.first_flip.is_some();
    // Few starts on the separatrix can be written down; the others are beside it by the rounding of a number.
    let is_rounded = !loses && poinsot::classify(&scene.body, start.body_momentum) == MotionClass::Separatrix;
    note(
        ui,
        match class {
            MotionClass::AboutAxis1 | MotionClass::AboutAxis3 if is_rounded => {
                "on the separatrix but for a rounding, which flips it again"
            }
            MotionClass::AboutAxis1 if flips => "it flips: M circles axis 1, past axis 2",
            MotionClass::AboutAxis3 if flips => "it flips: M circles axis 3, past axis 2",
            other => other.label(),
        },
    );
    let state = look.sim.state();
    let omega = scene.body.body_from_principal().transpose() * state.body_angular_velocity(&scene.body);
    let rate = so3::norm(omega);
    let energy = format!("{}{}", numbers::significant(state.energy(&scene.body), 4), look.energy_unit());
    if loses {
        lost(ui, look, &energy);
    } else {
        kept(ui, look, ("energy K", &energy), look.sim.energy_error(), |errors| errors.energy);
    }
    let momentum = numbers::significant(so3::norm(state.world_momentum), 4);
    let momentum = format!("{momentum} kg m²/{}", look.time_unit());
    kept(ui, look, ("momentum L", &momentum), look.sim.momentum_error(), |errors| errors.momentum);
    let angle = |along: f64| if rate > 0.0 { (along.abs() / rate).min(1.0).acos().to_degrees() } else { 0.0 };
    let angles = omega.to_array().map(|along| format!("{:.0}°", angle(along)));
    line(ui, "ω from axes 1, 2, 3", &angles.join("  "));
}

/// The energy of a body that loses it.
fn lost(ui: &mut Ui, look: &Look<'_>, energy: &str) {
    line(ui, "energy K", energy);
    // At the start that is 0, and not −0.
    let lost = numbers::significant(0.0 - 100.0 * look.sim.energy_error(), 3);
    note(ui, format!("{lost} % lost inside the body since the start, and none of L"));
}

/// An invariant: its value, its course so far, and in words whether it stays.
fn kept(ui: &mut Ui, look: &Look<'_>, (name, value): (&str, &str), drift: f64, of: fn(&Errors) -> f64) {
    ui.horizontal(|ui| {
        named(ui, RichText::new(name));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(RichText::new(value).monospace()));
    });
    ui.horizontal(|ui| {
        let (words, is_kept) = stays(drift);
        let color = if is_kept { style::good(ui.visuals().dark_mode) } else { style::warning(ui.visuals().dark_mode) };
        ui.label(RichText::new(words).small().color(color));
        let (rect, response) = ui.allocate_exact_size(egui::vec2(ui.available_width(), 18.0), Sense::hover());
        response.on_hover_text("Its course so far: flat where it stays; the edges are ±1 %");
        let painter = ui.painter().with_clip_rect(rect);
        // A ground of its own, so that it is read as a graph.
        painter.rect_filled(rect, 3.0, ui.visuals().extreme_bg_color);
        let mut times = look.history.samples().map(|sample| sample.time);
        let low = times.next().unwrap_or_default();
        let high = times.last().unwrap_or(low + 1.0);
        for piece in look.history.pieces(|sample| sample.errors.first().map(of)) {
            let points = piece.into_iter().map(|[time, error]| {
                let across = ((time - low) / (high - low)) as f32;
                let up = (error / FRAME).clamp(-1.0, 1.0) as f32;
                egui::pos2(rect.left() + across * rect.width(), rect.center().y - 0.5 * up * (rect.height() - 4.0))
            });
            painter.line(points.collect(), Stroke::new(2.0, color));
        }
    });
}

/// Whether an invariant with this relative drift stays the same, in words.
fn stays(drift: f64) -> (String, bool) {
    let size = drift.abs();
    if size < STEADY {
        // Measured, it is never known to more digits than the numbers have.
        (format!("stays the same to {:.0} digits", (-size.log10()).floor().min(DIGITS)), true)
    } else if size < FRAME {
        (format!("drifts: off by {} of it", numbers::scientific_short(size)), false)
    } else {
        (format!("drifts: off by {} %", numbers::significant(drift * 100.0, 3)), false)
    }
}

/// How far each method strays.
pub(super) fn errors(ui: &mut Ui, look: &Look<'_>) {
    section(ui, "Errors");
    if look.loses_energy() {
        note(
            ui,
            "Where energy is lost there is no exact motion to compare with: closed form, exact step and the prediction of flips do not know it.",
        );
        let momentum = numbers::scientific_short(look.sim.momentum_error());
        line(ui, "L", &momentum);
        failures(ui, look);
        return;
    }
    Grid::new("errors").num_columns(4).spacing([6.0, 4.0]).min_col_width(46.0).show(ui, |ui| {
        ui.label("");
        for head in ["energy", "L", "attitude"] {
            cell(ui, RichText::new(head).small().weak());
        }
        ui.end_row();
        for runner in std::iter::once(look.sim.main()).chain(look.sim.ghosts()) {
            let errors = Errors::of(look.sim, look.motion, runner.state());
            ui.allocate_ui_with_layout(egui::vec2(112.0, 16.0), Layout::left_to_right(Align::Center), |ui| {
                ui.set_width(112.0);
                let name = egui::Label::new(look.method_text(runner.method()).small()).truncate();
                ui.add(name).on_hover_text(runner.method().label);
            });
            for error in [errors.energy.abs(), errors.momentum, errors.attitude] {
                cell(ui, RichText::new(numbers::scientific_short(error)).size(13.0));
            }
            ui.end_row();
        }
    });
    failures(ui, look);
}

/// Why methods stopped, if they did.
fn failures(ui: &mut Ui, look: &Look<'_>) {
    let is_dark = ui.visuals().dark_mode;
    for runner in std::iter::once(look.sim.main()).chain(look.sim.ghosts()) {
        if let Some(failure) = runner.failure() {
            ui.label(RichText::new(failure.to_string()).small().color(style::warning(is_dark)));
        }
    }
}

/// A text at the right end of its column.
fn cell(ui: &mut Ui, text: RichText) {
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(text));
}

fn line(ui: &mut Ui, name: &str, value: &str) {
    ui.horizontal(|ui| {
        named(ui, RichText::new(name).weak());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(RichText::new(value).monospace()));
    });
}
