//! The words and the tables of the page.

use super::format::{escape, short, time, times};
use super::html::table;
use crate::physics::methods::Keeps;
use crate::physics::{self, METHODS};
use crate::report::long_run::Growth;
use crate::report::{Report, is_direct};

pub(super) const SUMMARY: &str = "<p class=\"soft\">Order as claimed and as measured; time of a step and its ratio to the floor, a lone sine \
and cosine; the smallest attitude error reached on the first case (rad); the largest step |Ω|h up to which a tumbling T-handle flips at the right \
times; hard cases held, of those in which the method promises anything.</p>\n";

pub(super) const READING: &str = "\
<p>A free rigid body is a problem with a known answer, so a program that computes its motion can be held to it. Each \
method here cuts time into steps of length h and advances the body step by step; three things are asked of it.</p>\n\
<p><b>Order</b> is how fast the error falls as the steps get shorter: halve the step, and the error of a method of order p falls to \
1/2<sup>p</sup>. On paper with logarithms on both axes that is a straight line of slope p. All lines end on the floor of \
round-off, near 10⁻¹⁵, where shorter steps no longer help and the rounding of every step begins to add up. An <i>exact</i> method has no \
slope at all: it lies on the floor at any step.</p>\n\
<p><b>Stability</b> is how large a step may be before the answer turns into nonsense: not a little wrong, but a body that swells, spins up, \
or flips when it should not.</p>\n\
<p><b>Conservation</b> is what remains true over a long time. Energy and momentum of the real body never change, and a rotation stays a \
rotation. A method that respects them shows a flat line near round-off; one that follows a nearby energy shows a flat line higher up; \
any other drifts, as t or faster. A method may keep the energy perfectly and still have the body at the wrong place on its way: \
small error and exact conservation are different virtues.</p>\n\
<p>Errors of attitude are angles in radians: 10⁻⁶ rad is a hair's breadth seen from a hundred metres. Errors of energy and momentum \
are relative.</p>\n";

pub(super) const WORK: &str = "<p>What does an error cost? Each curve is one method, from its coarsest steps (top left) to its finest. Thin \
bars are the middle half of repeated timings; dotted lines have the slope of their order. The closed form is a single point: it goes to \
the time asked for at once.</p>\n";

pub(super) const ORDER: &str = "<p>The same error against the step alone. The slope is fitted between the coarse steps, where the \
leading term does not rule yet, and the floor of round-off.</p>\n";

pub(super) const ORDER_CAPTION: &str = "The number beside each name is the measured slope. Dotted lines have the slopes 1, 2 and 4; exact methods lie flat on the floor.";

pub(super) const STEP_CAPTION: &str =
    "The same for the whole time of the case, at the points of the plot of work and precision.";

pub(super) const COST: &str = "Median of the repeats, with the spread of their middle half. The dashed line is the latency of one sine and cosine that \
waits for the one before it: a method that calls them once a step can hardly be faster. The closed form's bar is one evaluation, at any time.";

pub(super) const LARGE_STEPS: &str = "<p>A tumbling T-handle with steps up to three radians each: half a turn in one step. \
The error is that after one flip.</p>\n";

pub(super) const MANY_BODIES: &str = "<p>One case may flatter a method. Here boxes with random edges, each set turning about a random direction, \
are followed with the same angle a step, and the errors are sorted. The truth is the closed form; the closed form itself is held against the motion begun \
anew halfway, where its start is rounded.</p>\n";

pub(super) const SEPARATRIX: &str = "<p>A T-handle spun about its middle axis, ever closer to it: at each tenth of the tilt the flip comes later, and \
with it what a rounding of the start is worth. The steps are of a hundredth of a radian; the truth is the closed form.</p>\n";

/// How the errors are spread.
pub(super) fn many_bodies(report: &Report) -> String {
    let rows: Vec<_> = report
        .distributions
        .iter()
        .map(|row| {
            let failed = if row.failed == 0 { "–".to_owned() } else { row.failed.to_string() };
            let [median, most, worst] =
                [row.median, row.percentile_99, row.worst].map(|error| ("number", short(error)));
            vec![("", row.method.to_owned()), median, most, worst, ("", failed)]
        })
        .collect();
    table("", &["method", "median", "99 %", "worst", "could not go on"], &rows)
}

/// What many bodies at a time cost.
pub(super) fn batch(report: &Report) -> String {
    let batch = &report.batch;
    let names = [
        "a step of one body, with all that this processor has",
        "the same with what every processor of its kind has",
        "the same, each body by itself",
    ];
    let mut rows: Vec<_> = names.into_iter().zip(batch.step).collect();
    rows.push(("the momentum of one start at any time", batch.momentum));
    rows.push(("the state of one start at any time", batch.state));
    let rows: Vec<_> = rows
        .into_iter()
        .map(|(name, timing)| {
            let spread = format!("{} … {}", time(timing.seconds_lower), time(timing.seconds_upper));
            vec![("words", name.to_owned()), ("", time(timing.seconds)), ("", spread)]
        })
        .collect();
    format!(
        "<p>{} random bodies side by side, several in each register of the processor, stepped exactly; and {} starts of one body, gone to at once by the closed \
         form. Over 10⁴ steps the largest attitude error of the stepped ones is {:.2} of the bound 8ε(1 + |Ω|t) that the single step has too.</p>\n{}",
        batch.bodies,
        batch.starts,
        batch.part_of_bound,
        table("", &["", "median", "middle half"], &rows)
    )
}

/// The table of orders.
pub(super) fn orders(report: &Report) -> String {
    let rows: Vec<_> = report
        .orders
        .iter()
        .map(|row| {
            let claimed = row.claimed.map_or_else(|| "exact".to_owned(), |order| order.to_string());
            let measured = row.measured.map_or_else(|| "–".to_owned(), |slope| format!("{slope:.2}"));
            let mark = if row.agrees { ("good", "✓".to_owned()) } else { ("bad", "✗".to_owned()) };
            vec![("", row.method.to_owned()), ("", claimed), ("", measured), mark, ("words", escape(&row.words))]
        })
        .collect();
    table("", &["method", "claimed", "measured", "", ""], &rows)
}

/// The table of costs.
pub(super) fn costs(report: &Report) -> String {
    let rows: Vec<_> = report
        .cost
        .methods
        .iter()
        .map(|row| {
            let step = physics::method(row.method).map_or("", |method| method.cost);
            vec![
                ("", row.method.to_owned()),
                ("", time(row.timing.seconds)),
                ("", format!("{} … {}", time(row.timing.seconds_lower), time(row.timing.seconds_upper))),
                ("", format!("{:.1}", row.ratio)),
                ("", time(row.prepare.seconds)),
                ("words", escape(step)),
            ]
        })
        .collect();
    table("", &["method", "a step", "middle half", "× floor", "preparation", "what a step does"], &rows)
}

/// What the long run is.
pub(super) fn long_run_words(report: &Report) -> String {
    let Some(run) = report.long_run.first() else { return String::new() };
    let turns = report.long_run.iter().flat_map(|run| &run.samples).filter(|sample| sample.t <= 1e6);
    let turns = turns.map(|sample| sample.turns).fold(0.0, f64::max);
    format!(
        "<p>{} over {turns:.0} turns with a step of {} s. The closed form is compared at the times of the 60-digit table alone; everywhere else \
         it is itself the truth that the others are measured against.</p>\n",
        escape(&run.case),
        run.step
    )
}

/// What one sees in a plot of the long run.
pub(super) fn long_caption(name: &str) -> &'static str {
    match name {
        "attitude" => {
            "The angle between the computed attitude and the true one. At half a radian it is lost, and the curve says no more."
        }
        "energy" => "A flat line is an energy kept, exactly or nearby; a slope of one is a steady drift.",
        "momentum" => {
            "RM against the momentum at the start. Methods that store the momentum of the world keep it by construction."
        }
        _ => {
            "Methods that add matrices leave the rotations: the drawn body swells, shrinks and shears. Those that multiply rotations stay."
        }
    }
}

/// The laws of growth.
pub(super) fn growth(report: &Report) -> String {
    let cell = |growth: &Growth| {
        (
            "words",
            format!(
                "{}<br><span class=\"soft\">{}</span>",
                escape(&growth.words),
                if growth.largest < 10.0 { short(growth.largest) } else { "beyond all bounds".to_owned() }
            ),
        )
    };
    let rows: Vec<_> = report
        .long_run
        .iter()
        .map(|run| {
            vec![
                ("", run.method.to_owned()),
                cell(&run.attitude),
                cell(&run.energy),
                cell(&run.momentum),
                cell(&run.orthogonality),
            ]
        })
        .collect();
    table("growth", &["method", "attitude", "energy", "momentum", "rotation"], &rows)
}

/// The largest steps that flip rightly.
pub(super) fn large_steps(report: &Report) -> String {
    let rows: Vec<_> = report
        .stability
        .iter()
        .filter(|row| !is_direct(row.method))
        .map(|row| {
            let largest =
                row.largest_right_step.map_or_else(|| "none tried".to_owned(), |angle| format!("{angle:.3} rad"));
            let refusal = row.samples.iter().find_map(|sample| Some((sample.angle, sample.said.as_ref()?)));
            let refusal =
                refusal.map(|(angle, said)| format!("from {angle:.2} rad: {}", escape(said))).unwrap_or_default();
            vec![("", row.method.to_owned()), ("", largest), ("words", refusal)]
        })
        .collect();
    table("", &["method", "flips rightly up to", "what it refuses"], &rows)
}

/// The matrix of hard cases.
pub(super) fn hard(report: &Report) -> String {
    let mut cases: Vec<&str> = Vec::new();
    for row in &report.hard {
        if !cases.contains(&row.case.as_str()) {
            cases.push(&row.case);
        }
    }
    let mut head = vec!["case", "t (s)"];
    head.extend(METHODS.iter().map(|method| method.name));
    let rows: Vec<_> = cases
        .iter()
        .map(|case| {
            let in_case = || report.hard.iter().filter(|row| row.case == *case);
            let seconds = in_case().next().map_or(0.0, |row| row.t);
            let seconds = if (0.1..1e5).contains(&seconds) { format!("{seconds:.1}") } else { short(seconds) };
            let mut cells = vec![("", escape(case)), ("number", seconds)];
            cells.extend(METHODS.iter().map(|method| match in_case().find(|row| row.method == method.name) {
                None => ("none", String::new()),
                Some(row) => {
                    let error = row.error.map_or_else(|| "said so".to_owned(), short);
                    let bound = row.bound.map_or_else(|| "–".to_owned(), short);
                    let (class, mark) = match (row.held, row.is_promised()) {
                        (false, _) => ("number bad", " ✗"),
                        (true, true) => ("number good", " ✓"),
                        (true, false) => ("number none", " ·"),
                    };
                    let said = row.said.as_ref().map(|said| format!("; {}", escape(said))).unwrap_or_default();
                    let title = format!("{} steps, against {}{said}", row.steps, row.reference);
                    let bound = if row.is_promised() && row.error.is_some() {
                        format!("<br><small>≤ {bound}</small>")
                    } else {
                        String::new()
                    };
                    (class, format!("<span title=\"{title}\">{error}{mark}</span>{bound}"))
                }
            }));
            cells
        })
        .collect();
    format!(
        "<p>Motions chosen to break things: beside the separatrix and on it, moments that are equal or nearly so, needles and plates, sizes at \
         the ends of the numbers, times from which no step returns. Each error (rad; in the row of three-radian steps that of the energy, relative) is \
         held against a bound worked out beforehand, from the order of the method, a step of 0.01 rad and the sensitivity of the motion itself: ✓ within the \
         bound, ✗ past it, · nothing promised, because an error of that size is what such a step must expect there.</p>\n{}",
        table("hard", &head, &rows)
    )
}

/// What was done about the augmented term, and what it shows.
pub(super) fn augmented_words(report: &Report) -> String {
    let outcome = &report.augmented;
    format!(
        "<p>Buss' second-order method adds <i>h</i>²/12 α×ω to the mean velocity of a step. {} boxes with random edges, each set turning about a random \
         direction, were followed with steps of {} rad without that term, with it, and with its sign reversed; all three have order two.</p>\n<p>{}</p>\n",
        outcome.bodies,
        outcome.angle,
        escape(&outcome.words)
    )
}

/// The quantiles of the experiment on the augmented term.
pub(super) fn augmented(report: &Report) -> String {
    let mut rows = Vec::new();
    for horizon in &report.augmented.horizons {
        for variant in &horizon.variants {
            let mut row = vec![
                ("", escape(variant.name)),
                ("", format!("{:.0} rad", horizon.turned)),
                ("number", short(variant.median_error)),
            ];
            row.extend(variant.ratio_quantiles.map(|ratio| ("", format!("{ratio:.2}"))));
            row.push(("", format!("{:.0} %", 100.0 * variant.better)));
            rows.push(row);
        }
    }
    table("", &["variant", "turned", "median error", "10 %", "25 %", "ratio: 50 %", "75 %", "90 %", "better on"], &rows)
}

/// Other programs' points beside the best here.
pub(super) fn beside(report: &Report) -> String {
    let none = || ("none", "none as accurate".to_owned());
    let rows: Vec<_> = report
        .beside
        .iter()
        .map(|row| {
            let peer = &row.peer;
            let mut line = vec![
                ("", escape(&peer.case)),
                ("", escape(&peer.peer)),
                ("", escape(&peer.setting)),
                ("number", short(peer.error)),
                ("", time(peer.seconds)),
            ];
            match &row.stepping {
                Some(faster) => line.extend([
                    ("", format!("{} {}", faster.method, time(faster.seconds))),
                    ("number", short(faster.error)),
                    ("", format!("{}×", times(faster.times_faster))),
                ]),
                None => line.extend([none(), none(), none()]),
            }
            match &row.closed_form {
                Some(faster) => {
                    line.extend([("", time(faster.seconds)), ("", format!("{}×", times(faster.times_faster)))]);
                }
                None => line.extend([none(), none()]),
            }
            line
        })
        .collect();
    let head = [
        "case",
        "program",
        "setting",
        "error",
        "time",
        "fastest stepping",
        "its error",
        "faster",
        "closed form",
        "faster",
    ];
    format!(
        "<p>Other programs' points were measured by themselves, on the same motions, and read from a file. Beside each stand the fastest stepping \
         method here whose error is no larger, and the closed form. Times here are medians; what is prepared once for a motion is not \
         in them, as compiling is not in the others'.</p>\n{}",
        table("hard", &head, &rows)
    )
}

/// The cases, and how things were measured.
pub(super) fn cases(report: &Report) -> String {
    let three = |values: [f64; 3]| values.map(|value| format!("{value:.5}")).join(", ");
    let rows: Vec<_> = report
        .cases
        .iter()
        .map(|case| {
            vec![
                ("", escape(&case.name)),
                ("", three(case.moments)),
                ("", three(case.omega)),
                ("", format!("{}", case.t)),
                ("", case.reference.to_owned()),
            ]
        })
        .collect();
    let keeps = |keeps: Keeps| match keeps {
        Keeps::Exactly => ("good", "exactly".to_owned()),
        Keeps::Nearby => ("", "nearby".to_owned()),
        Keeps::No => ("none", "no".to_owned()),
    };
    let methods: Vec<_> = METHODS
        .iter()
        .map(|method| {
            vec![
                ("", method.name.to_owned()),
                keeps(method.keeps_momentum),
                keeps(method.keeps_rotation),
                keeps(method.keeps_energy),
                ("words", escape(method.source)),
            ]
        })
        .collect();
    format!(
        "{}<p>Attitudes are compared with a table from 60-digit arithmetic where it has the time, and with the closed form elsewhere. The error of \
         an attitude is the angle of the rotation that takes one to the other.</p>\n\
         <p>Times are those of the integration alone, on one thread, warm; short runs are repeated within one reading of the clock, and the methods \
         take turns, so that a busy moment of the machine falls on all of them. A time is the median of the readings, and its bar spans their middle half; the least and the most \
         are in the files. |Ω| is the angular velocity at the start.</p>\n<h3>What each method claims to keep</h3>\n{}",
        table("", &["case", "principal moments (kg m²)", "Ω at the start (rad/s)", "t (s)", "reference"], &rows),
        table("", &["method", "momentum", "rotation", "energy", "source"], &methods)
    )
}
