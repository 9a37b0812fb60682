//! The strip below the picture: time and what moves it.

use egui::{Align, Layout, RichText, Slider, Ui, vec2};

use super::icons::{Icon, icon_button};
use super::keys::{hint_of, keys_of};
use super::{Command, Look, Timeline, numbers, style, timeline};
use crate::objects::is_turning_over;
use crate::physics::MotionClass;
use crate::physics::poinsot;

/// Slowest and fastest speed, as powers of two.
pub const SPEED_POWERS: (i32, i32) = (-6, 3);

/// Room that the speed takes, and the words about flips (points).
const SPEED_WIDTH: f32 = 205.0;
const FLIPS_WIDTH: f32 = 250.0;
/// Room that the buttons take, with the clock behind them, and height of the second row where there is one (points).
const BUTTONS_WIDTH: f32 = 440.0;
pub(super) const SECOND_ROW: f32 = 44.0;
/// How much more room the buttons take where fingers press them, two more with them (points).
const FINGERS_WIDTH: f32 = 156.0;
/// How much more room the speed takes there, whose words stand beside it and not below (points).
const FINGERS_WORDS: f32 = 215.0;
/// How long before a flip (s of real time) its countdown lights up.
const SOON: f64 = 1.0;

/// The scrub bar, and below it the buttons, the clock, the flips that come and the speed.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    timeline::show(ui, look, commands);
    ui.add_space(2.0);
    let clock = &look.sim.clock;
    let is_narrow = is_narrow(ui, ui.available_width());
    let for_fingers = style::is_for_fingers(ui);
    let least = if for_fingers { style::FINGER } else { 0.0 };
    ui.horizontal(|ui| {
        ui.set_height(42f32.max(least));
        let mut button = |ui: &mut Ui, icon, name: &str, size, state: Option<bool>, command: Command| {
            let name = keys_of(&command, look.front).map_or(name.to_owned(), |keys| format!("{name} ({keys})"));
            if icon_button(ui, icon, &name, f32::max(size, least), state).clicked() {
                commands.push(command);
            }
        };
        // Where there is a keyboard, its keys go on and back.
        if for_fingers {
            button(ui, Icon::Before, "the step or scene before", 0.0, None, Command::PreviousStep);
            button(ui, Icon::After, "the next step or scene", 0.0, None, Command::NextStep);
        }
        button(ui, Icon::Restart, "restart", 34.0, None, Command::Restart);
        button(ui, Icon::StepBack, "one step back", 34.0, None, Command::Step(-1));
        let (icon, name) = if clock.paused { (Icon::Play, "play") } else { (Icon::Pause, "pause") };
        button(ui, icon, name, 42.0, Some(!clock.paused), Command::PlayPause);
        button(ui, Icon::StepOn, "one step on", 34.0, None, Command::Step(1));
        button(ui, Icon::Reverse, "reverse time", 34.0, Some(clock.speed < 0.0), Command::Reverse);
        // Where it never flips its place stays, and so does all that stands behind it.
        ui.add_enabled_ui(look.timeline.first_flip.is_some(), |ui| {
            button(ui, Icon::Next, "to the next flip", 34.0, None, Command::NextFlip);
        });
        ui.add_space(8.0);
        clock_ui(ui, look, commands);
        if !is_narrow {
            flips(ui, look);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| speed(ui, look, commands));
        }
    });
    // Large text or a small window: the rest has a row of its own.
    if is_narrow {
        ui.horizontal(|ui| {
            ui.set_height(SECOND_ROW);
            flips(ui, look);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| speed(ui, look, commands));
        });
    }
}

/// Whether a strip of this width (points) has no room for everything in one row.
pub(super) fn is_narrow(ui: &Ui, width: f32) -> bool {
    let more = if style::is_for_fingers(ui) { FINGERS_WIDTH + FINGERS_WORDS } else { 0.0 };
    width < BUTTONS_WIDTH + more + FLIPS_WIDTH + SPEED_WIDTH
}

/// The time, with as many decimals as one step shows in.
fn clock_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let decimals = (-look.sim.step_length().log10()).ceil().clamp(2.0, 6.0) as usize;
    let time = format!("{:.decimals$} {}", look.sim.time(), look.time_unit()).replace('-', "−");
    // It keeps its place while the last digits run.
    let width = 13.5 * time.chars().count().max(decimals + 5) as f32;
    let text = egui::Label::new(RichText::new(time).monospace().size(22.0)).halign(Align::Min);
    let height = if style::is_for_fingers(ui) { style::FINGER } else { 30.0 };
    let clock = ui.add_sized([width, height], text.sense(egui::Sense::click()));
    if clock.on_hover_text(hint_of(&Command::AskTime, look.front)).clicked() {
        commands.push(Command::AskTime);
    }
}

/// The speed, and below it where one is in the scene and that time runs slowly: beside it where fingers have a higher slider.
fn speed(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    if style::is_for_fingers(ui) {
        speed_row(ui, look, commands);
        return where_and_how_slow(ui, look);
    }
    if look.slow_words().is_none() && look.scene.at.is_none() {
        return speed_row(ui, look, commands);
    }
    ui.allocate_ui_with_layout(vec2(SPEED_WIDTH, 42.0), Layout::top_down(Align::Max), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.allocate_ui_with_layout(vec2(SPEED_WIDTH, 24.0), Layout::right_to_left(Align::Center), |ui| {
            speed_row(ui, look, commands);
        });
        ui.allocate_ui_with_layout(vec2(SPEED_WIDTH, 18.0), Layout::right_to_left(Align::Center), |ui| {
            where_and_how_slow(ui, look);
        });
    });
}

/// Where one is in the scene, and that time runs slowly.
pub(super) fn where_and_how_slow(ui: &mut Ui, look: &Look<'_>) {
    if let Some(step) = look.step_words() {
        ui.label(RichText::new(step).size(14.5));
    }
    if let Some(slow) = look.slow_words() {
        ui.label(RichText::new(slow).size(14.5).color(style::warning(ui.visuals().dark_mode)));
    }
}

/// The slider of the speed, and the speed.
pub(super) fn speed_row(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let speed = look.sim.clock.speed;
    let text = RichText::new(numbers::speed(speed)).monospace().size(16.0);
    ui.add_sized([58.0, 24.0], egui::Label::new(text).halign(Align::Max));
    let mut wanted = speed.abs();
    ui.spacing_mut().slider_width = 90.0;
    let (low, high) = SPEED_POWERS;
    let range = f64::from(low).exp2()..=f64::from(high).exp2();
    let slider = Slider::new(&mut wanted, range).logarithmic(true).smart_aim(false).show_value(false);
    let slid = ui.add(slider).on_hover_text("simulated seconds a real second (+ −)");
    let slid = slid.labelled_by(ui.label("speed").id);
    if slid.changed() {
        // The speeds are powers of two: the one next to the pointer, and none that comes of letting go of it; an arrow key,
        // which moves the slider by less than half of one, goes to the next.
        let power = (wanted / speed.abs()).log2();
        let is_down = slid.is_pointer_button_down_on();
        let (is_let_go, is_still) = ui.input(|input| {
            let pointer = &input.pointer;
            (pointer.any_released() && !pointer.any_pressed(), !pointer.is_decidedly_dragging())
        });
        // A press on the handle itself asks for nothing.
        let is_on_handle = is_down && is_still && power.abs() < 1.0;
        let by_key = !is_down && power.abs() < 0.5;
        let power = if by_key { power.signum() } else { power.round() };
        if power != 0.0 && !is_let_go && !is_on_handle {
            commands.push(Command::SetSpeed(speed.abs() * power.exp2()));
        }
    }
    // Said only where the machine cannot keep up: otherwise it is the speed that is set.
    if look.slowed == 1.0
        && let Some(factor) = look.real_time_factor
        && (factor / speed - 1.0).abs() > 0.05
    {
        ui.label(RichText::new(format!("really {factor:.2}×").replace('-', "−")).weak());
    }
}

/// When it flips next, in words, and whether that is at once.
pub(super) fn next_flip(look: &Look<'_>) -> (String, bool) {
    let speed = look.sim.clock.speed;
    let text = match look.timeline.next_flip(look.sim.time(), speed < 0.0) {
        // No countdown beside words that say it is on its way over.
        Some(_) if is_turning_over(look.sim) => return ("turning over now".to_owned(), true),
        Some(next) => {
            let wait = (next - look.sim.time()).abs();
            return (format!("next flip in {}", look.duration(wait)), wait < SOON * speed.abs());
        }
        None if look.loses_energy() => "flips are not predicted",
        None if look.timeline.first_flip.is_some() => "no flip comes any more",
        None => "it does not flip",
    };
    (text.to_owned(), false)
}

/// How often it flips and when next.
pub(super) fn flips(ui: &mut Ui, look: &Look<'_>) {
    let words = |text: String| RichText::new(text).size(14.5);
    let speed = look.sim.clock.speed;
    let next = look.timeline.next_flip(look.sim.time(), speed < 0.0);
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let (text, is_soon) = next_flip(look);
        let text = RichText::new(text).size(20.0).strong();
        ui.label(if is_soon { text.color(style::warning(ui.visuals().dark_mode)) } else { text });
        if look.loses_energy() {
            let left = 100.0 * (1.0 + look.sim.energy_error());
            ui.label(words(format!("energy is lost: {left:.1} % of K is left")));
            return;
        }
        let start = &look.scene.start;
        let as_rounded = poinsot::classify(&look.scene.body, start.body_momentum);
        if let (MotionClass::Separatrix, Some(period)) = (as_rounded, look.timeline.period) {
            // Few starts on the separatrix can be written down: this one is beside it by the rounding of a number.
            ui.label(words(format!("a rounding beside the separatrix: every {}", look.duration(period))));
        } else if look.timeline.first_flip.is_some() && look.timeline.period.is_none() {
            ui.label(words("once in all time: on the separatrix".to_owned()));
        } else if let Some(period) = look.timeline.period {
            // Counted from the start, wherever one came from.
            let count = next.map_or(0.0, |next| flips_since_start(look.timeline, next, speed < 0.0));
            let count =
                if count < 0.0 { format!("{:.0} before the start", -count) } else { format!("{count:.0} so far") };
            let every = look.duration(period);
            let measured = look.flips.between().map(|time| look.duration(time)).filter(|measured| *measured != every);
            let measured = measured.map_or(String::new(), |time| format!(", measured {time}"));
            ui.label(words(format!("{count}, one every {every}{measured}")));
        }
    });
}

/// Flips between the start and now, from the flip that comes next; negative before the start.
fn flips_since_start(line: &Timeline, next: f64, is_backwards: bool) -> f64 {
    let (Some(first), Some(period)) = (line.first_flip, line.period) else { return 0.0 };
    let ahead = ((next - first) / period).round();
    // Backwards the next flip has already been counted.
    if is_backwards { ahead + 1.0 } else { ahead }
}
