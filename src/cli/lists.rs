//! `scenes`, `methods`, `keys` and `objects`: what there is, a line each.

use std::fmt::Write as _;
use std::path::Path;

use clap::Args;
use dzhanibekov::files;
use dzhanibekov::physics::METHODS;
use dzhanibekov::physics::methods::{Keeps, Order};
use dzhanibekov::scene::{KEYS, SOLID_KEYS, STEP_KEYS, inside, presets};
use serde_json::json;

use super::failure::Failure;

/// Flags of the listing commands.
#[derive(Args, Debug)]
pub(super) struct ListArguments {
    /// Write JSON
    #[arg(long)]
    pub(super) json: bool,
    /// Say nothing but errors: nothing else is said besides the list
    #[arg(long = "quiet")]
    _quiet: bool,
}

pub(super) fn scenes(arguments: &ListArguments) -> Result<(), Failure> {
    let mut rows = Vec::new();
    for preset in presets() {
        let file = preset.read()?;
        rows.push((preset.name, file));
    }
    if arguments.json {
        let list: Vec<_> = rows
            .iter()
            .map(|(name, file)| {
                let steps: Vec<&str> = file.steps.iter().map(|step| &*step.text).collect();
                json!({
                    "name": name, "title": file.title, "text": file.text, "question": file.question,
                    "answer": file.answer, "steps": steps,
                })
            })
            .collect();
        return print(&format!("{:#}\n", json!(list)));
    }
    print(&table(rows.iter().map(|(name, file)| [*name, &file.title])))
}

pub(super) fn methods(arguments: &ListArguments) -> Result<(), Failure> {
    let order = |order| match order {
        Order::Finite(order) => order.to_string(),
        Order::Exact => "exact".to_owned(),
    };
    let keeps = |keeps| match keeps {
        Keeps::Exactly => "exactly",
        Keeps::Nearby => "nearby",
        Keeps::No => "no",
    };
    if arguments.json {
        let list: Vec<_> = METHODS
            .iter()
            .map(|method| {
                json!({
                    "name": method.name, "label": method.label, "order": order(method.order),
                    "explicit": method.explicit, "symplectic": method.symplectic,
                    "keeps": { "momentum": keeps(method.keeps_momentum), "rotation": keeps(method.keeps_rotation),
                               "energy": keeps(method.keeps_energy) },
                    "cost": method.cost, "source": method.source,
                })
            })
            .collect();
        return print(&format!("{:#}\n", json!(list)));
    }
    let rows = METHODS.iter().map(|method| {
        let kept: Vec<&str> =
            [("momentum", method.keeps_momentum), ("rotation", method.keeps_rotation), ("energy", method.keeps_energy)]
                .into_iter()
                .filter_map(|(what, keeps)| (keeps == Keeps::Exactly).then_some(what))
                .collect();
        let kept = if kept.is_empty() { "nothing".to_owned() } else { kept.join(", ") };
        [
            method.name.to_owned(),
            format!("order {}", order(method.order)),
            format!("keeps {kept}"),
            method.label.to_owned(),
        ]
    });
    print(&table(rows))
}

/// `keys`: whatever a scene file can say, with type, unit and flag.
pub(super) fn keys(arguments: &ListArguments) -> Result<(), Failure> {
    let of_scene = KEYS.iter().map(|key| (key.name, key.kind, key.unit, key.help, key.flag));
    let of_solid = SOLID_KEYS.iter().map(|key| (key.name, key.kind, key.unit, key.help, key.flag));
    let of_step = STEP_KEYS.iter().map(|key| (key.name, key.kind, key.unit, key.help, key.flag));
    let rows = of_scene.chain(of_solid).chain(of_step);
    if arguments.json {
        let list: Vec<_> = rows
            .map(|(name, kind, unit, help, flag)| {
                let flag = flag.map(|flag| format!("--{}", flag.name));
                let array = inside(name).map(|(array, _)| array);
                json!({ "name": name, "inside": array, "type": kind.words(), "unit": unit, "flag": flag, "help": help })
            })
            .collect();
        return print(&format!("{:#}\n", json!(list)));
    }
    print(&table(rows.map(|(name, kind, unit, help, flag)| {
        let unit = if unit.is_empty() { String::new() } else { format!(" ({unit})") };
        [
            name.to_owned(),
            format!("{}{unit}", kind.words()),
            match (flag, inside(name)) {
                (Some(flag), _) => format!("--{}", flag.name),
                (None, Some((array, _))) => format!("in [[{array}]]"),
                (None, None) => String::new(),
            },
            help.to_owned(),
        ]
    })))
}

/// `objects`: what can be drawn.
#[cfg(feature = "picture")]
pub(super) fn objects(arguments: &ListArguments) -> Result<(), Failure> {
    use dzhanibekov::objects::{OBJECTS, Space};
    let space = |space| match space {
        Space::World => "world",
        Space::Momentum => "body",
    };
    if arguments.json {
        let list: Vec<_> = OBJECTS
            .iter()
            .map(|object| {
                json!({ "name": object.name, "label": object.label, "view": space(object.space), "shown": object.shown,
                        "about": object.about })
            })
            .collect();
        return print(&format!("{:#}\n", json!(list)));
    }
    print(&table(OBJECTS.iter().map(|object| {
        let shown = if object.shown { "shown" } else { "not shown" };
        [object.name, space(object.space), shown, object.label, object.about]
    })))
}

/// Rows with their columns flush, two blanks apart.
pub(super) fn table<const N: usize, Cell: AsRef<str>>(rows: impl Iterator<Item = [Cell; N]>) -> String {
    let rows: Vec<[Cell; N]> = rows.collect();
    let mut widths = [0; N];
    for row in &rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.as_ref().chars().count());
        }
    }
    let mut text = String::new();
    for row in &rows {
        let mut line = String::new();
        for (width, cell) in widths.iter().zip(row) {
            // Writing to a string cannot fail.
            let _ = write!(line, "{:width$}  ", cell.as_ref());
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// Prints to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    Ok(files::write(Path::new("-"), text.as_bytes())?)
}
