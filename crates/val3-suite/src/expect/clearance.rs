//! Expectations about the distances of things around the arm:
//!
//! ```toml
//! [expect]
//! contact = true                   # something has to touch something else; else a contact is a failure
//! clearance = 20                   # nothing that moves is ever nearer to anything else, in mm
//!
//! [[expect.clearance]]             # in place of the number: the same for pairs
//! above = 50
//! of = ["gripper", "fence"]
//! ```

use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;
use val3_cell::{Minima, Minimum, Scene};
use val3_lang::suggest::{nearest, question};
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind, seconds};

use super::Expectations;
use super::filled::NOTHING;
use super::fit::ExpectationFault;
use super::occurrence::CycleState;
use crate::failure::{Failure, FailureLocation};
use crate::source::ExpectationSource;

/// Reason why distances cannot be compared.
const NO_CELL: &str = "there is nothing around the arm: the application has no cell.toml";

/// Greatest distance in mm that can be expected, because greater ones are not recorded.
const GREATEST: f64 = 500.0;

/// Smallest accepted distances.
#[derive(Debug, Clone, Deserialize)]
#[serde(
    untagged,
    expecting = "a clearance is a number of mm, or a list of `{ above = MM, of = [\"NAME\", \"NAME\"] }`"
)]
pub(super) enum Clearance {
    /// Of all pairs, in mm.
    All(f64),
    /// Of some pairs.
    Pairs(Vec<PairClearance>),
}

/// Smallest accepted distance of a pair.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PairClearance {
    /// Distance in mm.
    above: f64,
    /// Names of both things; without them, all pairs.
    of: Option<[String; 2]>,
}

impl Clearance {
    fn limits(&self) -> Vec<PairClearance> {
        match self {
            Self::All(above) => vec![PairClearance { above: *above, of: None }],
            Self::Pairs(pairs) => pairs.clone(),
        }
    }

    /// Reason why no run can meet the expectation.
    fn fault(&self, scene: &Scene) -> Option<String> {
        let limits = self.limits();
        if limits.is_empty() {
            return Some(NOTHING.to_owned());
        }
        if let Some(impossible) = limits.iter().find(|limit| !(0.0..=GREATEST).contains(&limit.above)) {
            return Some(format!("{} mm is no clearance: write 0 to {GREATEST} mm", impossible.above));
        }
        let is_of_all = limits.iter().any(|limit| limit.of.is_none());
        if is_of_all && !scene.has_link_shapes() {
            return Some(
                "the links of the arm have no [shapes], so their distances are unknown: name pairs".to_owned(),
            );
        }
        let missing = &scene.cell().missing;
        if let Some(name) = missing.first().filter(|_| is_of_all) {
            return Some(format!(
                "`{name}` is left out, because this application does not have its frame or tool: name pairs"
            ));
        }
        if is_of_all && !scene.compares_standing_things() {
            return Some(
                "the cell has nothing that the arm could come near to, apart from parts, whose distances are limited by \
                 name only: name pairs"
                    .to_owned(),
            );
        }
        if let Some([a, b]) = limits.iter().filter_map(|limit| limit.of.as_ref()).find(|pair| is_ignored(scene, pair)) {
            return Some(format!(
                "the distance of `{a}` and `{b}` is not compared: both stand, or belong to the arm, or may touch"
            ));
        }
        let mut names = limits.iter().filter_map(|limit| limit.of.as_ref()).flatten();
        let unknown = names.find(|name| !scene.has_body(name))?;
        let help = question(nearest(unknown, scene.body_names())).unwrap_or_else(|| {
            format!("it has {}", scene.body_names().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "))
        });
        Some(format!("the cell has nothing with the name `{unknown}`: {help}"))
    }
}

/// Whether both bodies exist, and their distance is not recorded.
fn is_ignored(scene: &Scene, pair: &[String; 2]) -> bool {
    pair.iter().all(|name| scene.has_body(name)) && !scene.compares(pair)
}

/// Expectations about distances that no run can meet.
pub(super) fn faults(
    contact: Option<&Spanned<bool>>,
    clearance: Option<&Spanned<Clearance>>,
    controller: &Controller,
) -> Vec<ExpectationFault> {
    let Some(watch) = &controller.devices.state.watch else {
        let expected = contact.filter(|contact| *contact.get_ref()).map(Spanned::span);
        let spans = expected.into_iter().chain(clearance.map(Spanned::span));
        return spans.map(|span| (span, NO_CELL.to_owned())).collect();
    };
    let fault = clearance.and_then(|clearance| Some((clearance.span(), clearance.get_ref().fault(watch.scene())?)));
    fault.into_iter().collect()
}

impl PairClearance {
    /// Whether it limits a distance. Parts touch what they stand on, so their distances are limited by name only.
    fn is_for(&self, Minimum { names, has_part, .. }: &Minimum) -> bool {
        match &self.of {
            None => !has_part,
            Some([a, b]) => names == &[a.clone(), b.clone()] || names == &[b.clone(), a.clone()],
        }
    }
}

/// Distances of a test during its execution.
#[derive(Default)]
pub(super) struct ClearanceState {
    /// The first contact of each pair.
    contacts: Vec<([String; 2], Failure)>,
    /// Smallest distances, if they are expected.
    minima: Option<Minima<()>>,
}

impl ClearanceState {
    pub(super) fn see(
        &mut self,
        CycleState { start, events, controller }: CycleState<'_>,
        expectations: &Expectations,
    ) {
        for (names, failure) in events.iter().filter_map(contact) {
            if self.contacts.iter().all(|(known, _)| *known != names) {
                self.contacts.push((names, failure));
            }
        }
        let Some(watch) = controller.devices.state.watch.as_ref().filter(|_| expectations.clearance.is_some()) else {
            return;
        };
        let minima = self.minima.get_or_insert_with(|| Minima::new(Arc::clone(watch.scene())));
        let sight = controller.sight(minima.scene(), seconds(start));
        minima.see(&sight, None);
    }

    /// Unexpected contacts, a missing contact, and distances below the limits.
    pub(super) fn failures(
        &self,
        Expectations { contact, clearance, .. }: &Expectations,
        controller: &Controller,
        source: &ExpectationSource,
    ) -> Vec<Failure> {
        let is_expected = contact.as_ref().is_some_and(|contact| *contact.get_ref());
        let missing = contact.as_ref().filter(|_| is_expected && self.contacts.is_empty()).map(|contact| {
            let message = "a contact was expected, and nothing has touched anything else".to_owned();
            Failure { message, places: vec![source.place("expect.contact", contact.span())] }
        });
        let unexpected = self.contacts.iter().filter(|_| !is_expected).map(|(_, failure)| failure.clone());
        let near = clearance.iter().flat_map(|clearance| {
            let place = source.place("expect.clearance", clearance.span());
            self.near(clearance.get_ref(), &place)
        });
        let unplaced = clearance.as_ref().zip(controller.unplaced_things()).map(|(clearance, message)| Failure {
            message,
            places: vec![source.place("expect.clearance", clearance.span())],
        });
        missing.into_iter().chain(unexpected).chain(near).chain(unplaced).collect()
    }

    fn near(&self, clearance: &Clearance, place: &FailureLocation) -> Vec<Failure> {
        let minima = self.minima.as_ref().map(Minima::of_pairs).unwrap_or_default();
        let near = clearance.limits().into_iter().filter_map(|limit| {
            let nearest = minima.iter().find(|minimum| limit.is_for(minimum))?;
            let is_near = nearest.measured.distance < limit.above;
            is_near.then(|| Failure { message: too_near(nearest, limit.above), places: vec![place.clone()] })
        });
        near.collect()
    }
}

fn too_near(Minimum { names: [a, b], measured, time, .. }: &Minimum, above: f64) -> String {
    let distance = measured.distance.max(0.0);
    format!("`{a}` is {distance:.1} mm from `{b}` at {time:.3} s; at least {above} mm were expected")
}

/// Names and failure of a contact.
fn contact(event: &Event) -> Option<([String; 2], Failure)> {
    let EventKind::Clearance { state: "contact", a, b, at, start, of, .. } = &event.kind else { return None };
    let when = if *start { " at the start".to_owned() } else { format!(" at {at:.3} s") };
    let places =
        of.iter().map(|of| FailureLocation { program: of.program.clone(), file: of.file.clone(), line: of.line });
    let failure = Failure { message: format!("`{a}` touches `{b}`{when}"), places: places.collect() };
    Some(([a.clone(), b.clone()], failure))
}
