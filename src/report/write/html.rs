//! `report.html`: one page that needs nothing else, in light, dark and on paper.

use std::fmt::Write as _;

use super::format::{escape, short, time};
use super::svg::style;
use super::{bars, plots, sections, summary};
use crate::report::{CaseRow, Report};

/// Cases whose plots stand open; the others unfold.
const OPEN_CASES: usize = 2;
/// Error (rad) at which a caption compares the methods.
const COMPARED_AT: f64 = 1e-6;

const PAGE_STYLE: &str = "\
*{box-sizing:border-box}html{color-scheme:light dark;-webkit-text-size-adjust:100%}
body{margin:0 auto;padding:2.5rem 1.25rem 5rem;max-width:66rem;background:var(--paper);color:var(--ink);\
font:16px/1.55 system-ui,\"Segoe UI\",\"Helvetica Neue\",sans-serif}
h1{font-size:1.9rem;line-height:1.2;margin:0 0 .3rem;font-weight:650}h2{font-size:1.3rem;margin:3.2rem 0 .6rem;font-weight:650}
h3{font-size:1.05rem;margin:1.8rem 0 .4rem}p{margin:.6rem 0;max-width:46rem}ul{max-width:46rem;padding-left:1.2rem}li{margin:.25rem 0}
a{color:inherit;text-underline-offset:.2em;text-decoration-color:var(--rule)}
.soft,figcaption{color:var(--soft)}.lead{color:var(--soft);margin:0 0 1.4rem}
nav ul{display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;list-style:none;padding:.7rem 0;margin:1.2rem 0;border:solid var(--rule);border-width:1px 0;max-width:none}
figure{margin:1.2rem 0 1.6rem}figure svg{display:block;width:100%;height:auto}figcaption{font-size:.9rem;max-width:46rem;margin-top:.3rem}
.grid2{display:grid;grid-template-columns:repeat(auto-fit,minmax(26rem,1fr));gap:0 1.5rem}.grid2 figure{margin:.6rem 0}
.scroll{overflow-x:auto;margin:1rem 0}table{border-collapse:collapse;font-size:.86rem;font-variant-numeric:tabular-nums}
th,td{padding:.28rem .7rem;text-align:right;white-space:nowrap;border-bottom:1px solid var(--faint)}
th{font-weight:600;border-bottom:1px solid var(--rule);vertical-align:bottom}
th:first-child,td:first-child{text-align:left;padding-left:0;position:sticky;left:0;background:var(--paper)}
td.words,th.words{text-align:left}td.words{white-space:normal;min-width:16rem}.growth td.words{min-width:9rem}td.number{font-family:ui-monospace,\"SF Mono\",\"DejaVu Sans Mono\",monospace;font-size:.8rem}
.good{color:var(--good)}.bad{color:var(--bad);font-weight:700}.none{color:var(--soft)}
.hard td,.hard th{padding:.25rem .5rem;font-size:.76rem}.hard th{white-space:normal}.hard th:first-child,.hard td:first-child{padding-left:0}\
.hard td.number{font-size:.72rem;line-height:1.35}.hard small{color:var(--soft);font-weight:400;font-size:.92em}
details{margin:.5rem 0}summary{cursor:pointer;padding:.3rem 0;border-bottom:1px solid var(--faint)}
@media print{body{max-width:none;padding:0;font-size:9.5pt}h2{break-after:avoid;margin-top:1.6rem}figure,tr{break-inside:avoid}nav{display:none}\
.scroll{overflow:visible}table{font-size:7.5pt}td,th{padding:.15rem .35rem}.hard td,.hard th{font-size:6pt;padding:.1rem .25rem}\
.hard td.number,td.number{font-size:inherit}figure svg{max-height:10.5cm}.grid2{grid-template-columns:1fr 1fr}}
";

/// The page.
#[must_use]
pub fn write(report: &Report) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Speed against error: the free rigid body</title>\n<style>\n{}{PAGE_STYLE}</style>\n</head>\n<body>\n",
        style()
    );
    // Writing to a string cannot fail, here and below.
    let kind = if report.quick { " This is the quick report: two cases, and less of everything." } else { "" };
    let _ = writeln!(
        page,
        "<header><h1>Speed against error</h1>\n<p class=\"lead\">Methods for the free rigid body, measured on {}.{kind}</p></header>",
        escape(&report.machine.line())
    );
    page.push_str("<nav aria-label=\"Contents\"><ul>");
    let parts = parts(report);
    for (id, title, _) in &parts {
        let _ = write!(page, "<li><a href=\"#{id}\">{title}</a></li>");
    }
    page.push_str("</ul></nav>\n");
    for (id, title, body) in &parts {
        let _ = writeln!(page, "<section id=\"{id}\">\n<h2>{title}</h2>\n{body}</section>");
    }
    page.push_str("</body>\n</html>\n");
    page
}

/// Every section: its anchor, its title and its text. Those with nothing to say are left out.
fn parts(report: &Report) -> Vec<(&'static str, &'static str, String)> {
    let mut parts = vec![
        ("summary", "Summary", summary_section(report)),
        ("reading", "Reading this report", sections::READING.to_owned()),
        ("work", "Work and precision", work(report)),
    ];
    if !report.beside.is_empty() {
        parts.push(("beside", "Beside other programs", sections::beside(report)));
    }
    parts.extend([
        ("order", "Order", orders(report)),
        ("cost", "Cost of a step", figure(&bars::cost(report).inline(), sections::COST) + &sections::costs(report)),
        ("long-run", "A hundred thousand turns", long_run(report)),
        ("large-steps", "Large steps", large_steps(report)),
        ("hard", "Hard cases", sections::hard(report)),
        ("many-bodies", "Ten thousand bodies", many_bodies(report)),
        ("separatrix", "Beside the separatrix", separatrix(report)),
        ("batch", "Many at a time", sections::batch(report)),
        ("augmented", "The augmented term", augmented(report)),
        ("cases", "What was measured, and how", sections::cases(report)),
    ]);
    parts
}

/// A figure with its caption.
fn figure(svg: &str, caption: &str) -> String {
    format!("<figure>\n{svg}<figcaption>{caption}</figcaption>\n</figure>\n")
}

/// A table: its head, and rows of cells, each with a class.
pub(super) fn table(class: &str, head: &[&str], rows: &[Vec<(&str, String)>]) -> String {
    let mut html = format!("<div class=\"scroll\"><table class=\"{class}\"><thead><tr>");
    for (i, cell) in head.iter().enumerate() {
        // A heading stands as the cells below it do.
        let class = rows.first().and_then(|row| row.get(i)).map_or("", |cell| cell.0);
        let class = if class == "words" { class } else { "" };
        let _ = write!(html, "<th scope=\"col\" class=\"{class}\">{}</th>", escape(cell));
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in rows {
        html.push_str("<tr>");
        for (class, cell) in row {
            let _ = write!(html, "<td class=\"{class}\">{cell}</td>");
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody></table></div>\n");
    html
}

fn summary_section(report: &Report) -> String {
    let rows: Vec<Vec<(&str, String)>> = summary::of(report)
        .iter()
        .map(|row| {
            let cells = row.cells().into_iter().enumerate();
            cells
                .map(|(i, cell)| {
                    (
                        if cell.contains('✗') {
                            "bad"
                        } else if i == 5 {
                            "number"
                        } else {
                            ""
                        },
                        escape(&cell),
                    )
                })
                .collect()
        })
        .collect();
    let mut html = table("", &summary::HEADER, &rows);
    html.push_str(sections::SUMMARY);
    html.push_str("<ul>\n");
    for remark in summary::remarks(report) {
        let _ = writeln!(html, "<li>{}</li>", escape(&remark));
    }
    html.push_str("</ul>\n");
    html
}

fn work(report: &Report) -> String {
    let mut html = sections::WORK.to_owned();
    for (i, case) in report.cases.iter().enumerate() {
        let plot = figure(&plots::work_precision(report, case).inline(), &caption(report, case));
        // The two cases that everybody knows, and the scene that was asked for.
        let is_open = ["Hairer-Lubich-Wanner", "T-handle"].contains(&case.name.as_str())
            || (i + 1 == report.cases.len() && case.reference == "closed form")
            || report.cases.len() <= OPEN_CASES;
        if is_open {
            html.push_str(&plot);
        } else {
            let _ = writeln!(html, "<details><summary>{}, {} s</summary>{plot}</details>", escape(&case.name), case.t);
        }
    }
    html
}

/// Who reaches a middling error first.
fn caption(report: &Report, case: &CaseRow) -> String {
    let mut fastest: Vec<(&str, f64)> = Vec::new();
    for method in crate::physics::METHODS {
        let good = report.rows.iter().filter(|row| {
            row.case == case.name && row.method == method.name && row.errors.attitude_error <= COMPARED_AT
        });
        let least = good.map(|row| row.timing.seconds).fold(f64::INFINITY, f64::min);
        if least.is_finite() {
            fastest.push((method.name, least));
        }
    }
    fastest.sort_by(|a, b| a.1.total_cmp(&b.1));
    let list: Vec<String> = fastest.iter().map(|(name, seconds)| format!("{name} {}", time(*seconds))).collect();
    let list = if list.is_empty() { "no method in the steps tried".to_owned() } else { list.join(", ") };
    format!(
        "Errors against the {} reference. To {} rad come: {list}. The further down and to the left, the better.",
        case.reference,
        short(COMPARED_AT)
    )
}

fn orders(report: &Report) -> String {
    let mut html = sections::ORDER.to_owned();
    html.push_str(&figure(&plots::order(report).inline(), sections::ORDER_CAPTION));
    html.push_str(&sections::orders(report));
    for case in &report.cases {
        let plot = figure(&plots::step_error(report, case).inline(), sections::STEP_CAPTION);
        let _ = writeln!(html, "<details><summary>{}, {} s</summary>{plot}</details>", escape(&case.name), case.t);
    }
    html
}

fn long_run(report: &Report) -> String {
    let mut html = sections::long_run_words(report);
    html.push_str("<div class=\"grid2\">\n");
    for (name, plot) in plots::long_run(report) {
        html.push_str(&figure(&plot.inline(), sections::long_caption(name)));
    }
    html.push_str("</div>\n");
    html.push_str(&sections::growth(report));
    html
}

fn large_steps(report: &Report) -> String {
    let caption = "A ring marks the largest step up to which the first five flips all come at their times, within a tenth of the time \
                   between two. A curve that ends early belongs to a method that refused larger steps, and said so. The ring and the error are different things: \
                   a body may flip at the right times and yet point the wrong way.";
    sections::LARGE_STEPS.to_owned()
        + &figure(&plots::large_steps(report).inline(), caption)
        + &sections::large_steps(report)
}

fn many_bodies(report: &Report) -> String {
    let caption = "Each curve tells on what share of the bodies the error is below that. A curve to the left is a better method; one that \
                   is steep does not depend on the body.";
    sections::MANY_BODIES.to_owned()
        + &figure(&plots::many_bodies(report).inline(), caption)
        + &sections::many_bodies(report)
}

fn separatrix(report: &Report) -> String {
    let caption = "The line without marks is how far an ulp of the start moves the answer itself, up to then: what a method adds below it \
                   cannot be seen in any motion that was measured or rounded. A method that lies far below still follows the start as it is given, bit for bit.";
    sections::SEPARATRIX.to_owned() + &figure(&plots::separatrix(report).inline(), caption)
}

fn augmented(report: &Report) -> String {
    let caption = "Each curve tells for what share of the bodies the error is below that multiple of plain second order's, whose own curve \
                   is the step at 1. A curve to the left is a better method.";
    sections::augmented_words(report)
        + &figure(&plots::augmented(report).inline(), caption)
        + &sections::augmented(report)
}
