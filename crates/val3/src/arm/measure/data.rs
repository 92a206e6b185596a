//! Data file of the measuring application.

use val3_kinematics::Arm;

use crate::args::AxisRange;

/// Half of a rotating axis' default range, in degrees.
const AROUND: f64 = 15.0;

/// Half of a stroke's default range, in mm.
const AROUND_STROKE: f64 = 40.0;

/// Number of moves in each direction, with each descriptor and length.
const TIMES: u8 = 2;

/// Key codes of the menu keys F1, F2 and F8.
const KEYS: [(&str, u16); 3] = [("nGo", 271), ("nSkip", 272), ("nEnd", 278)];

/// Speed, acceleration and deceleration of the measured moves in per cent, slow moves first. The low percentage
/// determines the time: a low `vel` in moves with constant speed, a low `accel` or `decel` in moves without.
const DESCRIPTORS: &[[f64; 3]] = &[
    [2.0, 100.0, 100.0],
    [5.0, 100.0, 100.0],
    [10.0, 100.0, 100.0],
    [20.0, 100.0, 100.0],
    [100.0, 2.0, 20.0],
    [100.0, 20.0, 2.0],
    [100.0, 5.0, 100.0],
    [100.0, 100.0, 5.0],
    [100.0, 10.0, 100.0],
    [100.0, 100.0, 10.0],
    [50.0, 100.0, 100.0],
    [100.0, 20.0, 20.0],
    [100.0, 100.0, 100.0],
];

/// Lengths of the moves with each descriptor, as fractions of the range. Several lengths distribute the times over the
/// 4 ms of a cycle.
const PARTS: &[f64] = &[1.0, 0.77, 0.53];

/// Text of the data file.
pub(super) fn file(arm: &Arm, ranges: &[AxisRange]) -> String {
    let axes = 0..arm.axes();
    let requested = |axis: usize| ranges.iter().find(|range| range.axis == axis + 1);
    let limits = arm.limits().iter().enumerate();
    let (low, high): (Vec<f64>, Vec<f64>) = limits
        .map(|(axis, limits)| requested(axis).map_or((limits.min, limits.max), |range| (range.from, range.to)))
        .unzip();
    let around = axes.clone().map(|axis| match requested(axis) {
        Some(_) => 0.0,
        None if arm.is_stroke(axis) => AROUND_STROKE,
        None => AROUND,
    });
    let units = axes.clone().map(|axis| format!(" {}", arm.unit(axis)));
    let joint = if arm.is_scara() { "jointRs" } else { "jointRx" };
    let moves: Vec<_> = DESCRIPTORS.iter().flat_map(|mdesc| PARTS.iter().map(move |part| (mdesc, *part))).collect();
    let column = |value: fn(&(&[f64; 3], f64)) -> f64| moves.iter().map(value).collect::<Vec<_>>();

    let mut data = vec![
        item("jStart", joint, 1, &[]),
        item("mMove", "mdesc", 1, &["blend=\"off\"".to_owned()]),
        numbers("nAccel", &column(|([_, accel, _], _)| *accel)),
        numbers("nAround", &around.collect::<Vec<_>>()),
        numbers("nAxes", &[f64::from(u8::try_from(arm.axes()).unwrap_or_default())]),
        numbers("nDecel", &column(|([_, _, decel], _)| *decel)),
        item("nFrom", "num", arm.axes(), &[]),
        numbers("nHigh", &high),
        numbers("nLow", &low),
        numbers("nPart", &column(|(_, part)| *part)),
        item("nStart", "num", arm.axes(), &[]),
        numbers("nTimes", &[f64::from(TIMES)]),
        item("nTo", "num", arm.axes(), &[]),
        numbers("nVel", &column(|([vel, _, _], _)| *vel)),
        texts("sArm", [arm.name().to_owned()]),
        texts("sUnit", units),
    ];
    data.extend(KEYS.iter().map(|(name, code)| numbers(name, &[f64::from(*code)])));
    data.sort();
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
         <Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n{}  </Datas>\n</Database>\n",
        data.concat()
    )
}

fn numbers(name: &str, values: &[f64]) -> String {
    let values: Vec<_> = values.iter().map(|value| format!("value=\"{value}\"")).collect();
    item(name, "num", values.len(), &values)
}

fn texts(name: &str, values: impl IntoIterator<Item = String>) -> String {
    let values: Vec<_> = values.into_iter().map(|value| format!("value=\"{}\"", escaped(&value))).collect();
    item(name, "string", values.len(), &values)
}

/// Formats an array with the first values' attributes.
fn item(name: &str, ty: &str, size: usize, values: &[String]) -> String {
    let head = format!("    <Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"{size}\"");
    if values.is_empty() {
        return format!("{head} />\n");
    }
    let values = values.iter().enumerate().map(|(key, value)| format!("      <Value key=\"{key}\" {value} />\n"));
    format!("{head}>\n{}    </Data>\n", values.collect::<String>())
}

fn escaped(text: &str) -> String {
    quick_xml::escape::escape(text).into_owned()
}
