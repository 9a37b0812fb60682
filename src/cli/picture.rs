//! `shot` and `adapters`: pictures with no window.

use dzhanibekov::headless::{HeadlessError, ShotOptions, shot as draw};
use dzhanibekov::objects::{OBJECTS, object_named};
use dzhanibekov::render;
use dzhanibekov::scene::{Scene, nearest};
use dzhanibekov::sim::Simulation;
use serde_json::json;

use super::arguments::PictureArguments;
use super::failure::Failure;
use super::lists::{ListArguments, print, table};
use super::output::{check_place, io_failure, write_whole};
use super::quiet_driver::keep_quiet;

impl From<HeadlessError> for Failure {
    fn from(error: HeadlessError) -> Self {
        if error.is_bad_request() { Self::request(error.to_string()) } else { Self::could(error.to_string()) }
    }
}

/// `shot`: everything that can be refused is refused before anything is drawn.
pub(super) fn shot(arguments: &PictureArguments) -> Result<(), Failure> {
    keep_quiet();
    let scene = arguments.scene.scene(Some(&arguments.view), arguments.quiet)?;
    check_objects(&scene)?;
    let simulation = simulation_at(&scene, arguments.time)?;
    check_place(&arguments.output)?;
    let options =
        ShotOptions { size: arguments.size, transparent: arguments.transparent, adapter: arguments.adapter.clone() };
    let bytes = draw(&simulation, &options)?;
    write_whole(&arguments.output, |writer| {
        writer.write_all(&bytes).map_err(|error| io_failure(&arguments.output, &error))
    })
}

/// The scene's motion at a time (s).
fn simulation_at(scene: &Scene, time: f64) -> Result<Simulation, Failure> {
    if !time.is_finite() {
        return Err(Failure::request(format!("--time {time} is not finite")));
    }
    let mut simulation = Simulation::new(scene);
    if time != 0.0 {
        simulation.go_to(time);
    }
    match simulation.main().failure() {
        Some(error) => Err(Failure::could(error.to_string())),
        None => Ok(simulation),
    }
}

/// Refuses names of objects that do not exist.
pub(super) fn check_objects(scene: &Scene) -> Result<(), Failure> {
    for name in scene.view.show.iter().chain(&scene.view.hide) {
        if object_named(name).is_none() {
            let known = OBJECTS.iter().map(|object| object.name);
            let hint = match nearest(name, known.clone()) {
                Some(near) => format!("the nearest is `{near}`"),
                None => format!("there are {}", known.collect::<Vec<_>>().join(", ")),
            };
            return Err(Failure::request(format!("object `{name}` is not known: {hint}")));
        }
    }
    Ok(())
}

/// `adapters`: what there is to draw with.
pub(super) fn adapters(arguments: &ListArguments) -> Result<(), Failure> {
    keep_quiet();
    let found = render::adapters();
    if arguments.json {
        let list: Vec<_> = found
            .iter()
            .map(|adapter| {
                json!({ "name": adapter.name, "kind": adapter.kind, "backend": adapter.backend, "driver": adapter.driver })
            })
            .collect();
        return print(&format!("{:#}\n", json!(list)));
    }
    if found.is_empty() {
        return Err(Failure::could(render::no_adapter()));
    }
    print(&table(found.iter().map(|adapter| [&*adapter.name, adapter.kind, adapter.backend, &*adapter.driver])))
}
