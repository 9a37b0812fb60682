//! The strip below the picture: time and what moves it.

use egui::{Align, Layout, RichText, Slider, Ui};

use super::icons::{Icon, icon_button};
use super::keys::keys_of;
use super::{Command, Look, numbers};

/// Slowest and fastest speed, as powers of two.
pub const SPEED_POWERS: (i32, i32) = (-6, 3);

/// Shows it.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let clock = &look.sim.clock;
    ui.horizontal_centered(|ui| {
        let mut button = |ui: &mut Ui, icon, name: &str, size, is_on, command: Command| {
            let name = keys_of(&command).map_or(name.to_owned(), |keys| format!("{name} ({keys})"));
            if icon_button(ui, icon, &name, size, is_on).clicked() {
                commands.push(command);
            }
        };
        button(ui, Icon::Restart, "restart", 34.0, false, Command::Restart);
        button(ui, Icon::StepBack, "one step back", 34.0, false, Command::Step(-1));
        let (icon, name) = if clock.paused { (Icon::Play, "play") } else { (Icon::Pause, "pause") };
        button(ui, icon, name, 42.0, !clock.paused, Command::PlayPause);
        button(ui, Icon::StepOn, "one step on", 34.0, false, Command::Step(1));
        button(ui, Icon::Reverse, "reverse time", 34.0, clock.speed < 0.0, Command::Reverse);
        ui.add_space(12.0);
        ui.label(RichText::new(format!("{:.2} s", look.sim.time()).replace('-', "−")).monospace().size(22.0));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let real = look.real_time_factor.map_or(String::new(), |factor| {
                // Said only where the machine cannot keep up: otherwise it is the speed that is set.
                if (factor / clock.speed - 1.0).abs() > 0.05 {
                    format!("really {}", numbers::speed((factor * 100.0).round() / 100.0))
                } else {
                    String::new()
                }
            });
            let mut power = clock.speed.abs().log2();
            ui.spacing_mut().slider_width = 130.0;
            ui.label(RichText::new(numbers::speed(clock.speed)).monospace().size(16.0));
            let (low, high) = SPEED_POWERS;
            let slider = Slider::new(&mut power, f64::from(low)..=f64::from(high)).step_by(1.0).show_value(false);
            let name = ui.label("speed");
            let slid = ui.add(slider).labelled_by(name.id).on_hover_text("simulated seconds a real second (+ −)");
            if slid.changed() {
                commands.push(Command::SetSpeed(power.exp2()));
            }
            ui.label(RichText::new(real).weak());
        });
    });
}
