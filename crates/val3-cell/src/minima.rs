//! Smallest distances of a run, by pair and by program line.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::measure::Measured;
use crate::observation::Observation;
use crate::pairs::Comparison;
use crate::scene::Scene;
use crate::step::Sight;
use crate::track::{EXACT, Track, Wanted};

/// Distance in mm above which nothing is recorded.
const FAR: f64 = 500.0;

/// Smallest distance of a pair, or for a key.
#[derive(Debug, Clone, PartialEq)]
pub struct Minimum {
    /// Names of both things.
    pub names: [String; 2],
    /// The smallest distance, with the nearest points.
    pub measured: Measured,
    /// Time in seconds.
    pub time: f64,
    /// Whether one of the things is a part. Parts touch their supports.
    pub has_part: bool,
}

/// Recorder of the smallest distances, by pair, and over all pairs by key. A key identifies a move, for example by the
/// program line that has requested it. Distances above 500 mm and between bodies that move with the arm are omitted.
#[derive(Debug, Clone)]
pub struct Minima<K> {
    observation: Observation,
    tracks: Vec<Track>,
    pairs: Vec<Option<Minimum>>,
    keys: BTreeMap<K, Minimum>,
}

impl<K: Ord + Clone> Minima<K> {
    /// Creates a recorder without distances. The first [`Self::see`] begins the recording.
    #[must_use]
    pub fn new(scene: Arc<Scene>) -> Self {
        let count = scene.pairs.len();
        Self {
            observation: Observation::new(scene),
            tracks: vec![Track::default(); count],
            pairs: vec![None; count],
            keys: BTreeMap::new(),
        }
    }

    /// Returns the scene, with the current arm model.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.observation.scene
    }

    /// Records the distances in a cycle in which the arm has moved for `key`.
    pub fn see(&mut self, sight: &Sight<'_>, key: Option<&K>) {
        if self.observation.adopt(sight) {
            self.tracks.fill(Track::default());
        }
        let (scene, step) = (&self.observation.scene, self.observation.step(sight));
        let pairs = scene.pairs.iter().zip(&mut self.tracks).zip(&mut self.pairs);
        for ((pair, track), least) in pairs {
            if step.comparison(pair) != Some(Comparison::Touching) {
                *track = Track::default();
                continue;
            }
            // A key's minimum ignores parts, because parts touch their supports.
            let key = key.filter(|_| !pair.has_part());
            let of_pair = least.as_ref().map_or(FAR, |least| least.measured.distance + pair.touch);
            let known = key.and_then(|key| self.keys.get(key));
            let of_key = if key.is_some() { known.map_or(FAR, |least| least.measured.distance) } else { of_pair };
            let threshold = of_pair.max(of_key);
            let Some(found) = track.follow(&step, pair, Wanted { threshold, margin: EXACT, limit: threshold }) else {
                continue;
            };
            let names = scene.names(pair);
            let (measured, time) = (found.measured.without(pair.touch), step.time(found.fraction));
            let minimum = Minimum { names, measured, time, has_part: pair.has_part() };
            if let Some(key) = key.filter(|_| found.measured.distance < of_key) {
                self.keys.insert(key.clone(), minimum.clone());
            }
            if found.measured.distance < of_pair {
                *least = Some(minimum);
            }
        }
        self.observation.record(sight);
    }

    /// Returns the smallest distances of all pairs that came within 500 mm, smallest first.
    #[must_use]
    pub fn of_pairs(&self) -> Vec<&Minimum> {
        let mut minima: Vec<&Minimum> = self.pairs.iter().flatten().collect();
        minima.sort_by(|a, b| a.measured.distance.total_cmp(&b.measured.distance));
        minima
    }

    /// Returns the smallest distance for a key, if it is within 500 mm.
    #[must_use]
    pub fn of(&self, key: &K) -> Option<&Minimum> {
        self.keys.get(key)
    }
}
