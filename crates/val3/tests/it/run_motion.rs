//! Motion reports of `val3 run`: trace, picture, times.

use std::io::Read as _;
use std::path::Path;
use std::process::Command;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use expect_test::{expect, expect_file};
use flate2::read::GzDecoder;
use serde_json::Value;

use crate::support::{Folder, run};

/// A joint move of 90 degrees, a pause of 1 s, and a line.
const MOVES: &str = "mdesc mStop\njoint jReady\npoint pNear\n  mStop.blend=off\n  enablePower()\n  wait(isPowered())\n  \
                     jReady={90,0,90,0,90,0}\n  movej(jReady,flange,mStop)\n  waitEndMove()\n  delay(1)\n  \
                     pNear=here(flange,world)\n  pNear.trsf.x=pNear.trsf.x+100\n  movel(pNear,flange,mStop)\n  \
                     waitEndMove()\n";

/// Rows of a trace without its head, as texts.
fn rows(text: &str) -> Vec<Vec<&str>> {
    text.lines().skip(1).map(|line| line.split(',').collect()).collect()
}

#[test]
fn the_trace_has_the_arm_every_4_ms_while_it_moves() {
    let folder = Folder::with(MOVES);
    assert_eq!(folder.val3(&["run", "--arm", "TX2-90", "--trace", "trace.csv"]).code, 0);
    let text = folder.read("trace.csv");
    assert_eq!(text.lines().next(), Some("t,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v,limit"));
    let rows = rows(&text);
    let number = |row: &[&str], column: usize| row[column].parse::<f64>().unwrap();
    assert_eq!((rows[0][0], rows[0][2]), ("1.008", "nominal"));
    let rest = rows.iter().find(|row| row[2] == "waiting").unwrap();
    assert_eq!((rest[3], rest[7], rest[1]), ("90.0000000", "90.0000000", "1.000000"));
    let last = rows.last().unwrap();
    assert!((number(last, 9) - number(rest, 9) - 100.0).abs() < 1e-6 && last[1] == "2.000000", "{last:?}");
    for pair in rows.windows(2).filter(|pair| pair[0][2] == "nominal") {
        assert!((number(&pair[1], 0) - number(&pair[0], 0) - 0.004).abs() < 1e-9, "{pair:?}");
    }
}

/// Messages of an exported recording: `u8` kind, `u32` length, content.
fn frames(page: &str) -> Vec<(u8, Vec<u8>)> {
    let (_, recording) = page.split_once("<body><script id=\"recording\" type=\"text/plain\">").unwrap();
    let packed = BASE64_STANDARD.decode(recording.split_once("</script>").unwrap().0).unwrap();
    let mut bytes = Vec::new();
    GzDecoder::new(&packed[..]).read_to_end(&mut bytes).unwrap();
    let (mut frames, mut rest) = (Vec::new(), &bytes[..]);
    while let [kind, a, b, c, d, content @ ..] = rest {
        let (frame, after) = content.split_at(u32::from_le_bytes([*a, *b, *c, *d]) as usize);
        frames.push((*kind, frame.to_vec()));
        rest = after;
    }
    frames
}

#[test]
fn an_exported_page_has_the_whole_run() {
    let folder = Folder::with(MOVES);
    assert_eq!(folder.val3(&["run", "--arm", "TX2-90", "--trace", "trace.csv", "--export", "run.html"]).code, 0);
    let page = folder.read("run.html");
    assert!(page.ends_with("</html>\n") || page.ends_with("</html>"), "{}", &page[page.len() - 40..]);
    let frames = frames(&page);
    let objects = frames.iter().filter(|(kind, _)| *kind == 0);
    let objects: Vec<Value> = objects.map(|(_, text)| serde_json::from_slice(text).unwrap()).collect();
    assert_eq!((&objects[0]["kind"], &objects[0]["role"]), (&"scene".into(), &"recording".into()));
    assert_eq!(objects.last().unwrap()["reason"], "finished");
    let samples = frames.iter().filter(|(kind, _)| *kind == 1);
    let count: usize = samples.map(|(_, batch)| u32::from_le_bytes(batch[4..8].try_into().unwrap()) as usize).sum();
    let moving = rows(&folder.read("trace.csv")).len();
    assert!(count >= moving && count < moving + 10, "{count} samples, {moving} rows");
}

#[test]
fn the_whole_trace_has_every_cycle() {
    let folder = Folder::with(MOVES);
    assert_eq!(folder.val3(&["run", "--arm", "TX2-90", "--trace-all", "trace.csv"]).code, 0);
    let text = folder.read("trace.csv");
    let rows = rows(&text);
    for (cycle, row) in rows.iter().enumerate() {
        assert_eq!(row[0], format!("{:.3}", cycle as f64 * 0.004));
    }
    assert!(rows.len() > 600 && rows[0][2] == "waiting", "{}", rows.len());
}

#[test]
fn the_times_of_a_run_are_those_of_its_lines() {
    let folder = Folder::with(MOVES);
    let run = folder.val3(&["run", "--arm", "TX2-90", "--times"]);
    assert!(run.stderr.contains("start:9   nominal"), "{}", run.stderr);
    assert_eq!(folder.val3(&["run", "--arm", "TX2-90", "--times=times.json"]).code, 0);
    let report: Value = serde_json::from_str(&folder.read("times.json")).unwrap();
    let sum = |part: &str| sum(&report[part], "seconds");
    let duration = report["duration"].as_f64().unwrap();
    assert!((sum("arm") - duration).abs() < 1e-9 && (sum("tasks") - duration).abs() < 0.01, "{report:#}");
    let delay = report["tasks"].as_array().unwrap().iter().find(|row| row["what"] == "time (`delay`)").unwrap();
    assert_eq!(delay["seconds"], 1.0, "{report:#}");
}

/// Sum of a field in an array.
fn sum(rows: &Value, field: &str) -> f64 {
    rows.as_array().unwrap().iter().map(|row| row[field].as_f64().unwrap()).sum()
}

/// The slow line is limited by its `tvel`; at 10 %, only the monitor speed limits the arm.
#[test]
fn each_line_has_the_limits_of_its_speed() {
    let folder = Folder::with(&format!(
        "{MOVES}  mStop.tvel=50\n  pNear.trsf.z=pNear.trsf.z-100\n  movel(pNear,flange,mStop)\n  waitEndMove()\n"
    ));
    expect![[r#"
        arm
        2.012 s  42.4 %            no move
        2.004 s  42.2 %  start:18  nominal  100 % tvel
        0.540 s  11.4 %  start:9   nominal  38 % deceleration of axis 1, 36 % acceleration of axis 1, 26 % speed of axis 1
        0.192 s   4.0 %  start:14  nominal  52 % deceleration of axis 1, 48 % acceleration of axis 1
        0.004 s   0.1 %  ~main            computing
        73 % of the moving time is limited by tvel: raise it in the motion descriptor
    "#]].assert_eq(&arm_times(&folder, "100"));
    expect![[r#"
        arm
        20.040 s  68.3 %  start:18  nominal  100 % monitor speed
        5.400 s  18.4 %  start:9   nominal  100 % monitor speed
        2.012 s   6.9 %            no move
        1.908 s   6.5 %  start:14  nominal  100 % monitor speed
        0.004 s   0.0 %  ~main            computing
        100 % of the moving time is limited by the monitor speed: raise it to 100 %
    "#]]
    .assert_eq(&arm_times(&folder, "10"));

    assert_eq!(folder.val3(&["run", "--arm", "TX2-90", "--times=times.json", "--trace", "trace.csv"]).code, 0);
    let report: Value = serde_json::from_str(&folder.read("times.json")).unwrap();
    for row in report["arm"].as_array().unwrap() {
        assert!((sum(&row["limits"], "seconds") - row["seconds"].as_f64().unwrap()).abs() < 1e-9, "{row:#}");
        assert!((sum(&row["limits"], "share") - 100.0).abs() < 1e-9, "{row:#}");
    }
    let trace = folder.read("trace.csv");
    let mut limits: Vec<&str> = rows(&trace).iter().map(|row| row[16]).collect();
    limits.dedup();
    expect![[r#"
        acceleration of axis 1
        speed of axis 1
        deceleration of axis 1
        end
        acceleration of axis 1
        deceleration of axis 1
        acceleration of axis 3
        tvel
        deceleration of axis 5
        end"#]]
    .assert_eq(&limits.join("\n"));
}

/// Times of the arm in the table of a run.
fn arm_times(folder: &Folder, monitor_speed: &str) -> String {
    let run = folder.val3(&["run", "--arm", "TX2-90", "--times", "--monitor-speed", monitor_speed]);
    let lines = run.stderr.lines().skip_while(|line| !line.ends_with("arm"));
    let without_tasks = lines.filter(|line| !line.contains("main~") && !line.ends_with("tasks"));
    without_tasks.map(|line| line.trim_start().to_owned() + "\n").collect()
}

#[test]
fn a_file_that_cannot_be_written_is_a_message_before_the_run() {
    let folder = Folder::with(MOVES);
    for (option, what) in [("--trace", "trace"), ("--trace-all", "trace"), ("--plot", "picture"), ("--times", "times")]
    {
        let run = folder.val3(&["run", &format!("{option}=missing/file")]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
        assert!(run.stderr.contains(&format!("cannot write the {what} to `missing/file`")), "{}", run.stderr);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_message() {
    let folder = Folder::with(MOVES);
    for (option, what) in [("--trace", "trace"), ("--plot", "picture"), ("--times", "times"), ("--export", "page")] {
        let run = folder.val3(&["run", "--arm", "TX2-90", &format!("{option}=/dev/full")]);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(run.stderr.contains(&format!("cannot write the {what} to `/dev/full`")), "{}", run.stderr);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn an_output_that_cannot_be_written_does_not_prevent_the_others() {
    let folder = Folder::with(MOVES);
    let options =
        ["--trace=/dev/full", "--times=/dev/full", "--plot=path.svg", "--result=result.json", "--export=page.html"];
    let run = folder.val3(&[&["run", "--arm", "TX2-90"], &options[..]].concat());
    assert_eq!(run.code, 2, "{run:?}");
    for what in ["trace", "times"] {
        assert_eq!(run.stderr.matches(&format!("error: cannot write the {what} to `/dev/full`")).count(), 1, "{run:?}");
    }
    let result: Value = serde_json::from_str(&folder.read("result.json")).unwrap();
    assert_eq!((&result["ok"], &result["exit_code"]), (&false.into(), &2.into()), "{result}");
    assert!(folder.read("path.svg").ends_with("</svg>\n") && folder.read("page.html").contains("</script>"));
}

/// If a run ends with an error, the picture shows the motion before the error.
#[test]
fn the_picture_shows_what_was_reached() {
    let folder = Folder::with(&format!("{MOVES}  pNear.trsf.x=9999\n  movel(pNear,flange,mStop)\n"));
    assert_eq!(folder.val3(&["run", "--arm", "TX2-90", "--plot", "path.svg"]).code, 1);
    let picture = folder.read("path.svg");
    assert!(
        picture.contains(">9<") && picture.contains(">14<") && picture.contains("2 moves (lines of start)"),
        "{picture}"
    );
}

/// A half circle at a low speed, a blend that is shortened because the last move's leave distance counts until it is
/// cancelled, and the stop.
const CIRCLE: &str = "mdesc mSlow\npoint pA\npoint pPick\n  enablePower()\n  wait(isPowered())\n  pA=here(flange,world)\n  \
                      mSlow.tvel=250\n  movec(appro(pA,{100,100,0,0,0,0}),appro(pA,{0,200,0,0,0,0}),flange,mSlow)\n  \
                      pPick=appro(pA,{60,200,0,0,0,0})\n  movel(pPick,flange,mSlow)\n  waitEndMove()\n";

#[test]
fn the_picture_has_circles_limits_and_shortened_blends() {
    let folder = Folder::with(CIRCLE);
    let start = ["run", "--arm", "TX2-90", "--start=0,0,90,0,90,0", "--monitor-speed", "100", "--plot", "path.svg"];
    assert_eq!(folder.val3(&start).code, 0);
    let picture = folder.read("path.svg");
    for shown in ["intermediate point", "tvel 250", "reach 50 → 30 mm", "at the limit"] {
        assert!(picture.contains(&format!(">{shown}<")), "{shown}: {picture}");
    }
    assert!(!picture.contains("joint accelerations"));
    assert_eq!(folder.val3(&[&start[..], &["--plot-accelerations"]].concat()).code, 0);
    let picture = folder.read("path.svg");
    assert!(picture.contains("joint accelerations") && picture.contains(">accel 100<"), "{picture}");
    assert_eq!(folder.val3(&["run", "--plot-accelerations"]).code, 2);
}

/// Twelve moves of 39 mm with blends of 40 mm, a move with reach 0, and a cancelled blend.
const SHORT_MOVES: &str = "mdesc m\nnum n\npoint p\n  enablePower()\n  wait(isPowered())\n  p=here(flange,world)\n  \
                           m.blend=joint\n  m.leave=40\n  m.reach=40\n  for n=1 to 12\n    \
                           p.trsf.x=p.trsf.x-39*(n%2)\n    p.trsf.y=p.trsf.y+39*(1-n%2)\n    movel(p,flange,m)\n  endFor\n  \
                           m.leave=10\n  m.reach=0\n  p.trsf.z=p.trsf.z-100\n  movel(p,flange,m)\n  m.reach=10\n  \
                           p.trsf.y=p.trsf.y-5\n  movel(p,flange,m)\n  waitEndMove()\n";

#[test]
fn blends_cut_short_are_told_with_their_reasons() {
    let folder = Folder::with(SHORT_MOVES);
    let args = ["run", "--arm", "TX2-90", "--start=0,0,90,0,90,0", "--monitor-speed", "100"];
    let run = folder.val3(&[&args[..], &["--times", "--plot", "path.svg", "--events", "events.jsonl"]].concat());
    assert_eq!(run.code, 0, "{run:?}");
    let (_, blends) = run.stderr.split_once("  blends").unwrap();
    let blends = format!("blends{blends}");
    expect![[r#"
        blends cut short
                  12 moves  start:14  leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)
                   1 move   start:19  leave 10 → 0 mm (the arm stops at the target, because reach is 0)
                   1 move   start:22  leave 10 → 0 mm (cancelled by start:23), reach 10 → 0 mm (cancelled by start:23)
    "#]].assert_eq(&blends);

    let events = folder.read("events.jsonl");
    let moves = events.lines().filter(|line| line.contains("\"requested\""));
    let part = |line: &str| line.split_once("\"id\"").map_or_else(String::new, |(_, rest)| format!("\"id\"{rest}\n"));
    let moves: Vec<String> = moves.map(part).collect();
    let (first, last) = (moves.get(..4).unwrap_or_default(), moves.get(moves.len() - 3..).unwrap_or_default());
    expect![[r#"
        "id":0.0,"phase":"recorded","type":"movel","program":"start","line":14,"leave":{"requested":40.0,"effective":39.0,"reason":"shortMove","program":"start","line":14}}
        "id":1.0,"phase":"recorded","type":"movel","program":"start","line":14,"leave":{"requested":40.0,"effective":19.5,"reason":"sharedWithPrevious","program":"start","line":14}}
        "id":2.0,"phase":"recorded","type":"movel","program":"start","line":14,"leave":{"requested":40.0,"effective":19.5,"reason":"sharedWithPrevious","program":"start","line":14}}
        "id":3.0,"phase":"recorded","type":"movel","program":"start","line":14,"leave":{"requested":40.0,"effective":19.5,"reason":"sharedWithPrevious","program":"start","line":14}}
        "id":11.0,"phase":"blend","type":"movel","program":"start","line":14,"leave":{"requested":40.0,"effective":19.5,"reason":"sharedWithPrevious","program":"start","line":14},"reach":{"requested":40.0,"effective":40.0}}
        "id":12.0,"phase":"blend","type":"movel","program":"start","line":19,"leave":{"requested":10.0,"effective":0.0,"reason":"stopAtTarget"},"reach":{"requested":0.0,"effective":0.0}}
        "id":13.0,"phase":"done","type":"movel","program":"start","line":22,"leave":{"requested":10.0,"effective":0.0,"reason":"cancelled","program":"start","line":23},"reach":{"requested":10.0,"effective":0.0,"reason":"cancelled","program":"start","line":23}}
    "#]].assert_eq(&[first, last].concat().concat());

    let picture = folder.read("path.svg");
    let notes = picture.lines().filter(|line| line.contains("class=\"note\""));
    let text = |line: &str| line.split_once('>').map_or_else(String::new, |(_, text)| format!("{text}\n"));
    expect![[r#"
        leave 40 → 39 mm, reach 40 → 19.5 mm<title>leave 40 → 39 mm (length of the move of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
        leave 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14)</title></text>
        leave 10 → 0 mm<title>leave 10 → 0 mm (the arm stops at the target, because reach is 0)</title></text>
        leave 40 → 19.5 mm, reach 40 → 19.5 mm<title>leave 40 → 19.5 mm (shared with the reach of start:14), reach 40 → 19.5 mm (shared with the leave of start:14)</title></text>
    "#]].assert_eq(&notes.map(text).collect::<String>());

    assert_eq!(folder.val3(&[&args[..], &["--times=times.json"]].concat()).code, 0);
    let report: Value = serde_json::from_str(&folder.read("times.json")).unwrap();
    let row = &report["blends"][0];
    let reach = &row["reach"];
    assert_eq!(
        (&row["moves"], &row["program"], &reach["requested"]),
        (&12.into(), &"start".into(), &40.0.into()),
        "{report:#}"
    );
    assert_eq!(reach["reason"], "sharedWithNext", "{report:#}");
}

/// The picture in the README, drawn by the command next to it.
#[test]
fn the_picture_of_the_palletiser_is_up_to_date() {
    let cell = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/palletiser");
    let folder = Folder::empty();
    let file = folder.path().join("palletiser.svg");
    let mut command = Command::new(env!("CARGO_BIN_EXE_val3"));
    command.current_dir(cell).args(["run", "usr/usrapp/palletiser", "--script", "boxes.toml", "--until", "11"]);
    command.args(["--until-ok", "--plot", file.to_str().unwrap()]);
    let run = run(command);
    assert_eq!(run.code, 0, "{run:?}");
    expect_file!["../../../../docs/src/palletiser.svg"].assert_eq(&folder.read("palletiser.svg"));
}

#[test]
fn a_run_can_start_with_power_and_anywhere_within_the_limits() {
    let folder = Folder::with("  ? isPowered()\n  ? herej()\n");
    let start = "--start=10,-20,90,0,45,0";
    let run = folder.val3(&["run", "--arm", "TX2-90", "--power", start]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.stdout.contains("true") && run.stdout.contains("{10,-20,90,0,45,0}"), "{}", run.stdout);
    let run = folder.val3(&["run", "--arm", "TX2-90", "--start=10,-20,290"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: the arm cannot start at [10.0, -20.0, 290.0]: the arm has 6 axes
          help: write 6 numbers, in degrees (a stroke in mm), with `--start` or in `[run] start`
    "#]]
    .assert_eq(&run.stderr);
    let run = folder.val3(&["run", "--arm", "TX2-90", "--start=10,-20,190,0,0,0"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: the arm cannot start at [10.0, -20.0, 190.0, 0.0, 0.0, 0.0]: axis 3 would be at 190.000, outside its range from -145 to 145 degrees
          help: write 6 numbers, in degrees (a stroke in mm), with `--start` or in `[run] start`
    "#]]
    .assert_eq(&run.stderr);
}

/// The note appears once for a trace and a table. It does not appear without a motion, for a measured arm, or without
/// these options.
#[test]
fn times_of_a_model_arm_are_noted_once() {
    let folder = Folder::with(MOVES);
    let notes = |args: &[&str]| model_notes(&folder, args);
    expect![[r#"
        note: times of a model arm: the speeds and accelerations of the TX2-90 are not measured; `val3 arm measure` measures yours
    "#]].assert_eq(&notes(&["--times", "--trace", "trace.csv"]));
    assert_eq!(folder.read("trace.csv").lines().next(), Some("t,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v,limit"));
    assert_eq!(notes(&["--times=times.json"]), notes(&["--trace", "trace.csv"]));
    assert!(folder.read("times.json").contains("\"times\": \"model\""));
    assert_eq!(notes(&["--plot", "plot.svg"]), "");
    let idle = Folder::with("? 1").val3(&["run", "--arm", "TX2-90", "--times"]);
    assert!(!idle.stderr.contains("model arm"), "{}", idle.stderr);

    let shipped = include_str!("../../../val3-kinematics/arms/tx2-90.toml");
    let models = |line: &&str| !line.starts_with("model = ");
    let lines: Vec<&str> = shipped.lines().filter(models).collect();
    folder.write("mine.toml", &format!("times = \"measured\"\n{}\n", lines.join("\n")));
    let run = folder.val3(&["run", "--arm", "mine.toml", "--times=times.json"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    assert!(folder.read("times.json").contains("\"times\": \"measured\""));
}

/// Notes of a run about times of a model arm.
fn model_notes(folder: &Folder, args: &[&str]) -> String {
    let run = folder.val3(&[&["run", "--arm", "TX2-90"], args].concat());
    let lines = run.stderr.lines().filter(|line| line.contains("model arm"));
    lines.map(|line| line.to_owned() + "\n").collect()
}
