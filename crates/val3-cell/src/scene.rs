//! A cell around an arm: bodies, their carriers, and their pairs.

use std::sync::Arc;

use val3_collision::Shape;
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints, LinkCapsule};

use crate::build::Cell;
use crate::carriers::Carrier;
use crate::names::body_names;
use crate::pairs::{Pair, pairs};
use crate::reach::Reach;

/// A cell around an arm.
#[derive(Debug, Clone)]
pub struct Scene {
    pub(crate) arm: Arc<Arm>,
    cell: Arc<Cell>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) pairs: Vec<Pair>,
    pub(crate) reach: Reach,
    /// Pose of the flange in the frame of the last link.
    flange: IsometryMatrix3<f64>,
}

/// The base, a link, or a thing.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) carrier: BodyCarrier,
    /// Shapes with their poses in the frame of the carrier.
    pub(crate) shapes: Vec<(Shape, IsometryMatrix3<f64>)>,
}

/// Carrier of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BodyCarrier {
    World,
    /// The base (0) or a link.
    Link(usize),
    Flange,
    /// A frame with this number in [`Scene::data`].
    Frame(usize),
    /// A tool with this number in [`Scene::data`].
    Tool(usize),
}

impl Scene {
    /// Combines a cell and an arm.
    #[must_use]
    pub fn new(cell: Arc<Cell>, arm: Arc<Arm>) -> Self {
        let axes = arm.axes();
        let names = body_names(cell.thing_names(), axes);
        let bodies = names.enumerate().map(|(number, name)| match number.checked_sub(axes + 1) {
            None => link_body(&arm, number, name),
            Some(thing) => thing_body(&cell, thing, name),
        });
        let bodies = bodies.collect();
        let pairs = pairs(&cell, axes);
        let zero = Joints::default();
        let last = arm.parts(&zero).last().copied().unwrap_or_default();
        let flange = last.inv_mul(&arm.flange(&zero));
        Self { reach: Reach::of(&arm), flange, arm, bodies, pairs, cell }
    }

    /// Returns the same cell around another model of the arm.
    #[must_use]
    pub fn with_arm(&self, arm: Arc<Arm>) -> Self {
        Self::new(Arc::clone(&self.cell), arm)
    }

    /// The cell.
    #[must_use]
    pub fn cell(&self) -> &Cell {
        &self.cell
    }

    /// Whether the links have shapes. Otherwise only the distances of things are known.
    #[must_use]
    pub fn has_link_shapes(&self) -> bool {
        !self.arm.shapes().is_empty()
    }

    /// Whether [`crate::Minima`] records the distance of two bodies.
    #[must_use]
    pub fn compares(&self, names: &[String; 2]) -> bool {
        let [first, second] = names;
        self.pairs
            .iter()
            .filter(|pair| !pair.is_arm)
            .map(|pair| self.names(pair))
            .any(|[a, b]| (&a, &b) == (first, second) || (&b, &a) == (first, second))
    }

    /// Names of the base, the links and the things.
    pub fn body_names(&self) -> impl Iterator<Item = &str> {
        self.bodies.iter().map(|body| body.name.as_str())
    }

    /// Whether the base, a link or a thing has this name.
    #[must_use]
    pub fn has_body(&self, name: &str) -> bool {
        self.body_names().any(|known| known == name)
    }

    /// Names of the frames and tools that carry things, in the order in which [`crate::Sight::places`] lists their poses.
    pub fn data(&self) -> impl Iterator<Item = &Carrier> {
        self.cell
            .things
            .iter()
            .map(|thing| &thing.carrier)
            .filter(|carrier| matches!(carrier, Carrier::Frame(_) | Carrier::Tool(_)))
    }

    /// Names of both bodies of a pair.
    pub(crate) fn names(&self, pair: &Pair) -> [String; 2] {
        [pair.first, pair.second].map(|body| self.bodies.get(body).map(|body| body.name.clone()).unwrap_or_default())
    }

    /// Poses of the arm's parts and of the flange at a joint position.
    pub(crate) fn position(&self, joints: &Joints) -> Position {
        let parts = self.arm.parts(joints);
        let flange = parts.last().copied().unwrap_or_default() * self.flange;
        Position { parts, flange }
    }

    /// Offset of the flange from the frame of the last link.
    pub(crate) fn flange_offset(&self) -> f64 {
        self.flange.translation.vector.norm()
    }
}

fn link_body(arm: &Arm, link: usize, name: String) -> Body {
    let shapes = arm.shapes().get(link).into_iter().flatten().filter_map(capsule).collect();
    Body { name, carrier: BodyCarrier::Link(link), shapes }
}

fn thing_body(cell: &Cell, number: usize, name: String) -> Body {
    let Some(thing) = cell.things.get(number) else {
        return Body { name, carrier: BodyCarrier::World, shapes: Vec::new() };
    };
    let number = |name: &str| data_names(cell).position(|known| known == name).unwrap_or_default();
    let carrier = match &thing.carrier {
        Carrier::World => BodyCarrier::World,
        Carrier::Link(link) => BodyCarrier::Link(*link),
        Carrier::Flange => BodyCarrier::Flange,
        Carrier::Frame(name) => BodyCarrier::Frame(number(name)),
        Carrier::Tool(name) => BodyCarrier::Tool(number(name)),
    };
    let shapes = thing.solids.iter().map(|solid| (solid.shape.clone(), thing.pose * solid.pose)).collect();
    Body { name, carrier, shapes }
}

fn data_names(cell: &Cell) -> impl Iterator<Item = &str> {
    cell.things.iter().filter_map(|thing| match &thing.carrier {
        Carrier::Frame(name) | Carrier::Tool(name) => Some(name.as_str()),
        Carrier::World | Carrier::Link(_) | Carrier::Flange => None,
    })
}

fn capsule(capsule: &LinkCapsule) -> Option<(Shape, IsometryMatrix3<f64>)> {
    let shape = Shape::capsule(capsule.from, capsule.to, capsule.radius).ok()?;
    Some((shape, IsometryMatrix3::identity()))
}

/// Poses of the arm's parts and of the flange.
#[derive(Debug, Clone)]
pub(crate) struct Position {
    parts: Vec<IsometryMatrix3<f64>>,
    flange: IsometryMatrix3<f64>,
}

impl Position {
    /// Pose of a carrier in `world`; `None` for a frame or tool without a place.
    pub(crate) fn carrier(
        &self,
        carrier: BodyCarrier,
        places: &[Option<IsometryMatrix3<f64>>],
    ) -> Option<IsometryMatrix3<f64>> {
        let place = |number: usize| places.get(number).copied().flatten();
        match carrier {
            BodyCarrier::World => Some(IsometryMatrix3::identity()),
            BodyCarrier::Link(link) => self.parts.get(link).copied(),
            BodyCarrier::Flange => Some(self.flange),
            BodyCarrier::Frame(number) => place(number),
            BodyCarrier::Tool(number) => Some(self.flange * place(number)?),
        }
    }
}
