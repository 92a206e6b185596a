//! Conveyors of a cell file.

use val3_geometry::{IsometryMatrix3, Trsf, Vector3, set_frame};

use crate::build::{CellMaker, Thing};
use crate::carriers::{Carried, CarriedKeys};
use crate::conveyor::{Conveyor, Feed};
use crate::error::CellError;
use crate::file::{CellFile, ConveyorEntry, FeedKeys, PartEntry, ShapeKeys};
use crate::part::Part;
use crate::poses::{check_colour, distance, pose, triple};
use crate::solids::{Solid, SolidMaker, solid};

/// Longest accepted time between two parts, in seconds.
const LONGEST_PAUSE: f64 = 3600.0;

/// Shortest accepted time between two parts, in seconds.
const SHORTEST_PAUSE: f64 = 0.1;

/// Largest accepted speed, in mm/s.
const FASTEST: f64 = 10_000.0;

/// Length in mm of the vectors that define a direction.
const UNIT: f64 = 100.0;

/// A conveyor, and its belt as a thing.
pub(super) type Built = (Conveyor, Thing);

/// The cell's parts, to which feeds refer.
#[derive(Clone, Copy)]
pub(super) struct FedParts<'p> {
    pub(super) entries: &'p [PartEntry],
    pub(super) parts: &'p [Part],
}

/// Returns the names of the part entries that feeds add to the cell.
///
/// # Errors
///
/// A feed names an unknown part, a part that another feed adds, or a part with its own `in`, `at` or `step`.
pub(super) fn fed_parts(file: &CellFile) -> Result<Vec<&str>, CellError> {
    let mut names: Vec<&str> = Vec::new();
    let feeds = file.conveyors.iter().enumerate().filter_map(|(index, entry)| Some((index, entry.feed.as_ref()?)));
    for (index, FeedKeys { part, .. }) in feeds {
        let key = format!("conveyor[{index}].feed.part");
        let Some(entry) = file.parts.iter().find(|entry| entry.name == *part) else {
            let known: Vec<String> = file.parts.iter().map(|entry| format!("`{}`", entry.name)).collect();
            let help = if known.is_empty() { "add a `[[part]]`".to_owned() } else { known.join(", ") };
            return Err(CellError::new(key, format!("there is no part `{part}`"), help));
        };
        if names.contains(&part.as_str()) {
            let help = "add a second `[[part]]` with another name";
            return Err(CellError::new(key, format!("another feed adds the part `{part}`"), help));
        }
        if entry.carrier.is_some() || !entry.at.is_empty() || !entry.step.is_empty() {
            let message = format!("`{part}` has a place, and the feed gives it another one");
            let help = "remove `in`, `at` and `step` of the part, or add a second `[[part]]`";
            return Err(CellError::new(key, message, help));
        }
        names.push(part);
    }
    Ok(names)
}

impl CellMaker<'_> {
    /// Builds the conveyors, each with its belt.
    pub(super) fn conveyors(
        &mut self,
        entries: &[ConveyorEntry],
        parts: FedParts<'_>,
    ) -> Result<Vec<Built>, CellError> {
        let mut conveyors = Vec::new();
        for (index, entry) in entries.iter().enumerate() {
            match self.conveyor(entry, &format!("conveyor[{index}]"), parts)? {
                Some(built) => conveyors.push(built),
                None => self.missing.push(entry.name.clone()),
            }
        }
        Ok(conveyors)
    }

    /// Builds a conveyor; `None` if the application does not have the frame or one of the signals.
    fn conveyor(&mut self, entry: &ConveyorEntry, key: &str, parts: FedParts<'_>) -> Result<Option<Built>, CellError> {
        let ConveyorEntry { name, carrier, at, when, end, clearance, colour, .. } = entry;
        let belt = self.belt(entry, key)?;
        let (speed, direction) = direction(entry, key)?;
        let when = match when {
            None => Some(Vec::new()),
            Some(when) if when.io.is_empty() => {
                let help = "write `when = { io = { 'BasicIO-1\\%Q3' = true } }`, or remove it";
                return Err(CellError::new(format!("{key}.when"), "`when` names no signal", help));
            }
            Some(when) => self.compared(&when.io, &format!("{key}.when.io"))?,
        };
        let keys = CarriedKeys { carrier: carrier.as_deref().unwrap_or("world"), at, key };
        let (Some(when), Some(Carried { carrier, pose: place })) = (when, self.carriers.of(keys, self.surroundings)?)
        else {
            return Ok(None);
        };
        if carrier.is_arm() {
            let message = format!("the arm cannot carry the conveyor `{name}`");
            return Err(CellError::new(format!("{key}.in"), message, "name `world`, `base`, a frame, or an object"));
        }
        let feed = entry.feed.as_ref().map(|feed| self::feed(feed, key, &place, parts)).transpose()?;
        let track = belt.pose * direction;
        let clearance = clearance.map(|least| distance(least, &format!("{key}.clearance"))).transpose()?;
        let colour = colour.as_deref().map(|colour| check_colour(colour, key)).transpose()?;
        let bounds = belt.shape.bounds(&track.inv_mul(&belt.pose));
        let conveyor = Conveyor {
            name: name.clone(),
            when,
            speed,
            end: *end,
            feed,
            carrier: carrier.clone(),
            track: place * track,
            belt: bounds,
        };
        let thing = Thing { name: name.clone(), carrier, pose: place, solids: vec![belt], clearance, colour };
        Ok(Some((conveyor, thing)))
    }

    fn belt(&mut self, entry: &ConveyorEntry, key: &str) -> Result<Solid, CellError> {
        let keys = ShapeKeys { cuboid: entry.cuboid.clone(), ..ShapeKeys::default() };
        let mut maker = SolidMaker { surroundings: &mut *self.surroundings, is_carried: false };
        solid(&keys, &[], key, &mut maker)?.ok_or_else(|| {
            let help = "add the belt: `box = [2000, 400, 20]`";
            CellError::new(key, format!("`{}` has no box", entry.name), help)
        })
    }
}

/// Returns the speed in mm/s, and the rotation of the track, whose x axis is the transport direction.
fn direction(entry: &ConveyorEntry, key: &str) -> Result<(f64, IsometryMatrix3<f64>), CellError> {
    let key = format!("{key}.speed");
    let speed = Vector3::from(triple(&entry.speed, &key)?);
    let amount = speed.norm();
    if !(amount > 0.0 && amount <= FASTEST) {
        let help = format!("write the speed in mm/s, at most {FASTEST}: `speed = [250, 0, 0]`");
        return Err(CellError::new(key, format!("{amount} mm/s is no speed of a conveyor"), help));
    }
    let point = |vector: Vector3<f64>| Trsf::new(vector.into(), [0.0; 3]);
    let along = speed * (UNIT / amount);
    let frame = set_frame(&Trsf::default(), &point(along), &point(Vector3::z().cross(&along))).map_err(|_| {
        CellError::new(key, "a conveyor does not move its parts straight up or down", "write a speed along x or y")
    })?;
    Ok((amount, frame.isometry()))
}

/// Builds the feed of a conveyor that has this pose in its carrier.
fn feed(
    keys: &FeedKeys,
    key: &str,
    place: &IsometryMatrix3<f64>,
    FedParts { entries, parts }: FedParts<'_>,
) -> Result<Feed, CellError> {
    let FeedKeys { part, every, at } = keys;
    if !(SHORTEST_PAUSE..=LONGEST_PAUSE).contains(every) {
        let help = format!("write seconds from {SHORTEST_PAUSE} to {LONGEST_PAUSE}");
        return Err(CellError::new(format!("{key}.feed.every"), format!("{every} is no time between parts"), help));
    }
    let names: Vec<String> = entries.iter().filter(|entry| entry.name == *part).flat_map(super::parts::names).collect();
    let numbers = parts.iter().enumerate().filter(|(_, part)| names.contains(&part.name)).map(|(number, _)| number);
    Ok(Feed { parts: numbers.collect(), every: *every, pose: place * pose(at, &format!("{key}.feed.at"))? })
}
