use proptest::prelude::*;
use val3_kinematics::Joints;

use super::*;
use crate::handling::CellOutputs;
use crate::scene::Scene;
use crate::step::Sight;
use crate::testing::{arm, build, scene};

/// A belt along the y axis with its top at z = 0 and its end at y = 500, and two boxes of 100 mm on it.
const BELT: &str = "[[conveyor]]\nname = \"belt\"\nbox = { min = [-200, -500, -20], max = [200, 500, 0] }\n\
    speed = [0, 250, 0]\nwhen = { io = { valve = true } }\n\
    [[part]]\nname = \"carton\"\nbox = [100, 100, 100]\nat = [0, -300, 50]\ncopies = 2\nstep = [0, -150, 0]\n";

/// A belt that receives three boxes, one each second.
const FEED: &str = "[[conveyor]]\nname = \"belt\"\nbox = { min = [-200, -500, -20], max = [200, 500, 0] }\n\
    speed = [0, 250, 0]\nfeed = { part = \"carton\", every = 1, at = [0, -400, 50] }\nEND\n\
    [[part]]\nname = \"carton\"\nbox = [100, 100, 100]\ncopies = 3\n";

const CYCLE: f64 = 0.004;

#[derive(Clone)]
struct Belt {
    scene: Scene,
    handling: Handling,
    time: f64,
}

impl Belt {
    fn new(text: &str) -> Self {
        let scene = scene(text, &arm("tx2-60l"));
        let handling = Handling::new(&scene);
        Self { scene, handling, time: 0.0 }
    }

    fn see(&mut self, runs: bool) -> Vec<HandlingEvent> {
        self.time += CYCLE;
        let arm = Arc::clone(&self.scene.arm);
        let parts = Arc::clone(self.handling.parts());
        let joints: Joints = [0.0; 6];
        let sight = Sight { arm: &arm, joints, placement: 0, places: Vec::new(), parts, time: self.time };
        let outputs = CellOutputs { grippers: Vec::new(), conveyors: vec![Some(runs)] };
        self.handling.see(&self.scene, &sight, &outputs, CYCLE)
    }

    /// Simulates this number of seconds with a running or stopped conveyor.
    fn wait(&mut self, seconds: f64, runs: bool) -> Vec<HandlingEvent> {
        let cycles = std::iter::successors(Some(0u32), |cycle| Some(cycle + 1));
        cycles.take_while(|cycle| f64::from(*cycle) * CYCLE < seconds).flat_map(|_| self.see(runs)).collect()
    }

    /// y coordinates of the parts, rounded to 0.1 mm; `None` outside of the cell.
    fn places(&self) -> Vec<Option<f64>> {
        let place = |place: &PartPlace| match place.holder {
            PartHolder::Gone => None,
            _ => Some((place.pose.translation.vector.y * 10.0).round() / 10.0),
        };
        self.handling.parts().iter().map(place).collect()
    }
}

#[test]
fn parts_move_while_the_conveyor_runs() {
    let mut belt = Belt::new(BELT);
    belt.wait(1.0, false);
    assert_eq!(belt.places(), [Some(-300.0), Some(-450.0)]);
    belt.see(true);
    belt.wait(1.0, true);
    assert_eq!(belt.places(), [Some(-50.0), Some(-200.0)]);
    belt.see(false);
    let stopped = belt.places();
    belt.wait(1.0, false);
    assert_eq!(belt.places(), stopped);
}

#[test]
fn parts_wait_at_the_end_and_one_after_the_other() {
    let mut belt = Belt::new(BELT);
    belt.wait(10.0, true);
    assert_eq!(belt.places(), [Some(450.0), Some(349.0)]);
    assert_eq!(belt.handling.next_due(), None, "nothing moves");
    belt.handling.place(&belt.scene.clone(), 0, None);
    assert_eq!(belt.handling.next_due(), Some(0.0), "the second part can move");
    belt.wait(10.0, true);
    assert_eq!(belt.places(), [None, Some(450.0)]);
}

#[test]
fn parts_next_to_a_belt_and_high_above_it_stay() {
    for place in ["[300, 0, 50]", "[0, 600, 50]", "[0, 0, 120]", "[0, 0, -100]"] {
        let mut belt = Belt::new(&BELT.replace("[0, -300, 50]", place));
        let before = belt.places()[0];
        belt.wait(0.5, true);
        assert_eq!(belt.places()[0], before, "{place}");
    }
}

#[test]
fn a_feed_adds_parts_in_its_time_and_waits_for_their_place() {
    let mut belt = Belt::new(&FEED.replace("END", ""));
    let part = |index: u32| HandlingEvent::Part { part: format!("carton[{index}]"), is_gone: false };
    assert_eq!(belt.places(), [None; 3]);
    assert_eq!(belt.see(true), [part(0)]);
    assert_eq!(belt.wait(0.9, true), []);
    assert_eq!(belt.wait(0.2, true), [part(1)]);
    assert_eq!(belt.wait(1.0, true), [part(2)]);
    belt.wait(10.0, true);
    assert_eq!(belt.places(), [Some(450.0), Some(349.0), Some(248.0)]);
    assert_eq!(belt.handling.next_due(), None);
    let mut blocked = Belt::new(&FEED.replace("END", "").replace("[0, 250, 0]", "[0, 50, 0]"));
    assert_eq!(blocked.wait(1.9, true), [part(0)], "the first part has moved by 95 mm");
    assert_eq!(blocked.wait(0.2, true), [part(1)]);
}

#[test]
fn a_part_that_a_script_has_placed_does_not_arrive() {
    let mut belt = Belt::new(&FEED.replace("END", ""));
    let pose = Trsf::new([1000.0, 0.0, 0.0], [0.0; 3]).isometry();
    belt.handling.place(&belt.scene.clone(), 0, Some(pose));
    let events = belt.wait(1.5, true);
    let names: Vec<String> = ["carton[1]", "carton[2]"].map(str::to_owned).into();
    let arrived = events.into_iter().map(|event| match event {
        HandlingEvent::Part { part, .. } => part,
        other => format!("{other:?}"),
    });
    assert_eq!((arrived.collect::<Vec<_>>(), belt.places()[0]), (names, Some(0.0)));
}

#[test]
fn a_part_leaves_the_cell_at_the_end() {
    let mut belt = Belt::new(&FEED.replace("END", "end = \"remove\""));
    let events = belt.wait(8.0, true);
    let gone = events.iter().filter(|event| matches!(event, HandlingEvent::Part { is_gone: true, .. })).count();
    assert_eq!((gone, belt.places()), (3, vec![None; 3]));
}

#[track_caller]
fn refused(text: &str, expected: &str) {
    let error = build(text, &arm("tx2-60l")).unwrap_err();
    assert_eq!(format!("{error}\nhelp: {}", error.help), expected);
}

#[test]
fn errors_of_conveyors_name_their_keys() {
    let belt = "[[conveyor]]\nname = \"belt\"\nbox = [100, 100, 10]\n";
    refused(
        &format!("{belt}speed = [0, 0, 0]"),
        "conveyor[0].speed: 0 mm/s is no speed of a conveyor\nhelp: write \
        the speed in mm/s, at most 10000: `speed = [250, 0, 0]`",
    );
    refused(
        &format!("{belt}speed = [0, 0, 9]"),
        "conveyor[0].speed: a conveyor does not move its parts straight up \
        or down\nhelp: write a speed along x or y",
    );
    refused(
        "[[conveyor]]\nname = \"belt\"\nspeed = [1, 0, 0]",
        "conveyor[0]: `belt` has no box\nhelp: add the \
        belt: `box = [2000, 400, 20]`",
    );
    let belt = format!("{belt}speed = [1, 0, 0]\n");
    refused(
        &format!("{belt}in = \"flange\""),
        "conveyor[0].in: the arm cannot carry the conveyor `belt`\nhelp: name \
        `world`, `base`, a frame, or an object",
    );
    refused(
        &format!("{belt}feed = {{ part = \"crate\", every = 1 }}"),
        "conveyor[0].feed.part: there is no part \
        `crate`\nhelp: add a `[[part]]`",
    );
    let part = "[[part]]\nname = \"crate\"\nbox = [1, 2, 3]\n";
    refused(
        &format!("{belt}feed = {{ part = \"crate\", every = 0 }}\n{part}"),
        "conveyor[0].feed.every: 0 is no time \
        between parts\nhelp: write seconds from 0.1 to 3600",
    );
    refused(
        &format!("{belt}feed = {{ part = \"crate\", every = 1 }}\n{part}at = [1, 2, 3]"),
        "conveyor[0].feed.part: \
        `crate` has a place, and the feed gives it another one\nhelp: remove `in`, `at` and `step` of the part, or add a \
        second `[[part]]`",
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// A copy of the state behaves like the original, with the same input and at any time.
    #[test]
    fn a_restored_belt_repeats_its_future(runs in prop::collection::vec(any::<bool>(), 2..200), split in 0usize..200) {
        let mut first = Belt::new(&FEED.replace("END", "").replace("every = 1", "every = 0.3"));
        let split = split.min(runs.len());
        runs[..split].iter().for_each(|runs| drop(first.see(*runs)));
        let mut second = first.clone();
        let future = |belt: &mut Belt| runs[split..].iter().map(|runs| belt.see(*runs)).collect::<Vec<_>>();
        prop_assert_eq!(future(&mut first), future(&mut second));
        prop_assert_eq!(first.handling.parts(), second.handling.parts());
    }

    /// Cycles that the caller skips because of [`Handling::is_idle`] would have changed nothing.
    #[test]
    fn an_idle_belt_does_not_change(runs in prop::collection::vec((any::<bool>(), 1usize..40), 1..12)) {
        let text = FEED.replace("END", "").replace("every = 1", "every = 0.3").replace("-400", "200");
        let mut belt = Belt::new(&text);
        for (runs, cycles) in runs {
            for _ in 0..cycles {
                let outputs = CellOutputs { grippers: Vec::new(), conveyors: vec![Some(runs)] };
                let is_idle = belt.handling.is_idle(&outputs, belt.time + CYCLE);
                let before = belt.handling.parts().clone();
                let events = belt.see(runs);
                prop_assert!(!is_idle || events.is_empty() && before == *belt.handling.parts());
            }
        }
    }

    /// Parts on a belt keep their order and the gap between them, and do not pass the end of the belt.
    #[test]
    fn parts_on_a_belt_never_overlap(starts in prop::collection::vec(-450.0..440.0f64, 2), speed in 1.0..2000.0f64) {
        prop_assume!((starts[0] - starts[1]).abs() > 101.0);
        let mut belt = Belt::new(&BELT.replace("250", &speed.to_string()));
        for (part, y) in starts.iter().enumerate() {
            let pose = Trsf::new([0.0, *y, 50.0], [0.0; 3]).isometry();
            belt.handling.place(&belt.scene.clone(), part, Some(pose));
        }
        for _ in 0..300 {
            belt.see(true);
            let places: Vec<f64> = belt.handling.parts().iter().map(|place| place.pose.translation.vector.y).collect();
            prop_assert!((places[0] - places[1]).abs() > 101.0 - 1e-6, "{places:?}");
            prop_assert!(places.iter().all(|y| *y < 450.0 + 1e-6), "{places:?}");
        }
    }
}
