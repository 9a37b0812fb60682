//! The motion as numbers, for pages and notebooks around this one: what `trace` writes.

use js_sys::{Array, Float64Array};
use wasm_bindgen::JsValue;

use crate::physics::Integration;
use crate::scene::Scene;

/// Most times that are answered at once, and most steps on the way to one.
const MOST_TIMES: usize = 100_000;
const MOST_STEPS: f64 = 1e6;

/// A row for each of these times (s), in the order and with the bits of the columns of `trace`; a sentence where that cannot be.
pub(super) fn rows(scene: &Scene, times: &[f64]) -> Result<Array, String> {
    if times.len() > MOST_TIMES {
        return Err(format!("{} times are too many: at most {MOST_TIMES} are answered at once", times.len()));
    }
    if let Some(time) = times.iter().find(|time| !time.is_finite()) {
        return Err(format!("{time} is no time: times are finite numbers (s)"));
    }
    let farthest = times.iter().fold(0.0, |farthest: f64, time| farthest.max(time.abs()));
    let steps = farthest / scene.step;
    if !scene.method.is_direct && steps > MOST_STEPS {
        return Err(format!(
            "{farthest} s is {steps} steps away: at most {MOST_STEPS} are taken; closed-form goes to any time at once"
        ));
    }
    let mut integration =
        Integration::with_energy_loss(scene.method, &scene.body, scene.start, scene.step, scene.energy_loss);
    let rows = Array::new();
    for &time in times {
        let state = integration.state_at(time).map_err(|error| error.to_string())?;
        let turned = state.world_from_body.transpose();
        let rate = state.body_angular_velocity(&scene.body);
        let vectors = [turned.x_axis, turned.y_axis, turned.z_axis, state.body_momentum, rate, state.world_momentum];
        let mut row = vec![time];
        row.extend(vectors.iter().flat_map(glam::DVec3::to_array));
        row.push(state.energy(&scene.body));
        rows.push(&JsValue::from(Float64Array::from(row.as_slice())));
    }
    Ok(rows)
}
