//! Parts in scripts: entries that place and remove them.
//!
//! ```toml
//! place = { "carton[0]" = [150, 200, -40] }                                    # where the part is from now on, in its `in`
//! place = { "carton[1]" = { in = "fPallet", at = [0, 0, 75, 0, 0, 90] } }      # or in another frame
//! remove = ["carton[2]"]
//! ```

use val3_cell::DataKind;
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_lang::ports::Time;

use super::ScriptEntry;
use super::check::Misfit;
use super::part_values::{FramedPose, PartPose};
use crate::controller::Controller;

impl Controller {
    /// Names of an entry that are no parts or no frames.
    pub(super) fn part_faults(&self, entry: &ScriptEntry) -> Vec<Misfit> {
        let parts = entry.place.keys().chain(entry.remove.all()).filter_map(|name| self.part_misfit(name));
        let frames = entry.place.values().filter_map(|pose| match pose {
            PartPose::In(FramedPose { frame, .. }) => self.frame_misfit(frame),
            PartPose::Own(_) => None,
        });
        parts.chain(frames).collect()
    }

    /// Returns the problem if there is no part of this name.
    #[must_use]
    pub fn part_misfit(&self, name: &str) -> Option<Misfit> {
        if self.is_held(name).is_some() {
            return None;
        }
        let known = self.part_names();
        if known.is_empty() {
            return Some(format!("there is no part `{name}`: the application has no cell.toml with parts").into());
        }
        Some(Misfit { message: format!("there is no part `{name}`"), unknown: Some((name.to_owned(), known)) })
    }

    /// Returns the problem if there is no sensor of this name.
    #[must_use]
    pub fn sensor_misfit(&self, name: &str) -> Option<Misfit> {
        if self.is_seen(name).is_some() {
            return None;
        }
        let known = self.sensor_names();
        if known.is_empty() {
            return Some(format!("there is no sensor `{name}`: the application has no cell.toml with sensors").into());
        }
        Some(Misfit { message: format!("there is no sensor `{name}`"), unknown: Some((name.to_owned(), known)) })
    }

    /// Returns the problem if a name is neither `world`, nor `base`, nor a frame of the application.
    #[must_use]
    pub fn frame_misfit(&self, name: &str) -> Option<Misfit> {
        if matches!(name, "world" | "base") || self.carrier_kind(name) == Some(DataKind::Frame) {
            return None;
        }
        let mut known = vec!["world".to_owned(), "base".to_owned()];
        known.extend(self.carrier_names().into_iter().filter(|name| self.carrier_kind(name) == Some(DataKind::Frame)));
        Some(Misfit { message: format!("there is no frame `{name}`"), unknown: Some((name.to_owned(), known)) })
    }

    /// Pose in `world` of `world`, of `base`, or of a frame of the application; `None` without a place.
    #[must_use]
    pub fn named_frame(&self, name: &str) -> Option<IsometryMatrix3<f64>> {
        match name {
            "world" => Some(IsometryMatrix3::identity()),
            "base" => Some(Trsf::new([0.0, 0.0, -self.arm().model().height()], [0.0; 3]).isometry()),
            _ => self.frame_in_world(name),
        }
    }

    /// Places and removes the parts of an entry. Returns the problems.
    pub(super) fn apply_parts(&mut self, entry: &ScriptEntry, now: Time) -> Vec<String> {
        let mut problems = Vec::new();
        for (name, pose) in &entry.place {
            if let Some(misfit) = self.part_misfit(name) {
                problems.push(misfit.with_proposals());
                continue;
            }
            let (frame, pose) = match pose {
                PartPose::Own(numbers) => (self.own_frame(name), numbers.pose()),
                PartPose::In(FramedPose { frame, at }) => (self.named_frame(frame), at.pose()),
            };
            match frame {
                Some(frame) => self.place_part(name, Some(frame * pose), now),
                None => problems.push(format!("`{name}` cannot be placed: its frame has no place")),
            }
        }
        for name in entry.remove.all() {
            match self.part_misfit(name) {
                Some(misfit) => problems.push(misfit.with_proposals()),
                None => self.place_part(name, None, now),
            }
        }
        problems
    }
}
