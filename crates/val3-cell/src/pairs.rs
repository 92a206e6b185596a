//! Pairs of bodies whose distances are measured.

use crate::build::{Cell, Thing};
use crate::carriers::Chain;
use crate::names::body_names;
use crate::part::Part;

/// Smallest difference between the chain positions of compared bodies. Nearer bodies always touch, or can never touch.
const APART: usize = 3;

/// Smallest difference for bodies on the flange. It is greater because the capsules of wrist and forearm extend beyond
/// the flange.
const CARRIED_APART: usize = 4;

/// Pairs of links that are far enough apart in the chain but cannot touch each other on any arm.
const NEVER: [(usize, usize); 2] = [(2, 5), (2, 6)];

/// Two bodies, by their indexes in the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair {
    pub(crate) first: usize,
    pub(crate) second: usize,
    /// Distance in mm below which the bodies are too near to each other.
    pub(crate) clearance: f64,
    /// Overlap depth in mm up to which nothing is a contact: the shapes of parts are smaller by this depth.
    pub(crate) touch: f64,
    /// Kind of comparison; `None` if it depends on the current carrier of a part.
    pub(crate) comparison: Option<Comparison>,
}

impl Pair {
    /// Whether at least one of the bodies is a part.
    pub(crate) fn has_part(&self) -> bool {
        self.comparison.is_none()
    }

    /// Whether both bodies always belong to the arm or are on it.
    pub(crate) fn is_arm(&self) -> bool {
        self.comparison == Some(Comparison::Arm)
    }
}

/// Kind of comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Comparison {
    /// The bodies can touch each other.
    Touching,
    /// Both bodies belong to the arm or are on it. Link shapes are larger than the links, so an overlap does not prove
    /// a contact.
    Arm,
}

/// Returns the kind of comparison for bodies at two positions in the chain of the arm, which has `axes` axes; `None` if
/// the bodies are not compared.
pub(crate) fn comparison(first: Chain, second: Chain, axes: usize) -> Option<Comparison> {
    match (first, second) {
        (Some(a), Some(b)) => {
            let apart = if a.max(b) > axes { CARRIED_APART } else { APART };
            let can_touch = a.abs_diff(b) >= apart && !NEVER.contains(&(a.min(b), a.max(b)));
            can_touch.then_some(Comparison::Arm)
        }
        (Some(chain), None) | (None, Some(chain)) => (chain > 0).then_some(Comparison::Touching),
        (None, None) => None,
    }
}

/// Returns the compared pairs of a cell's bodies. The bodies are the base, the links of an arm with `axes` axes, the
/// things and the parts.
pub(crate) fn pairs(cell: &Cell, axes: usize) -> Vec<Pair> {
    let count = axes + 1 + cell.things.len() + cell.parts.len();
    let names: Vec<String> = body_names(cell.body_names(), axes).collect();
    let every = (0..count).flat_map(|first| (first + 1..count).map(move |second| (first, second)));
    let pairs = every.filter_map(|(first, second)| {
        let (a, b) = (PairBody::of(cell, axes, first)?, PairBody::of(cell, axes, second)?);
        let has_part = a.is_part || b.is_part;
        let compared = if has_part { None } else { Some(comparison(a.chain, b.chain, axes)?) };
        let is_gripper = a.is_part && b.is_piece || b.is_part && a.is_piece;
        let is_allowed = cell.allowed.contains(names.get(first)?, names.get(second)?);
        let own = a.clearance.into_iter().chain(b.clearance).reduce(f64::max);
        let clearance = match compared {
            Some(Comparison::Arm) => 0.0,
            Some(Comparison::Touching) => own.unwrap_or(cell.clearance),
            // Parts are always near their supports, so the general clearance does not apply.
            None => own.unwrap_or(0.0),
        };
        // The moving body comes first.
        let (first, second) = if a.chain.is_none() && !a.is_part { (second, first) } else { (first, second) };
        let pair = Pair { first, second, clearance, touch: a.touch + b.touch, comparison: compared };
        (!is_gripper && !is_allowed).then_some(pair)
    });
    pairs.collect()
}

/// Properties of a body that determine its pairs.
struct PairBody {
    chain: Chain,
    clearance: Option<f64>,
    is_part: bool,
    /// Whether the body belongs to a gripper.
    is_piece: bool,
    touch: f64,
}

impl PairBody {
    fn of(cell: &Cell, axes: usize, body: usize) -> Option<Self> {
        let none = Self { chain: None, clearance: None, is_part: false, is_piece: false, touch: 0.0 };
        let Some(thing) = body.checked_sub(axes + 1) else { return Some(Self { chain: Some(body), ..none }) };
        let Some(Thing { carrier, clearance, .. }) = cell.things.get(thing) else {
            let Part { touch, clearance, .. } = cell.parts.get(thing - cell.things.len())?;
            return Some(Self { clearance: *clearance, is_part: true, touch: *touch, ..none });
        };
        let is_piece = cell.grippers.iter().any(|gripper| gripper.pieces.contains(&thing));
        Some(Self { chain: carrier.chain(axes), clearance: *clearance, is_piece, ..none })
    }
}
