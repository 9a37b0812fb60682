//! The simulation, its clock and its history, held to what they say of themselves.

use crate::physics::{Motion, poinsot, so3};
use crate::scene::{Scene, SceneError, SceneFile, preset};
use crate::sim::{Clock, Errors, History, Simulation, Tick};

fn scene(text: &str) -> Result<Scene, SceneError> {
    Scene::check(&SceneFile::parse(text)?)
}

const COMPARED: &str = "[spin]\naxis = 2\ntilt_deg = 3.0\nrate = 6.0\n[motion]\nmethod = 'buss'\nstep = 0.01\ncompare = ['closed-form', 'lie-euler']";

#[test]
fn a_clock_turns_real_time_into_whole_steps_and_carries_the_rest() {
    let mut clock = Clock::default();
    clock.speed = 2.0;
    assert_eq!(clock.tick(0.004, 0.01), Tick::Still);
    // 0.008 s are carried: with 0.006 more one step of 0.01 is full, and 0.004 stay.
    assert_eq!(clock.tick(0.003, 0.01), Tick::Steps(1));
    assert_eq!(clock.tick(0.002_9, 0.01), Tick::Still);
    assert_eq!(clock.tick(0.000_2, 0.01), Tick::Steps(1));
    clock.clear();
    assert_eq!(clock.tick(0.004_9, 0.01), Tick::Still);
    clock.clear();
    clock.speed = -3.0;
    assert_eq!(clock.tick(0.01, 0.01), Tick::Steps(-3));
    for real in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(clock.tick(real, 0.01), Tick::Still);
    }
    clock.paused = true;
    assert_eq!(clock.tick(1.0, 0.01), Tick::Still);
}

#[test]
fn a_frame_that_would_freeze_is_capped_and_forgets_the_rest() {
    let mut clock = Clock::default();
    clock.most_steps = 10;
    assert_eq!(clock.tick(1.0, 0.01), Tick::Capped(10));
    assert_eq!(clock.tick(0.05, 0.01), Tick::Steps(5));
    clock.speed = -1.0;
    assert_eq!(clock.tick(1.0, 0.01), Tick::Capped(-10));
    assert_eq!(clock.tick(0.1, 0.01), Tick::Steps(-10));
}

#[test]
fn a_frame_advances_all_methods_alike() -> Result<(), SceneError> {
    let mut simulation = Simulation::new(&scene(COMPARED)?);
    assert_eq!(simulation.step_length(), 0.01);
    assert_eq!(simulation.advance_frame(0.095), Tick::Steps(9));
    assert!((simulation.time() - 0.09).abs() < 1e-15);
    let names: Vec<_> = simulation.ghosts().iter().map(|ghost| ghost.method().name).collect();
    assert_eq!((simulation.main().method().name, names), ("buss", vec!["closed-form", "lie-euler"]));
    // Each is where its own method has it: near the exact motion, and no two at the same place.
    let exact = Motion::new(simulation.body(), simulation.start());
    let error = |runner: &crate::sim::Runner| Errors::of(&simulation, &exact, runner.state()).attitude;
    let [main, closed, euler] = [simulation.main(), &simulation.ghosts()[0], &simulation.ghosts()[1]].map(error);
    assert!(closed < 1e-14 && closed < main && main < euler && euler < 0.02, "{closed} {main} {euler}");
    assert_eq!(simulation.advance_frame(0.0), Tick::Still);
    Ok(())
}

#[test]
fn steps_to_a_time_are_those_from_here_or_from_the_start() -> Result<(), SceneError> {
    let mut simulation = Simulation::new(&scene(COMPARED)?);
    // Two methods step; the closed form goes anywhere at once.
    let near = |steps: f64, wanted: f64| assert!((steps - wanted).abs() < 1e-6, "{steps} {wanted}");
    near(simulation.steps_to(1.0), 200.0);
    near(simulation.steps_to(-1.0), 200.0);
    simulation.step(40);
    near(simulation.steps_to(1.0), 120.0);
    near(simulation.steps_to(0.1), 20.0);
    near(simulation.steps_to(-0.5), 100.0);
    near(simulation.steps_to(0.4), 0.0);
    simulation.step(-80);
    assert!((simulation.time() + 0.4).abs() < 1e-14);
    near(simulation.steps_to(-1.0), 120.0);
    near(simulation.steps_to(1.0), 200.0);
    Ok(())
}

#[test]
fn a_method_that_goes_anywhere_steps_on_from_there() -> Result<(), SceneError> {
    let text = "[spin]\ntilt_deg = 3.0\n[motion]\nmethod = 'closed-form'\nstep = 0.01";
    for time in [123.456, -123.456] {
        let mut simulation = Simulation::new(&scene(text)?);
        simulation.go_to(time);
        assert_eq!(simulation.time(), time);
        simulation.step(1);
        // The steps are counted from 0: the next whole one after the time that was gone to, towards 0 cut off.
        let wanted = ((time / 0.01).trunc() + 1.0) * 0.01;
        assert!((simulation.time() - wanted).abs() < 1e-9, "{} {wanted}", simulation.time());
        let exact = Motion::new(simulation.body(), simulation.start()).attitude(simulation.time());
        assert!(so3::angle_between(simulation.state().world_from_body, exact) < 1e-13);
    }
    Ok(())
}

#[test]
fn a_restart_is_the_start_with_the_same_methods_and_clock() -> Result<(), SceneError> {
    let scene = scene(COMPARED)?;
    let mut simulation = Simulation::new(&scene);
    simulation.clock.speed = 4.0;
    simulation.step(25);
    simulation.restart();
    assert_eq!((simulation.time(), simulation.clock.speed, simulation.ghosts().len()), (0.0, 4.0, 2));
    assert_eq!(*simulation.state(), scene.start);
    Ok(())
}

#[test]
fn a_method_that_cannot_go_on_stops_the_clock_and_keeps_its_last_state() -> Result<(), SceneError> {
    // Steps of a hundred turns: the implicit equation has no solution near.
    let text = "[spin]\ntilt_deg = 30.0\nrate = 100.0\n[motion]\nmethod = 'moser-veselov'\nstep = 5.0";
    let scene = scene(text)?;
    let mut simulation = Simulation::new(&scene);
    simulation.step(3);
    assert!(simulation.main().failure().is_some() && simulation.clock.paused);
    assert_eq!(*simulation.state(), scene.start);
    simulation.go_to(1.0);
    assert!(simulation.main().failure().is_some());
    Ok(())
}

#[test]
fn errors_are_measured_on_the_state() -> Result<(), SceneError> {
    let text = "[spin]\ntilt_deg = 3.0\nrate = 6.0\n[motion]\nmethod = 'forward-euler'\nstep = 0.001";
    let mut simulation = Simulation::new(&scene(text)?);
    assert_eq!((simulation.energy_error(), simulation.momentum_error()), (0.0, 0.0));
    simulation.step(500);
    let (start, now, body) = (simulation.start(), simulation.state(), simulation.body());
    let energy = now.energy(body) / start.energy(body) - 1.0;
    assert!(energy.abs() > 1e-6 && (simulation.energy_error() - energy).abs() < 1e-14, "{energy}");
    let drift = now.world_from_body * now.body_momentum - start.world_momentum;
    let momentum = so3::norm(drift) / so3::norm(start.world_momentum);
    assert!(momentum > 1e-6 && (simulation.momentum_error() - momentum).abs() < 1e-14, "{momentum}");
    let exact = Motion::new(body, start);
    let errors = Errors::of(&simulation, &exact, now);
    assert!((errors.energy - energy).abs() < 1e-14 && (errors.momentum - momentum).abs() < 1e-14);
    let angle = so3::angle_between(exact.attitude(simulation.time()), now.world_from_body);
    assert!(angle > 1e-6 && errors.attitude == angle);
    Ok(())
}

#[test]
fn the_history_is_in_order_thins_itself_and_keeps_its_ends() -> Result<(), SceneError> {
    let scene = Scene::check(&preset("flip")?.read()?)?;
    let exact = Motion::new(&scene.body, &scene.start);
    let mut simulation = Simulation::new(&scene);
    let mut history = History::default();
    let times = |history: &History| history.samples().map(|sample| sample.time).collect::<Vec<_>>();
    simulation.go_to(100.0);
    for _ in 0..1000 {
        simulation.step(1);
        history.record(&simulation, &exact);
    }
    // The same time again is nothing new, be it the last one or the first.
    history.record(&simulation, &exact);
    assert_eq!(times(&history).len(), 1000);
    simulation.go_to(times(&history)[0]);
    history.record(&simulation, &exact);
    assert_eq!(times(&history).len(), 1000);
    simulation.go_to(times(&history)[999]);
    for _ in 0..3000 {
        simulation.step(1);
        history.record(&simulation, &exact);
    }
    let seen = times(&history);
    assert!((600..=1201).contains(&seen.len()), "{}", seen.len());
    assert!(seen.windows(2).all(|pair| pair[0] < pair[1]));
    assert!((seen[0] - 100.001).abs() < 1e-12 && seen.last().is_some_and(|last| simulation.time() - last < 0.02));
    // Thinned, the spacing is that of what is kept: about the time seen over the number of samples.
    let widest = seen.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    assert!((0.003..0.02).contains(&widest), "{widest}");
    // Before its beginning it grows the other way, no closer than the others lie.
    simulation.go_to(seen[0] - 0.001);
    history.record(&simulation, &exact);
    assert_eq!(times(&history), seen);
    simulation.go_to(-1.0);
    history.jump();
    history.record(&simulation, &exact);
    assert_eq!(times(&history).first(), Some(&-1.0));
    assert_eq!(history.pieces(|sample| sample.errors.first().map(|errors| errors.energy)).len(), 2);
    // A time within is nothing new either.
    let before = times(&history);
    simulation.go_to(0.5);
    history.jump();
    history.record(&simulation, &exact);
    assert_eq!(times(&history), before);
    history.clear();
    assert!(times(&history).is_empty());
    Ok(())
}

/// A body that loses energy, in steps of 0.01 s.
pub(super) const LOSING: &str = "[body]\nbox = [1.0, 0.2, 0.1]\n[spin]\naxis = 1\ntilt_deg = 2.0\nrate = 6.0\n[motion]\nenergy_loss = 0.05\nstep = 0.01";

/// However one comes to a time where energy is lost, it is the same state to the bit: steps back are the way there taken again.
#[test]
fn a_way_back_with_loss_is_the_way_there() -> Result<(), SceneError> {
    let mut simulation = Simulation::new(&scene(LOSING)?);
    let mut seen = vec![*simulation.state()];
    // Past the number of places that are kept: every second one has gone.
    for _ in 0..20_000 {
        simulation.step(1);
        seen.push(*simulation.state());
    }
    assert!(simulation.energy_error() < -0.5, "{}", simulation.energy_error());
    for (by, at) in [(-1, 19_999), (-99, 19_900), (-9_900, 10_000), (3, 10_003), (-10_002, 1), (-1, 0)] {
        simulation.step(by);
        assert_eq!(*simulation.state(), seen[at], "at step {at}");
        assert!((simulation.time() - at as f64 * 0.01).abs() < 1e-12);
    }
    for at in [150.0, 3.0, 199.0, 0.0] {
        simulation.go_to(at);
        assert_eq!(*simulation.state(), seen[(at * 100.0) as usize], "at {at} s");
    }
    // Before the start it has more energy, and comes back to the start.
    simulation.step(-50);
    let before = *simulation.state();
    assert!(simulation.energy_error() > 0.0);
    simulation.go_to(-1.0);
    simulation.step(50);
    assert_eq!(*simulation.state(), before);
    simulation.step(60);
    assert_eq!(*simulation.state(), seen[10]);
    Ok(())
}

/// What is drawn around now: the way that it came and will go, with and without loss.
#[test]
fn around_now_is_the_motion_itself() -> Result<(), SceneError> {
    for (text, bound) in [(COMPARED.replace("buss", "exact-step"), 1e-12), (LOSING.to_owned(), 1e-5)] {
        let mut simulation = Simulation::new(&scene(&text)?);
        let mut at = |time: f64| {
            simulation.go_to(time);
            *simulation.state()
        };
        let wanted = [2.0, 2.5, 3.0, 3.5, 4.0, 4.5].map(&mut at);
        at(4.0);
        // By steps of 0.05 rad at most: (0.05)⁴ of some 20 rad, over the factor of a hundred or so that such errors have.
        let around = simulation.around(-2.0, 0.5, 5);
        assert_eq!(around.len(), wanted.len());
        for (found, wanted) in around.iter().zip(&wanted) {
            let apart = so3::angle_between(found.world_from_body, wanted.world_from_body);
            assert!(apart < bound, "{apart}");
        }
    }
    Ok(())
}

/// From the start to now, on the motion: by steps of 0.15 rad, of which 0.15⁴ of some 50 rad over a hundred is left.
#[test]
fn the_way_since_the_start_begins_there_and_ends_here() -> Result<(), SceneError> {
    for text in [COMPARED.replace("buss", "exact-step"), LOSING.to_owned()] {
        let scene = scene(&text)?;
        let ell = so3::norm(scene.start.body_momentum);
        let mut simulation = Simulation::new(&scene);
        for time in [8.0, -1.0, 0.0] {
            simulation.go_to(time);
            let way = simulation.momenta_since_start();
            let (first, last) = (way[0], way[way.len() - 1]);
            assert!((first - scene.start.body_momentum).length() < 1e-12 * ell);
            assert!((last - simulation.state().body_momentum).length() < 1e-3 * ell, "{time}");
            assert!(way.windows(2).all(|pair| (pair[1] - pair[0]).length() < 0.15 * ell));
        }
    }
    Ok(())
}

#[test]
fn flips_are_forgotten_after_a_jump() -> Result<(), SceneError> {
    let scene = Scene::check(&preset("flip")?.read()?)?;
    let period = poinsot::flip_period_of(&scene.body, &scene.start).unwrap_or_default();
    let mut simulation = Simulation::new(&scene);
    let mut watch = crate::sim::FlipWatch::default();
    let look_until = |simulation: &mut Simulation, watch: &mut crate::sim::FlipWatch, from: f64, to: f64| {
        for look in 0..=20 {
            simulation.go_to(from + (to - from) * f64::from(look) / 20.0);
            watch.watch(simulation);
        }
    };
    // One flip alone has no time between.
    look_until(&mut simulation, &mut watch, 0.0, period);
    assert_eq!(watch.between(), None);
    watch.jump();
    // Five periods later another one: not measured from the first, of which nothing is known any more.
    look_until(&mut simulation, &mut watch, 5.0 * period, 6.0 * period);
    assert_eq!(watch.between(), None);
    look_until(&mut simulation, &mut watch, 6.0 * period, 7.0 * period);
    assert!(watch.between().is_some_and(|between| (between - period).abs() < 1e-12 * period));
    Ok(())
}
