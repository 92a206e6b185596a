//! Conveyors: moving the parts on them, and receiving new parts.

use std::sync::Arc;

use val3_collision::Bounds;
use val3_geometry::{IsometryMatrix3, Trsf};

use super::conveyor_state::{ConveyorState, NextPart};
use super::{Handling, HandlingEvent, HandlingView};
use crate::conveyor::Conveyor;
use crate::file::ConveyorEnd;
use crate::part::{PartHolder, PartPlace};
use crate::scene::{BodyCarrier, Places};

/// Gap in mm that a part keeps to the part ahead.
const GAP: f64 = 1.0;

/// Height in mm above the belt up to which a conveyor moves a part.
const ABOVE: f64 = 50.0;

/// A part that no gripper holds, in the track's frame.
struct TrackPart {
    number: usize,
    bounds: Bounds,
}

impl Handling {
    /// Moves the parts on a conveyor for a cycle of this duration in seconds, and receives new parts. `runs` is the
    /// conveyor's state according to its signals; `None` if one of the signals does not exist.
    pub(super) fn convey(
        &mut self,
        number: usize,
        runs: Option<bool>,
        cycle: f64,
        view: &HandlingView<'_>,
    ) -> Vec<HandlingEvent> {
        let Some(conveyor) = view.scene.cell().conveyors.get(number) else { return Vec::new() };
        let Some(mut state) = self.conveyors.get(number).copied() else { return Vec::new() };
        let Some(place) = view.place(&conveyor.carrier) else { return Vec::new() };
        let track = place * conveyor.track;
        let mut events = Vec::new();
        let runs = runs.unwrap_or_default();
        // The belt has moved by its state at the beginning of the cycle. Signal changes become effective at the end.
        let shift = if state.runs == Some(true) { conveyor.speed * cycle } else { 0.0 };
        let has_moved = self.shift(conveyor, &track, shift, &mut events, view);
        if state.runs != Some(runs) {
            state.runs = Some(runs);
            state.next = state.next.switched(runs, view.sight.time);
        }
        state.is_moving = runs && (has_moved || shift == 0.0 && self.on_belt(conveyor, &track, view).next().is_some());
        if runs && state.next.is_due(view.sight.time) {
            events.extend(self.feed(conveyor, &mut state, &place, view));
        }
        if let Some(known) = self.conveyors.get_mut(number) {
            *known = state;
        }
        events
    }

    /// Moves the parts on a belt, the foremost first. Returns whether at least one part has moved.
    fn shift(
        &mut self,
        conveyor: &Conveyor,
        track: &IsometryMatrix3<f64>,
        shift: f64,
        events: &mut Vec<HandlingEvent>,
        view: &HandlingView<'_>,
    ) -> bool {
        if shift <= 0.0 {
            return false;
        }
        let mut parts: Vec<TrackPart> = self.on_belt(conveyor, track, view).collect();
        parts.sort_by(|one, other| other.bounds.max.x.total_cmp(&one.bounds.max.x));
        let mut has_moved = false;
        for part in parts {
            if conveyor.end == ConveyorEnd::Remove && centre(&part.bounds)[0] + shift > conveyor.belt.max.x {
                events.extend(self.place(view.scene, part.number, None));
                has_moved = true;
                continue;
            }
            let free = self.free_way(conveyor, &part, track, view).min(shift);
            if free > 0.0 {
                self.move_along(part.number, track, free, view);
                has_moved = true;
            }
        }
        has_moved
    }

    /// Returns the distance in mm by which a part can move before it reaches the end of the belt or the part ahead.
    fn free_way(
        &self,
        conveyor: &Conveyor,
        part: &TrackPart,
        track: &IsometryMatrix3<f64>,
        view: &HandlingView<'_>,
    ) -> f64 {
        let end = match conveyor.end {
            ConveyorEnd::Stop => conveyor.belt.max.x - part.bounds.max.x,
            ConveyorEnd::Remove => f64::INFINITY,
        };
        let ahead = self.track_parts(track, view).filter(|other| other.number != part.number);
        let gaps = ahead.filter(|other| is_ahead(&part.bounds, &other.bounds));
        let gap = gaps.map(|other| other.bounds.min.x - part.bounds.max.x - GAP).fold(f64::INFINITY, f64::min);
        end.min(gap).max(0.0)
    }

    fn move_along(&mut self, part: usize, track: &IsometryMatrix3<f64>, way: f64, view: &HandlingView<'_>) {
        let Some(here) = view.body(BodyCarrier::Part(part), &self.parts) else { return };
        let step = Trsf::new([way, 0.0, 0.0], [0.0; 3]).isometry();
        let pose = track * step * track.inverse() * here;
        if let Some(place) = Arc::make_mut(&mut self.parts).get_mut(part) {
            *place = PartPlace { holder: PartHolder::World, pose };
        }
    }

    /// Adds the next part to the belt of a conveyor at `place` in `world`, if there is room for it.
    fn feed(
        &mut self,
        conveyor: &Conveyor,
        state: &mut ConveyorState,
        place: &IsometryMatrix3<f64>,
        view: &HandlingView<'_>,
    ) -> Option<HandlingEvent> {
        let waits = |part: &usize| self.parts.get(*part).is_some_and(|place| place.holder == PartHolder::Gone);
        let next = conveyor.feed.as_ref().and_then(|feed| {
            // Skips parts that a script has placed before their arrival.
            let skipped = feed.parts.iter().skip(state.fed).position(waits)?;
            state.fed += skipped;
            Some((feed, *feed.parts.get(state.fed)?))
        });
        let Some((feed, part)) = next else {
            state.next = NextPart::Never;
            return None;
        };
        let pose = place * feed.pose;
        let track = place * conveyor.track;
        let bounds = part_bounds(part, &pose, &track, view)?;
        if self.track_parts(&track, view).any(|other| overlap(&bounds, &other.bounds)) {
            state.next = NextPart::Blocked;
            return None;
        }
        *Arc::make_mut(&mut self.parts).get_mut(part)? = PartPlace { holder: PartHolder::World, pose };
        // If a part had to wait for a free pose, the next part is delayed as well.
        let time = if let NextPart::At(due) = state.next { due } else { view.sight.time };
        state.next = NextPart::At(time + feed.every);
        state.fed += 1;
        state.is_moving = true;
        let name = view.scene.cell().parts.get(part)?.name.clone();
        Some(HandlingEvent::Part { part: name, is_gone: false })
    }

    /// Returns the parts on a belt, which the conveyor moves.
    fn on_belt<'h>(
        &'h self,
        conveyor: &'h Conveyor,
        track: &'h IsometryMatrix3<f64>,
        view: &'h HandlingView<'_>,
    ) -> impl Iterator<Item = TrackPart> + 'h {
        self.track_parts(track, view).filter(|part| {
            let [x, y] = centre(&part.bounds);
            let belt = &conveyor.belt;
            let is_within = belt.min.x <= x && x <= belt.max.x && belt.min.y <= y && y <= belt.max.y;
            is_within && (belt.min.z..=belt.max.z + ABOVE).contains(&part.bounds.min.z)
        })
    }

    /// Returns all parts in the cell that no gripper holds.
    fn track_parts<'h>(
        &'h self,
        track: &'h IsometryMatrix3<f64>,
        view: &'h HandlingView<'_>,
    ) -> impl Iterator<Item = TrackPart> + 'h {
        let places = Places { data: &view.sight.places, parts: &self.parts };
        let free = self
            .parts
            .iter()
            .enumerate()
            .filter(|(_, place)| matches!(place.holder, PartHolder::World | PartHolder::Frame(_)));
        free.filter_map(move |(number, _)| {
            let pose = view.position.carrier(BodyCarrier::Part(number), places)?;
            Some(TrackPart { number, bounds: part_bounds(number, &pose, track, view)? })
        })
    }
}

/// Returns the bounding box, in the track's frame, of a part with a pose in `world`.
fn part_bounds(
    part: usize,
    pose: &IsometryMatrix3<f64>,
    track: &IsometryMatrix3<f64>,
    view: &HandlingView<'_>,
) -> Option<Bounds> {
    let pose = track.inv_mul(pose);
    let solids = view.scene.cell().parts.get(part)?.solids.iter();
    let boxes = solids.map(|solid| solid.shape.bounds(&(pose * solid.pose)));
    boxes.reduce(|all, next| Bounds { min: all.min.inf(&next.min), max: all.max.sup(&next.max) })
}

/// Returns the centre of a box in the top view.
fn centre(bounds: &Bounds) -> [f64; 2] {
    [(bounds.min.x + bounds.max.x) / 2.0, (bounds.min.y + bounds.max.y) / 2.0]
}

/// Whether `other` blocks the way of `moving` along the x axis.
fn is_ahead(moving: &Bounds, other: &Bounds) -> bool {
    let in_way = |from: f64, to: f64, low: f64, high: f64| from < high && low < to;
    centre(moving)[0] < centre(other)[0]
        && in_way(moving.min.y, moving.max.y, other.min.y, other.max.y)
        && in_way(moving.min.z, moving.max.z, other.min.z, other.max.z)
}

/// Whether two boxes overlap, or their distance along the track is less than the gap between parts.
fn overlap(one: &Bounds, other: &Bounds) -> bool {
    let touches = |from: f64, to: f64, low: f64, high: f64| from < high && low < to;
    touches(one.min.x - GAP, one.max.x + GAP, other.min.x, other.max.x)
        && touches(one.min.y, one.max.y, other.min.y, other.max.y)
        && touches(one.min.z, one.max.z, other.min.z, other.max.z)
}

#[cfg(test)]
mod tests;
