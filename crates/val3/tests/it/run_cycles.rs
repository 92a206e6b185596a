//! Cycle times of `val3 run`.

use serde_json::Value;

use crate::support::{CommandOutput, Folder};

/// Four cycles with two moves and a pause. A variable is set in each of them.
const CYCLES: &str = "num nCount\nmdesc mA\njoint jA\njoint jB\n  jA={30,0,90,0,60,0}\n  jB={0,0,90,0,60,0}\n  \
                      mA.blend=off\n  for nCount=1 to 4\n    movej(jA,flange,mA)\n    movej(jB,flange,mA)\n    \
                      waitEndMove()\n    ? \"done\"\n    delay(0.5)\n  endFor\n";

fn run(folder: &Folder, options: &[&str]) -> CommandOutput {
    folder.val3(&[&["run", "--arm", "TX2-60L", "--power", "--start", "0,0,90,0,60,0"], options].concat())
}

/// Cycles in a file of `--times`.
fn cycles(folder: &Folder, file: &str) -> Value {
    let report: Value = serde_json::from_str(&folder.read(file)).unwrap();
    report["cycles"].clone()
}

#[test]
fn the_cycles_of_a_move_have_their_times_and_parts() {
    let folder = Folder::with(CYCLES);
    let listed = run(&folder, &["--cycles"]);
    assert_eq!(listed.code, 0, "{}", listed.stderr);
    let event =
        listed.stderr.lines().find_map(|line| Some(format!("move = {}", line.split_once("move = ")?.1))).unwrap();
    assert!(listed.stderr.contains("events that repeat") && event.starts_with("move = 'start:"), "{}", listed.stderr);

    let measured = run(&folder, &[&format!("--cycles={event}"), "--times=times.json"]);
    assert!(measured.stderr.contains(&format!("3 cycles of {event}\n")), "{}", measured.stderr);
    assert!(measured.stderr.contains("%  the arm moves") && measured.stderr.contains("%  waits for time"));
    let report = cycles(&folder, "times.json");
    let number = |key: &str| report[key].as_f64().unwrap();
    assert_eq!((&report["count"], report["cycles"].as_array().unwrap().len()), (&Value::from(3), 3));
    assert!((number("time") - 0.5).abs() <= 0.008 && number("outside") == 0.0, "{report}");
    let total: f64 = ["moving", "outside", "arm", "time", "other"].into_iter().map(number).sum();
    assert!((total - number("mean")).abs() <= 0.004 && number("min") <= number("mean"), "{report}");
    assert!(number("mean") <= number("max") && number("first") <= number("max"), "{report}");
}

#[test]
fn cycles_are_compared_with_an_earlier_run() {
    let folder = Folder::with(CYCLES);
    assert_eq!(run(&folder, &["--cycles=print = 'done'", "--times=before.json"]).code, 0);
    let same = run(&folder, &["--against", "before.json"]);
    assert!(same.stderr.contains("3 cycles of print = 'done', against 3 in before.json"), "{}", same.stderr);
    assert!(same.stderr.contains("+0.0 %  mean"), "{}", same.stderr);

    let slow = run(&folder, &["--against", "before.json", "--monitor-speed", "50", "--times=slow.json"]);
    let mean = |file: &str| cycles(&folder, file)["mean"].as_f64().unwrap();
    let change = format!("{:+.1} %  mean", (mean("slow.json") / mean("before.json") - 1.0) * 100.0);
    assert!(mean("slow.json") > 1.1 * mean("before.json") && slow.stderr.contains(&change), "{}", slow.stderr);
}

#[test]
fn an_event_without_a_complete_cycle_is_explained() {
    let run = run(&Folder::with(CYCLES), &["--cycles=print = 'finished'"]);
    let note = "note: there is no complete cycle, because it never happens that \"finished\" is printed\n";
    assert!(run.code == 0 && run.stderr.contains(note) && run.stderr.contains("move = 'start:"), "{}", run.stderr);
}

#[test]
fn invalid_events_and_files_are_rejected_before_the_run() {
    let folder = Folder::with(CYCLES);
    for (options, reason) in [
        (vec!["--cycles=pick"], "`pick` is no event of a cycle: "),
        (vec!["--cycles=move = 'pick'"], "there is no program `pick`"),
        (vec!["--against", "none.json"], "cannot compare with `none.json`"),
        (vec!["--against", "usrapp/main/main.dtx"], "cannot compare with `usrapp/main/main.dtx`"),
    ] {
        let rejected = run(&folder, &options);
        assert_eq!((rejected.code, rejected.stdout.as_str()), (2, ""), "{options:?}");
        assert!(rejected.stderr.contains(reason), "{}", rejected.stderr);
    }
}
