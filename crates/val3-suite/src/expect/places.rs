//! Expectations about where parts of the cell are:
//!
//! ```toml
//! [expect]
//! placed = { "carton[0]" = { in = "fPallet", is = [200, 150, 90], within = 2 } }
//!
//! [[expect.at]]                    # at a time
//! t = 5
//! placed = { "carton[0]" = { is = [950, -600, -700] } }
//! ```

use std::collections::BTreeMap;
use std::ops::Range;

use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use toml::Spanned;
use val3_geometry::{IsometryMatrix3, Trsf, rotation};
use val3_machine::controller::Controller;
use val3_machine::event::shown_seconds;
use val3_machine::script::PoseNumbers;

use super::filled::NOTHING;
use super::fit::{ExpectationFault, Fit};
use crate::failure::Failure;
use crate::source::ExpectationSource;

/// Accepted distance in mm, and accepted angle in degrees, without `within`.
const WITHIN: f64 = 1.0;

/// Where parts are.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(transparent)]
pub(super) struct ExpectedPlaces(BTreeMap<Spanned<String>, ExpectedPlace>);

/// Where a part is.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct ExpectedPlace {
    /// The frame of the pose: `world`, `base`, or a frame of the application.
    #[serde(rename = "in", default = "world")]
    frame: String,
    /// The pose of the part; with three numbers, any orientation.
    is: PoseNumbers,
    /// Accepted distance in mm, and accepted angle in degrees.
    #[serde(default = "within")]
    within: f64,
}

fn world() -> String {
    "world".to_owned()
}

const fn within() -> f64 {
    WITHIN
}

/// Deserialises the places of at least one part.
pub(super) fn places<'de, D: Deserializer<'de>>(deserializer: D) -> Result<ExpectedPlaces, D::Error> {
    let places = ExpectedPlaces::deserialize(deserializer)?;
    if places.is_empty() { Err(D::Error::custom(NOTHING)) } else { Ok(places) }
}

impl ExpectedPlaces {
    /// Whether there are no parts.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Parts and frames that do not exist.
    pub(super) fn faults(&self, fit: &Fit<'_>) -> Vec<ExpectationFault> {
        let faults = self.0.iter().flat_map(|(name, ExpectedPlace { frame, within, .. })| {
            let misfits = [fit.controller.part_misfit(name.get_ref()), fit.controller.frame_misfit(frame)];
            let texts = misfits.into_iter().flatten().map(|misfit| misfit.with_proposals());
            let is_wrong = !(0.0..=1e6).contains(within);
            let distance = is_wrong.then(|| format!("{within} is no distance: write 0 or more mm in `within`"));
            let faults: Vec<(Range<usize>, String)> = texts.chain(distance).map(|text| (name.span(), text)).collect();
            faults
        });
        faults.collect()
    }

    /// Parts that are somewhere else.
    pub(super) fn failures(&self, key: &str, controller: &Controller, source: &ExpectationSource) -> Vec<Failure> {
        let now = shown_seconds(controller.now());
        let failures = self.0.iter().filter_map(|(name, place)| {
            let message = place.difference(name.get_ref(), controller)?;
            let places = vec![source.place(key, name.span())];
            Some(Failure { message: format!("{message}, at {now} s"), places })
        });
        failures.collect()
    }
}

impl ExpectedPlace {
    /// States where a part is in place of the expected place; `None` if it is there.
    fn difference(&self, part: &str, controller: &Controller) -> Option<String> {
        let Self { frame, is, within } = self;
        let Some(in_world) = controller.part_in_world(part) else {
            return Some(format!("`{part}` was removed, and is not in `{frame}`"));
        };
        let Some(frame_in_world) = controller.named_frame(frame) else {
            return Some(format!("the frame `{frame}` has no place, so `{part}` is not in it"));
        };
        let actual = frame_in_world.inv_mul(&in_world);
        let expected = is.pose();
        let distance = (actual.translation.vector - expected.translation.vector).norm();
        let turn = || rotation::angle_between(&actual.rotation, &expected.rotation).to_degrees();
        let angle = if is.has_orientation() { turn() } else { 0.0 };
        if distance <= *within && angle <= *within {
            return None;
        }
        let by = if distance > *within { format!("{distance:.1} mm") } else { format!("{angle:.1} degrees") };
        let actual = shown(&actual, is.has_orientation());
        let held = if controller.is_part_held(part) { ", held by a gripper" } else { "" };
        Some(format!("`{part}` is {by} from its place: at {actual} in `{frame}`{held}"))
    }
}

fn shown(pose: &IsometryMatrix3<f64>, has_orientation: bool) -> String {
    let Trsf { x, y, z, rx, ry, rz } = Trsf::from_parts(pose.translation.vector, &pose.rotation);
    let numbers = if has_orientation { vec![x, y, z, rx, ry, rz] } else { vec![x, y, z] };
    // Without a negative zero.
    let texts: Vec<String> =
        numbers.iter().map(|number| format!("{:.1}", (number * 10.0).round() / 10.0 + 0.0)).collect();
    format!("[{}]", texts.join(", "))
}
