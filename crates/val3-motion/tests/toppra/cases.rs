//! Programs whose durations are compared. Each program is one motion without an intermediate stop.

use std::sync::Arc;

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, Joints, RequestedConfiguration};
use val3_motion::{
    Blend, DegreesPerSecond, Manner, Millimetres, MillimetresPerSecond, Motion, Move, MovePath, MoveTarget, SpeedLimits,
};

/// Arm with a program of moves.
pub(crate) struct Case {
    pub(crate) name: String,
    arm: Arc<Arm>,
    start: Joints,
    moves: Vec<Move>,
    /// Tool centre point at the end of the last move.
    pose: IsometryMatrix3<f64>,
    tool: IsometryMatrix3<f64>,
    speeds: Speeds,
    corner: Blend,
}

/// Fields of a motion descriptor that limit speeds.
#[derive(Clone, Copy)]
struct Speeds {
    vel: f64,
    accel: f64,
    decel: f64,
    tvel: f64,
    rvel: f64,
}

impl Case {
    fn new(name: &str, arm: &str, start: Joints) -> Self {
        let name = format!("{arm} {name}");
        let arm = Arc::new(Arm::by_name(arm).unwrap());
        let speeds = Speeds { vel: 100.0, accel: 100.0, decel: 100.0, tvel: 99999.0, rvel: 99999.0 };
        let (pose, tool) = (arm.flange(&start), IsometryMatrix3::identity());
        Self { name, arm, start, moves: Vec::new(), pose, tool, speeds, corner: Blend::Off }
    }

    /// Sets the fields `vel`, `accel` and `decel` for the following moves.
    fn effort(mut self, vel: f64, accel: f64, decel: f64) -> Self {
        self.speeds = Speeds { vel, accel, decel, ..self.speeds };
        self
    }

    /// Sets the fields `tvel` and `rvel` for the following moves.
    fn tool_speed(mut self, tvel: f64, rvel: f64) -> Self {
        self.speeds = Speeds { tvel, rvel, ..self.speeds };
        self
    }

    fn tool(mut self, place: [f64; 3], angles: [f64; 3]) -> Self {
        self.tool = Trsf::new(place, angles).isometry();
        self.pose *= self.tool;
        self
    }

    fn joint_corners(mut self, leave: f64, reach: f64) -> Self {
        self.corner = Blend::Joint { leave: Millimetres(leave), reach: Millimetres(reach) };
        self
    }

    fn cartesian_corners(mut self, leave: f64, reach: f64) -> Self {
        self.corner = Blend::Cartesian { leave: Millimetres(leave), reach: Millimetres(reach) };
        self
    }

    fn joint(mut self, joints: Joints) -> Self {
        self.pose = self.arm.flange(&joints) * self.tool;
        self.add(MovePath::Joint(joints))
    }

    /// Adds a line to a position at an offset in `world`, with a rotation of the tool about its own axes.
    fn line(mut self, offset: [f64; 3], turn: [f64; 3]) -> Self {
        self.pose = self.at(offset, turn);
        let destination = self.destination();
        self.add(MovePath::Line(destination))
    }

    fn arc(mut self, through: [f64; 3], to: [f64; 3]) -> Self {
        let intermediate = self.at(through, [0.0; 3]);
        self.pose = self.at(to, [0.0; 3]);
        let destination = self.destination();
        self.add(MovePath::Circle(intermediate, destination))
    }

    fn at(&self, offset: [f64; 3], turn: [f64; 3]) -> IsometryMatrix3<f64> {
        let turned = self.pose * Trsf::new([0.0; 3], turn).isometry();
        let place = turned.translation.vector + val3_geometry::Vector3::from(offset);
        IsometryMatrix3::from_parts(place.into(), turned.rotation)
    }

    fn destination(&self) -> MoveTarget {
        MoveTarget { pose: self.pose, configuration: RequestedConfiguration::FREE }
    }

    fn add(mut self, path: MovePath) -> Self {
        let axes = [0, 1, 2, 3, 4, 5];
        let Speeds { vel, accel, decel, tvel, rvel } = self.speeds;
        let limits = SpeedLimits {
            speed: axes.map(|axis| self.arm.nominal_speed(axis) * vel / 100.0),
            acceleration: axes.map(|axis| self.arm.nominal_acceleration(axis) * accel / 100.0),
            deceleration: axes.map(|axis| self.arm.nominal_deceleration(axis) * decel / 100.0),
            translation: MillimetresPerSecond(tvel),
            rotation: DegreesPerSecond(rvel),
        };
        let id = self.moves.len() as f64;
        self.moves.push(Move { path, tool: self.tool, limits, blend: self.corner, id, manner: Manner::Rigid });
        self
    }

    /// Motion at the start, with all moves recorded.
    pub(crate) fn motion(&self) -> Motion {
        let mut motion = Motion::new(Arc::clone(&self.arm), self.start);
        for request in &self.moves {
            motion.record(request).unwrap_or_else(|cause| panic!("{}: {cause}", self.name));
        }
        motion.close().unwrap_or_else(|cause| panic!("{}: {cause}", self.name));
        motion
    }

    pub(crate) fn axes(&self) -> usize {
        self.arm.axes()
    }

    /// Limits of a move.
    pub(crate) fn limits(&self, index: usize) -> &SpeedLimits {
        &self.moves[index.min(self.moves.len() - 1)].limits
    }
}

const BENT: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

/// General position for six-axis arms, without an axis at a special angle.
const TURNED: Joints = [25.0, 30.0, 75.0, 20.0, 50.0, -35.0];

/// All cases.
pub(crate) fn all() -> Vec<Case> {
    let mut cases = Vec::new();
    for arm in ["TX2-60L", "TX2-140", "RX160", "TX2-40", "TX2-90"] {
        let reach = Arm::by_name(arm).unwrap().flange(&BENT).translation.vector.x;
        cases.extend(six_axis(arm, reach / 500.0));
    }
    for (arm, reach) in [("TS2-60", 1.0), ("TS2-100", 1.6), ("TS40", 0.6)] {
        cases.extend(scara(arm, reach));
    }
    cases
}

/// Cases for a six-axis arm. Distances in mm are for an arm that reaches 500 mm in [`BENT`], multiplied by `size`.
fn six_axis(arm: &str, size: f64) -> Vec<Case> {
    let case = |name, start| Case::new(name, arm, start);
    let mm = |place: [f64; 3]| place.map(|value| value * size);
    let none = [0.0; 3];
    let half = |case: Case| case.effort(50.0, 50.0, 50.0);
    vec![
        case("short joint move", BENT).joint([3.0, -2.0, 94.0, 1.0, 88.0, 5.0]),
        case("long joint move", TURNED).joint([-120.0, -60.0, 20.0, -90.0, -40.0, 170.0]),
        case("joint move with tvel", TURNED).tool_speed(200.0, 9999.0).joint([-40.0, 10.0, 60.0, -20.0, 70.0, 20.0]),
        case("joint move with rvel", TURNED).tool_speed(9999.0, 60.0).joint([-40.0, 10.0, 60.0, -20.0, 70.0, 20.0]),
        case("joint move with soft brakes", TURNED)
            .effort(80.0, 100.0, 30.0)
            .joint([-40.0, 10.0, 60.0, -20.0, 70.0, 20.0]),
        case("short line", BENT).line(mm([3.0, 4.0, -2.0]), none),
        case("line across", TURNED).line(mm([-80.0, -220.0, 60.0]), none),
        case("long line across", BENT).line(mm([0.0, 300.0, 0.0]), none),
        case("line up", BENT).line(mm([0.0, 0.0, 150.0]), none),
        case("line with rotation", TURNED).line(mm([40.0, -150.0, -30.0]), [20.0, -15.0, 60.0]),
        case("rotation in place", TURNED).line(none, [10.0, 30.0, -80.0]),
        case("line with tvel", TURNED).tool_speed(150.0, 9999.0).line(mm([-80.0, -220.0, 60.0]), none),
        case("line with rvel", TURNED).tool_speed(9999.0, 45.0).line(mm([40.0, -150.0, -30.0]), [20.0, -15.0, 60.0]),
        case("slow line", TURNED).effort(5.0, 100.0, 100.0).line(mm([-80.0, -220.0, 60.0]), none),
        case("line of low acceleration", TURNED).effort(100.0, 10.0, 20.0).line(mm([-80.0, -220.0, 60.0]), none),
        case("line with a tool", TURNED)
            .tool(mm([0.0, 60.0, 120.0]), [0.0, 45.0, 0.0])
            .line(mm([-80.0, -150.0, 40.0]), [0.0, 0.0, 30.0]),
        case("line past the wrist", [10.0, 20.0, 60.0, 30.0, 12.0, 0.0]).line(mm([0.0, -160.0, 20.0]), none),
        case("arc", BENT).arc(mm([0.0, 80.0, 80.0]), mm([0.0, 160.0, 0.0])),
        case("large arc", TURNED).arc(mm([70.0, -70.0, 0.0]), mm([0.0, -140.0, 0.0])),
        case("arc with tvel", BENT).tool_speed(100.0, 9999.0).arc(mm([0.0, 80.0, 80.0]), mm([0.0, 160.0, 0.0])),
        case("lines with joint corners", BENT)
            .joint_corners(40.0 * size, 40.0 * size)
            .line(mm([0.0, 150.0, 0.0]), none)
            .line(mm([0.0, 0.0, 150.0]), none)
            .line(mm([0.0, -150.0, 0.0]), none),
        case("lines with unequal joint corners", TURNED)
            .joint_corners(20.0 * size, 60.0 * size)
            .line(mm([-50.0, -150.0, 0.0]), none)
            .line(mm([0.0, -60.0, 120.0]), [10.0, 0.0, 30.0]),
        case("lines with Cartesian corners", BENT)
            .cartesian_corners(40.0 * size, 40.0 * size)
            .line(mm([0.0, 150.0, 0.0]), none)
            .line(mm([0.0, 0.0, 150.0]), none)
            .line(mm([0.0, -150.0, 0.0]), none),
        case("lines with unequal Cartesian corners", TURNED)
            .cartesian_corners(20.0 * size, 60.0 * size)
            .line(mm([-50.0, -150.0, 0.0]), none)
            .line(mm([0.0, -60.0, 120.0]), [10.0, 0.0, 30.0]),
        case("corners with tvel", BENT)
            .tool_speed(120.0, 9999.0)
            .cartesian_corners(30.0 * size, 30.0 * size)
            .line(mm([0.0, 120.0, 0.0]), none)
            .line(mm([0.0, 0.0, 120.0]), none),
        half(case("corners of joint moves", TURNED).joint_corners(50.0 * size, 80.0 * size))
            .joint([-40.0, 10.0, 60.0, -20.0, 70.0, 20.0])
            .joint([-60.0, 40.0, 40.0, 10.0, 60.0, 90.0]),
        case("pick and place", BENT)
            .joint_corners(30.0 * size, 30.0 * size)
            .line(mm([0.0, 0.0, 100.0]), none)
            .joint([40.0, -10.0, 100.0, 0.0, 90.0, 40.0])
            .line(mm([0.0, 0.0, -100.0]), none),
        case("arc between lines", BENT)
            .cartesian_corners(10.0 * size, 10.0 * size)
            .line(mm([0.0, 100.0, 0.0]), none)
            .arc(mm([0.0, 40.0, 40.0]), mm([0.0, 0.0, 80.0]))
            .line(mm([0.0, -100.0, 0.0]), none),
        case("fast and slow move", BENT)
            .joint_corners(20.0 * size, 30.0 * size)
            .line(mm([0.0, 150.0, 0.0]), none)
            .effort(30.0, 60.0, 40.0)
            .line(mm([0.0, 0.0, 120.0]), none)
            .effort(100.0, 80.0, 100.0)
            .line(mm([0.0, -150.0, 0.0]), none),
        case("Cartesian corner into a slow move", TURNED)
            .cartesian_corners(30.0 * size, 30.0 * size)
            .line(mm([-50.0, -150.0, 0.0]), none)
            .effort(40.0, 50.0, 70.0)
            .tool_speed(200.0, 90.0)
            .line(mm([0.0, 0.0, 120.0]), none),
    ]
}

/// Cases for a SCARA arm. Distances in mm are for an arm with links of 620 mm, multiplied by `size`.
fn scara(arm: &str, size: f64) -> Vec<Case> {
    let start = [-30.0, 70.0, 100.0, 20.0, 0.0, 0.0];
    let case = |name| Case::new(name, arm, start);
    let mm = |[x, y, z]: [f64; 3]| [x * size, y * size, z];
    let none = [0.0; 3];
    vec![
        case("short joint move").joint([-32.0, 73.0, 96.0, 25.0, 0.0, 0.0]),
        case("long joint move").joint([60.0, -90.0, 20.0, 300.0, 0.0, 0.0]),
        case("stroke").joint([-30.0, 70.0, 20.0, 20.0, 0.0, 0.0]),
        case("line across").line(mm([-60.0, 200.0, 0.0]), none),
        case("line down").line([0.0, 0.0, -70.0], none),
        case("line with rotation").line(mm([60.0, 120.0, -20.0]), [0.0, 0.0, 75.0]),
        case("line with tvel").tool_speed(200.0, 9999.0).line(mm([-60.0, 200.0, -30.0]), none),
        case("slow line").effort(5.0, 50.0, 100.0).line(mm([-60.0, 200.0, 0.0]), none),
        case("arc").arc(mm([40.0, 40.0, 0.0]), mm([0.0, 80.0, 0.0])),
        case("pick and place with joint corners")
            .joint_corners(30.0, 30.0)
            .line([0.0, 0.0, 60.0], none)
            .line(mm([-40.0, 180.0, 0.0]), none)
            .line([0.0, 0.0, -60.0], none),
        case("pick and place with Cartesian corners")
            .cartesian_corners(25.0, 40.0)
            .line([0.0, 0.0, 60.0], none)
            .line(mm([-40.0, 180.0, 0.0]), none)
            .line([0.0, 0.0, -60.0], none),
        case("arch of joint moves")
            .joint_corners(20.0, 20.0)
            .joint([-30.0, 70.0, 160.0, 20.0, 0.0, 0.0])
            .joint([40.0, 50.0, 160.0, 90.0, 0.0, 0.0])
            .joint([40.0, 50.0, 100.0, 90.0, 0.0, 0.0]),
    ]
}
