//! A cell around an arm: bodies, their carriers, and their pairs.

use std::sync::Arc;

use val3_collision::Shape;
use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Joints, LinkCapsule};

use crate::build::{Cell, Thing};
use crate::carriers::{Carrier, Chain};
use crate::names::body_names;
use crate::pairs::{Comparison, Pair, comparison, pairs};
use crate::part::{Part, PartHolder, PartPlace};
use crate::reach::Reach;

/// A cell around an arm.
#[derive(Debug, Clone)]
pub struct Scene {
    pub(crate) arm: Arc<Arm>,
    cell: Arc<Cell>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) pairs: Vec<Pair>,
    pub(crate) reach: Reach,
    /// Frames and tools that are carriers.
    data: Vec<Carrier>,
    /// Pose of the flange in the frame of the last link.
    flange: IsometryMatrix3<f64>,
}

/// The base, a link, a thing, or a part.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) carrier: BodyCarrier,
    /// Position in the arm's chain; `None` for stationary bodies and parts.
    pub(crate) chain: Chain,
    /// Shapes with their poses in the carrier's frame; for a part, its cores with their poses in the part's frame.
    pub(crate) shapes: Vec<(Shape, IsometryMatrix3<f64>)>,
}

impl Body {
    /// Radius in mm of the sphere that contains all shapes: around the origin of the frame in which the carrier's frame
    /// has this pose. For a part, the pose is the part's own.
    pub(crate) fn reach(&self, pose: &IsometryMatrix3<f64>) -> f64 {
        let reaches = self.shapes.iter().map(|(shape, own)| (pose * own).translation.vector.norm() + shape.reach());
        reaches.fold(0.0, f64::max)
    }
}

/// Carrier of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BodyCarrier {
    World,
    /// The base (0) or a link.
    Link(usize),
    Flange,
    /// The frame with this index in [`Scene::data`].
    Frame(usize),
    /// The tool with this index in [`Scene::data`].
    Tool(usize),
    /// The current holder of the part with this index.
    Part(usize),
}

impl Scene {
    /// Combines a cell with an arm.
    #[must_use]
    pub fn new(cell: Arc<Cell>, arm: Arc<Arm>) -> Self {
        let axes = arm.axes();
        let data = data(&cell);
        let names = body_names(cell.body_names(), axes);
        let bodies = names.enumerate().map(|(number, name)| match number.checked_sub(axes + 1) {
            None => link_body(&arm, &cell, number, name),
            Some(thing) => match cell.things.get(thing) {
                Some(thing) => thing_body(thing, &data, axes, name),
                None => part_body(&cell, thing - cell.things.len(), name),
            },
        });
        let bodies = bodies.collect();
        let pairs = pairs(&cell, axes);
        let zero = Joints::default();
        let last = arm.parts(&zero).last().copied().unwrap_or_default();
        let flange = last.inv_mul(&arm.flange(&zero));
        Self { reach: Reach::of(&arm), data, flange, arm, bodies, pairs, cell }
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

    /// Whether the links have shapes. Without them, only distances between things can be measured.
    #[must_use]
    pub fn has_link_shapes(&self) -> bool {
        let mut links = self.bodies.iter().take(self.first_thing());
        links.all(|link| !link.shapes.is_empty())
    }

    /// Whether [`crate::Minima`] records the distance between these two bodies.
    #[must_use]
    pub fn compares(&self, names: &[String; 2]) -> bool {
        let [first, second] = names;
        self.pairs
            .iter()
            .filter(|pair| !pair.is_arm())
            .map(|pair| self.names(pair))
            .any(|[a, b]| (&a, &b) == (first, second) || (&b, &a) == (first, second))
    }

    /// Whether [`crate::Minima`] records any distance between bodies that are no parts.
    #[must_use]
    pub fn compares_standing_things(&self) -> bool {
        self.pairs.iter().any(|pair| !pair.is_arm() && !pair.has_part())
    }

    /// Returns the names of the base, the links, the things and the parts.
    pub fn body_names(&self) -> impl Iterator<Item = &str> {
        self.bodies.iter().map(|body| body.name.as_str())
    }

    /// Whether the base, a link, a thing or a part has this name.
    #[must_use]
    pub fn has_body(&self, name: &str) -> bool {
        self.body_names().any(|known| known == name)
    }

    /// Returns the frames and tools that are carriers. [`crate::Sight::places`] contains their poses in the same order.
    pub fn data(&self) -> impl Iterator<Item = &Carrier> {
        self.data.iter()
    }

    /// Returns the body index of the first thing. The base and the links precede the things.
    pub(crate) fn first_thing(&self) -> usize {
        self.arm.axes() + 1
    }

    /// Returns the body index of a part.
    pub(crate) fn part_body(&self, part: usize) -> usize {
        self.first_thing() + self.cell.things.len() + part
    }

    /// Returns the carrier with the index of its frame or tool.
    pub(crate) fn carrier(&self, carrier: &Carrier) -> BodyCarrier {
        body_carrier(carrier, &self.data)
    }

    /// Returns the kind of comparison for the pair, with parts at `parts`; `None` if the pair is not compared.
    pub(crate) fn comparison(&self, pair: &Pair, parts: &[PartPlace]) -> Option<Comparison> {
        if pair.comparison.is_some() {
            return pair.comparison;
        }
        comparison(self.chain(pair.first, parts)?, self.chain(pair.second, parts)?, self.arm.axes())
    }

    /// Returns the position of a body in the arm's chain, with parts at `parts`; `None` for a removed part.
    fn chain(&self, body: usize, parts: &[PartPlace]) -> Option<Chain> {
        let body = self.bodies.get(body)?;
        let BodyCarrier::Part(part) = body.carrier else { return Some(body.chain) };
        match parts.get(part)?.holder {
            PartHolder::World | PartHolder::Frame(_) => Some(None),
            PartHolder::Gripper(_) => Some(Some(self.arm.axes() + 1)),
            PartHolder::Gone => None,
        }
    }

    /// Returns the names of both bodies in a pair.
    pub(crate) fn names(&self, pair: &Pair) -> [String; 2] {
        [pair.first, pair.second].map(|body| self.bodies.get(body).map(|body| body.name.clone()).unwrap_or_default())
    }

    /// Computes the poses of the arm's links and of the flange at a joint position.
    pub(crate) fn position(&self, joints: &Joints) -> Position {
        let parts = self.arm.parts(joints);
        let flange = parts.last().copied().unwrap_or_default() * self.flange;
        Position { parts, flange }
    }

    /// Returns the distance in mm between the flange and the frame of the last link.
    pub(crate) fn flange_offset(&self) -> f64 {
        self.flange.translation.vector.norm()
    }
}

fn link_body(arm: &Arm, cell: &Cell, link: usize, name: String) -> Body {
    let shapes = match cell.links.get(link) {
        Some(Some(hull)) => vec![(hull.0.clone(), IsometryMatrix3::identity())],
        _ => arm.shapes().get(link).into_iter().flatten().filter_map(capsule).collect(),
    };
    Body { name, carrier: BodyCarrier::Link(link), chain: Some(link), shapes }
}

fn thing_body(thing: &Thing, data: &[Carrier], axes: usize, name: String) -> Body {
    let shapes = thing.solids.iter().map(|solid| (solid.shape.clone(), thing.pose * solid.pose)).collect();
    Body { name, carrier: body_carrier(&thing.carrier, data), chain: thing.carrier.chain(axes), shapes }
}

fn part_body(cell: &Cell, number: usize, name: String) -> Body {
    let shapes = cell.parts.get(number).map(Part::cores).unwrap_or_default();
    Body { name, carrier: BodyCarrier::Part(number), chain: None, shapes }
}

fn body_carrier(carrier: &Carrier, data: &[Carrier]) -> BodyCarrier {
    let number = || data.iter().position(|known| known == carrier).unwrap_or_default();
    match carrier {
        Carrier::World => BodyCarrier::World,
        Carrier::Link(link) => BodyCarrier::Link(*link),
        Carrier::Flange => BodyCarrier::Flange,
        Carrier::Frame(_) => BodyCarrier::Frame(number()),
        Carrier::Tool(_) => BodyCarrier::Tool(number()),
    }
}

/// Returns the frames and tools that are carriers, without duplicates.
fn data(cell: &Cell) -> Vec<Carrier> {
    let things = cell.things.iter().map(|thing| &thing.carrier);
    let parts = cell.parts.iter().map(|part| &part.carrier);
    let grippers = cell.grippers.iter().map(|gripper| &gripper.carrier);
    let sensors = cell.sensors.iter().map(|sensor| &sensor.carrier);
    let conveyors = cell.conveyors.iter().map(|conveyor| &conveyor.carrier);
    let mut data: Vec<Carrier> = Vec::new();
    for carrier in things.chain(parts).chain(grippers).chain(sensors).chain(conveyors) {
        if matches!(carrier, Carrier::Frame(_) | Carrier::Tool(_)) && !data.contains(carrier) {
            data.push(carrier.clone());
        }
    }
    data
}

fn capsule(capsule: &LinkCapsule) -> Option<(Shape, IsometryMatrix3<f64>)> {
    let shape = Shape::capsule(capsule.from, capsule.to, capsule.radius).ok()?;
    Some((shape, IsometryMatrix3::identity()))
}

/// Poses of the arm's links and of the flange.
#[derive(Debug, Clone)]
pub(crate) struct Position {
    parts: Vec<IsometryMatrix3<f64>>,
    flange: IsometryMatrix3<f64>,
}

impl Position {
    /// Returns the pose of the flange in `world`.
    pub(crate) fn flange(&self) -> &IsometryMatrix3<f64> {
        &self.flange
    }

    /// Returns the pose of a carrier in `world`; `None` for a frame or tool without a pose, and for a removed part.
    pub(crate) fn carrier(&self, carrier: BodyCarrier, places: Places<'_>) -> Option<IsometryMatrix3<f64>> {
        let place = |number: usize| places.data.get(number).copied().flatten();
        match carrier {
            BodyCarrier::World => Some(IsometryMatrix3::identity()),
            BodyCarrier::Link(link) => self.parts.get(link).copied(),
            BodyCarrier::Flange => Some(self.flange),
            BodyCarrier::Frame(number) => place(number),
            BodyCarrier::Tool(number) => Some(self.flange * place(number)?),
            BodyCarrier::Part(number) => {
                let PartPlace { holder, pose } = places.parts.get(number)?;
                match holder {
                    PartHolder::World => Some(*pose),
                    PartHolder::Frame(number) => Some(place(*number)? * pose),
                    PartHolder::Gripper(_) => Some(self.flange * pose),
                    PartHolder::Gone => None,
                }
            }
        }
    }
}

/// Poses of frames, tools and parts.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places<'p> {
    /// Poses of the carriers in [`Scene::data`].
    pub(crate) data: &'p [Option<IsometryMatrix3<f64>>],
    pub(crate) parts: &'p [PartPlace],
}
