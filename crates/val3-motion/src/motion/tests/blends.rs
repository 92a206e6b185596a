//! Laws of blends over random programs: short moves, moves that only turn, tools off axis 6, SCARA arms, and distances that
//! are unequal or overlap (section (a) of the motion model, manual 10.1.2).

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

/// Random programs of each law: at least 300, or as many as `PROPTEST_CASES` in the environment sets.
fn cases() -> ProptestConfig {
    let default = ProptestConfig::default();
    ProptestConfig { cases: default.cases.max(300), max_shrink_iters: 2000, ..default }
}
