use proptest::prelude::*;
use val3_geometry::Trsf;
use val3_kinematics::{Arm, Joints};

use super::*;
use crate::testing::{arm, build, scene};

/// A post below the flange, which points straight down, two parts, and a gripper on the flange.
const POST: &str = "[[object]]\nname = \"post\"\nin = \"plate\"\nat = [0, 0, -60]\nbox = [60, 60, 40]\n\
    [[object]]\nname = \"plate\"\nat = [0, 0, 0]\nsphere = { radius = 1 }\n\
    [[part]]\nname = \"carton\"\nbox = [40, 40, 80]\ncopies = 2\nstep = [500, 0, 0]\nat = [0, 0, 20]\n\
    [[gripper]]\nwhen = { io = { valve = true } }\nholding = { aiVacuum = 100 }\nempty = { aiVacuum = 0 }\n";

/// The arm points to the front with its flange down.
const DOWN: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

/// A cell around an arm, its parts, and the time.
#[derive(Clone)]
struct Bench {
    arm: Arc<Arm>,
    scene: Scene,
    handling: Handling,
    joints: Joints,
    time: f64,
}

impl Bench {
    fn new(text: &str) -> Self {
        let arm = arm("tx2-60l");
        let scene = scene(text, &arm);
        let handling = Handling::new(&scene);
        Self { arm, scene, handling, joints: DOWN, time: 0.0 }
    }

    /// Ends a cycle with this output of the gripper.
    fn see(&mut self, holds: bool, delay: f64) -> Vec<HandlingEvent> {
        self.time += 0.004;
        let sight = Sight {
            arm: &self.arm,
            joints: self.joints,
            placement: 0,
            places: vec![None; self.scene.data().count()],
            parts: Arc::clone(self.handling.parts()),
            time: self.time,
        };
        let outputs = outputs(&self.scene, holds, delay);
        self.handling.see(&self.scene, &sight, &outputs, 0.004)
    }

    fn place(&mut self, part: usize, offset: [f64; 3]) {
        let flange = *self.scene.position(&DOWN).flange();
        let pose = flange * Trsf::new(offset, [0.0; 3]).isometry();
        self.handling.place(&self.scene, part, Some(pose));
    }

    fn part(&self, part: usize) -> [f64; 3] {
        let position = self.scene.position(&self.joints);
        let places = Places { data: &[], parts: self.handling.parts() };
        let pose = position.carrier(BodyCarrier::Part(part), places).unwrap();
        pose.translation.vector.map(|length| (length * 1e6).round() / 1e6).into()
    }
}

/// The same command for all grippers, and running conveyors.
fn outputs(scene: &Scene, holds: bool, delay: f64) -> CellOutputs {
    let grippers = vec![Some(GripperCommand { holds, delay }); scene.cell().grippers.len()];
    CellOutputs { grippers, conveyors: vec![Some(true); scene.cell().conveyors.len()] }
}

/// A bench whose first part is `gap` mm below the flange.
fn bench(gap: f64) -> Bench {
    let mut bench = Bench::new(POST);
    bench.place(0, [0.0, 0.0, 40.0 + gap]);
    bench.see(false, 0.0);
    bench
}

#[test]
fn a_gripper_carries_the_nearest_part_and_releases_it() {
    let mut bench = bench(3.0);
    let writes = |bench: &mut Bench| bench.handling.take_writes().iter().map(|write| write.value).collect::<Vec<_>>();
    assert_eq!(writes(&mut bench), [0.0]);
    let [HandlingEvent::Grip { part: Some(part), nearest: Some(near), .. }] = &bench.see(true, 0.0)[..] else {
        panic!("nothing was gripped")
    };
    assert_eq!((part.as_str(), near.distance.round()), ("carton[0]", 3.0));
    assert_eq!(writes(&mut bench), [100.0]);
    let before = bench.part(0);
    bench.joints[0] = 90.0;
    assert_eq!(bench.see(true, 0.0), []);
    let turned = [-before[1], before[0], before[2]];
    assert_eq!(bench.part(0), turned.map(|length| if length == 0.0 { 0.0 } else { length }));
    let [HandlingEvent::Release { part, .. }] = &bench.see(false, 0.0)[..] else { panic!("nothing was released") };
    assert_eq!((part.as_str(), writes(&mut bench)), ("carton[0]", vec![0.0]));
    bench.joints = DOWN;
    bench.see(false, 0.0);
    assert_eq!(bench.part(0), turned.map(|length| if length == 0.0 { 0.0 } else { length }), "it stays where it is");
}

#[test]
fn a_gripper_that_is_too_far_names_the_nearest_part() {
    let mut bench = bench(12.3);
    let [HandlingEvent::Grip { part: None, nearest: Some(near), within, .. }] = &bench.see(true, 0.0)[..] else {
        panic!("something was gripped")
    };
    assert_eq!((near.name.as_str(), (near.distance * 10.0).round(), *within), ("carton[0]", 123.0, 5.0));
}

#[test]
fn an_output_takes_effect_after_its_time() {
    let mut bench = bench(0.0);
    assert_eq!(bench.see(true, 0.01), []);
    assert_eq!(bench.handling.next_due(), Some(0.0), "values for signals");
    bench.handling.take_writes();
    assert!((bench.handling.next_due().unwrap() - 0.018).abs() < 1e-12);
    assert_eq!(bench.see(true, 0.01).len() + bench.see(true, 0.01).len(), 0);
    assert!(matches!(&bench.see(true, 0.01)[..], [HandlingEvent::Grip { part: Some(_), .. }]));
    assert_eq!(bench.handling.next_due(), Some(0.0));
}

#[test]
fn nothing_is_to_do_until_the_output_changes() {
    let mut bench = bench(0.0);
    let is_idle = |bench: &Bench, holds| bench.handling.is_idle(&outputs(&bench.scene, holds, 0.01), bench.time);
    assert!(is_idle(&bench, false) && !is_idle(&bench, true));
    bench.see(true, 0.01);
    assert!(!is_idle(&bench, true), "the change has not taken effect");
    (0..3).for_each(|_| drop(bench.see(true, 0.01)));
    assert!(bench.handling.is_held(0) && is_idle(&bench, true) && !is_idle(&bench, false));
}

#[test]
fn a_short_pulse_of_the_output_has_no_effect() {
    let mut bench = bench(0.0);
    assert_eq!(bench.see(true, 0.01), []);
    let events: Vec<HandlingEvent> = (0..5).flat_map(|_| bench.see(false, 0.01)).collect();
    assert_eq!(events, []);
    assert!(!bench.handling.is_held(0));
}

#[test]
fn a_gripper_closed_at_the_start_has_missed_nothing() {
    let mut bench = Bench::new(POST);
    assert_eq!(bench.see(true, 0.0), []);
}

#[test]
fn a_script_takes_a_part_out_of_the_gripper() {
    let mut bench = bench(0.0);
    bench.see(true, 0.0);
    bench.handling.take_writes();
    let event = bench.handling.place(&bench.scene.clone(), 0, None);
    assert_eq!(event, Some(HandlingEvent::Part { part: "carton[0]".to_owned(), is_gone: true }));
    assert_eq!(bench.handling.take_writes().iter().map(|write| write.value).collect::<Vec<_>>(), [0.0]);
    assert!(!bench.handling.is_held(0));
    assert!(matches!(&bench.see(false, 0.0)[..], []), "nothing is left to release");
}

#[test]
fn a_part_released_in_the_air_states_its_height() {
    let floor = format!("{POST}[[object]]\nname = \"floor\"\nin = \"base\"\nbox = [4000, 4000, 10]\nat = [0, 0, -5]");
    let mut bench = Bench::new(&floor);
    bench.place(0, [0.0, 0.0, 40.0]);
    bench.see(false, 0.0);
    bench.see(true, 0.0);
    let [HandlingEvent::Release { above: Some(above), .. }] = &bench.see(false, 0.0)[..] else { panic!("no height") };
    let bottom = bench.part(0)[2] - 40.0;
    assert!((above - (bottom + 375.0)).abs() < 1e-6, "{above} {bottom}");
}

const BEAM: &str = "[[part]]\nname = \"carton\"\nbox = [40, 40, 80]\n\
    [[sensor]]\nname = \"stop\"\nbeam = { from = [300, -100, 0], to = [300, 100, 0] }\nio = \"diPart\"\ndelay = 0.008\n";

#[test]
fn a_sensor_detects_a_part_and_its_input_follows_after_the_delay() {
    let mut bench = Bench::new(BEAM);
    let writes = |bench: &mut Bench| bench.handling.take_writes().iter().map(|write| write.value).collect::<Vec<_>>();
    assert_eq!((bench.see(false, 0.0), writes(&mut bench)), (vec![], vec![0.0]));
    let at = |x: f64| Some(Trsf::new([x, 0.0, 0.0], [0.0; 3]).isometry());
    bench.handling.place(&bench.scene.clone(), 0, at(281.0));
    let [HandlingEvent::Sensor { detects: Some(detects), .. }] = &bench.see(false, 0.0)[..] else { panic!("not seen") };
    assert_eq!((detects.as_str(), bench.handling.detects(0), writes(&mut bench)), ("carton", true, vec![]));
    bench.see(false, 0.0);
    bench.see(false, 0.0);
    assert_eq!(writes(&mut bench), [1.0]);
    bench.handling.place(&bench.scene.clone(), 0, at(279.0));
    assert!(matches!(&bench.see(false, 0.0)[..], [HandlingEvent::Sensor { detects: None, .. }]));
    bench.see(false, 0.0);
    bench.see(false, 0.0);
    assert_eq!(writes(&mut bench), [0.0]);
}

#[test]
fn a_barrier_that_detects_the_arm_can_be_inverted() {
    let text = "[[sensor]]\nname = \"barrier\"\nzone = { box = [3000, 3000, 100], at = [0, 0, 0] }\nio = \"diPart\"\n\
                not = true\nsees = [\"arm\"]\n";
    let mut bench = Bench::new(text);
    assert!(matches!(&bench.see(false, 0.0)[..], [HandlingEvent::Sensor { detects: Some(_), .. }]));
    assert_eq!(bench.handling.take_writes().iter().map(|write| write.value).collect::<Vec<_>>(), [0.0]);
}

#[track_caller]
fn refused(text: &str, expected: &str) {
    let error = build(text, &arm("tx2-60l")).unwrap_err();
    assert_eq!(format!("{error}\nhelp: {}", error.help), expected);
}

#[test]
fn errors_of_parts_name_their_keys() {
    let part = "[[part]]\nname = \"a\"\nbox = [1, 2, 3]\n";
    let carried = "part[0].in: the arm cannot carry the part `a` from the start\nhelp: let a gripper hold it, or \
                   describe it as an object";
    refused(&format!("{part}in = \"flange\""), carried);
    refused(&format!("{part}copies = 0"), "part[0].copies: 0 is no number of copies\nhelp: write 1 to 1000");
    let step = "part[0].step: one part has no next copy\nhelp: add `copies`, or remove `step`";
    refused(&format!("{part}step = [1, 2, 3]"), step);
    let frame = "part[0].in: there is no frame, tool or object `ftable`\nhelp: did you mean `fTable`?";
    refused(&format!("{part}in = \"ftable\""), frame);
    let twice = "part[0].name: two things have the name `a`\nhelp: rename one of them";
    refused(&format!("[[object]]\nname = \"a\"\nbox = [1, 2, 3]\n{part}"), twice);
    let touch = "part[0].touch: -1 is no distance\nhelp: write 0 or a greater number of mm";
    refused(&format!("{part}touch = -1"), touch);
}

#[test]
fn errors_of_grippers_name_their_keys() {
    let none = "gripper[0]: nothing controls this gripper\nhelp: add `tool = \"…\"`, or `when = { io = { \"…\" = true } }` \
                with `in` and `at`";
    refused("[[gripper]]\nwithin = 3", none);
    let tool = "gripper[0].tool: there is no frame, tool or object `tGriper`\nhelp: write `world`, `base`, `flange`, \
                `link1`, or a name of the application or of this file";
    refused("[[gripper]]\ntool = \"tGriper\"", tool);
    let frame = "gripper[0].tool: `fTable` is no tool, and the arm has to carry a gripper\nhelp: name a tool of the \
                 application, or `flange`";
    refused("[[gripper]]\ntool = \"fTable\"", frame);
    let digital = "gripper[0].holding.diPart: `diPart` is digital, and 5 is a number\nhelp: write true or false";
    refused("[[gripper]]\ntool = \"tGripper\"\nholding = { diPart = 5 }", digital);
    let output = "gripper[0].holding.valve: `valve` is an output, which only programs write\nhelp: name an input";
    refused("[[gripper]]\ntool = \"tGripper\"\nholding = { valve = true }", output);
    let signal = "gripper[0].empty.dipart: there is no input or output `dipart`\nhelp: did you mean `diPart`?";
    refused("[[gripper]]\ntool = \"tGripper\"\nempty = { dipart = true }", signal);
    let object = "gripper[0].objects: there is no object `claw`\nhelp: the objects are `pad`";
    let pad = "[[object]]\nname = \"pad\"\nin = \"flange\"\nbox = [1, 2, 3]\n";
    refused(&format!("{pad}[[gripper]]\ntool = \"tGripper\"\nobjects = [\"claw\"]"), object);
    let twice = "gripper[1].tool: two grippers are controlled by the tool `tGripper`\nhelp: one tool moves one gripper";
    refused("[[gripper]]\ntool = \"tGripper\"\n[[gripper]]\ntool = \"tGripper\"", twice);
}

#[test]
fn errors_of_sensors_name_their_keys() {
    let beam = "beam = { from = [0, 0, 0], to = [0, 0, 9] }";
    let none = "sensor[0]: `a` has no beam and no zone\nhelp: add `beam = { from = [0, -200, 50], to = [0, 200, 50] }`, \
                or a `zone` with a shape";
    refused("[[sensor]]\nname = \"a\"", none);
    let analog = "sensor[0].io: `aiVacuum` is analog\nhelp: name a digital input";
    refused(&format!("[[sensor]]\nname = \"a\"\nio = \"aiVacuum\"\n{beam}"), analog);
    let delay = "sensor[0].delay: -1 is no delay\nhelp: write seconds from 0 to 3600";
    refused(&format!("[[sensor]]\nname = \"a\"\ndelay = -1\n{beam}"), delay);
    let sees = "sensor[0].sees: the cell has nothing with the name `karton*`\nhelp: it has `base`, `link1`, `link2`, \
                `link3`, `link4`, `link5`, `link6`";
    refused(&format!("[[sensor]]\nname = \"a\"\nsees = [\"karton*\"]\n{beam}"), sees);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// A copy of the state behaves like the original, with the same input and at any time.
    #[test]
    fn a_restored_state_repeats_its_future(outputs in prop::collection::vec(any::<bool>(), 2..40), split in 0usize..40) {
        let mut first = bench(2.0);
        let split = split.min(outputs.len());
        for holds in &outputs[..split] {
            first.see(*holds, 0.006);
        }
        let mut second = first.clone();
        let future = |bench: &mut Bench| outputs[split..].iter().map(|holds| bench.see(*holds, 0.006)).collect::<Vec<_>>();
        prop_assert_eq!(future(&mut first), future(&mut second));
        prop_assert_eq!(first.handling.parts(), second.handling.parts());
        prop_assert_eq!(first.handling.take_writes(), second.handling.take_writes());
    }

    /// A held part keeps its pose in the flange in any posture. After the release it keeps its pose in `world`.
    #[test]
    fn a_held_part_moves_with_the_flange(joints in prop::array::uniform6(-60.0..60.0f64)) {
        let mut bench = bench(1.0);
        bench.see(true, 0.0);
        let held = bench.handling.parts()[0];
        bench.joints = joints;
        bench.see(true, 0.0);
        prop_assert_eq!(bench.handling.parts()[0], held);
        let before = bench.part(0);
        bench.see(false, 0.0);
        prop_assert!(bench.part(0).iter().zip(before).all(|(now, then)| (now - then).abs() < 1e-5));
    }
}
