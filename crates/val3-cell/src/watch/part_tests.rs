//! Encounters of held and of stationary parts.

use proptest::prelude::*;
use val3_geometry::{IsometryMatrix3, Trsf};

use super::tests::line;
use super::*;
use crate::part::{PartHolder, PartPlace};
use crate::testing::{arm, scene, sight};

/// The arm is stretched to the front: its flange is at (920, 20, 0), with z along the axis x of `world`.
const STRETCHED: Joints = [0.0, 90.0, 0.0, 0.0, 0.0, 0.0];

const GRIPPER: &str = "[[object]]\nname = \"cup\"\nin = \"flange\"\ncapsule = { from = [0, 0, 0], to = [0, 0, 80], radius = 20 }\n\
    [[gripper]]\nwhen = { io = { valve = true } }\n[[part]]\nname = \"carton\"\nbox = [100, 100, 100]\n";

fn at(x: f64, y: f64, z: f64) -> IsometryMatrix3<f64> {
    Trsf::new([x, y, z], [0.0; 3]).isometry()
}

/// Encounters while the arm moves through joint positions and the part has this place.
fn encounters(text: &str, path: &[Joints], place: PartPlace) -> Vec<Encounter<()>> {
    let arm = arm("tx2-60l");
    let mut watch = Watch::new(scene(&format!("{GRIPPER}{text}"), &arm));
    let parts = Arc::new(vec![place]);
    let see = |(cycle, joints): (usize, &Joints)| {
        let sight = Sight { parts: Arc::clone(&parts), ..sight(&arm, *joints, cycle as f64 * 0.004) };
        watch.see(&sight, &())
    };
    path.iter().enumerate().flat_map(see).collect()
}

fn words(encounters: &[Encounter<()>]) -> Vec<String> {
    let word = |one: &Encounter<()>| {
        format!("{} {} {} {:.1}", one.state.word(), one.names[0], one.names[1], one.measured.distance)
    };
    encounters.iter().map(word).collect()
}

/// Place of a held part with a gap of 150 mm to the flange.
fn held() -> PartPlace {
    PartPlace { holder: PartHolder::Gripper(0), pose: at(0.0, 0.0, 200.0) }
}

#[test]
fn a_held_part_touches_what_stands() {
    let post = "[[object]]\nname = \"post\"\nbox = [40, 40, 400]\nat = [1100, 120, 0]";
    let found = encounters(post, &line(STRETCHED, [10.0, 90.0, 0.0, 0.0, 0.0, 0.0], 50), held());
    assert_eq!(found[0].names, ["carton", "post"].map(str::to_owned), "{:?}", words(&found));
    assert_eq!(found[0].state, EncounterState::Contact);
    assert!(found[0].time > 0.0, "not at the start");
}

#[test]
fn a_thin_wall_between_two_cycles_touches_a_held_part() {
    let wall = "[[object]]\nname = \"wall\"\nbox = [200, 0.1, 200]\nat = [1250, 0, 0]";
    let path = [[-50.0, 90.0, 0.0, 0.0, 0.0, 0.0], [50.0, 90.0, 0.0, 0.0, 0.0, 0.0]];
    let long = PartPlace { pose: at(0.0, 0.0, 300.0), ..held() };
    let found = encounters(wall, &path, long);
    assert!(found.iter().any(|one| one.names == ["carton", "wall"].map(str::to_owned)), "{:?}", words(&found));
}

#[test]
fn a_part_that_rests_on_something_is_no_contact() {
    // The table is 0.5 mm, then 2.5 mm higher than the bottom of the part.
    let table =
        |top: f64| format!("[[object]]\nname = \"table\"\nbox = [400, 400, 20]\nat = [1120, 0, {}]", top - 10.0);
    let path = [STRETCHED, [0.001, 90.0, 0.0, 0.0, 0.0, 0.0]];
    assert_eq!(words(&encounters(&table(-49.5), &path, held())), Vec::<String>::new());
    assert_eq!(words(&encounters(&table(-47.5), &path, held())), ["contact carton table -2.5"]);
    // An object's own clearance also applies to parts.
    let own = format!("{}\nclearance = 40", table(-80.0));
    assert_eq!(words(&encounters(&own, &path, held())), ["near link4 table 36.5", "near carton table 30.0"]);
}

#[test]
fn a_standing_part_touches_the_arm_but_not_its_gripper() {
    let path = line(STRETCHED, [20.0, 90.0, 0.0, 0.0, 0.0, 0.0], 50);
    let standing = |x: f64, y: f64| PartPlace { holder: PartHolder::World, pose: at(x, y, 0.0) };
    let found = encounters("", &path, standing(980.0, 140.0));
    assert!(found.iter().all(|one| one.names[0].starts_with("link")), "{:?}", words(&found));
    let found = encounters("", &path, standing(600.0, 200.0));
    assert!(words(&found)[0].starts_with("contact link4 carton"), "{:?}", words(&found));
    let gone = PartPlace { holder: PartHolder::Gone, ..standing(600.0, 200.0) };
    assert_eq!(words(&encounters("", &path, gone)), Vec::<String>::new());
}

#[test]
fn a_part_on_a_standing_thing_is_not_compared_with_it() {
    let table = "[[object]]\nname = \"table\"\nbox = [400, 400, 20]\nat = [0, -900, 0]";
    let path = line(STRETCHED, [20.0, 90.0, 0.0, 0.0, 0.0, 0.0], 10);
    let inside = PartPlace { holder: PartHolder::World, pose: at(0.0, -900.0, 0.0) };
    assert_eq!(words(&encounters(table, &path, inside)), Vec::<String>::new());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// A held part has the same encounters as an object on the flange with the part's core as its shape.
    #[test]
    fn a_held_part_is_as_a_carried_object(turn in 5.0..60.0f64, x in 950.0..1250.0f64, z in -80.0..80.0f64) {
        let post = format!("[[object]]\nname = \"post\"\nbox = [40, 40, 60]\nat = [{x}, 200, {z}]\n");
        let path = line(STRETCHED, [turn, 90.0, 0.0, 0.0, 0.0, 0.0], 40);
        let of_part = encounters(&post, &path, held());
        let object = "[[object]]\nname = \"carton\"\nin = \"flange\"\nbox = [98, 98, 98]\nat = [0, 0, 200]\n";
        let arm = arm("tx2-60l");
        let mut watch = Watch::new(scene(&format!("{object}{post}"), &arm));
        let see = |(cycle, joints): (usize, &Joints)| watch.see(&sight(&arm, *joints, cycle as f64 * 0.004), &());
        let of_object: Vec<_> = path.iter().enumerate().flat_map(see).collect();
        let events = |found: &[Encounter<()>], touch: f64| {
            let of_carton = found.iter().filter(|one| one.names.contains(&"carton".to_owned()));
            let event = |one: &Encounter<()>| (one.state, (one.time * 1e6).round(), ((one.measured.distance + touch) * 1e3).round());
            of_carton.map(event).collect::<Vec<_>>()
        };
        prop_assert_eq!(events(&of_part, 1.0), events(&of_object, 0.0));
    }
}
