//! Contacts at joint positions and on planned paths, for checks of programs.
//!
//! Parts are ignored because their poses depend on the run. Links are not compared with each other or with bodies on
//! the arm, because link shapes are larger than the links.

use std::sync::Arc;

use val3_geometry::IsometryMatrix3;
use val3_kinematics::Joints;

use crate::measure::Reading;
use crate::pairs::{Comparison, Pair};
use crate::scene::Scene;
use crate::step::{Past, Sight, Step};
use crate::track::{Track, Wanted};
use crate::watch::TOUCHING;

/// Finds contacts between moving bodies (the links and carried objects) and stationary objects.
#[derive(Debug, Clone)]
pub struct Contacts {
    scene: Arc<Scene>,
    /// Poses of the frames in `world` and of the tools in `flange`, in the order of [`Scene::data`].
    places: Vec<Option<IsometryMatrix3<f64>>>,
    pairs: Vec<Pair>,
}

/// A contact between a moving body and a stationary object.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Names of both bodies, the moving one first.
    pub names: [String; 2],
    /// Depth of the overlap in mm; `None` if unknown, as for surfaces and between two positions of a path.
    pub depth: Option<f64>,
    /// Joint position of the contact, in degrees or mm.
    pub joints: Joints,
}

impl Contacts {
    /// Prepares the comparison of a scene's bodies. `places` are the poses of the frames in `world` and of the tools in
    /// `flange`, in the order of [`Scene::data`]. Bodies whose frame or tool has no pose are ignored.
    #[must_use]
    pub fn new(scene: Arc<Scene>, places: Vec<Option<IsometryMatrix3<f64>>>) -> Self {
        let pairs = scene.pairs.iter().filter(|pair| pair.comparison == Some(Comparison::Touching)).copied().collect();
        Self { scene, places, pairs }
    }

    /// Returns the contacts at a joint position.
    #[must_use]
    pub fn at(&self, joints: &Joints) -> Vec<Contact> {
        let sight = self.sight(*joints);
        let step = Step::new(&self.scene, None, &sight);
        let contacts = self.pairs.iter().filter_map(|pair| {
            let Reading::Measured(measured) = step.measure(pair, 1.0, TOUCHING) else { return None };
            (measured.distance <= TOUCHING).then(|| self.contact(pair, measured.distance, *joints))
        });
        contacts.collect()
    }

    /// Returns the first contacts of all pairs on a path, in path order. The joints move linearly between two
    /// positions, and contacts between the positions are found as well.
    #[must_use]
    pub fn along(&self, path: &[Joints]) -> Vec<Contact> {
        let mut open: Vec<(&Pair, Track)> = self.pairs.iter().map(|pair| (pair, Track::default())).collect();
        let mut contacts = Vec::new();
        let mut past: Option<Past> = None;
        for joints in path {
            let sight = self.sight(*joints);
            let step = Step::new(&self.scene, past.as_ref(), &sight);
            let wanted = Wanted { threshold: TOUCHING, margin: 0.0, limit: TOUCHING };
            let mut found: Vec<(f64, Contact)> = Vec::new();
            open.retain_mut(|(pair, track)| match track.follow(&step, pair, wanted) {
                None => true,
                Some(contact) => {
                    let at = step.joints(contact.fraction);
                    found.push((contact.fraction, self.contact(pair, contact.measured.distance, at)));
                    false
                }
            });
            found.sort_by(|(one, _), (other, _)| one.total_cmp(other));
            contacts.extend(found.into_iter().map(|(_, contact)| contact));
            past = Some(Past::of(&sight));
        }
        contacts
    }

    fn sight(&self, joints: Joints) -> Sight<'_> {
        let places = self.places.clone();
        Sight { arm: &self.scene.arm, joints, placement: 0, places, parts: Arc::default(), time: 0.0 }
    }

    fn contact(&self, pair: &Pair, distance: f64, joints: Joints) -> Contact {
        Contact { names: self.scene.names(pair), depth: (distance < 0.0).then_some(-distance), joints }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{arm, scene, sight};
    use crate::watch::{EncounterState, Watch};

    /// A thin wall next to the arm, a post that may be touched, and a rod at the flange.
    const CELL: &str = "allow = [[\"rod\", \"post\"]]\n[[object]]\nname = \"wall\"\nbox = [2000, 1, 2000]\nat = [0, 500, 0]\n\
        [[object]]\nname = \"post\"\nbox = [100, 100, 2000]\nat = [500, 0, 0]\n\
        [[object]]\nname = \"elsewhere\"\nbox = [5000, 5000, 5000]\nin = \"fTable\"\n\
        [[object]]\nname = \"rod\"\nin = \"flange\"\ncapsule = { from = [0, 0, 0], to = [0, 0, 200], radius = 5 }";

    fn contacts() -> Contacts {
        let scene = scene(CELL, &arm("tx2-60l"));
        let places = vec![None; scene.data().count()];
        Contacts::new(Arc::new(scene), places)
    }

    fn names(contacts: &[Contact]) -> Vec<[&str; 2]> {
        contacts.iter().map(|contact| [contact.names[0].as_str(), contact.names[1].as_str()]).collect()
    }

    #[test]
    fn a_position_touches_what_overlaps_and_is_not_allowed() {
        let contacts = contacts();
        assert_eq!(names(&contacts.at(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0])), [] as [[&str; 2]; 0]);
        let stretched = contacts.at(&[0.0, 90.0, 0.0, 0.0, 0.0, 0.0]);
        assert!(names(&stretched).contains(&["link4", "post"]) && !names(&stretched).contains(&["rod", "post"]));
        assert!(stretched[0].depth.is_some_and(|depth| depth > 1.0), "{stretched:?}");
    }

    #[test]
    fn a_wall_between_two_positions_of_a_path_is_found() {
        let contacts = contacts();
        let path = [[60.0, 90.0, 0.0, 0.0, 0.0, 0.0], [140.0, 90.0, 0.0, 0.0, 0.0, 0.0]];
        assert!(contacts.at(&path[0]).is_empty() == contacts.at(&path[1]).is_empty());
        let folded = [[20.0, 90.0, 0.0, 0.0, 0.0, 0.0], [160.0, 90.0, 0.0, 0.0, 0.0, 0.0]];
        assert!(contacts.at(&folded[1]).is_empty(), "{:?}", contacts.at(&folded[1]));
        let found = contacts.along(&folded);
        let rod = found.iter().find(|contact| contact.names == ["rod", "wall"]).unwrap();
        assert!((20.0..160.0).contains(&rod.joints[0]), "{rod:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// A path check finds the same contacts as a run along the path.
        #[test]
        fn contacts_on_a_path_are_contacts_of_a_run(
            path in prop::collection::vec(prop::array::uniform6(-90.0..90.0f64), 1..6),
        ) {
            let (arm, contacts) = (arm("tx2-60l"), contacts());
            let mut watch = Watch::new(scene(CELL, &arm));
            let mut reported: Vec<[String; 2]> = Vec::new();
            for (cycle, joints) in (0u32..).zip(&path) {
                let mut sight = sight(&arm, *joints, f64::from(cycle) * 0.004);
                sight.places = vec![None; contacts.places.len()];
                let encounters = watch.see(&sight, &()).into_iter();
                reported.extend(
                    encounters.filter(|found| found.state == EncounterState::Contact).map(|found| found.names),
                );
            }
            let mut found: Vec<[String; 2]> = contacts.along(&path).into_iter().map(|contact| contact.names).collect();
            reported.sort();
            reported.dedup();
            found.sort();
            prop_assert_eq!(&found, &reported);
            for joints in &path {
                prop_assert!(contacts.at(joints).iter().all(|contact| found.contains(&contact.names)));
            }
        }
    }
}
