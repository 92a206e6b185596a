//! Pairs of bodies whose distances are measured.

use crate::build::{Cell, Thing};
use crate::carriers::Carrier;
use crate::names::body_names;

/// Fewest steps in the chain of the arm between two bodies of it that can touch each other: nearer ones always touch, or
/// never.
const APART: usize = 3;

/// The same for what the flange carries: the capsules of the wrist and of the forearm reach beyond the flange.
const CARRIED_APART: usize = 4;

/// Pairs of links that are far enough apart in the chain, and cannot touch each other on any arm.
const NEVER: [(usize, usize); 2] = [(2, 5), (2, 6)];

/// Two bodies, by their numbers in the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pair {
    pub(crate) first: usize,
    pub(crate) second: usize,
    /// Distance below which they are too near to each other.
    pub(crate) clearance: f64,
    /// Whether both belong to the arm or are carried by it. The shapes of links are larger than the links, so that an
    /// overlap is no proof of a contact.
    pub(crate) is_arm: bool,
}

/// Returns the pairs of a cell around an arm with this number of axes. Bodies are the base, the links and the things.
pub(crate) fn pairs(cell: &Cell, axes: usize) -> Vec<Pair> {
    let things = axes + 1;
    let count = things + cell.things.len();
    let names: Vec<String> = body_names(cell.thing_names(), axes).collect();
    let every = (0..count).flat_map(|first| (first + 1..count).map(move |second| (first, second)));
    let pairs = every.filter_map(|(first, second)| {
        let (a, b) = (PairBody::of(cell, axes, first)?, PairBody::of(cell, axes, second)?);
        let is_arm = a.chain.is_some() && b.chain.is_some();
        let matters = match (a.chain, b.chain) {
            (Some(a), Some(b)) => {
                let apart = if a.max(b) > axes { CARRIED_APART } else { APART };
                a.abs_diff(b) >= apart && !NEVER.contains(&(first, second))
            }
            (Some(chain), None) | (None, Some(chain)) => chain > 0,
            (None, None) => false,
        };
        let is_allowed = cell.allowed.contains(names.get(first)?, names.get(second)?);
        let own = a.clearance.into_iter().chain(b.clearance).reduce(f64::max);
        let clearance = if is_arm { 0.0 } else { own.unwrap_or(cell.clearance) };
        // What moves is named first.
        let (first, second) = if a.chain.is_none() { (second, first) } else { (first, second) };
        (matters && !is_allowed).then_some(Pair { first, second, clearance, is_arm })
    });
    pairs.collect()
}

/// Properties of a body that determine its pairs.
struct PairBody {
    /// Place in the chain of the arm: 0 for the base, the number of a link, one more than the last link for what the
    /// flange carries; `None` for what stands.
    chain: Option<usize>,
    clearance: Option<f64>,
}

impl PairBody {
    fn of(cell: &Cell, axes: usize, body: usize) -> Option<Self> {
        let Some(thing) = body.checked_sub(axes + 1) else { return Some(Self { chain: Some(body), clearance: None }) };
        let Thing { carrier, clearance, .. } = cell.things.get(thing)?;
        let chain = match carrier {
            Carrier::World | Carrier::Frame(_) => None,
            Carrier::Link(link) => Some(*link),
            Carrier::Flange | Carrier::Tool(_) => Some(axes + 1),
        };
        Some(Self { chain, clearance: *clearance })
    }
}
