//! The start's part of the panel: which axis, how far from it, how fast.

use egui::Ui;
use egui::{Align2, FontId, Stroke};
use glam::DVec3;

use super::widgets::{NumberRow, choice, note, section};
use super::{Command, Look};
use crate::scene::Scene;

/// The start as the panel shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    /// Principal axis nearest to the spin.
    pub axis: u8,
    /// Angle from it (degrees).
    pub tilt_deg: f64,
    /// Angular speed (rad/s).
    pub rate: f64,
}

impl Spin {
    /// Reads the start of a scene, however it is given.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let file = &scene.file.spin;
        if file.omega.is_none() {
            return Self {
                axis: file.axis.unwrap_or(2),
                tilt_deg: file.tilt_deg.unwrap_or(0.0),
                rate: file.rate.unwrap_or(1.0),
            };
        }
        let omega = scene.start.body_angular_velocity(&scene.body);
        let principal = scene.body.body_from_principal().transpose() * omega;
        let (axis, unit) = [(1, DVec3::X), (2, DVec3::Y), (3, DVec3::Z)]
            .into_iter()
            .max_by(|(_, a), (_, b)| a.dot(principal).abs().total_cmp(&b.dot(principal).abs()))
            .unwrap_or((2, DVec3::Y));
        let along = unit.dot(principal);
        let across = (principal - along * unit).length();
        Self { axis, tilt_deg: across.atan2(along.abs()).to_degrees(), rate: principal.length() }
    }
}

/// The start: axis, tilt, rate and energy, and the buttons for other starts.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    section(ui, "Spin");
    let mut spin = Spin::of(look.scene);
    let options = [
        (1, "1 smallest", "Axis of the smallest moment: stable"),
        (2, "2 middle", "Axis of the middle moment: unstable, the Dzhanibekov effect"),
        (3, "3 largest", "Axis of the largest moment: stable"),
    ];
    if let Some(axis) = choice(ui, Some(spin.axis), &options)
        && axis != spin.axis
    {
        commands.push(Command::SpinAxis(axis));
    }
    let tilt = NumberRow {
        label: "tilt",
        unit: "°",
        range: (0.0, 30.0),
        logarithmic: Some(1e-6),
        hint: "Angle between the spin and the axis at the start; all the way left is exactly 0",
    };
    let rate = NumberRow {
        label: "rate",
        unit: if look.time_unit() == "d" { " rad/d" } else { " rad/s" },
        range: (0.0, 20.0),
        logarithmic: None,
        hint: "Angular speed at the start",
    };
    if tilt.ui(ui, &mut spin.tilt_deg, commands).changed() {
        commands.push(Command::SetTilt(spin.tilt_deg));
    }
    exactly(ui, spin, commands);
    if rate.ui(ui, &mut spin.rate, commands).changed() {
        commands.push(Command::SetRate(spin.rate));
    }
    energy(ui, look, commands);
    ui.horizontal(|ui| {
        let button = |ui: &mut Ui, name: &str, hint: &str| ui.button(name).on_hover_text(hint).clicked();
        if button(
            ui,
            "to the border",
            "A start that flips just once: on the border (separatrix) between circling axis 1 and axis 3",
        ) {
            commands.push(Command::ToSeparatrix);
        }
        if button(ui, "poke", "Turns the body by 1° under its momentum: L stays, M moves to a neighbouring path (P)") {
            commands.push(Command::Poke);
        }
    });
}

/// The button for no tilt at all, which no slider is trusted to reach.
fn exactly(ui: &mut Ui, spin: Spin, commands: &mut Vec<Command>) {
    let is_on = spin.tilt_deg == 0.0;
    ui.horizontal(|ui| {
        let button = egui::Button::selectable(is_on, "exactly 0").frame_when_inactive(true);
        let pressed = ui.add(button).on_hover_text("No tilt at all: the spin is about the axis itself").clicked();
        if is_on {
            note(ui, if spin.axis == 2 { "exactly on the axis: never flips" } else { "exactly on the axis" });
        } else if pressed {
            commands.push(Command::SetTilt(0.0));
        }
    });
}

/// The energy at this momentum, between a spin about axis 3 and one about axis 1, with a tick at the separatrix.
fn energy(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let body = &look.scene.body;
    let moments = body.principal_moments();
    let ell = look.scene.start.body_momentum.length();
    if ell == 0.0 || moments.x == moments.y || moments.y == moments.z {
        return;
    }
    // ℓ²/2Iᵢ, the energies of the three pure spins.
    let [most, middle, least] = moments.to_array().map(|moment| ell / moment * ell * 0.5);
    let now = look.scene.start.energy(body);
    let mut value = now;
    let row = NumberRow {
        label: "energy",
        unit: look.energy_unit(),
        range: (least, most),
        logarithmic: None,
        hint: "Energy K at this momentum: least for the spin about axis 3, most about axis 1; the tick is the border (separatrix) between circling the one and the other",
    };
    let response = row.ui(ui, &mut value, commands);
    if response.changed() {
        commands.push(Command::SetEnergy(value.clamp(least, most)));
    }
    let slider = super::widgets::slider_track(response.rect);
    let x = slider.left() + ((middle - least) / (most - least)) as f32 * slider.width();
    let color = super::style::warning(ui.visuals().dark_mode);
    ui.painter().vline(x, slider.y_range().shrink(3.0), Stroke::new(2.0, color));
    // Below the tick, kept within the row.
    let (_, space) = ui.allocate_space(egui::vec2(ui.available_width(), 10.0));
    let row = response.rect.x_range().shrink(64.0);
    let place = egui::pos2(x.min(row.max).max(row.min), space.top() - 7.0);
    ui.painter().text(place, Align2::CENTER_TOP, "border (separatrix)", FontId::proportional(14.5), color);
}
