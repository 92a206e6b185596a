//! Random programs of blended moves.

use super::*;

/// Program for one arm.
#[derive(Clone, Debug)]
pub(super) struct Program {
    pub(super) arm: &'static str,
    /// Tool centre point relative to the flange.
    pub(super) tool: Trsf,
    pub(super) moves: Vec<RandomMove>,
}

/// Move relative to its start position.
#[derive(Clone, Debug)]
pub(super) struct RandomMove {
    path: RandomPath,
    blend: RandomBlend,
    leave: f64,
    reach: f64,
}

#[derive(Clone, Debug)]
enum RandomPath {
    /// Joint move to the pose after a transformation by the tool.
    JointTo(Trsf),
    /// Joint move by these axis angles.
    Joints(Joints),
    Line(Trsf),
    /// Circle through an intermediate position to a target, both relative to the start, with a tool rotation.
    Circle([Vector3<f64>; 2], Vector3<f64>),
}

#[derive(Clone, Copy, Debug)]
enum RandomBlend {
    Joint,
    Cartesian,
}

/// Length in mm: 0, the scatter of taught points, a short move, or a long move.
fn length() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), (-20.0..2.3_f64).prop_map(power_of_two), 1.0..60.0_f64, 60.0..250.0_f64]
}

/// Length in mm, of any order of magnitude.
fn power_of_two(power: f64) -> f64 {
    (1.0 + power - power.floor()) * 2_f64.powi(power.floor() as i32)
}

fn direction() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0_f64)
        .prop_map(|vector| Vector3::from(vector).try_normalize(1e-3).unwrap_or(Vector3::x()))
}

fn transformation() -> impl Strategy<Value = Trsf> {
    let turn = prop_oneof![2 => Just(0.0), 1 => 0.0..5.0_f64, 3 => 5.0..100.0_f64];
    (length(), direction(), turn, direction()).prop_map(|(length, direction, turn, axis)| {
        let rotation = rotation::from_vector(&(axis * turn.to_radians()));
        Trsf::from_parts(direction * length, &rotation)
    })
}

fn path() -> impl Strategy<Value = RandomPath> {
    let circle = (direction(), 5.0..120.0_f64, direction(), 5.0..120.0_f64, direction(), 0.0..40.0_f64);
    prop_oneof![
        4 => transformation().prop_map(RandomPath::Line),
        3 => transformation().prop_map(RandomPath::JointTo),
        1 => prop::array::uniform6(-25.0..25.0_f64).prop_map(RandomPath::Joints),
        1 => circle.prop_map(|(one, far, other, further, axis, turn)| {
            RandomPath::Circle([one * far, one * far + other * further], axis * turn.to_radians())
        }),
    ]
}

fn distance() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 1 => (-8.0..0.0_f64).prop_map(power_of_two), 4 => 1.0..60.0_f64, 1 => 60.0..300.0_f64]
}

fn random_move() -> impl Strategy<Value = RandomMove> {
    let distances = prop_oneof![
        1 => distance().prop_map(|distance| (distance, distance)),
        2 => (distance(), distance()),
        1 => Just((50.0, 50.0)),
    ];
    let blend = prop_oneof![Just(RandomBlend::Joint), Just(RandomBlend::Cartesian)];
    (path(), blend, distances).prop_map(|(path, blend, (leave, reach))| RandomMove { path, blend, leave, reach })
}

fn tool() -> impl Strategy<Value = Trsf> {
    let tilt = prop_oneof![Just(0.0), -60.0..60.0_f64];
    (length(), direction(), 0.0..200.0_f64, tilt).prop_map(|(length, direction, z, tilt)| {
        let aside = direction * length.min(100.0);
        Trsf::new([aside.x, aside.y, z], [tilt, 0.0, 0.0])
    })
}

pub(super) fn programs() -> impl Strategy<Value = Program> {
    let arms = prop::sample::select(vec!["TX2-90", "TX2-60", "RX160", "TS2-60", "TP80"]);
    let moves = prop::collection::vec(random_move(), 2..6);
    (arms, tool(), moves).prop_map(|(arm, tool, moves)| {
        let scara = Arm::by_name(arm).unwrap().is_scara();
        let tool = if scara { Trsf { rx: 0.0, ..tool } } else { tool };
        Program { arm, tool, moves }
    })
}

impl Program {
    pub(super) fn arm(&self) -> Arm {
        Arm::by_name(self.arm).unwrap()
    }

    pub(super) fn start(&self) -> Joints {
        if self.arm().is_scara() { [20.0, 60.0, 100.0, 10.0, 0.0, 0.0] } else { START }
    }

    pub(super) fn limits(&self) -> SpeedLimits {
        let arm = self.arm();
        let axes: [usize; AXES] = std::array::from_fn(|axis| axis);
        SpeedLimits {
            speed: axes.map(|axis| arm.nominal_speed(axis)),
            acceleration: axes.map(|axis| arm.nominal_acceleration(axis)),
            deceleration: axes.map(|axis| arm.nominal_deceleration(axis)),
            translation: MillimetresPerSecond(99999.0),
            rotation: DegreesPerSecond(99999.0),
        }
    }

    /// Records all moves that the arm can execute. Returns the motion and the recorded moves.
    pub(super) fn record(&self) -> (Motion, Vec<Move>) {
        let mut motion = Motion::new(Arc::new(self.arm()), self.start());
        let mut recorded = Vec::new();
        for random in &self.moves {
            let request = self.request(&motion, random, recorded.len());
            if motion.record(&request).is_ok() {
                recorded.push(request);
            }
        }
        // Closing a path with a fault is an error.
        drop(motion.close());
        (motion, recorded)
    }

    fn request(&self, motion: &Motion, random: &RandomMove, id: usize) -> Move {
        let scara = self.arm().is_scara();
        let tool = self.tool.isometry();
        let joints = motion.destination();
        let start = self.arm().flange(&joints) * tool;
        let upright = |turn: &Vector3<f64>| if scara { Vector3::new(0.0, 0.0, turn.z) } else { *turn };
        let turned = |offset: &Vector3<f64>, turn: &Vector3<f64>| {
            start * IsometryMatrix3::from_parts((*offset).into(), rotation::from_vector(turn))
        };
        let destination = |pose| MoveTarget { pose, configuration: RequestedConfiguration::SAME };
        let path = match &random.path {
            RandomPath::Line(change) => {
                let change = change.isometry();
                let turn = upright(&rotation::to_vector(&change.rotation));
                MovePath::Line(destination(turned(&change.translation.vector, &turn)))
            }
            RandomPath::JointTo(change) => {
                let change = change.isometry();
                let turn = upright(&rotation::to_vector(&change.rotation));
                let flange = turned(&change.translation.vector, &turn) * tool.inverse();
                let configuration = self.arm().configuration(&joints);
                let target = self.arm().inverse_isometry_on(configuration, &flange, &joints);
                MovePath::Joint(target.unwrap_or(joints))
            }
            RandomPath::Joints(by) => {
                let mut target = joints;
                target.iter_mut().zip(by).take(self.arm().limits().len()).for_each(|(axis, by)| *axis += by);
                MovePath::Joint(target)
            }
            RandomPath::Circle([intermediate, target], turn) => {
                let turn = upright(turn);
                MovePath::Circle(turned(intermediate, &(turn * 0.5)), destination(turned(target, &turn)))
            }
        };
        let [leave, reach] = [random.leave, random.reach].map(Millimetres);
        let blend = match random.blend {
            RandomBlend::Joint => Blend::Joint { leave, reach },
            RandomBlend::Cartesian => Blend::Cartesian { leave, reach },
        };
        Move { path, tool, limits: self.limits(), blend, id: id as f64, manner: Manner::Rigid }
    }
}
