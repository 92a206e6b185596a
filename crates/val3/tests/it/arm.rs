//! `val3 arm`: lists and files of arms, and measuring an arm with hidden times on the embedded controller.

use std::fmt::Write as _;

use expect_test::{Expect, expect};
use val3_kinematics::{Arm, AxisLimits};

use crate::support::{CommandOutput, Folder};

#[test]
fn the_list_has_a_line_for_each_arm() {
    let list = Folder::empty().val3(&["arm", "list"]);
    assert_eq!((list.code, list.stderr.as_str()), (0, ""));
    assert_eq!(list.stdout.lines().count(), 1 + Arm::names().count());
    let shown = |name: &str| list.stdout.lines().find(|line| line.starts_with(name)).unwrap().to_owned() + "\n";
    let lines = [shown("name"), shown("TX2-60L"), shown("TS60-L400")].concat();
    expect![[r#"
        name             reach  axes         times     sources
        TX2-60L         920 mm  6            model     ros-industrial/staubli_experimental, kinetic-devel, URDF and OPW parameters; CCoudoin/staubli_tx2_60L_gz_sim, URDF; IvoD1998/Staubli_ROS2; robotkinematicscatalogue 1.1.2
        TS60-L400       600 mm  4 (SCARA)    model     robotkinematicscatalogue 1.1.2
    "#]]
    .assert_eq(&lines);
}

#[test]
fn a_shown_file_is_an_arm() {
    let folder = Folder::with("? getVersion(\"ArmType\")\n");
    let shown = folder.val3(&["arm", "show", "tx2_60l"]);
    assert_eq!((shown.code, shown.stderr.as_str()), (0, ""));
    folder.write("my-arm.toml", &shown.stdout.replace("\"TX2-60L\"", "\"mine\""));
    assert_eq!(folder.val3(&["run", "--arm", "my-arm.toml"]).stdout, "mine\n");
    refused(
        &folder,
        &["arm", "show", "rx13b"],
        expect![[r#"
            error: the arm `rx13b` is not known
              help: did you mean `RX130B`?
        "#]],
    );
    refused(
        &folder,
        &["arm", "show", "scara"],
        expect![[r#"
            error: `scara` is a kind of arm, and a model is needed here
              help: name a model such as `tx2-60l` (`val3 arm list` shows them), or a file such as `my-arm.toml`
        "#]],
    );
}

#[track_caller]
fn refused(folder: &Folder, args: &[&str], message: Expect) {
    let run = folder.val3(args);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
    message.assert_eq(&run.stderr);
}

#[test]
fn ranges_lie_within_the_limits_of_the_arm() {
    let folder = Folder::empty();
    let mut messages = String::new();
    for range in ["1=-200..0", "7=0..10", "0=0..10", "1=0..1", "1=30..-30", "1=30"] {
        let run = folder.val3(&["arm", "measure", "--arm", "tx2-60l", "--range", range]);
        assert_eq!(run.code, 2);
        let lines = run.stderr.lines().take_while(|line| !line.is_empty());
        lines.for_each(|line| writeln!(messages, "{line}").unwrap());
    }
    let twice = ["arm", "measure", "--arm", "tx2-60l", "--range", "1=0..10", "--range", "1=0..20"];
    messages += &folder.val3(&twice).stderr;
    messages += &folder.val3(&["arm", "measure", "my arm", "--arm", "tx2-60l"]).stderr;
    expect![[r#"
        error: the range from -200 to 0 exceeds the limits of axis 1
          help: name positions from -180 to 180 degrees
        error: axis 7 does not exist
          help: name an axis from 1 to 6
        error: axis 0 does not exist
          help: name an axis from 1 to 6
        error: the range of axis 1 is 1 degrees long, too short to measure its times
          help: name at least 5 degrees
        error: invalid value '1=30..-30' for '--range <AXIS=FROM..TO>': 30 is not less than -30: write the lowest position first
        error: invalid value '1=30' for '--range <AXIS=FROM..TO>': write AXIS=FROM..TO, for example 1=-30..30
        error: axis 1 has two ranges
          help: remove one of them
        error: an application cannot have the name `my arm`
          help: name a folder with at most 15 letters, digits and `_`, such as `armTimes`
    "#]]
    .assert_eq(&messages);
    assert_eq!(folder.path().read_dir().unwrap().count(), 0);
}

#[test]
fn files_are_replaced_only_by_force() {
    let folder = Folder::empty();
    let measure = ["arm", "measure", "--arm", "tx2-60l"];
    let run = folder.val3(&measure);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""));
    expect![[r#"
        wrote armTimes
          1. copy it to `usrapp` of the controller and start it in local or remote mode
          2. copy the event log: errors.log (CS8) or user.log (CS9)
          3. val3 arm fit LOG --arm tx2-60l --output my-arm.toml
    "#]]
    .assert_eq(&run.stderr);
    refused(
        &folder,
        &measure,
        expect![[r#"
            error: `armTimes/ask.pgx` exists
              help: --force replaces it
        "#]],
    );
    folder.write("armTimes/stop.pgx", "mine");
    assert_eq!(folder.val3(&[&measure[..], &["--force"]].concat()).code, 0);
    assert_ne!(folder.read("armTimes/stop.pgx"), "mine");
    folder.write("log", "val3arm begin arm=TX2-60L axes=6\n");
    folder.write("my.toml", "mine");
    refused(
        &folder,
        &["arm", "fit", "log", "--arm", "tx2-60l", "--output", "my.toml"],
        expect![[r#"
            error: `my.toml` exists
              help: --force replaces it
        "#]],
    );
    assert_eq!(folder.read("my.toml"), "mine");
}

/// An arm with hidden times, the ranges of its measurement and its start position.
struct Measured {
    arm: &'static str,
    /// Nominal speeds, accelerations and decelerations by axis.
    hidden: [&'static [f64]; 3],
    ranges: &'static [&'static str],
    start: &'static str,
}

const SIX_AXIS: Measured = Measured {
    arm: "tx2-60l",
    hidden: [
        &[230.0, 210.5, 301.0, 500.0, 620.0, 870.0],
        &[1000.0, 800.0, 1200.0, 4000.0, 5200.0, 8000.0],
        &[700.0, 1900.0, 1300.0, 2500.0, 3000.0, 8000.0],
    ],
    ranges: &["1=-30..30", "6=-60..60"],
    start: "0,20,60,0,45,0",
};

const SCARA: Measured = Measured {
    arm: "ts2-60",
    hidden: [&[230.0, 410.5, 1801.0, 2100.0], &[4000.0, 3800.0, 20200.0, 24000.0], &[3700.0, 5900.0, 16300.0, 12500.0]],
    ranges: &["3=20..180", "4=-90..90"],
    start: "0,30,100,0",
};

impl Measured {
    /// A folder with the application and `hidden.toml`.
    fn folder(&self) -> Folder {
        let folder = Folder::empty();
        let ranges = self.ranges.iter().flat_map(|range| ["--range", range]);
        let args: Vec<_> = ["arm", "measure", "--arm", self.arm].into_iter().chain(ranges).collect();
        assert_eq!(folder.val3(&args).code, 0);
        let file = Arm::file(self.arm).unwrap();
        let columns = ["nominal_speed =", "acceleration =", "deceleration ="];
        let lines = file.lines().map(|line| {
            let column = columns.iter().position(|column| line.starts_with(column));
            column.map_or(line.to_owned(), |column| format!("{} {:?}", columns[column], self.hidden[column]))
        });
        folder.write("hidden.toml", &lines.map(|line| line + "\n").collect::<String>());
        folder
    }

    /// Runs the application with these key presses of the operator.
    fn run(&self, folder: &Folder, keys: &str, more: &[&str]) -> CommandOutput {
        let start = format!("--start={}", self.start);
        let args = ["run", "armTimes", "--arm", "hidden.toml", "--power", "--until", "3600", "--keys", keys, &start];
        folder.val3(&[&args[..], more].concat())
    }

    /// Keys with which the operator starts all axes.
    fn all_keys(&self) -> String {
        vec!["F1"; 2 * self.hidden[0].len()].join(",")
    }
}

/// Adds noise between -4 and 4 ms to each time of a log.
fn noisy(log: &str) -> String {
    let mut noise = Noise(42);
    log.lines().map(|line| noise.line(line)).collect()
}

/// Pseudo-random noise that is the same in every run.
struct Noise(u64);

impl Noise {
    fn line(&mut self, line: &str) -> String {
        let Some((before, times)) = line.split_once("ms=") else { return format!("{line}\n") };
        let times = times.trim_end_matches(';').split(',');
        let times: Vec<_> =
            times.map(|time| (time.parse::<i64>().unwrap() + self.milliseconds()).to_string()).collect();
        format!("{before}ms={};\n", times.join(","))
    }

    fn milliseconds(&mut self) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from((self.0 >> 33) % 9).unwrap() - 4
    }
}

#[track_caller]
fn the_hidden_times_are_found(measured: &Measured) {
    let folder = measured.folder();
    let check = folder.val3(&["check", "armTimes"]);
    assert_eq!((check.code, check.stdout.as_str()), (0, ""), "{}", check.stderr);
    assert_eq!(folder.val3(&["fmt", "--check", "armTimes"]).code, 0);

    let run = measured.run(&folder, &measured.all_keys(), &[]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for (log, name) in [(run.stdout.clone(), "exact.log"), (noisy(&run.stdout), "noisy.log")] {
        folder.write(name, &log);
        let fit = folder.val3(&["arm", "fit", name, "--arm", measured.arm, "--output", "my.toml", "--force"]);
        assert_eq!((fit.code, fit.stdout.as_str()), (0, ""), "{}", fit.stderr);
        let found = Arm::from_toml(&folder.read("my.toml")).unwrap();
        assert!(found.has_measured_times());
        let values: [fn(&AxisLimits) -> f64; 3] =
            [|axis| axis.nominal_speed, |axis| axis.acceleration, |axis| axis.deceleration];
        for (value, hidden) in values.iter().zip(measured.hidden) {
            for (axis, hidden) in found.limits().iter().zip(hidden) {
                let ratio = value(axis) / hidden;
                assert!((ratio - 1.0).abs() < 0.01, "{name}: {hidden}: {axis:?}\n{}", fit.stderr);
            }
        }
    }
    // The file is a valid arm description for all commands.
    assert_eq!(folder.val3(&["run", "armTimes", "--arm", "my.toml", "--until", "1"]).code, 3);
}

#[test]
fn the_times_of_a_six_axis_arm_are_found_within_one_per_cent() {
    the_hidden_times_are_found(&SIX_AXIS);
}

#[test]
fn the_times_of_a_scara_arm_are_found_within_one_per_cent() {
    the_hidden_times_are_found(&SCARA);
}

/// Joint values in each row of a trace.
fn joints(trace: &str, axes: usize) -> Vec<Vec<f64>> {
    let rows = trace.lines().skip(1).map(|row| row.split(',').skip(3).take(axes).map(|joint| joint.parse().unwrap()));
    rows.map(Iterator::collect).collect()
}

/// Axes 1 and 6 have requested ranges; the range of each other axis is 15 degrees to both sides of the start position.
#[test]
fn each_axis_moves_alone_and_stays_in_its_range() {
    let folder = SIX_AXIS.folder();
    let run = SIX_AXIS.run(&folder, &SIX_AXIS.all_keys(), &["--trace", "trace.csv"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let start = [0.0, 20.0, 60.0, 0.0, 45.0, 0.0];
    let ranges = [(-30.0, 30.0), (5.0, 35.0), (45.0, 75.0), (-15.0, 15.0), (30.0, 60.0), (-60.0, 60.0)];
    let rows = joints(&folder.read("trace.csv"), 6);
    assert!(rows.len() > 10_000);
    for row in &rows {
        for (joint, (low, high)) in row.iter().zip(ranges) {
            assert!((low - 1e-6..=high + 1e-6).contains(joint), "{row:?}");
        }
        assert!(row.iter().zip(start).filter(|(joint, start)| (*joint - start).abs() > 1e-6).count() <= 1, "{row:?}");
    }
    for (axis, (low, high)) in ranges.iter().enumerate() {
        let positions = || rows.iter().map(|row| row[axis]);
        assert!(positions().fold(f64::MAX, f64::min) < low + 1e-3);
        assert!(positions().fold(f64::MIN, f64::max) > high - 1e-3);
    }
}

/// Without the operator's key press nothing moves; keys that the page does not show have no effect.
#[test]
fn the_operator_decides_about_each_axis() {
    let folder = SIX_AXIS.folder();
    let (moved, run) = moved_axes(&folder, "Return");
    assert_eq!((moved, run.code), (Vec::new(), 3));
    expect![[r#"
        log: USR val3arm begin arm=TX2-60L axes=6
        +Times of the arm------------------------+
        |Axis 1 moves alone,                     |
        |slowly,                                 |
        |from -30   to 30   degrees              |
        |Keep its way free.                      |
        |                                        |
        |F1 start   F2 skip   F8 end             |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        +----------------------------------------+
    "#]]
    .assert_eq(&run.stdout);
    assert_eq!(moved_axes(&folder, "F2,F2,F8").0, Vec::<usize>::new());
    let (moved, run) = moved_axes(&folder, "F2,F1,F2,F8");
    assert_eq!((moved, run.code), (vec![2], 0), "{}", run.stderr);
    assert!(!run.stdout.contains("times"), "{}", run.stdout);
    expect![[r#"
        log: USR val3arm begin arm=TX2-60L axes=6
        log: USR val3arm finished
        +Times of the arm------------------------+
        |Finished. The event log has the results:|
        |errors.log (CS8) or user.log (CS9)      |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        |                                        |
        +----------------------------------------+
    "#]]
    .assert_eq(&run.stdout);
}

/// Numbers of the axes that the keys of the operator move.
fn moved_axes(folder: &Folder, keys: &str) -> (Vec<usize>, CommandOutput) {
    let run = SIX_AXIS.run(folder, keys, &["--trace", "trace.csv", "--screen"]);
    let rows = joints(&folder.read("trace.csv"), 6);
    let moved = |axis: &usize| rows.iter().any(|row| (row[*axis] - rows[0][*axis]).abs() > 0.01);
    ((0..6).filter(moved).map(|axis| axis + 1).collect(), run)
}

/// In manual mode and below full monitor speed, the times would be wrong, so nothing moves.
#[test]
fn the_controller_has_to_be_ready() {
    let folder = SIX_AXIS.folder();
    folder.write("manual.toml", "[[at]]\nt = 0\nmode = \"manual\"\n");
    let messages = messages_at_start(&folder, &["--monitor-speed", "50"])
        + &messages_at_start(&folder, &["--script", "manual.toml"]);
    expect![[r#"
        pop-up: Set the monitor speed to 100 %
        pop-up: Select local or remote mode
    "#]]
    .assert_eq(&messages);
}

/// Messages of a run that does not measure.
fn messages_at_start(folder: &Folder, more: &[&str]) -> String {
    let run = SIX_AXIS.run(folder, "F1,F8", more);
    assert!(!run.stdout.contains("times"), "{}", run.stdout);
    run.stdout.lines().filter(|line| !line.contains("val3arm")).map(|line| format!("{line}\n")).collect()
}

/// An axis outside its range is not moved.
#[test]
fn an_axis_outside_of_its_range_is_not_moved() {
    let folder = SIX_AXIS.folder();
    let outside = Measured { start: "40,20,60,0,45,0", ..SIX_AXIS };
    let run = outside.run(&folder, "F8", &[]);
    expect![[r#"
        log: USR val3arm begin arm=TX2-60L axes=6
        pop-up: Axis 1 is outside of its range: jog it there and start again
        log: USR val3arm outside axis=1
        log: USR val3arm finished
    "#]]
    .assert_eq(&run.stdout);
}

/// Missing and invalid parts of a log are reported, and the times are copied from the model.
#[test]
fn an_incomplete_log_is_no_complete_measurement() {
    let folder = SCARA.folder();
    let run = SCARA.run(&folder, &SCARA.all_keys(), &[]);
    let end = run.stdout.find("val3arm end axis=3").unwrap();
    let log: String = run.stdout.split_at(end).0.replace("val3arm begin", "other message\r\nval3arm begin");
    let cut = log.replacen("decel=100 ms=", "dec", 1);
    folder.write("cut.log", &cut);
    let fit = folder.val3(&["arm", "fit", "cut.log", "--arm", "ts2-60", "--output", "my.toml"]);
    assert_eq!(fit.code, 1);
    expect![[r#"
        warning: cut.log:3: the line is cut: `decel` is missing; the line is not used
        warning: axis 1: lines of its measurement are missing, because it was ended early or the log was cut
        warning: axis 3: lines of its measurement are missing, because it was ended early or the log was cut
        axis 1: nominal speed 230.07 degrees/s ± 0.02 %, acceleration 4008.9 degrees/s² ± 0.19 %, deceleration 3700.5 degrees/s² ± 0.18 % (38 measurements, delay 2 ms, residual 1.1 ms)
        axis 2: nominal speed 410.68 degrees/s ± 0.03 %, acceleration 3796.6 degrees/s² ± 0.19 %, deceleration 5881.8 degrees/s² ± 0.23 % (39 measurements, delay 2 ms, residual 1.1 ms)
        axis 3: nominal speed 1801.7 mm/s ± 0.02 %, acceleration 20277 mm/s² ± 0.19 %, deceleration 16332 mm/s² ± 0.17 % (39 measurements, delay 3 ms, residual 1.1 ms)
        warning: axis 4: the log contains no or too few moves of it
    "#]]
    .assert_eq(&fit.stderr);
    let file = folder.read("my.toml");
    let arm = Arm::from_toml(&file).unwrap();
    assert!(!arm.has_measured_times());
    assert_eq!(arm.limits()[3], Arm::by_name("ts2-60").unwrap().limits()[3]);
    expect![[r##"
        # Times of a TS2-60, measured with the application of `val3 arm measure`, with their standard uncertainties.
        #   axis 1: nominal speed 230.07 degrees/s ± 0.02 %, acceleration 4008.9 degrees/s² ± 0.19 %, deceleration 3700.5 degrees/s² ± 0.18 % (38 measurements, delay 2 ms, residual 1.1 ms)
        #   axis 2: nominal speed 410.68 degrees/s ± 0.03 %, acceleration 3796.6 degrees/s² ± 0.19 %, deceleration 5881.8 degrees/s² ± 0.23 % (39 measurements, delay 2 ms, residual 1.1 ms)
        #   axis 3: nominal speed 1801.7 mm/s ± 0.02 %, acceleration 20277 mm/s² ± 0.19 %, deceleration 16332 mm/s² ± 0.17 % (39 measurements, delay 3 ms, residual 1.1 ms)
        #   axis 4: not measured
        # Comments before the measurement:
        #   The height of the flange at axis 3 = 0 and the height of the base are not public: both are 0.
        #   The maximum speeds are those of the TP80.
        #   The nominal speeds are 0.66 times the maximum speeds.
        #   Accelerations and decelerations reach the nominal speed in 0.2 s.
        name = "TS2-60"
        kind = "scara"
        sources = [
          "robotkinematicscatalogue 1.1.2",
          "published range page: payload and reach",
          "measured with the application of `val3 arm measure`",
        ]
        # The entries below that no public source settles.
        model = ["height", "z0", "maximum_speed", "nominal_speed", "acceleration", "deceleration", "shapes"]

        # Lengths in mm.
        [geometry]
        l1 = 380
        l2 = 240
        z0 = 0
        height = 0

        # Degrees, degrees/s and degrees/s²; for axis 3 mm, mm/s and mm/s².
        [axes]
        min = [-180, -141.5, 0, -500]
        max = [180, 141.5, 200, 500]
        nominal_speed = [230.07, 410.68, 1801.7, 1584.0]
        maximum_speed = [525, 525, 2000, 2400]
        acceleration = [4008.9, 3796.6, 20277.0, 7920.0]
        deceleration = [3700.5, 5881.8, 16332.0, 7920.0]

        # Kilograms.
        [payload]
        maximum = 8.4

        # By drawings of arms of this size: no mesh is public.
        [shapes]
        base = [{ from = [0, 0, -150], to = [0, 0, 60], radius = 90 }]
        link1 = [{ from = [0, 0, 90], to = [380, 0, 90], radius = 70 }]
        link2 = [{ from = [0, 0, 230], to = [240, 0, 230], radius = 75 }]
        link3 = [{ from = [0, 0, 0], to = [0, 0, 300], radius = 12 }]
        link4 = [{ from = [0, 0, -10], to = [0, 0, -10], radius = 25 }]
    "##]]
    .assert_eq(&file);

    // The measured file is a valid base for another measurement.
    let again = folder.val3(&["arm", "fit", "cut.log", "--arm", "my.toml"]);
    assert_eq!(again.stdout, file);
}

#[test]
fn a_log_without_measurements_is_an_error() {
    let folder = Folder::empty();
    folder.write("empty.log", "");
    folder.write("two.log", "val3arm begin arm=TX2-60L axes=6\nval3arm begin arm=TX2-90 axes=6\n");
    for (log, message) in [
        (
            "empty.log",
            expect![[r#"
                warning: axis 1: the log contains no or too few moves of it
                warning: axis 2: the log contains no or too few moves of it
                warning: axis 3: the log contains no or too few moves of it
                warning: axis 4: the log contains no or too few moves of it
                error: the log determines the times of no axis, so no file is written
                  help: measure at least one axis with the application of `val3 arm measure`
            "#]],
        ),
        (
            "two.log",
            expect![[r#"
                error: the log contains measurements of several arms: TX2-60L, TX2-90
                  help: copy the lines of one arm into a file of their own
            "#]],
        ),
        (
            "missing.log",
            expect![[r#"
                error: cannot read `missing.log`: it does not exist
            "#]],
        ),
    ] {
        refused(&folder, &["arm", "fit", log, "--arm", "ts2-60"], message);
    }
}
