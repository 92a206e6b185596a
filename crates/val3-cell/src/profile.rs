//! Smallest distance over all pairs in each cycle.

use std::sync::Arc;

use crate::measure::Reading;
use crate::observation::Observation;
use crate::pairs::Pair;
use crate::scene::Scene;
use crate::step::Sight;

/// Distance in mm above which the smallest distance is not reported.
const FAR: f64 = 500.0;

/// Distance in mm beyond the smallest distance up to which pairs are measured. The results then remain useful lower
/// bounds for some cycles.
const AHEAD: f64 = 50.0;

/// Smallest distance at the end of a cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct Proximity {
    /// Names of both things.
    pub names: [String; 2],
    /// Distance in mm; for an overlap the negative depth.
    pub distance: f64,
    /// Distance in mm below which these things are too near to each other.
    pub clearance: f64,
}

/// Computes the smallest distance in each cycle. Parts are ignored because they touch their supports. Pairs of bodies
/// that move with the arm are ignored as well.
#[derive(Debug, Clone)]
pub struct Profile {
    observation: Observation,
    /// Compared pairs: index in the scene, and lower bound of the distance in mm.
    bounds: Vec<(usize, f64)>,
}

impl Profile {
    /// Creates a profile without measured distances.
    #[must_use]
    pub fn new(scene: Arc<Scene>) -> Self {
        let pairs = scene.pairs.iter().enumerate().filter(|(_, pair)| !pair.is_arm() && !pair.has_part());
        let bounds = pairs.map(|(number, _)| (number, f64::NEG_INFINITY)).collect();
        Self { observation: Observation::new(scene), bounds }
    }

    /// Returns the scene, with the current arm model.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.observation.scene
    }

    /// Returns the smallest distance at the end of a cycle; `None` above 500 mm.
    pub fn see(&mut self, sight: &Sight<'_>) -> Option<Proximity> {
        let is_stale = self.observation.adopt(sight);
        let (scene, step) = (&self.observation.scene, self.observation.step(sight));
        let pair = |number: usize| scene.pairs.get(number);
        for (number, bound) in &mut self.bounds {
            let travel = pair(*number).and_then(|pair| step.travel(pair)).filter(|_| !is_stale);
            *bound -= travel.unwrap_or(f64::INFINITY);
        }
        self.bounds.sort_by(|(_, one), (_, other)| one.total_cmp(other));
        let mut nearest: Option<(&Pair, f64)> = None;
        for (number, bound) in &mut self.bounds {
            let least = nearest.map_or(FAR, |(_, distance)| distance);
            let Some(pair) = pair(*number).filter(|_| *bound < least) else { break };
            let reading = step.measure(pair, 1.0, least.max(0.0) + AHEAD);
            *bound = reading.at_least();
            if let Reading::Measured(measured) = reading
                && measured.distance < least
            {
                nearest = Some((pair, measured.distance));
            }
        }
        let proximity =
            nearest.map(|(pair, distance)| Proximity { names: scene.names(pair), distance, clearance: pair.clearance });
        self.observation.record(sight);
        proximity
    }
}

#[cfg(test)]
mod tests {
    use val3_kinematics::Joints;

    use super::*;
    use crate::step::Step;
    use crate::testing::{arm, scene, sight};

    const CELL: &str = "clearance = 30\n[[object]]\nname = \"post\"\nbox = [40, 40, 2000]\nat = [0, 700, 0]\n\
        [[object]]\nname = \"far\"\nsphere = { radius = 10 }\nat = [0, 0, 5000]\n\
        [[object]]\nname = \"rod\"\nin = \"flange\"\ncapsule = { from = [0, 0, 0], to = [0, 0, 100], radius = 5 }";

    #[test]
    fn the_smallest_distance_is_that_of_all_pairs() {
        let arm = arm("tx2-60l");
        let scene = Arc::new(scene(CELL, &arm));
        let mut profile = Profile::new(Arc::clone(&scene));
        for cycle in 0..400 {
            let turned = f64::from(cycle) * 0.45;
            let joints: Joints = [turned, 90.0 - turned / 4.0, 0.0, turned, 0.0, 0.0];
            let sight = sight(&arm, joints, f64::from(cycle) * 0.004);
            let step = Step::new(&scene, None, &sight);
            let pairs = scene.pairs.iter().filter(|pair| !pair.is_arm());
            let expected = pairs.map(|pair| step.measure(pair, 1.0, 1e4).at_least()).fold(f64::INFINITY, f64::min);
            match profile.see(&sight) {
                Some(found) => assert!((found.distance - expected).abs() < 1e-3, "{found:?} for {expected}"),
                None => assert!(expected >= FAR, "{expected}"),
            }
        }
    }

    #[test]
    fn far_things_have_no_smallest_distance() {
        let arm = arm("tx2-60l");
        let text = "[[object]]\nname = \"far\"\nsphere = { radius = 10 }\nat = [0, 0, 5000]";
        let mut profile = Profile::new(Arc::new(scene(text, &arm)));
        assert_eq!(profile.see(&sight(&arm, [0.0; 6], 0.0)), None);
    }
}
