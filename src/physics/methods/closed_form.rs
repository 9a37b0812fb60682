//! The motion in closed form, as a method among the others: it goes to any time at once.

use glam::{DMat3, DVec3};

use super::{Dash, Failure, Hue, Keeps, Mark, Method, Order, Problem, Stepper};
use crate::physics::exact::Path;
use crate::physics::orbit::Orbit;

pub(super) const METHOD: Method = Method {
    name: "closed-form",
    label: "Closed form",
    order: Order::Exact,
    explicit: true,
    symplectic: true,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::Exactly,
    is_direct: true,
    cost: "two sin/cos and two dozen series terms, whatever the time",
    source: "Jacobi, J. reine angew. Math. 39 (1849) 293; van Zon & Schofield, J. Comput. Phys. 225 (2007) 145",
    hue: Hue { on_dark: 0x00a8_a8a8, on_light: 0x007e_7e7e },
    dash: Dash::Solid,
    mark: Mark::OpenTriangle,
    start: |problem| Box::new(ClosedForm::new(problem)),
};

/// A prepared motion and where it has been asked to be.
#[derive(Clone)]
struct ClosedForm {
    path: Path,
    principal_from_standard: DMat3,
    time: f64,
}

impl ClosedForm {
    fn new(problem: &Problem) -> Self {
        let orbit = Orbit::new(&problem.start);
        Self { path: Path::new(&orbit), principal_from_standard: orbit.principal_from_standard, time: 0.0 }
    }

    fn at(&self, time: f64) -> (DMat3, DVec3) {
        let (turned, momentum) = self.path.at(time);
        (DMat3::from_quat(turned), momentum)
    }
}

impl Stepper for ClosedForm {
    fn advance(&mut self, step: f64, count: u64) -> Result<(), Failure> {
        self.time += step * count as f64;
        Ok(())
    }

    fn attitude(&self) -> DMat3 {
        self.at(self.time).0
    }

    fn momentum(&self) -> DVec3 {
        self.at(self.time).1
    }

    fn now(&self) -> (DMat3, DVec3) {
        self.at(self.time)
    }

    fn principal_from_own(&self) -> DMat3 {
        self.principal_from_standard
    }

    fn directly(&self, time: f64) -> Option<(DMat3, DVec3)> {
        Some(self.at(time))
    }

    fn duplicate(&self) -> Box<dyn Stepper> {
        Box::new(self.clone())
    }
}
