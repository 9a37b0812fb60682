//! What the scenes say, held against the motion: each figure in their texts, questions and answers.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::assert_at_most;
use dzhanibekov::physics::{Motion, State, motion, period, poinsot, so3};
use dzhanibekov::scene::{self, Scene};
use dzhanibekov::sim::Simulation;
use glam::DVec3;

/// The built-in scene of this name, of which all of these words are said.
fn scene_that_says(name: &str, words: &[&str]) -> Scene {
    let file = scene::preset(name).expect("a scene").read().expect("a scene's text");
    let steps = file.steps.iter().map(|step| step.text.as_str());
    let texts: Vec<&str> = [file.text.as_str(), &file.question, &file.answer].into_iter().chain(steps).collect();
    for words in words {
        assert!(texts.iter().any(|text| text.contains(words)), "{name} does not say: {words}");
    }
    Scene::check(&file).expect("a scene")
}

/// The angle (degrees) between two directions.
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

/// The angle (rad) of the rotation from one attitude to another.
fn apart(a: &State, b: &State) -> f64 {
    let q = so3::quaternion(a.world_from_body.transpose() * b.world_from_body);
    2.0 * q.xyz().length().atan2(q.w.abs())
}

fn exact(scene: &Scene) -> Motion {
    Motion::new(&scene.body, &scene.start)
}

/// A body momentum in principal components.
fn principal(scene: &Scene, momentum: DVec3) -> DVec3 {
    scene.body.body_from_principal().transpose() * momentum
}

/// Of M's angle (degrees) from a principal axis over many periods, the least and the largest.
fn angles_from(scene: &Scene, axis: DVec3) -> (f64, f64) {
    let exact = exact(scene);
    let along = |n: i32| angle(principal(scene, exact.momentum(0.01 * f64::from(n))), axis);
    (0..20_000).map(along).fold((180.0, 0.0), |(low, high), angle| (low.min(angle), high.max(angle)))
}

/// Times at which M passes between the two ends of axis 2, up to this one (s).
fn flips(scene: &Scene, duration: f64) -> Vec<f64> {
    let (first, every) = (
        poinsot::next_flip_of(&scene.body, &scene.start).expect("it flips"),
        poinsot::flip_period_of(&scene.body, &scene.start).expect("it flips"),
    );
    let times: Vec<f64> =
        (0..1_000).map(|n| first + every * f64::from(n)).take_while(|time| *time < duration).collect();
    let exact = exact(scene);
    for time in &times {
        let middle = |time: f64| principal(scene, exact.momentum(time)).y;
        assert!(middle(time - 0.01 * every) * middle(time + 0.01 * every) < 0.0, "no flip at {time}");
    }
    times
}

#[test]
fn about_axes_1_and_3_it_stays_near() {
    let (low, high) = angles_from(&scene_that_says("axis-1", &["some 12° to 13°", "stays small"]), DVec3::X);
    assert!((11.5..12.5).contains(&low) && (12.5..13.5).contains(&high), "{low} {high}");
    let scene = scene_that_says("axis-3", &["never turns over", "the least energy"]);
    assert!(angles_from(&scene, DVec3::Z).1 < 15.0);
    // ℓ²/2I is least about axis 3.
    let moments = scene.body.principal_moments();
    assert!(moments.z > moments.y && moments.y > moments.x);
}

#[test]
fn beside_the_separatrix_it_lingers() {
    let scene = scene_that_says(
        "near-separatrix",
        &["a millionth of a degree beside axis 2", "lingers", "it is seen to pass beside", "e-fold by e-fold"],
    );
    let body = &scene.body;
    assert_at_most((angle(scene.start.body_angular_velocity(body), DVec3::Y) / 1e-6 - 1.0).abs(), 1e-9, "the tilt");
    let exact = exact(&scene);
    let near =
        (0..3_000).filter(|n| exact.momentum(0.01 * f64::from(*n)).normalize().y.abs() > 5f64.to_radians().cos());
    assert!(near.count() > 2_400);
    // On it, what is missing to the end shrinks as e^(−σt).
    let sigma = poinsot::growth_rate(body, 1.0);
    let missing = |time: f64| angle(period::separatrix_at(body, 1.0, time).expect("three moments")[0], DVec3::Y);
    assert_at_most((missing(6.0 / sigma) / missing(5.0 / sigma) * 1f64.exp() - 1.0).abs(), 1e-3, "an e-fold");
}

#[test]
fn a_smaller_tilt_waits_longer_by_the_same() {
    let scene = scene_that_says("tilt", &["ten times smaller", "10⁻⁹⁴ of a degree", "the same 0.63 seconds"]);
    let first = |tilt: f64| {
        let mut file = scene.file.clone();
        file.spin.tilt_deg = Some(tilt);
        let scene = Scene::check(&file).expect("a scene");
        poinsot::next_flip_of(&scene.body, &scene.start).expect("it flips")
    };
    for power in [-2, -3, -6, -20, -90] {
        let more = first(10f64.powi(power - 1)) - first(10f64.powi(power));
        assert!((0.625..0.635).contains(&more), "{more}");
    }
    // A minute lies nearer to this tilt than to ten times or a tenth of it.
    assert!((first(1e-94) - 60.0).abs() < 0.5 * 0.625, "{}", first(1e-94));
}

#[test]
fn racket_and_phone_roll_by_half_a_turn_while_they_go_round_once() {
    // The handle of the racket and the length of the phone lie along y, axis 1; face and screen are square to z.
    let rolled = |scene: &Scene| {
        let exact = exact(scene);
        let up = scene.start.world_momentum.normalize();
        let handle = |time: f64| exact.attitude(time).y_axis;
        let from = (handle(0.0) - up * handle(0.0).dot(up)).normalize();
        let round = |time: f64| handle(time).dot(up.cross(from)).atan2(handle(time).dot(from));
        // When it has gone round once: a little before, it comes from below.
        let once =
            (1..10_000).map(|n| 0.0005 * f64::from(n)).find(|time| round(time - 0.0005) < 0.0 && round(*time) >= 0.0);
        angle(exact.attitude(once.expect("it goes round")).z_axis, exact.attitude(0.0).z_axis)
    };
    let racket = scene_that_says("racket", &["nearly half a turn", "About its handle, axis 1"]);
    assert!((155.0..180.0).contains(&rolled(&racket)), "{}", rolled(&racket));
    let axes = racket.body.body_from_principal();
    assert!(axes.x_axis.y.abs() > 0.999 && axes.y_axis.x.abs() > 0.999 && axes.z_axis.z.abs() > 0.999);
    let phone = scene_that_says("phone", &["from 5° it has rolled by 150°", "from the left edge to the right"]);
    assert!(phone.body.body_from_principal().y_axis.x.abs() > 0.999);
    let mut file = phone.file.clone();
    file.spin.tilt_deg = Some(5.0);
    let thrown = rolled(&Scene::check(&file).expect("a scene"));
    assert!((145.0..155.0).contains(&thrown), "{thrown}");
    assert!(flips(&phone, 10.0).len() > 3);
}

#[test]
fn the_t_handle_turns_over_about_its_stem_every_few_seconds() {
    let scene =
        scene_that_says("t-handle", &["every few seconds", "Its stem is the middle axis", "the cross bar, axis 1"]);
    let axes = scene.body.body_from_principal();
    assert!(axes.x_axis.x.abs() > 0.999 && axes.y_axis.z.abs() > 0.999);
    let times = flips(&scene, 20.0);
    assert!((2.0..6.0).contains(&(times[1] - times[0])), "{times:?}");
}

#[test]
fn a_symmetric_top_goes_round_steadily() {
    let scene =
        scene_that_says("symmetric-top", &["at a steady pace", "the herpolhode is a circle", "There M stands still"]);
    let exact = exact(&scene);
    let up = scene.start.world_momentum.normalize();
    for of in
        [(|state: &State, _: &Scene| state.world_from_body.z_axis) as fn(&State, &Scene) -> DVec3, |state, scene| {
            state.world_angular_velocity(&scene.body)
        }]
    {
        let across = |time: f64| of(&exact.state(time), &scene).reject_from_normalized(up);
        // Always as far from L, and by as much farther round in as much time: within the roundings of twenty seconds.
        let step = angle(across(0.0), across(0.1));
        for n in 1..200 {
            let time = 0.1 * f64::from(n);
            assert_at_most((across(time).length() / across(0.0).length() - 1.0).abs(), 1e-12, "a circle");
            assert_at_most((angle(across(time), across(time + 0.1)) - step).abs(), 1e-10, "a steady pace");
        }
    }
    // On the equator M stands still.
    let equator = motion::momentum_rate(&scene.body, DVec3::new(0.6, 0.8, 0.0));
    assert_at_most(equator.length() * scene.body.principal_moments().x, 1e-12, "the equator");
}

#[test]
fn poinsot_s_ellipsoid_keeps_its_height_and_the_polhode_passes_slowly_near_axis_2() {
    let scene = scene_that_says("rolling", &["which is 2K/ℓ", "never leaves its ring"]);
    let exact = exact(&scene);
    let (energy, ell) = (scene.start.energy(&scene.body), so3::norm(scene.start.world_momentum));
    let (inner, outer) = poinsot::herpolhode_radii(&scene.body, scene.start.body_momentum);
    for n in 0..500 {
        let omega = exact.state(0.02 * f64::from(n)).world_angular_velocity(&scene.body);
        let up = scene.start.world_momentum / ell;
        assert_at_most((omega.dot(up) * ell / (2.0 * energy) - 1.0).abs(), 1e-12, "height");
        let radius = omega.reject_from_normalized(up).length();
        assert!(inner * (1.0 - 1e-9) <= radius && radius <= outer * (1.0 + 1e-9), "{inner} {radius} {outer}");
    }

    let scene = scene_that_says("momentum-sphere", &["midway: here 29 times as fast", "stands still"]);
    let exact = self::exact(&scene);
    let period = period::period_of(&scene.body, &scene.start).expect("M comes round").time;
    let momenta = (0..4_000).map(|n| exact.momentum(period * f64::from(n) / 4_000.0));
    let speeds: Vec<(f64, f64)> = momenta
        .map(|m| (motion::momentum_rate(&scene.body, m).length(), principal(&scene, m.normalize()).y.abs()))
        .collect();
    let fastest = speeds.iter().max_by(|a, b| a.0.total_cmp(&b.0)).expect("many");
    let slowest = speeds.iter().min_by(|a, b| a.0.total_cmp(&b.0)).expect("many");
    assert!(fastest.1 < 0.01 && slowest.1 > 0.99, "{fastest:?} {slowest:?}");
    assert!((28.5..29.5).contains(&(fastest.0 / slowest.0)), "{}", fastest.0 / slowest.0);
}

#[test]
fn the_methods_leave_the_rotations_as_is_said() {
    let mut scene = Simulation::new(&scene_that_says(
        "methods",
        &["Forward Euler swells the body, backward Euler shrinks it", "by 4·10⁻⁸", "within 10⁻¹⁵"],
    ));
    scene.go_to(10.0);
    let states: Vec<State> = scene.ghosts().iter().map(|ghost| *ghost.state()).collect();
    let size: Vec<f64> = states.iter().map(|state| state.world_from_body.determinant()).collect();
    assert!(size[0] > 1.5 && size[1] < 0.7 && (size[2] - 1.0).abs() < 1e-6, "{size:?}");
    let off: Vec<f64> = states.iter().map(|state| so3::orthogonality_error(state.world_from_body)).collect();
    assert!((3.5e-8..4.5e-8).contains(&off[2]) && off[3] < 1e-15, "{off:?}");
}

#[test]
fn buss_keeps_step_twice_as_long_and_its_error_shrinks_twice_as_much() {
    let scene =
        scene_that_says("buss", &["about twice as long", "to about a half", "to about a quarter", "to the last bit"]);
    let exact = exact(&scene);
    let run = |step: f64| {
        let mut file = scene.file.clone();
        file.motion.step = Some(step);
        let mut simulation = Simulation::new(&Scene::check(&file).expect("a scene"));
        let mut errors = vec![];
        for n in 1..250 {
            simulation.go_to(0.02 * f64::from(n));
            let truth = exact.state(simulation.time());
            errors.push([0, 1].map(|ghost: usize| apart(simulation.ghosts()[ghost].state(), &truth)));
            for ghost in simulation.ghosts() {
                assert_eq!(ghost.state().world_momentum, scene.start.world_momentum);
            }
        }
        errors
    };
    let (whole, half) = (run(0.02), run(0.01));
    for limit in [0.1, 1.0] {
        let until =
            [0, 1].map(|ghost: usize| whole.iter().position(|error| error[ghost] > limit).expect("it parts") as f64);
        assert!((1.7..2.5).contains(&(until[1] / until[0])), "{until:?}");
    }
    // After a second.
    let shrunk = [0, 1].map(|ghost: usize| half[49][ghost] / whole[49][ghost]);
    assert!((0.45..0.55).contains(&shrunk[0]) && (0.22..0.28).contains(&shrunk[1]), "{shrunk:?}");
}

#[test]
fn a_long_run_keeps_what_is_said() {
    let scene = scene_that_says(
        "long-run",
        &["about 2·10⁻¹² rad in a thousand seconds", "Buss' method keeps L alone, and rk4 neither"],
    );
    let mut simulation = Simulation::new(&scene);
    simulation.go_to(1000.0);
    let parted = apart(simulation.state(), &exact(&scene).state(1000.0));
    // Half of what is said to twice that.
    assert!((1e-12..4e-12).contains(&parted), "{parted}");
    let kept: Vec<(&str, bool, bool, bool)> = simulation
        .ghosts()
        .iter()
        .map(|ghost| {
            let (start, now) = (&scene.start, ghost.state());
            let energy = motion::energy_error(&scene.body, start, now).abs() < 1e-12;
            let l = motion::momentum_error(start, now) < 1e-12;
            (ghost.method().name, energy, l, apart(now, &exact(&scene).state(1000.0)) < 1e-3)
        })
        .collect();
    let wanted = [
        ("closed-form", true, true, true),
        ("rk4", false, false, false),
        ("buss", false, true, false),
        ("moser-veselov", true, true, false),
    ];
    assert_eq!(kept, wanted);
}

#[test]
fn game_engines_do_what_is_said() {
    let scene = scene_that_says(
        "engines",
        &[
            "circles axis 1 for ever",
            "a fifth of its energy",
            "where it flips",
            "less than two degrees off",
            "keeps energy and L",
        ],
    );
    assert!(angles_from(&scene, DVec3::X).1 < 45.0);
    let mut simulation = Simulation::new(&scene);
    simulation.go_to(10.0);
    let [midpoint, bullet, jolt] = [0, 1, 2];
    let off = apart(simulation.ghosts()[midpoint].state(), &exact(&scene).state(simulation.time())).to_degrees();
    assert!((1.0..2.0).contains(&off), "{off}");
    let error = |simulation: &Simulation, ghost: usize| {
        motion::energy_error(&scene.body, &scene.start, simulation.ghosts()[ghost].state())
    };
    let middle =
        |simulation: &Simulation| principal(&scene, simulation.ghosts()[jolt].state().body_momentum.normalize()).y;
    let (mut least, mut most) = (1.0_f64, -1.0_f64);
    for n in 0..500 {
        simulation.go_to(60.0 + 0.1 * f64::from(n));
        (least, most) = (least.min(middle(&simulation)), most.max(middle(&simulation)));
    }
    assert!(least < -0.99 && most > 0.99, "{least} {most}");
    assert!(error(&simulation, midpoint).abs() < 1e-12);
    assert!((0.19..0.22).contains(&-error(&simulation, bullet)), "{}", error(&simulation, bullet));
    let spin = principal(&scene, simulation.ghosts()[bullet].state().body_momentum);
    assert!(angle(spin, DVec3::X) < 0.1);
}

#[test]
fn toutatis_has_its_two_periods() {
    let scene = scene_that_says("toutatis", &["in 5.38 days", "in 7.40 days", "keeps 50° to 51°"]);
    let period = period::period_of(&scene.body, &scene.start).expect("M comes round");
    assert!((period.time - 5.38).abs() < 0.005, "{period:?}");
    // The long axis has gone round by what the body has turned, whole turns that the body makes about it left out.
    let turns = (period.turn / std::f64::consts::TAU).rem_euclid(1.0);
    assert!((period.time / turns - 7.40).abs() < 0.005, "{}", period.time / turns);
    let (low, high) = angles_from(&scene, -DVec3::X);
    assert!(low > 49.5 && high < 51.5, "{low} {high}");
}

#[test]
fn lost_energy_leads_to_axis_3() {
    let scene = scene_that_says("flat-spin", &["past axis 2 to axis 3", "from 8 to 1.7 rad/s", "5.1 times"]);
    let moments = scene.body.principal_moments();
    assert!((moments.z / moments.x - 5.1).abs() < 0.05);
    let mut simulation = Simulation::new(&scene);
    let mut nearest = [180.0_f64; 3];
    for n in 0..400 {
        simulation.go_to(0.5 * f64::from(n));
        let at = principal(&scene, simulation.state().body_momentum).abs();
        for (axis, nearest) in DVec3::AXES.into_iter().zip(&mut nearest) {
            *nearest = nearest.min(angle(at, axis));
        }
    }
    assert!(nearest[1] < 25.0 && nearest[2] < 0.1, "{nearest:?}");
    let [from, to] = [&scene.start, simulation.state()].map(|state| state.body_angular_velocity(&scene.body).length());
    assert!((from - 8.0).abs() < 1e-9 && (to - 1.7).abs() < 0.05 && (4.5..5.0).contains(&(from / to)), "{from} {to}");

    let scene =
        scene_that_says("earth", &["sixty times as much", "23 % more here", "a third of a percent", "die away"]);
    let moments = scene.body.principal_moments();
    assert!(((1.0 - 0.5 * (moments.x + moments.y)) / 0.0033 - 60.0).abs() < 3.0);
    assert!((moments.z / moments.y - 1.23).abs() < 0.01 && (1.0 / (1.0 - 0.0033) - 1.0033_f64).abs() < 1e-4);
    let mut simulation = Simulation::new(&scene);
    simulation.go_to(60.0);
    assert!(angle(principal(&scene, simulation.state().body_momentum), DVec3::Z) < 0.2);
}

/// Seen from outside M goes round axis 1 clockwise and round axis 3 counter-clockwise, and at axis 2 in along one line and out along the other.
#[test]
fn the_flow_is_of_centres_and_saddles() {
    let scene =
        scene_that_says("flow", &["in along one line and go out along another", "Clockwise at both ends of axis 1"]);
    let body = &scene.body;
    let flow =
        |direction: DVec3| principal(&scene, motion::momentum_rate(body, body.body_from_principal() * direction));
    for n in 0..12 {
        let (sin, cos) = (f64::from(n) * std::f64::consts::FRAC_PI_6).sin_cos();
        for end in [-1.0, 1.0] {
            for (axis, sign) in [(0, -1.0), (2, 1.0)] {
                let outward = DVec3::AXES[axis] * end;
                let beside = outward + 0.1 * (DVec3::AXES[(axis + 1) % 3] * cos + DVec3::AXES[(axis + 2) % 3] * sin);
                assert!(outward.dot(beside.cross(flow(beside))) * sign > 0.0);
            }
        }
    }
    // Of the four ways at an end of axis 2 two lead there and two away.
    let slope = poinsot::separatrix(body, 1.0, 8).expect("three moments")[0]
        .iter()
        .map(|m| principal(&scene, *m))
        .find(|m| m.y.abs() < 0.9);
    let across = slope.expect("a point aside").with_y(0.0).normalize();
    for end in [-1.0, 1.0] {
        let outwards = |across: DVec3| flow(DVec3::Y * end + 0.01 * across).dot(across);
        let other = DVec3::new(-across.x, 0.0, across.z);
        assert!(outwards(across) * outwards(other) < 0.0 && outwards(across) * outwards(-across) > 0.0);
    }
}

#[test]
fn the_cloud_is_drawn_out_round_axis_2_alone() {
    let scene = scene_that_says(
        "cloud",
        &[
            "2400 starts within 8°",
            "800 within 8° of each axis",
            "everywhere along it",
            "half are nearer to the one end by then",
            "the clump turns, and stays a clump",
        ],
    );
    let simulation = Simulation::new(&scene);
    let after = poinsot::next_flip_of(&scene.body, &scene.start).expect("it flips")
        + 9.0 * poinsot::flip_period_of(&scene.body, &scene.start).expect("it flips");
    let [i1, i2, i3] = scene.body.principal_moments().to_array();
    let slope = (i1 * (i3 - i2) / (i3 * (i2 - i1))).sqrt();
    let borders = [1.0, -1.0].map(|sign| DVec3::new(1.0, 0.0, sign * slope).normalize());
    let (mut count, mut clumps) = ([0; 3], [0.0_f64; 3]);
    let (mut far, mut ends, mut seen) = (0.0_f64, [0, 0], [[0; 10]; 4]);
    for (axis, momentum) in simulation.cloud().momenta_at(after) {
        let m = principal(&scene, momentum).normalize();
        count[axis] += 1;
        clumps[axis] = clumps[axis].max(angle(m.abs(), DVec3::AXES[axis]));
        if axis == 1 {
            // How far (degrees) from the nearer of the two circles.
            far = far.max(borders.iter().map(|border| m.dot(*border).asin().abs().to_degrees()).fold(90.0, f64::min));
            ends[usize::from(m.y > 0.0)] += 1;
            let quarter = 2 * usize::from(m.x > 0.0) + usize::from(m.z > 0.0);
            // Along it, evenly in angle from one end to the other.
            let part = 10.0 * angle(m, DVec3::Y) / 180.0;
            seen[quarter][(part as usize).min(9)] += 1;
        }
    }
    assert_eq!(count, [800; 3]);
    assert!(clumps[0] < 25.0 && clumps[2] < 25.0, "{clumps:?}");
    assert!(far < 8.5, "{far}");
    assert!(ends.iter().all(|end| (350..=450).contains(end)), "{ends:?}");
    assert!(seen.iter().flatten().all(|count| *count > 0), "{seen:?}");
}

#[test]
fn the_body_has_turned_as_far_as_is_said() {
    let scene = scene_that_says(
        "turn",
        &["at 2.715 s", "2KT/ℓ is 9.75,", "Λ = 0.54 ", "9.21 rad", "1 turn and 167.6°", "goes round axis 3"],
    );
    let period = period::period_of(&scene.body, &scene.start).expect("M comes round");
    let energy_term = 2.0 * scene.start.energy(&scene.body) * period.time / so3::norm(scene.start.world_momentum);
    for (value, said) in [(energy_term, 9.75), (period.solid_angle, 0.54), (period.turn, 9.21)] {
        assert_at_most((value - said).abs(), 5e-3, &said.to_string());
    }
    assert_at_most((period.time - 2.715).abs(), 5e-4, "T");
    assert_at_most((period.turn.to_degrees() - 360.0 - 167.6).abs(), 0.05, "the turn");
    let after = Motion::new(&scene.body, &scene.start).state(period.time);
    let turned = angle(
        scene.start.world_from_body.y_axis.reject_from(scene.start.world_momentum),
        after.world_from_body.y_axis.reject_from(scene.start.world_momentum),
    );
    assert_at_most((turned - 167.6).abs(), 0.05, "axis 2");
    // The step that shows it is at that time.
    assert!(scene.file.steps.iter().any(|step| step.time == Some(2.715)));
}

/// The flip, the first scene: the surfaces are as long as is said, the lines apart, M is slow near axis 2 and fast between, and there K is a pass.
#[test]
fn the_flip_is_as_is_said() {
    let scene = scene_that_says(
        "flip",
        &[
            "it spins on the same way round",
            "about one axis |L|²/2I",
            "least about 1, largest about 3",
            "between them the shares add up",
            "every arrow with this K, short along 1, long along 3",
            "never turns quite about L",
            "two lines: at axis 2 it takes a magnifying glass to see the gap",
            "from beside one end of axis 2 to beside the other",
            "1 (least I) is a summit, 3 a valley, 2 a pass between",
            "Round 1 (blue) and 3 (green) that is a ring: the box only wobbles",
            "exactly on an axis M stands still",
            "tenfold every 0.63 s",
        ],
    );
    let body = &scene.body;
    let ell = so3::norm(scene.start.world_momentum);
    let axes = poinsot::energy_semi_axes(body, scene.start.energy(body));
    assert!(axes.z > axes.y && axes.y > axes.x);
    assert!(flips(&scene, 30.0).len() > 3);
    let rate = |momentum: DVec3| motion::momentum_rate(body, momentum).length();
    let half = poinsot::next_flip_of(body, &scene.start).expect("it flips");
    let exact = exact(&scene);
    assert!(rate(exact.momentum(half)) > 100.0 * rate(exact.momentum(0.0)));
    // M keeps to one of the two lines: axis 3 is up in the picture.
    let around: Vec<DVec3> = (0..1_000).map(|n| principal(&scene, exact.momentum(0.02 * f64::from(n)))).collect();
    assert!(around.iter().all(|momentum| momentum.z > 0.0));
    // The other is the same on the far side: the two touch nowhere, as the plane between them is met by neither. It leads
    // to within a degree of both ends of axis 2, as near as the tilt at the start.
    let line: Vec<DVec3> = poinsot::polhode(body, scene.start.body_momentum, 4_096)
        .into_iter()
        .map(|momentum| principal(&scene, momentum).normalize())
        .collect();
    assert!(line.iter().all(|momentum| momentum.z > 0.0));
    for end in [DVec3::Y, DVec3::NEG_Y] {
        let nearest = line.iter().map(|momentum| angle(*momentum, end)).fold(180.0, f64::min);
        assert!((0.01..1.0).contains(&nearest), "{nearest}");
    }
    // On an axis M stands still, within the rounding of one that is not along an edge.
    for axis in DVec3::AXES {
        assert_at_most(rate(body.body_from_principal() * axis * ell) / rate(exact.momentum(half)), 1e-12, "on an axis");
    }
    // ω·L = 2K is above 0.
    assert!(scene.start.energy(body) > 0.0);
    // Along an axis K = |L|²/2I; of all M of one length it is largest along axis 1 and least along axis 3, and a pass along axis 2.
    let energy = |direction: DVec3| body.energy(body.body_from_principal() * direction.normalize() * ell);
    for (axis, moment) in DVec3::AXES.into_iter().zip(body.principal_moments().to_array()) {
        assert_at_most((energy(axis) * 2.0 * moment / ell.powi(2) - 1.0).abs(), 1e-14, "K = |L|²/2I");
    }
    for n in 0..36 {
        let (sine, cosine) = (f64::from(n) * std::f64::consts::TAU / 36.0).sin_cos();
        for end in [1.0, -1.0] {
            assert!(energy(DVec3::new(end, 0.2 * sine, 0.2 * cosine)) < energy(DVec3::X));
            assert!(energy(DVec3::new(0.2 * sine, 0.2 * cosine, end)) > energy(DVec3::Z));
        }
    }
    for side in [0.2, -0.2] {
        assert!(
            energy(DVec3::new(side, 1.0, 0.0)) > energy(DVec3::Y)
                && energy(DVec3::new(0.0, 1.0, side)) < energy(DVec3::Y)
        );
    }
    // A tilt grows tenfold in ln 10 over its rate.
    let tenfold = 10f64.ln() / poinsot::growth_rate(body, ell);
    assert!((0.625..0.635).contains(&tenfold), "{tenfold}");
    let tilt = |time: f64| angle(principal(&scene, exact.momentum(time)), DVec3::Y);
    assert!(
        (9.0..11.0).contains(&(tilt(0.2 + 2.0 * tenfold) / tilt(0.2 + tenfold))),
        "{}",
        tilt(0.2 + 2.0 * tenfold) / tilt(0.2 + tenfold)
    );
}

/// Every question that is asked has an answer.
#[test]
fn every_question_has_an_answer() {
    for preset in scene::presets() {
        let file = preset.read().expect("a scene's text");
        assert_eq!(file.question.trim().is_empty(), file.answer.trim().is_empty(), "{}", file.title);
    }
}
