//! Two charts below the picture: the angular velocity in the body, and the errors of the methods.

use egui::{Color32, RichText, Ui};
use egui_plot::{Line, LineStyle, Plot, PlotPoints, Points, VLine};

use super::numbers::{power_of_ten, significant, trimmed};
use super::timeline::round_step;
use super::{Command, Look, style};
use crate::physics::Method;
use crate::sim::Errors;
use crate::sim::Runner;

/// Width (points) that both charts take.
const TWO_CHARTS: f32 = 720.0;
/// Points of a curve.
const POINTS: u32 = 500;
/// What is drawn for no error at all, on the logarithmic scale.
const FLOOR: f64 = -17.0;
/// What the second chart shows where energy is lost.
const ENERGY_LEFT: &str = "Energy K, in parts of that of the start";
/// The components of the angular velocity along the principal axes.
const NAMES: [&str; 3] = ["Ω₁", "Ω₂", "Ω₃"];

/// Which error the second chart shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Kind {
    #[default]
    Energy,
    Momentum,
    Attitude,
}

impl Kind {
    fn of(self, errors: &Errors) -> f64 {
        match self {
            Self::Energy => errors.energy.abs(),
            Self::Momentum => errors.momentum,
            Self::Attitude => errors.attitude,
        }
    }
}

/// The charts.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Charts {
    kind: Kind,
    /// Which one is shown where there is no room for both.
    shows_errors: bool,
}

impl Charts {
    /// Shows them side by side.
    pub(super) fn ui(&mut self, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
        if ui.available_width() < TWO_CHARTS {
            self.one(ui, look, commands);
            return;
        }
        ui.columns(2, |columns| {
            if let [left, right] = columns {
                velocity(left, look, commands);
                self.errors(right, look, commands);
            }
        });
    }

    /// Where there is no room for both: the one that is chosen.
    fn one(&mut self, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
        ui.horizontal(|ui| {
            ui.selectable_value(&mut self.shows_errors, false, "velocity");
            let other = if look.loses_energy() { "energy" } else { "errors" };
            ui.selectable_value(&mut self.shows_errors, true, other);
            if self.shows_errors && look.loses_energy() {
                ui.label(ENERGY_LEFT);
            } else if self.shows_errors {
                ui.separator();
                self.kinds(ui);
            } else {
                names(ui, look);
            }
        });
        match (self.shows_errors, look.loses_energy()) {
            (true, true) => energy_graph(ui, look, commands),
            (true, false) => errors_graph(self.kind, ui, look, commands),
            (false, _) => velocity_graph(ui, look, commands),
        }
    }

    fn kinds(&mut self, ui: &mut Ui) {
        for (kind, name) in [(Kind::Energy, "energy"), (Kind::Momentum, "momentum"), (Kind::Attitude, "attitude")] {
            ui.selectable_value(&mut self.kind, kind, name);
        }
    }

    fn errors(&mut self, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
        if look.loses_energy() {
            ui.label(ENERGY_LEFT);
            energy_graph(ui, look, commands);
            return;
        }
        ui.horizontal(|ui| {
            ui.label("Error of");
            self.kinds(ui);
        });
        errors_graph(self.kind, ui, look, commands);
    }
}

/// The names of the methods in their colours, above the graph, where they cover nothing of it.
fn method_names(ui: &mut Ui, runners: &[&'static Method], look: &Look<'_>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(10.0, 0.0);
        for method in runners {
            ui.label(look.method_text(method).small());
        }
    });
}

fn errors_graph(kind: Kind, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let runners: Vec<&'static Method> =
        std::iter::once(look.sim.main()).chain(look.sim.ghosts()).map(Runner::method).collect();
    method_names(ui, &runners, look);
    let is_dark = ui.visuals().dark_mode;
    let response = plot("errors", look)
        .default_y_bounds(FLOOR, 1.0)
        .y_axis_formatter(|mark, _| if mark.value.fract() == 0.0 { power_of_ten(mark.value) } else { String::new() })
        .y_grid_spacer(egui_plot::uniform_grid_spacer(|_| [20.0, 10.0, 5.0]))
        .show(ui, |plot| {
            for (index, method) in runners.iter().enumerate() {
                let color = look.color_of(method);
                let pieces = look.history.pieces(|sample| {
                    let error = kind.of(sample.errors.get(index)?);
                    Some(if error > 0.0 { error.log10().max(FLOOR) } else { FLOOR })
                });
                for piece in pieces {
                    let line = Line::new(method.short_label(), PlotPoints::from(piece));
                    plot.line(line.color(color).width(if index == 0 { 2.5 } else { 1.5 }));
                }
            }
            finish(plot, look, is_dark)
        });
    name(&response.response, "graph of the errors of the methods");
    go_to(response.inner, commands);
}

/// How much of its energy a body that loses it has left.
fn energy_graph(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let is_dark = ui.visuals().dark_mode;
    let chart = plot("energy", look).default_y_bounds(0.0, 1.0).include_y(0.0).include_y(1.0);
    let response = chart.show(ui, |plot| {
        let color = look.color_of(look.scene.method);
        for piece in look.history.pieces(|sample| Some(1.0 + sample.errors.first()?.energy)) {
            plot.line(Line::new("K", PlotPoints::from(piece)).color(color).width(2.5));
        }
        finish(plot, look, is_dark)
    });
    name(&response.response, "graph of the energy that is left");
    go_to(response.inner, commands);
}

fn velocity(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        ui.label("Angular velocity in the body");
        names(ui, look);
    });
    velocity_graph(ui, look, commands);
}

fn names(ui: &mut Ui, look: &Look<'_>) {
    for (name, color) in NAMES.into_iter().zip(look.axis_colors()) {
        ui.label(RichText::new(name).size(17.0).strong().color(color));
    }
}

fn velocity_graph(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let is_dark = ui.visuals().dark_mode;
    let principal_from_body = look.sim.body().body_from_principal().transpose();
    let moments = look.sim.body().principal_moments();
    let (low, high) = (look.timeline.low, look.timeline.high);
    let omega = |momentum| principal_from_body * momentum / moments;
    // Where energy is lost only what has been is known.
    let curves: [Vec<Vec<[f64; 2]>>; 3] = std::array::from_fn(|axis| {
        if look.loses_energy() {
            return look.history.pieces(|sample| Some(omega(sample.momentum).to_array()[axis]));
        }
        let time = |index| low + (high - low) * f64::from(index) / f64::from(POINTS);
        let at = |index| [time(index), omega(look.motion.momentum(time(index))).to_array()[axis]];
        vec![(0..=POINTS).map(at).collect()]
    });
    let now = principal_from_body * look.sim.state().body_momentum / moments;
    let per = look.time_unit();
    let unit = move |mark: egui_plot::GridMark, _: &_| format!("{} rad/{per}", trimmed(&significant(mark.value, 4)));
    let chart = plot("velocity", look).y_axis_min_width(70.0).y_axis_formatter(unit);
    let chart = chart.y_grid_spacer(egui_plot::uniform_grid_spacer(|grid| round_steps(&grid, 5.0)));
    let colors = look.axis_colors();
    let response = chart.show(ui, |plot| {
        for ((axis, name), pieces) in NAMES.into_iter().enumerate().zip(curves) {
            let color = colors[axis];
            for piece in pieces {
                plot.line(Line::new(name, PlotPoints::from(piece)).color(color).width(2.0));
            }
            // Where the method at work has it: off the line where the method errs.
            let here = vec![[look.sim.time(), now.to_array()[axis]]];
            plot.points(Points::new("", PlotPoints::from(here)).color(color).radius(4.0).allow_hover(false));
        }
        finish(plot, look, is_dark)
    });
    name(&response.response, "graph of the angular velocity in the body, Ω₁ Ω₂ Ω₃");
    go_to(response.inner, commands);
}

/// Tells a screen reader what a graph is.
fn name(graph: &egui::Response, name: &str) {
    graph.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, name));
}

fn plot<'a>(name: &'static str, look: &Look<'_>) -> Plot<'a> {
    let unit = look.time_unit();
    Plot::new(name)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_axis_zoom_drag(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show_crosshair(false)
        .default_x_bounds(look.timeline.low, look.timeline.high)
        .x_axis_formatter(move |mark, _| format!("{} {unit}", trimmed(&significant(mark.value, 6))))
        .x_grid_spacer(egui_plot::uniform_grid_spacer(|grid| round_steps(&grid, 8.0)))
        .grid_spacing(egui::Rangef::new(14.0, 120.0))
        .grid_color(Color32::GRAY)
        .y_axis_min_width(38.0)
        .label_formatter(|_| None)
        .set_margin_fraction(egui::vec2(0.0, 0.08))
}

/// Round distances of lines, the smallest such that there are about `count` of them.
fn round_steps(grid: &egui_plot::GridInput, count: f64) -> [f64; 3] {
    let step = round_step((grid.bounds.1 - grid.bounds.0) / count).unwrap_or(1.0);
    [10.0 * step, 5.0 * step, step]
}

/// The cursor at the present time; gives the time that was clicked or dragged to.
fn finish(plot: &mut egui_plot::PlotUi<'_>, look: &Look<'_>, is_dark: bool) -> Option<f64> {
    plot.set_plot_bounds_x(look.timeline.low..=look.timeline.high);
    let color = style::accent(is_dark);
    plot.vline(VLine::new("", look.sim.time()).color(color).width(1.5).style(LineStyle::Solid).allow_hover(false));
    let response = plot.response();
    if !(response.clicked() || response.dragged()) {
        return None;
    }
    let pointer = response.interact_pointer_pos()?;
    Some(plot.plot_from_screen(pointer).x.clamp(look.timeline.low, look.timeline.high))
}

fn go_to(time: Option<f64>, commands: &mut Vec<Command>) {
    if let Some(time) = time {
        commands.push(Command::GoTo(time));
    }
}
