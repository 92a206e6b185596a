//! Reports bodies that come too near to each other.

use std::sync::Arc;

use val3_kinematics::Joints;

use crate::measure::Measured;
use crate::observation::Observation;
use crate::pairs::{Comparison, Pair};
use crate::scene::Scene;
use crate::step::{Sight, Step};
use crate::track::{EXACT, Found, Track, Wanted};

/// Distance in mm up to which things touch.
pub const TOUCHING: f64 = 1e-9;

/// An encounter between two things.
#[derive(Debug, Clone, PartialEq)]
pub struct Encounter<T> {
    /// State.
    pub state: EncounterState,
    /// Names of both things.
    pub names: [String; 2],
    /// Distance with which the state begins; for [`EncounterState::Clear`], the smallest distance of the encounter.
    pub measured: Measured,
    /// Time at which the things have this distance, in seconds.
    pub time: f64,
    /// Joint position at this time, in degrees or mm.
    pub joints: Joints,
    /// Caller's label for the cycle with this distance, for example the move.
    pub label: T,
    /// Whether the things were already this near at the start of the run.
    pub at_start: bool,
}

/// Nearness of the things in an encounter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EncounterState {
    /// The distance is below the clearance.
    Near,
    /// The things touch.
    Contact,
    /// The things are apart again, or the run has ended.
    Clear,
}

impl EncounterState {
    /// Returns the state's name in event records.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Near => "near",
            Self::Contact => "contact",
            Self::Clear => "clear",
        }
    }
}

/// Watches all pairs of a scene. A label identifies the arm's activity in a cycle, for example the executed move.
#[derive(Debug, Clone)]
pub struct Watch<T> {
    observation: Observation,
    pairs: Vec<WatchedPair<T>>,
    /// For each body, whether it had no pose while the arm moved.
    unplaced: Vec<bool>,
}

#[derive(Debug, Clone)]
struct WatchedPair<T> {
    track: Track,
    /// Smallest distance of the current encounter; `None` if there is no encounter.
    nearest: Option<Nearest<T>>,
}

#[derive(Debug, Clone)]
struct Nearest<T> {
    /// Distance between the cores of the bodies.
    measured: Measured,
    /// Sum of the depths in mm by which the cores are smaller than the bodies.
    touch: f64,
    time: f64,
    joints: Joints,
    label: T,
    at_start: bool,
    touches: bool,
}

impl<T: Clone> Watch<T> {
    /// Creates a watch without encounters. The first [`Self::see`] begins the observation.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        let pairs = vec![WatchedPair { track: Track::default(), nearest: None }; scene.pairs.len()];
        let unplaced = vec![false; scene.bodies.len()];
        Self { observation: Observation::new(Arc::new(scene)), pairs, unplaced }
    }

    /// Returns the scene, with the current arm model.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.observation.scene
    }

    /// Returns the names of things that had no pose while the arm moved, because their frame or tool has no father or
    /// impossible values. The distances to these things were not measured.
    pub fn unplaced(&self) -> impl Iterator<Item = &str> {
        let bodies = self.scene().body_names().zip(&self.unplaced);
        bodies.filter(|(_, is_unplaced)| **is_unplaced).map(|(name, _)| name)
    }

    /// Evaluates the end of a cycle. Returns the encounters that begin, become contacts or end.
    pub fn see(&mut self, sight: &Sight<'_>, label: &T) -> Vec<Encounter<T>> {
        if self.observation.is_same(sight) {
            self.observation.record(sight);
            return Vec::new();
        }
        if self.observation.adopt(sight) {
            self.pairs.iter_mut().for_each(|pair| pair.track = Track::default());
        }
        let (scene, step) = (&self.observation.scene, self.observation.step(sight));
        for (number, unplaced) in self.unplaced.iter_mut().enumerate() {
            *unplaced |= step.is_motion() && !step.has_place(number);
        }
        let present = Present { step: &step, label, at_start: self.observation.is_new() };
        let pairs = scene.pairs.iter().zip(&mut self.pairs);
        let mut encounters = Vec::new();
        pairs.for_each(|(pair, watched)| watched.see(scene, pair, &present, &mut encounters));
        self.observation.record(sight);
        encounters
    }

    /// Ends all encounters at the end of a run.
    pub fn finish(&mut self) -> Vec<Encounter<T>> {
        let scene = &self.observation.scene;
        let pairs = scene.pairs.iter().zip(&mut self.pairs);
        pairs.filter_map(|(pair, watched)| watched.end(scene, pair)).collect()
    }
}

/// Inputs with which all pairs are evaluated in a cycle.
struct Present<'p, T> {
    step: &'p Step<'p>,
    label: &'p T,
    /// Whether this is the first cycle.
    at_start: bool,
}

impl<T: Clone> WatchedPair<T> {
    /// Evaluates a pair. Adds one encounter if it begins or becomes a contact, and one if it ends.
    fn see(&mut self, scene: &Scene, pair: &Pair, present: &Present<'_, T>, encounters: &mut Vec<Encounter<T>>) {
        let Some(comparison) = present.step.comparison(pair) else {
            self.track = Track::default();
            encounters.extend(self.end(scene, pair));
            return;
        };
        // Distances of parts are measured between their cores.
        let least = if pair.clearance > 0.0 { pair.clearance + pair.touch } else { TOUCHING };
        let wanted = match &self.nearest {
            None => Wanted { threshold: least, margin: 0.0, limit: least },
            Some(nearest) => Wanted { threshold: nearest.measured.distance, margin: EXACT, limit: least + EXACT },
        };
        let found = self.track.follow(present.step, pair, wanted);
        if let Some(found) = found
            && let Some(state) = self.approach(&found, pair, comparison, present)
        {
            encounters.extend(self.nearest.as_ref().map(|nearest| nearest.encounter(state, scene.names(pair))));
        }
        if self.track.at_least() > least + EXACT {
            encounters.extend(self.end(scene, pair));
        }
    }

    /// Ends the encounter, if there is one.
    fn end(&mut self, scene: &Scene, pair: &Pair) -> Option<Encounter<T>> {
        Some(self.nearest.take()?.encounter(EncounterState::Clear, scene.names(pair)))
    }

    /// Records a smaller distance. Returns the encounter's state if it has changed.
    fn approach(
        &mut self,
        found: &Found,
        pair: &Pair,
        comparison: Comparison,
        present: &Present<'_, T>,
    ) -> Option<EncounterState> {
        let Found { measured, fraction } = *found;
        let touches = measured.distance <= TOUCHING && comparison == Comparison::Touching;
        let before = self.nearest.as_ref();
        let has_touched = before.is_some_and(|nearest| nearest.touches);
        let is_new = before.is_none() || touches && !has_touched;
        let (time, joints) = (present.step.time(fraction), present.step.joints(fraction));
        let at_start = before.map_or(present.at_start, |nearest| nearest.at_start);
        let label = present.label.clone();
        let (touches_ever, touch) = (touches || has_touched, pair.touch);
        self.nearest = Some(Nearest { measured, touch, time, joints, label, at_start, touches: touches_ever });
        is_new.then_some(if touches { EncounterState::Contact } else { EncounterState::Near })
    }
}

impl<T: Clone> Nearest<T> {
    fn encounter(&self, state: EncounterState, names: [String; 2]) -> Encounter<T> {
        let Self { measured, time, joints, label, at_start, .. } = self;
        let measured = measured.without(self.touch);
        let (time, joints, label, at_start) = (*time, *joints, label.clone(), *at_start);
        Encounter { state, names, measured, time, joints, label, at_start }
    }
}

#[cfg(test)]
mod part_tests;
#[cfg(test)]
mod tests;
