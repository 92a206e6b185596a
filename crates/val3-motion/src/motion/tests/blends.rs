//! Properties of blends in random programs: short moves, pure rotations, tools off axis 6, SCARA arms, and unequal or
//! overlapping distances (section (a) of the motion model, manual 10.1.2).

use proptest::prelude::*;
use val3_geometry::{Vector3, rotation};

use super::*;
use crate::bounds::AXES;

mod acceleration;
mod faults;
mod programs;
mod reported;
mod shape;

use programs::{Program, programs};

/// Number of random programs per property: `PROPTEST_CASES` in the environment, at least 300.
fn cases() -> ProptestConfig {
    let default = ProptestConfig::default();
    ProptestConfig { cases: default.cases.max(300), max_shrink_iters: 2000, ..default }
}
