//! Reports when things come too near to each other.

use std::sync::Arc;

use val3_kinematics::Joints;

use crate::measure::Measured;
use crate::scene::Scene;
use crate::step::{Past, Sight, Step};
use crate::track::{EXACT, Found, Track, Wanted};

/// Distance in mm at which things with the clearance 0 touch.
const TOUCHING: f64 = 1e-9;

/// An encounter of two things.
#[derive(Debug, Clone, PartialEq)]
pub struct Encounter {
    /// What has happened.
    pub state: EncounterState,
    /// Names of both things.
    pub names: [String; 2],
    /// Their distance: the first below the clearance; at the end of the encounter its smallest.
    pub measured: Measured,
    /// Time of this distance, in seconds.
    pub time: f64,
    /// Joint position at this time, in degrees or mm.
    pub joints: Joints,
    /// Whether they were so near when the run began.
    pub at_start: bool,
}

/// State of an encounter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EncounterState {
    /// They are nearer than their clearance.
    Near,
    /// They touch.
    Contact,
    /// They are apart again, or the run has ended.
    Clear,
}

impl EncounterState {
    /// Word in records.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Near => "near",
            Self::Contact => "contact",
            Self::Clear => "clear",
        }
    }
}

/// Watches all pairs of a scene.
#[derive(Debug, Clone)]
pub struct Watch {
    scene: Arc<Scene>,
    past: Option<Past>,
    pairs: Vec<WatchedPair>,
}

#[derive(Debug, Clone, Default)]
struct WatchedPair {
    track: Track,
    /// The present encounter: its smallest distance.
    nearest: Option<Nearest>,
}

#[derive(Debug, Clone)]
struct Nearest {
    measured: Measured,
    time: f64,
    joints: Joints,
    at_start: bool,
    touches: bool,
}

impl Watch {
    /// Watches a scene from the first sight on.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        let pairs = vec![WatchedPair::default(); scene.pairs.len()];
        Self { scene: Arc::new(scene), past: None, pairs }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Looks at the end of a cycle. Returns the encounters that begin, become contacts or end.
    pub fn see(&mut self, sight: Sight<'_>) -> Vec<Encounter> {
        if !Arc::ptr_eq(&self.scene.arm, sight.arm) {
            // Other lengths of links: all bounds are void.
            self.scene = Arc::new(self.scene.with_arm(Arc::clone(sight.arm)));
            self.pairs.iter_mut().for_each(|pair| pair.track = Track::default());
        } else if self.past.as_ref().is_some_and(|past| past.is_same(&sight)) {
            self.past = Some(Past::of(sight));
            return Vec::new();
        }
        let at_start = self.past.is_none();
        if self.past.as_ref().is_some_and(|past| past.has_jumped(&sight)) {
            self.pairs.iter_mut().for_each(|pair| pair.track = Track::default());
        }
        let step = Step::new(&self.scene, self.past.as_ref(), &sight);
        let mut encounters = Vec::new();
        for (pair, watched) in self.scene.pairs.iter().zip(&mut self.pairs) {
            let least = pair.clearance.max(TOUCHING);
            let best = watched.nearest.as_ref().map(|nearest| nearest.measured.distance);
            let wanted = match best {
                None => Wanted { threshold: least, margin: 0.0, limit: least },
                Some(best) => Wanted { threshold: best, margin: EXACT, limit: least + EXACT },
            };
            let found = watched.track.follow(&step, pair, wanted);
            let names = || [pair.first, pair.second].map(|body| self.scene.name(body).to_owned());
            if let Some(Found { measured, fraction }) = found {
                let touches = measured.distance <= TOUCHING && !pair.is_arm;
                let before = watched.nearest.as_ref();
                let at_start = before.map_or(at_start, |nearest| nearest.at_start);
                let state = if touches { EncounterState::Contact } else { EncounterState::Near };
                let is_new = before.is_none_or(|nearest| touches && !nearest.touches);
                let touches = touches || before.is_some_and(|nearest| nearest.touches);
                let nearest =
                    Nearest { measured, time: step.time(fraction), joints: step.joints(fraction), at_start, touches };
                if is_new {
                    encounters.push(nearest.encounter(state, names()));
                }
                watched.nearest = Some(nearest);
            }
            if watched.track.at_least() > least + EXACT
                && let Some(nearest) = watched.nearest.take()
            {
                encounters.push(nearest.encounter(EncounterState::Clear, names()));
            }
        }
        self.past = Some(Past::of(sight));
        encounters
    }

    /// Ends all encounters, at the end of a run.
    pub fn finish(&mut self) -> Vec<Encounter> {
        let pairs = self.scene.pairs.iter().zip(&mut self.pairs);
        let ended = pairs.filter_map(|(pair, watched)| {
            let names = [pair.first, pair.second].map(|body| self.scene.name(body).to_owned());
            Some(watched.nearest.take()?.encounter(EncounterState::Clear, names))
        });
        ended.collect()
    }
}

impl Nearest {
    fn encounter(&self, state: EncounterState, names: [String; 2]) -> Encounter {
        let Self { measured, time, joints, at_start, .. } = self;
        Encounter { state, names, measured: *measured, time: *time, joints: *joints, at_start: *at_start }
    }
}

#[cfg(test)]
mod tests;
