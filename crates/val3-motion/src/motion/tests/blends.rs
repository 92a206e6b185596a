//! Laws of blends over random programs: short moves, moves that only turn, tools off axis 6, SCARA arms, and distances that
//! are unequal or overlap (section (a) of the motion model, manual 10.1.2).

use proptest::prelude::*;
use val3_geometry::{Vector3, rotation};

use super::*;
use crate::bounds::AXES;

mod acceleration;
mod programs;
mod reported;
mod shape;

use programs::{Program, programs};

/// Random programs of each law; `VAL3_CASES` in the environment sets another number.
fn cases() -> ProptestConfig {
    let cases = std::env::var("VAL3_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(300);
    ProptestConfig { cases, max_shrink_iters: 2000, ..ProptestConfig::default() }
}
