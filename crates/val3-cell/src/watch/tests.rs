use proptest::prelude::*;
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::Arm;

use super::*;
use crate::step::Past;
use crate::testing::{arm, build, scene, sight};

/// Duration of a cycle, in seconds.
const CYCLE: f64 = 0.004;

/// Encounters while the arm moves through joint positions, one position each cycle.
fn encounters(text: &str, arm: &Arc<Arm>, path: &[Joints]) -> Vec<Encounter<()>> {
    let mut watch = Watch::new(scene(text, arm));
    see_all(&mut watch, arm, path, 0)
}

fn see_all(watch: &mut Watch<()>, arm: &Arc<Arm>, path: &[Joints], start: usize) -> Vec<Encounter<()>> {
    let times = (start..).map(|cycle| cycle as f64 * CYCLE);
    path.iter().zip(times).flat_map(|(joints, time)| watch.see(&sight(arm, *joints, time), &())).collect()
}

/// A path on which all axes move linearly.
pub(super) fn line(from: Joints, to: Joints, cycles: usize) -> Vec<Joints> {
    let at =
        |cycle: usize| std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * cycle as f64 / cycles as f64);
    (0..=cycles).map(at).collect()
}

fn words(encounters: &[Encounter<()>]) -> Vec<String> {
    let word = |one: &Encounter<()>| {
        format!("{} {} {} {:.1}", one.state.word(), one.names[0], one.names[1], one.measured.distance)
    };
    encounters.iter().map(word).collect()
}

/// The arm is stretched to the front, and its forearm turns around axis 1 into a post.
const STRETCHED: Joints = [0.0, 90.0, 0.0, 0.0, 0.0, 0.0];

#[test]
fn an_encounter_begins_touches_and_ends() {
    let arm = arm("tx2-60l");
    let post = "clearance = 50\n[[object]]\nname = \"post\"\nbox = [40, 40, 2000]\nat = [0, 700, 0]";
    let path = line(STRETCHED, [180.0, 90.0, 0.0, 0.0, 0.0, 0.0], 250);
    let found = encounters(post, &arm, &path);
    let of_link4: Vec<Encounter<()>> = found.into_iter().filter(|one| one.names[0] == "link4").collect();
    let states: Vec<EncounterState> = of_link4.iter().map(|one| one.state).collect();
    assert_eq!(states, [EncounterState::Near, EncounterState::Contact, EncounterState::Clear]);
    assert!(of_link4[0].measured.distance < 50.0 && of_link4[0].measured.distance > 40.0, "{of_link4:?}");
    assert!(of_link4[2].measured.distance < -10.0, "the depth of the overlap: {of_link4:?}");
    assert!(of_link4[0].time < of_link4[1].time && of_link4[1].time < of_link4[2].time);
}

#[test]
fn a_thin_wall_between_two_cycles_is_found() {
    let arm = arm("tx2-60l");
    // In a cycle at ten times the greatest speed, the flange passes from one side of the wall to the other.
    let wall = "[[object]]\nname = \"wall\"\nbox = [400, 0.1, 400]\nat = [1050, 0, 0]\n\
                [[object]]\nname = \"rod\"\nin = \"flange\"\ncapsule = { from = [0, 0, 0], to = [0, 0, 100], radius = 5 }";
    let path = [[-50.0, 90.0, 0.0, 0.0, 0.0, 0.0], [50.0, 90.0, 0.0, 0.0, 0.0, 0.0]];
    let found = encounters(wall, &arm, &path);
    let rod: Vec<&Encounter<()>> = found.iter().filter(|one| one.names[1] == "rod" || one.names[0] == "rod").collect();
    assert!(rod.iter().any(|one| one.state == EncounterState::Contact), "{:?}", words(&found));
    assert!(rod[0].time > 0.0 && rod[0].time < CYCLE, "between the cycles: {}", rod[0].time);
}

#[test]
fn an_overlap_at_the_start_is_reported_once() {
    let arm = arm("tx2-60l");
    let sleeve = "[[object]]\nname = \"sleeve\"\nbox = [3000, 100, 100]";
    let path = line(STRETCHED, [1.0, 90.0, 0.0, 0.0, 0.0, 0.0], 10);
    let found = encounters(sleeve, &arm, &path);
    let of_link4 = |one: &&Encounter<()>| one.names[0] == "link4";
    assert_eq!(found.iter().filter(of_link4).count(), 1, "{:?}", words(&found));
    assert!(found.iter().all(|one| one.at_start));
    let allowed = format!("allow = [[\"sleeve\", \"arm\", \"it is a sleeve\"]]\n{sleeve}");
    assert_eq!(encounters(&allowed, &arm, &path), []);
}

#[test]
fn the_end_of_a_run_ends_encounters() {
    let arm = arm("tx2-60l");
    let mut watch = Watch::new(scene("[[object]]\nname = \"bar\"\nin = \"world\"\nbox = [3000, 100, 100]", &arm));
    let begun = watch.see(&sight(&arm, STRETCHED, 0.0), &()).len();
    assert!(begun > 0);
    assert_eq!(watch.finish().len(), begun);
    assert_eq!(watch.finish(), []);
}

#[test]
fn a_frame_that_moves_carries_its_things() {
    let arm = arm("tx2-60l");
    let mut watch = Watch::new(scene("[[object]]\nname = \"cup\"\nin = \"fPart\"\nsphere = { radius = 20 }", &arm));
    let place = |x: f64| Some(Trsf::new([x, 0.0, 0.0], [0.0; 3]).isometry());
    let at = |place: Option<IsometryMatrix3<f64>>, time| Sight { places: vec![place], ..sight(&arm, STRETCHED, time) };
    assert_eq!(watch.see(&at(place(2000.0), 0.0), &()), []);
    assert_eq!(words(&watch.see(&at(place(850.0), 0.004), &()))[0].split(' ').next(), Some("contact"));
    assert!(watch.see(&at(None, 0.008), &()).iter().all(|one| one.state == EncounterState::Clear));
    let nowhere = Some(Trsf::new([f64::NAN, 0.0, 1e300], [0.0; 3]).isometry());
    assert_eq!(watch.see(&at(nowhere, 0.012), &()), []);
}

#[test]
fn a_thing_without_a_place_is_known() {
    let arm = arm("tx2-60l");
    let mut watch = Watch::new(scene("[[object]]\nname = \"cup\"\nin = \"fPart\"\nsphere = { radius = 20 }", &arm));
    let mut see = |joints: Joints, place: Option<IsometryMatrix3<f64>>, time| {
        watch.see(&Sight { places: vec![place], ..sight(&arm, joints, time) }, &());
        watch.unplaced().map(str::to_owned).collect::<Vec<_>>()
    };
    let place = Some(Trsf::new([2000.0, 0.0, 0.0], [0.0; 3]).isometry());
    // The pose is missing while the arm rests, and exists while it moves.
    assert_eq!(see([0.0; 6], None, 0.0), [""; 0]);
    assert_eq!(see([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], place, 0.004), [""; 0]);
    assert_eq!(see([2.0, 0.0, 0.0, 0.0, 0.0, 0.0], None, 0.008), ["cup"]);
}

#[test]
fn distances_of_standing_things_and_of_parts_of_the_arm_are_not_recorded() {
    let scene = scene(CELL, &arm("tx2-60l"));
    let compares = |a: &str, b: &str| scene.compares(&[a.to_owned(), b.to_owned()]);
    assert!(compares("gripper", "table") && compares("table", "gripper") && compares("link2", "post"));
    assert!(!compares("table", "post") && !compares("link1", "link5") && !compares("base", "table"));
}

#[test]
fn an_arm_that_is_placed_elsewhere_touches_nothing_on_the_way() {
    let arm = arm("tx2-60l");
    let wall = "[[object]]\nname = \"wall\"\nbox = [0.1, 400, 400]\nat = [850, 0, 0]";
    let mut watch = Watch::new(scene(wall, &arm));
    let placed = |angle, placement, time| Sight { placement, ..sight(&arm, [angle, 90.0, 0.0, 0.0, 0.0, 0.0], time) };
    assert_eq!(watch.see(&placed(-40.0, 0, 0.0), &()), []);
    assert_eq!(watch.see(&placed(40.0, 1, 0.004), &()), []);
}

#[test]
fn parts_of_the_arm_come_near_each_other() {
    let arm = arm("tx2-60l");
    let path = line([0.0; 6], [0.0, 120.0, 140.0, 0.0, 0.0, 0.0], 500);
    let found = encounters("", &arm, &path);
    assert!(
        found.iter().all(|one| one.state != EncounterState::Contact),
        "capsules prove no contact: {:?}",
        words(&found)
    );
    assert!(found.iter().any(|one| one.state == EncounterState::Near), "{:?}", words(&found));
}

/// Objects around the arm.
const CELL: &str = "[[object]]\nname = \"table\"\nbox = [900, 900, 50]\nat = [500, 0, -300]\n\
    [[object]]\nname = \"post\"\ncylinder = { radius = 60, length = 1200 }\nat = [300, 500, 200]\n\
    [[object]]\nname = \"gripper\"\nin = \"flange\"\nbox = [60, 140, 120]\nat = [0, 0, 60]\n\
    [[object]]\nname = \"ball\"\nsphere = { radius = 80 }\nat = [-400, -300, 500]";

fn joints() -> impl Strategy<Value = Joints> {
    let limits = Arm::by_name("tx2-60l").unwrap().limits().to_vec();
    let axes: Vec<_> = limits.iter().map(|limits| limits.min..limits.max).collect();
    axes.prop_map(|axes| std::array::from_fn(|axis| axes[axis]))
}

/// Random positions, and lines between them at about the nominal speed.
fn path() -> impl Strategy<Value = Vec<Joints>> {
    prop::collection::vec(joints(), 2)
        .prop_map(|corners| corners.windows(2).flat_map(|ends| line(ends[0], ends[1], 100)).collect())
}

/// Returns the smallest distances of all pairs on a path, measured at four positions in each cycle.
fn sampled(text: &str, arm: &Arc<Arm>, path: &[Joints]) -> Vec<f64> {
    let scene = scene(text, arm);
    let least = |pair: &Pair| {
        let distances = path.windows(2).flat_map(|ends| line(ends[0], ends[1], 4)).map(|joints| {
            let sight = sight(arm, joints, 0.0);
            Step::new(&scene, None, &sight).measure(pair, 1.0, 1e4).at_least()
        });
        distances.fold(f64::INFINITY, f64::min)
    };
    scene.pairs.iter().map(least).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, ..ProptestConfig::default() })]

    #[test]
    fn every_encounter_of_dense_sampling_is_found(path in path(), clearance in 0.0..80.0) {
        let arm = arm("tx2-60l");
        let text = format!("clearance = {clearance}\n{CELL}");
        let mut watch = Watch::new(scene(&text, &arm));
        let mut found = see_all(&mut watch, &arm, &path, 0);
        found.extend(watch.finish());
        let scene = Arc::clone(watch.scene());
        for (pair, least) in scene.pairs.iter().zip(sampled(&text, &arm, &path)) {
            let names = scene.names(pair);
            let ends = found.iter().filter(|one| one.state == EncounterState::Clear && one.names == names);
            let nearest = ends.map(|one| one.measured.distance).fold(f64::INFINITY, f64::min);
            prop_assert!(least >= pair.clearance || nearest <= least.max(0.0) + EXACT, "{names:?}: {nearest} for {least}");
            prop_assert!(nearest == f64::INFINITY || nearest < pair.clearance.max(TOUCHING), "{names:?}: {nearest}");
        }
    }

    #[test]
    fn an_encounter_lasts_as_long_as_the_measured_distances(path in path(), clearance in 0.0..200.0) {
        let arm = arm("tx2-60l");
        let mut watch = Watch::new(scene(&format!("clearance = {clearance}\n{CELL}"), &arm));
        let scene = Arc::clone(watch.scene());
        for (cycle, joints) in (0u32..).zip(&path) {
            let sight = sight(&arm, *joints, f64::from(cycle) * CYCLE);
            watch.see(&sight, &());
            let step = Step::new(&scene, None, &sight);
            for (pair, watched) in scene.pairs.iter().zip(&watch.pairs) {
                let distance = step.measure(pair, 1.0, 1e4).at_least();
                let least = pair.clearance.max(TOUCHING);
                let smallest = watched.nearest.as_ref().map(|nearest| nearest.measured.distance);
                let agrees = match smallest {
                    Some(smallest) => distance < least + EXACT + 1e-3 && smallest < distance + 1e-3,
                    None => distance > least - 1e-3,
                };
                prop_assert!(agrees, "{:?} in cycle {cycle}: {distance}, {smallest:?}", scene.names(pair));
            }
        }
    }

    #[test]
    fn a_copy_continues_like_the_original(path in path(), cut in 1usize..100) {
        let arm = arm("tx2-60l");
        let text = format!("clearance = 40\n{CELL}");
        let mut watch = Watch::new(scene(&text, &arm));
        see_all(&mut watch, &arm, &path[..cut], 0);
        let mut copy = watch.clone();
        prop_assert_eq!(see_all(&mut watch, &arm, &path[cut..], cut), see_all(&mut copy, &arm, &path[cut..], cut));
    }

    #[test]
    fn a_greater_clearance_loses_no_encounter(path in path()) {
        let arm = arm("tx2-60l");
        let begun = |clearance: f64| {
            let found = encounters(&format!("clearance = {clearance}\n{CELL}"), &arm, &path);
            let begun = found.into_iter().filter(|one| one.state != EncounterState::Clear);
            begun.map(|one| one.names).collect::<std::collections::BTreeSet<_>>()
        };
        prop_assert!(begun(10.0).is_subset(&begun(60.0)));
    }

    #[test]
    fn no_point_moves_farther_than_its_bound(from in joints(), to in joints(), arm in prop_oneof![Just("tx2-60l"), Just("ts60")]) {
        let arm = crate::testing::arm(arm);
        let scene = scene(CELL, &arm);
        let small: Joints = std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) / 100.0);
        let past = Past::of(&sight(&arm, from, 0.0));
        let sight = sight(&arm, small, CYCLE);
        let step = Step::new(&scene, Some(&past), &sight);
        for pair in &scene.pairs {
            let way = step.travel(pair).unwrap();
            let [before, after] = [0.0, 1.0].map(|fraction| step.measure(pair, fraction, 1e5).at_least());
            prop_assert!((before - after).abs() <= way + 1e-6, "{} to {} for {way}", before, after);
        }
    }
}

#[test]
fn the_cell_of_these_tests_is_valid() {
    assert_eq!(build(CELL, &arm("tx2-60l")).unwrap().things.len(), 4);
}
