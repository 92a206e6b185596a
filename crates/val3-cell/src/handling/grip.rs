//! Grippers: selection of the part that they hold.

use std::sync::Arc;

use val3_collision::{Nearness, PlacedShape, Shape, nearest};
use val3_geometry::IsometryMatrix3;

use super::{Handling, HandlingEvent, HandlingView, SAME_TIME};
use crate::gripper::{Gripper, GripperCommand, SignalWrite};
use crate::part::{PartHolder, PartPlace};
use crate::scene::{BodyCarrier, Scene};

/// Radius in mm of the sphere that represents the grip point, and rounding unit of the distances to it.
const POINT: f64 = 1e-6;

/// A part, and its distance from a grip point.
#[derive(Debug, Clone, PartialEq)]
pub struct NearPart {
    /// Part name.
    pub name: String,
    /// Distance in mm.
    pub distance: f64,
}

/// State of a gripper.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct GripperState {
    /// Whether the output had its value for holding in the last cycle; `None` before the first cycle.
    commanded: Option<bool>,
    /// Time in seconds at which the output's last change becomes effective.
    pub(super) due: Option<f64>,
    /// Index of the held part.
    holds: Option<usize>,
    /// Whether the gripper held a part when its inputs were last written.
    written: Option<bool>,
    /// Whether an output controls the gripper.
    pub(super) is_controlled: bool,
}

impl GripperState {
    /// Whether the command is unchanged and already effective.
    pub(super) fn follows(&self, command: GripperCommand) -> bool {
        self.commanded == Some(command.holds) && self.due.is_none()
    }
}

impl Handling {
    /// Processes the command of a gripper's output.
    pub(super) fn command(
        &mut self,
        number: usize,
        command: GripperCommand,
        view: &HandlingView<'_>,
    ) -> Option<HandlingEvent> {
        let gripper = view.scene.cell().grippers.get(number)?;
        let state = self.grippers.get_mut(number)?;
        state.is_controlled = true;
        let before = state.commanded.replace(command.holds);
        if before != Some(command.holds) {
            // An output with this value at the start was set before the run, so the delay has passed.
            let delay = if before.is_none() { 0.0 } else { command.delay };
            state.due = Some(view.sight.time + delay);
        }
        let event = match state.due.take_if(|due| *due <= view.sight.time + SAME_TIME) {
            Some(_) if command.holds && state.holds.is_none() => {
                self.grip(number, gripper, view).filter(|event| {
                    // At the start, a closed gripper without a part is no event.
                    before.is_some() || matches!(event, HandlingEvent::Grip { part: Some(_), .. })
                })
            }
            Some(_) if !command.holds => self.release(number, gripper, view),
            _ => None,
        };
        self.write_inputs(number, gripper);
        event
    }

    /// Grips the nearest part.
    fn grip(&mut self, number: usize, gripper: &Gripper, view: &HandlingView<'_>) -> Option<HandlingEvent> {
        let point = view.place(&gripper.carrier)? * gripper.pose;
        let found = self.nearest_part(&point, view);
        let near = found.filter(|(_, distance)| *distance <= gripper.within);
        if let Some((part, _)) = near {
            let here = view.body(BodyCarrier::Part(part), &self.parts)?;
            let pose = view.position.flange().inv_mul(&here);
            *Arc::make_mut(&mut self.parts).get_mut(part)? = PartPlace { holder: PartHolder::Gripper(number), pose };
            self.has_part_moved = true;
            self.grippers.get_mut(number)?.holds = Some(part);
        }
        let name = |part: usize| view.scene.cell().parts.get(part).map(|part| part.name.clone());
        Some(HandlingEvent::Grip {
            gripper: gripper.name.clone(),
            part: near.and_then(|(part, _)| name(part)),
            nearest: found.and_then(|(part, distance)| Some(NearPart { name: name(part)?, distance })),
            within: gripper.within,
        })
    }

    /// Returns the index and distance of the nearest part that no gripper holds.
    fn nearest_part(&self, point: &IsometryMatrix3<f64>, view: &HandlingView<'_>) -> Option<(usize, f64)> {
        let ball = Shape::sphere(POINT).ok()?;
        let mut found: Option<(usize, f64)> = None;
        for (number, part) in view.scene.cell().parts.iter().enumerate() {
            if self.is_held(number) {
                continue;
            }
            let Some(place) = view.body(BodyCarrier::Part(number), &self.parts) else { continue };
            for solid in part.solids.iter() {
                let limit = found.map_or(f64::MAX, |(_, distance)| distance);
                let (first, pose) = (PlacedShape { shape: &ball, pose: point }, place * solid.pose);
                let distance = match nearest(first, PlacedShape { shape: &solid.shape, pose: &pose }, limit) {
                    Nearness::Beyond => continue,
                    Nearness::Apart(closest) => ((closest.distance + POINT) / POINT).round() * POINT,
                    Nearness::Overlap(_) => 0.0,
                };
                if found.is_none_or(|(_, least)| distance < least) {
                    found = Some((number, distance));
                }
            }
        }
        found
    }

    /// Releases the held part, which keeps its pose.
    fn release(&mut self, number: usize, gripper: &Gripper, view: &HandlingView<'_>) -> Option<HandlingEvent> {
        let part = self.grippers.get_mut(number)?.holds.take()?;
        let pose = view.body(BodyCarrier::Part(part), &self.parts)?;
        *Arc::make_mut(&mut self.parts).get_mut(part)? = PartPlace { holder: PartHolder::World, pose };
        self.has_part_moved = true;
        Some(HandlingEvent::Release {
            gripper: gripper.name.clone(),
            part: view.scene.cell().parts.get(part)?.name.clone(),
            above: self.height_above(part, view),
        })
    }

    /// Empties a gripper, because a script has placed the held part elsewhere.
    pub(super) fn lose(&mut self, gripper: usize, scene: &Scene) {
        if let Some(state) = self.grippers.get_mut(gripper) {
            state.holds = None;
        }
        if let Some(of) = scene.cell().grippers.get(gripper) {
            self.write_inputs(gripper, of);
        }
    }

    /// Requests the values of the gripper's inputs if the gripper has begun or ceased to hold a part.
    fn write_inputs(&mut self, number: usize, gripper: &Gripper) {
        let Some(state) = self.grippers.get_mut(number) else { return };
        let holds = state.holds.is_some();
        if state.written.replace(holds) != Some(holds) {
            let values: &[SignalWrite] = if holds { &gripper.holding } else { &gripper.empty };
            self.writes.extend_from_slice(values);
        }
    }
}
