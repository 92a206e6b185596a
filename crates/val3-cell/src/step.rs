//! Movement of all bodies during a cycle.

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;
use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints};

use crate::measure::{Placed, Reading, measure};
use crate::pairs::{Comparison, Pair};
use crate::part::{PartHolder, PartPlace};
use crate::scene::{Body, BodyCarrier, Places, Position, Scene};

/// Coordinate in mm beyond which a pose is unusable.
const FARTHEST: f64 = 1e9;

/// State of the arm and of all carriers at the end of a cycle.
#[derive(Debug, Clone)]
pub struct Sight<'a> {
    /// The arm's model.
    pub arm: &'a Arc<Arm>,
    /// Joint position, in degrees or mm.
    pub joints: Joints,
    /// Number that changes when the arm is placed elsewhere without a motion.
    pub placement: u64,
    /// Poses of the frames in `world` and of the tools in `flange`, in the order of [`Scene::data`]; `None` for a frame
    /// or tool without a pose.
    pub places: Vec<Option<IsometryMatrix3<f64>>>,
    /// Holders and poses of the parts, in the order of the cell.
    pub parts: Arc<Vec<PartPlace>>,
    /// Time, in seconds.
    pub time: f64,
}

impl Sight<'_> {
    pub(crate) fn places(&self) -> Places<'_> {
        Places { data: &self.places, parts: &self.parts }
    }
}

/// Copy of the last sight, at which a step begins.
#[derive(Debug, Clone, Default)]
pub(crate) struct Past {
    joints: Joints,
    placement: u64,
    places: Vec<Option<IsometryMatrix3<f64>>>,
    parts: Arc<Vec<PartPlace>>,
    time: f64,
}

impl Past {
    pub(crate) fn of(sight: &Sight<'_>) -> Self {
        let Sight { joints, placement, places, parts, time, .. } = sight;
        let (places, parts) = (places.clone(), Arc::clone(parts));
        Self { joints: *joints, placement: *placement, places, parts, time: *time }
    }

    /// Whether the arm was placed elsewhere without a motion.
    pub(crate) fn has_jumped(&self, sight: &Sight<'_>) -> bool {
        self.placement != sight.placement
    }

    /// Whether nothing has moved since the last sight.
    pub(crate) fn is_same(&self, sight: &Sight<'_>) -> bool {
        self.joints == sight.joints
            && self.placement == sight.placement
            && self.places == sight.places
            && (Arc::ptr_eq(&self.parts, &sight.parts) || self.parts == sight.parts)
    }
}

/// The movement of all bodies between two sights, with linear joint motion.
pub(crate) struct Step<'s> {
    scene: &'s Scene,
    from: Joints,
    to: Joints,
    start: f64,
    end: f64,
    places: Places<'s>,
    /// For each part, whether its pose differs from the last sight.
    has_part_moved: Vec<bool>,
    /// For each frame or tool, whether its pose differs from the last sight.
    has_moved: Vec<bool>,
    /// Movement of each axis, in degrees or mm.
    moved: Joints,
    /// Positions at fractions of the step. The searches of different pairs divide the step at the same fractions.
    positions: RefCell<Vec<(f64, Rc<Position>)>>,
    /// Results of [`Self::way`] for all bodies.
    ways: OnceCell<Vec<Option<f64>>>,
}

impl<'s> Step<'s> {
    pub(crate) fn new(scene: &'s Scene, past: Option<&Past>, sight: &'s Sight<'_>) -> Self {
        let before = past.filter(|past| past.placement == sight.placement);
        let from = before.map_or(sight.joints, |past| past.joints);
        let moved = |number: usize| past.is_none_or(|past| past.places.get(number) != sight.places.get(number));
        Self {
            scene,
            from,
            to: sight.joints,
            start: past.map_or(sight.time, |past| past.time),
            end: sight.time,
            places: sight.places(),
            has_part_moved: moved_parts(past, sight),
            has_moved: (0..sight.places.len()).map(moved).collect(),
            moved: std::array::from_fn(|axis| difference(&sight.joints, &from, axis)),
            positions: RefCell::default(),
            ways: OnceCell::new(),
        }
    }

    /// Returns an upper bound in mm for the sum of both bodies' movements; `None` if a body was placed elsewhere.
    pub(crate) fn travel(&self, pair: &Pair) -> Option<f64> {
        // The results are stored because each body belongs to many pairs.
        let ways = self.ways.get_or_init(|| self.scene.bodies.iter().map(|body| self.way(body)).collect());
        let way = |number: usize| ways.get(number).copied().flatten();
        Some(way(pair.first)? + way(pair.second)?)
    }

    /// Returns an upper bound in mm for the movement of a body with the arm; `None` if the body, its frame or its tool
    /// was placed elsewhere.
    fn way(&self, body: &Body) -> Option<f64> {
        let here = IsometryMatrix3::identity();
        let (reach, axes) = (&self.scene.reach, self.scene.arm.axes());
        match body.carrier {
            BodyCarrier::World => Some(0.0),
            BodyCarrier::Frame(number) => self.has_moved.get(number).is_some_and(|moved| !moved).then_some(0.0),
            BodyCarrier::Link(link) => Some(reach.way(link, body.reach(&here), &self.moved)),
            BodyCarrier::Flange => Some(reach.way(axes, self.scene.flange_offset() + body.reach(&here), &self.moved)),
            BodyCarrier::Tool(number) if self.has_moved.get(number).is_some_and(|moved| !moved) => {
                let tool = self.places.data.get(number).copied().flatten()?;
                Some(reach.way(axes, self.scene.flange_offset() + body.reach(&tool), &self.moved))
            }
            BodyCarrier::Tool(_) => None,
            BodyCarrier::Part(number) if self.has_part_moved.get(number).is_some_and(|moved| !moved) => {
                let PartPlace { holder, pose } = self.places.parts.get(number)?;
                match holder {
                    PartHolder::World => Some(0.0),
                    PartHolder::Frame(number) => self.has_moved.get(*number).is_some_and(|moved| !moved).then_some(0.0),
                    PartHolder::Gripper(_) => {
                        Some(reach.way(axes, self.scene.flange_offset() + body.reach(pose), &self.moved))
                    }
                    PartHolder::Gone => None,
                }
            }
            BodyCarrier::Part(_) => None,
        }
    }

    fn body(&self, number: usize) -> Option<&'s Body> {
        self.scene.bodies.get(number)
    }

    /// Measures a pair at a fraction of the step, from 0 to 1.
    pub(crate) fn measure(&self, pair: &Pair, fraction: f64, limit: f64) -> Reading {
        let position = self.position(fraction.clamp(0.0, 1.0));
        match (self.placed(pair.first, &position), self.placed(pair.second, &position)) {
            (Some(first), Some(second)) => measure(&first, &second, limit),
            // A body without a pose is infinitely far away.
            _ => Reading::Beyond(f64::INFINITY),
        }
    }

    /// Returns the kind of comparison for a pair at the end of the step; `None` if the pair is not compared.
    pub(crate) fn comparison(&self, pair: &Pair) -> Option<Comparison> {
        self.scene.comparison(pair, self.places.parts)
    }

    /// Whether the arm moves.
    pub(crate) fn is_motion(&self) -> bool {
        self.from != self.to
    }

    /// Whether a body has a pose at the end of the step, or was removed.
    pub(crate) fn has_place(&self, body: usize) -> bool {
        self.is_removed(body) || self.placed(body, &self.position(1.0)).is_some()
    }

    /// Whether a body is a removed part.
    fn is_removed(&self, body: usize) -> bool {
        let Some(BodyCarrier::Part(part)) = self.body(body).map(|body| body.carrier) else { return false };
        self.places.parts.get(part).is_some_and(|place| place.holder == PartHolder::Gone)
    }

    /// Returns the shapes and the pose of a body for a position of the arm; `None` if the body has no pose.
    fn placed(&self, number: usize, position: &Position) -> Option<Placed<'s>> {
        let body = self.body(number)?;
        let pose = position.carrier(body.carrier, self.places)?;
        is_usable(&pose).then_some(Placed { shapes: &body.shapes, pose })
    }

    /// Returns the position at a fraction of the step, from 0 to 1.
    fn position(&self, fraction: f64) -> Rc<Position> {
        let known = self.positions.borrow().iter().find(|(at, _)| *at == fraction).map(|(_, known)| Rc::clone(known));
        known.unwrap_or_else(|| {
            let joints = if fraction == 1.0 { self.to } else { self.joints(fraction) };
            let position = Rc::new(self.scene.position(&joints));
            self.positions.borrow_mut().push((fraction, Rc::clone(&position)));
            position
        })
    }

    /// Returns the joint position at a fraction of the step.
    pub(crate) fn joints(&self, fraction: f64) -> Joints {
        std::array::from_fn(|axis| {
            self.from.get(axis).copied().unwrap_or_default() + fraction * difference(&self.to, &self.from, axis)
        })
    }

    /// Returns the time at a fraction of the step, in seconds.
    pub(crate) fn time(&self, fraction: f64) -> f64 {
        self.start + fraction * (self.end - self.start)
    }
}

/// Whether distances can be computed with a pose: a program can write any numbers into a frame.
fn is_usable(pose: &IsometryMatrix3<f64>) -> bool {
    pose.rotation.matrix().iter().all(|number| number.is_finite())
        && pose.translation.vector.iter().all(|length| length.abs() < FARTHEST)
}

/// Returns for each part whether its pose differs from the last sight.
fn moved_parts(past: Option<&Past>, sight: &Sight<'_>) -> Vec<bool> {
    match past {
        Some(past) if Arc::ptr_eq(&past.parts, &sight.parts) => vec![false; sight.parts.len()],
        _ => {
            let before = |number: usize| past.and_then(|past| past.parts.get(number));
            sight.parts.iter().enumerate().map(|(number, place)| before(number) != Some(place)).collect()
        }
    }
}

fn difference(to: &Joints, from: &Joints, axis: usize) -> f64 {
    to.get(axis).copied().unwrap_or_default() - from.get(axis).copied().unwrap_or_default()
}
