//! `val3 run`.

use std::io::Read as _;
use std::process::Stdio;

use serde_json::Value;

use crate::support::{CommandOutput, FAULTY, Folder};

/// An application with run-time error 10 in a separate task, and the reaction of `start`.
fn failing(answer: &str) -> Folder {
    Folder::with(&format!(
        r#"
num nZero
program divide()
begin
  // half of nothing
  nZero=1/nZero
end
program start()
begin
  taskCreate "divide",10,divide()
  wait(taskStatus("divide")!=1)
  {answer}
end
program stop()
begin
  ? "stop"
end
"#
    ))
}

const ENDLESS: &str = r#"
    num nCount
    program start()
    begin
      while true
        nCount=nCount+1
        ? nCount
        delay(1)
      endWhile
    end
    program stop()
    begin
    end
"#;

#[track_caller]
fn ends(run: &CommandOutput, code: i32, stdout: &str) {
    assert_eq!((run.code, run.stdout.as_str()), (code, stdout), "{run:?}");
}

#[test]
fn an_application_runs_to_its_end() {
    let folder = Folder::with("? \"hello\"\ndelay(3600)\n? roundDown(clock())\n");
    for arguments in [&["run"][..], &["run", "usrapp/main"], &["run", "usrapp/main/main.pjx"]] {
        let run = folder.val3(arguments);
        ends(&run, 0, "hello\n3600\n");
        assert_eq!(run.stderr, "");
    }
}

#[test]
fn an_unhandled_error_is_a_failure() {
    let run = failing("taskSuspend(\"divide\")").val3(&["run"]);
    ends(&run, 1, "");
    insta::assert_snapshot!(run.stderr);
}

#[test]
fn an_error_that_another_task_handles_is_no_failure() {
    let handled = "taskKill(\"divide\")";
    ends(&failing(handled).val3(&["run"]), 0, "stop\n");
    let repaired = "nZero=2\n  taskResume(\"divide\",0)";
    ends(&failing(repaired).val3(&["run"]), 0, "stop\n");
}

/// Only errors that are unhandled at the end of the run are failures.
#[test]
fn a_handled_error_is_not_shown() {
    let run = failing("taskKill(\"divide\")").val3(&["run"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    let events = failing("taskKill(\"divide\")").val3(&["run", "--events", "-"]);
    assert!(events.stdout.contains("\"kind\":\"error\""), "the record has it: {events:?}");
}

#[test]
fn an_application_with_faults_does_not_start() {
    let run = Folder::with(FAULTY).val3(&["run"]);
    assert_eq!(run.code, 1, "{run:?}");
    insta::assert_snapshot!(format!("{}{}", run.stdout, run.stderr));
}

#[test]
fn the_time_of_a_run_can_be_limited() {
    ends(&Folder::with(ENDLESS).val3(&["run", "--until", "2.5"]), 3, "1\n2\n3\n");
}

#[test]
fn the_limit_can_be_the_normal_end() {
    let folder = Folder::with(ENDLESS);
    let limited = folder.val3(&["run", "--until", "2.5"]);
    assert!(limited.stderr.contains("task `main~` waits for time (`delay`) at usrapp/main/start.pgx:"), "{limited:?}");
    let run = folder.val3(&["run", "--until", "2.5", "--until-ok"]);
    ends(&run, 0, "1\n2\n3\n");
    assert_eq!(run.stderr, "");
    let failing = failing("wait(false)").val3(&["run", "--until", "2.5", "--until-ok"]);
    assert_eq!(failing.code, 1, "an error nobody handles stays a failure: {failing:?}");
    assert_eq!(folder.val3(&["run", "--until-ok"]).code, 2, "it needs --until");
}

#[test]
fn a_run_that_cannot_continue_says_why() {
    let folder = Folder::with(
        r#"
bool bGo
num nKey
program work()
begin
  nKey=get()
end
program start()
begin
  taskCreate "work",10,work()
  taskCreate "halted",10,work()
  delay(1)
  taskSuspend("halted")
  wait(bGo)
end
"#,
    );
    let run = folder.val3(&["run"]);
    ends(&run, 1, "");
    insta::assert_snapshot!(run.stderr);
    let told = events(&folder, &[], "stuck");
    let told: Vec<(&str, &str, &str)> = told
        .iter()
        .map(|event| {
            let text = |key: &str| event[key].as_str().unwrap_or_default();
            (text("name"), text("state"), text("awaits"))
        })
        .collect();
    let expected =
        [("main~", "waiting", "a condition"), ("work", "waiting", "the operator (`get`)"), ("halted", "suspended", "")];
    assert_eq!(told, expected);
}

#[test]
fn a_library_that_is_missing_names_its_path() {
    let folder = Folder::with(
        "library io \"Disk://ioBoard/ioBoard.pjx\"\nprogram start()\nbegin\n  ? \"start\"\n  ? io:nInput\nend",
    );
    folder.write("val3.toml", "[rules]\nall=\"off\"\n");
    let run = folder.val3(&["run"]);
    ends(&run, 1, "start\n");
    let reason =
        "= help: The library `io` could not be loaded from `Disk://ioBoard/ioBoard.pjx`: code 39, file not found.";
    assert!(run.stderr.contains("error[80]") && run.stderr.contains(reason), "{run:?}");
    std::fs::remove_file(folder.path().join("val3.toml")).unwrap();
    let run = folder.val3(&["run"]);
    ends(&run, 1, "start\n");
    assert!(run.stderr.starts_with("error[V0501]"), "{run:?}");
}

#[test]
fn scripts_can_only_name_existing_items() {
    let folder = Folder::with(
        "num nKey\nnum nList[2]\nnum nGrown[1]\nstring sName[\"\"]\ndio dStart\nprogram start()\nbegin\n  \
         resize(nGrown,1,5)\n  delay(1)\nend\n",
    );
    let data = folder.read("usrapp/main/main.dtx");
    let linked =
        r#"name="dStart" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\Go" /></Data>"#;
    let (before, rest) = data.split_once("name=\"dStart\"").unwrap();
    let (_, behind) = rest.split_once("/>").unwrap();
    folder.write("usrapp/main/main.dtx", &format!("{before}{linked}{behind}"));
    for (entry, message) in [
        ("set = { nKye = 4 }", "t = 0.5: there is no variable `nKye`; did you mean `nKey`?"),
        ("set = { \"lib:nKey\" = 4 }", "there is no variable `lib:nKey`"),
        ("set = { nKey = \"four\" }", "`nKey` is of type num and does not take this value"),
        ("set = { \"nList[2]\" = 1 }", "`nList` does not have this index"),
        ("set = { sName = \"a\" }", "`sName` is a collection"),
        ("io = { \"Io\\\\Og\" = true }", "no input or output is called `Io\\Og`; did you mean `Io\\Go`?"),
        ("lock = \"Io\\\\Stop\"", "no input or output is called `Io\\Stop`"),
        ("simulate = { \"Io\\\\Stop\" = true }", "no input or output is called `Io\\Stop`"),
        ("fault = { link = \"Io\\\\Og\", code = -3 }", "no input or output is called `Io\\Og`"),
        ("fault = { link = \"Io\\\\Go\", code = -7 }", "fails with -2 or -3"),
    ] {
        folder.write("cell.toml", &format!("[[at]]\nt = 0.5\n{entry}\n"));
        let run = folder.val3(&["run", "--script", "cell.toml", "--events", "run.json"]);
        ends(&run, 2, "");
        assert!(run.stderr.contains(message), "{entry}: {}", run.stderr);
    }
    let all = "set = { nKey = 4, \"nList[1]\" = 1, \"nGrown[4]\" = 1, 'sName[\"a\"]' = \"a\" }\n\
               io = { \"Io\\\\Go\" = true, Go = true }\nlock = \"Io\\\\Go\"\n";
    folder.write("cell.toml", &format!("[[at]]\nt = 0.5\n{all}fault = {{ link = \"Io\", code = 5 }}\n"));
    assert_eq!(folder.val3(&["run", "--script", "cell.toml"]).code, 0);
}

/// A run that ends at its limit, and its recording.
fn recorded(listing: &str) -> Folder {
    let folder = Folder::with(listing);
    folder.val3(&["run", "--until", "2.5", "--events", "first.json"]);
    folder
}

#[test]
fn a_replay_ends_where_the_recording_ends() {
    let folder = recorded(ENDLESS);
    let run = folder.val3(&["run", "--replay", "first.json", "--events", "again.json"]);
    ends(&run, 0, "1\n2\n3\n");
    assert_eq!(run.stderr, "");
    assert_eq!(folder.read("again.json"), folder.read("first.json"));
    // The recorded run was killed while it wrote a line.
    let whole = folder.read("first.json");
    folder.write("cut.json", &whole[..whole.len() - 20]);
    ends(&folder.val3(&["run", "--replay", "cut.json"]), 0, "1\n2\n3\n");
}

#[test]
fn a_replay_reports_the_first_difference() {
    let folder = recorded(ENDLESS);
    let program = folder.read("usrapp/main/start.pgx");
    folder.write("usrapp/main/start.pgx", &program.replace("? nCount", "? nCount*nCount"));
    let run = folder.val3(&["run", "--replay", "first.json"]);
    ends(&run, 1, "1\n4\n9\n");
    assert_eq!(run.stderr.matches("differs").count(), 1, "{run:?}");
    assert!(run.stderr.starts_with("error: the run differs from `first.json` at line 4\n  recorded: {"), "{run:?}");
    // A run that ends before the recording also differs.
    folder.write("usrapp/main/start.pgx", &program.replace("while true", "while nCount<2"));
    let run = folder.val3(&["run", "--replay", "first.json"]);
    ends(&run, 1, "1\n2\n");
    assert!(run.stderr.contains("differs"), "{run:?}");
}

#[test]
fn keys_are_typed_as_in_a_script() {
    let folder = Folder::with("num nValue\nnum nKey\nprogram start()\nbegin\n  nKey=get(nValue)\n  ? nValue\nend\n");
    for keys in ["12.5{Return}", "49,50,46,53,Return"] {
        ends(&folder.val3(&["run", "--keys", keys]), 0, "12.5\n");
    }
    folder.write("people.toml", "[[at]]\nt = 0\nkeys = \"12.5{Return}\"\n");
    ends(&folder.val3(&["run", "--script", "people.toml"]), 0, "12.5\n");
}

#[test]
fn the_message_about_an_unknown_program_lists_the_others() {
    let run = failing("delay(0)").val3(&["run", "--program", "devide"]);
    ends(&run, 2, "");
    let help = "did you mean `divide`? choose one of its programs with --program: divide, start, stop";
    assert!(run.stderr.contains(help), "{run:?}");
}

#[test]
fn equal_runs_write_equal_events() {
    let folder = Folder::with(ENDLESS);
    let first = folder.val3(&["run", "--until", "2.5", "--events", "-"]);
    let lines: Vec<&str> = first.stdout.lines().collect();
    assert_eq!((first.code, lines.len()), (3, 6), "{first:?}");
    assert!(lines[0].starts_with(r#"{"t":0.0,"kind":"begin","options":{"program":"start","#), "{first:?}");
    assert!(lines[5].ends_with(r#""kind":"end","reason":"limit"}"#), "{first:?}");
    ends(&folder.val3(&["run", "--until", "2.5", "--events", "again.jsonl"]), 3, "1\n2\n3\n");
    assert_eq!(folder.read("again.jsonl"), first.stdout);
}

#[test]
fn a_program_with_parameters_cannot_be_started() {
    let folder = Folder::with("program count(num& x_nParts)\nbegin\n  x_nParts=1\nend\nprogram start()\nbegin\nend");
    let run = folder.val3(&["run", "--program", "count"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""));
    assert!(run.stderr.starts_with("error: a run cannot start `count`, because it has parameters\n"), "{run:?}");
}

#[test]
fn another_program_can_be_started() {
    let folder = failing("taskKill(\"divide\")");
    ends(&folder.val3(&["run", "--program", "stop"]), 0, "stop\nstop\n");
}

#[test]
fn a_script_and_keys_replace_the_operator() {
    let folder = Folder::with("num nKey\nnKey=get()\n? nKey\nwait(nKey==4)\n? clock()\n");
    folder.write("people.toml", "[[at]]\nt = 2\nset = { nKey = 4 }\n");
    ends(&folder.val3(&["run", "--keys", "271", "--script", "people.toml"]), 0, "271\n2\n");
    ends(&folder.val3(&["run", "--keys", "F1", "--script", "people.toml"]), 0, "271\n2\n");
}

#[test]
fn wrong_usage_is_refused() {
    let folder = Folder::with(&format!("{ENDLESS}\n    program work(num x_nValue)\n    begin\n    end\n"));
    folder.write("bad.toml", "[[at]]\nt = 2\nsett = { nKey = 4 }\n");
    for (arguments, word) in [
        (&["run", "no/such"][..], "no/such"),
        (&["run", "--program", "nothing"], "nothing"),
        (&["run", "--program", "work"], "cannot start `work`"),
        (&["run", "--until=-1"], "--until"),
        (&["run", "--script", "no.toml"], "no.toml"),
        (&["run", "--script", "bad.toml"], "sett"),
        (&["run", "--events", "no/such/x"], "no/such/x"),
        (&["run", "--monitor-speed", "101"], "101"),
        (&["run", "--keys", "97,Enter"], "`Enter` is not a key"),
    ] {
        let run = folder.val3(arguments);
        ends(&run, 2, "");
        assert!(run.stderr.contains(word), "{arguments:?} {run:?}");
    }
}

#[test]
fn an_application_starts_without_missing_libraries() {
    let folder = Folder::with(
        "library part \"Disk://part/part.pjx\"\nnum nValue\nprogram start()\nbegin\n  ? \"start\"\n  \
         nValue=$read(1)+1\n  ? part:nInput\nend",
    );
    folder.write("val3.toml", "[rules]\nV0501=\"warning\"\n");
    let run = folder.val3(&["run"]);
    ends(&run, 1, "start\n");
    insta::assert_snapshot!(run.stderr);
}

#[test]
fn a_limit_of_the_controller_is_shown_at_its_line() {
    let sums: String = (0..670).map(|line| sum(line * 100)).collect();
    let run = Folder::with(&format!("num n\nprogram start()\nbegin\n  n=1\n{sums}end")).val3(&["run"]);
    ends(&run, 1, "");
    insta::assert_snapshot!(run.stderr);
}

#[test]
fn data_that_no_controller_has_room_for_are_refused_at_their_declaration() {
    let folder = Folder::with("num nSmall\nnum nHuge[65535,65535]\nnSmall=1\nnHuge[0,0]=nSmall\n");
    let check = folder.val3(&["check", "--format", "concise", "--quiet"]);
    let message = "`nHuge` needs 32768 MB, and a controller has 512 MB for all data";
    assert!(check.stdout.contains("usrapp/main/main.dtx:") && check.stdout.contains(message), "{check:?}");
    for run in [folder.val3(&["run"]), folder.val3(&["run", "--scene"])] {
        assert_eq!((run.code, run.stdout.as_str()), (1, ""), "{run:?}");
        assert!(run.stderr.starts_with("error[V0539]") && run.stderr.contains(message), "{run:?}");
    }
    assert_eq!(check.code, 1, "{check:?}");
}

#[test]
fn fields_that_no_controller_has_room_for_are_refused_at_their_declaration() {
    let listing = "type Slot \"Disk://Slot/Slot.pjx\"\nSlot tMany[1000000]\n? tMany[0].nCells[0]\n\
                   --- Slot\npublic num nCells[1000]\n";
    let folder = Folder::with(listing);
    for run in [folder.val3(&["run", "usrapp/main"]), folder.val3(&["run", "usrapp/main", "--scene"])] {
        assert_eq!((run.code, run.stdout.as_str()), (1, ""), "{run:?}");
        assert!(run.stderr.contains("the data need more memory than a controller has"), "{run:?}");
        assert!(run.stderr.contains("`tMany` exceeds") && run.stderr.contains("main.dtx:4"), "{run:?}");
    }
}

fn sum(from: u32) -> String {
    let parts: String = (from..from + 100).map(|number| format!("+{number}")).collect();
    format!("  n=n{parts}\n")
}

/// Events of one kind that a run writes.
fn events(folder: &Folder, arguments: &[&str], kind: &str) -> Vec<Value> {
    let run = folder.val3(&[&["run", "--events", "-"], arguments].concat());
    let events = run.stdout.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    events.filter(|event| event["kind"] == kind).collect()
}

#[test]
fn events_of_tasks_give_the_position_of_the_named_task() {
    let folder = Folder::with(
        r#"
program work()
begin
  while true
    delay(1)
  endWhile
end
program start()
begin
  taskCreate "work",10,work()
  delay(0)
  taskSuspend("work")
  taskResume("work",0)
  taskKill("work")
end
"#,
    );
    let told = events(&folder, &[], "task");
    let told: Vec<String> = told.iter().map(shown_event).collect();
    let expected = [
        "- created main~ start 5",
        "main~ created work work 5",
        "main~ suspended work work 6",
        "main~ resumed work work 6",
        "main~ killed work work 6",
        "main~ ended main~ start 9",
    ];
    assert_eq!(told[..6], expected);
}

/// Task, state, name, program and line in an event about a task.
fn shown_event(event: &Value) -> String {
    let words = ["task", "state", "name", "program"].map(|key| event[key].as_str().unwrap_or("-"));
    format!("{} {}", words.join(" "), event["line"])
}

#[test]
fn a_task_ends_at_the_place_and_time_of_its_last_line() {
    let folder = Folder::with("num n\nprogram before()\nbegin\nend\nprogram start()\nbegin\n  n=1\n  n=n+1\nend\n");
    let told = events(&folder, &["--line-cost", "500"], "task");
    let ended = told.iter().find(|event| event["state"] == "ended").unwrap();
    assert_eq!((&ended["t"], &ended["program"], &ended["line"]), (&0.001.into(), &"start".into(), &6.into()));
}

#[test]
fn a_run_ends_exactly_at_its_limit() {
    let folder = Folder::with("  wait(clock()<0)\n");
    let end = events(&folder, &["--until", "2"], "end");
    assert_eq!((&end[0]["t"], &end[0]["reason"]), (&2.0.into(), &"limit".into()));
}

#[test]
fn a_loop_of_slow_instructions_ends_at_the_limit() {
    let folder = Folder::with("  while true\n    libSave()\n  endWhile\n");
    let saved = events(&folder, &["--until", "0.1"], "lib");
    assert!((5..=25).contains(&saved.len()), "{saved:?}");
    let end = events(&folder, &["--until", "0.1"], "end");
    assert_eq!((&end[0]["t"], &end[0]["reason"]), (&0.1.into(), &"limit".into()));
    let run = folder.val3(&["run", "--until", "0.1"]);
    assert!(run.stderr.contains("task `main~` waits for a file at "), "{run:?}");
}

#[test]
fn only_the_first_of_many_tasks_are_listed() {
    let folder = Folder::with(
        "program start()\n  num i\nbegin\n  for i=1 to 60\n    taskCreate toString(\"\",i),10,idle()\n  endFor\n  \
         wait(false)\nend\nprogram idle()\nbegin\n  wait(false)\nend\n",
    );
    let run = folder.val3(&["run", "--until", "1"]);
    assert_eq!(run.stderr.matches("  task `").count(), 50, "{run:?}");
    assert!(run.stderr.contains("\n  and 11 more tasks\n"), "{run:?}");
}

#[test]
fn the_arm_of_the_cell_has_limits() {
    let ask = |j1: i32, j5: f64| format!("  ? isInRange({{{j1},0,90,0,{j5},0}})\n");
    let code = [ask(0, 140.0), ask(0, 140.5), ask(-170, 0.0), ask(95, 0.0)].concat();
    let folder = Folder::with(&code);
    ends(&folder.val3(&["run"]), 0, "true\nfalse\ntrue\ntrue\n");
    ends(&folder.val3(&["run", "--arm", "tx40"]), 0, "false\nfalse\ntrue\ntrue\n");
    folder.write(
        "configs/arm.cfx",
        "<arm><FloatArray name=\"maxArmJointPos\"><Float index=\"0\" value=\"90\"/></FloatArray>\
         <FloatArray name=\"minArmJointPos\"><Float index=\"0\" value=\"-9999999\"/></FloatArray>\
         <String name=\"arm\" value=\"rx160l-S1\"/></arm>",
    );
    ends(&folder.val3(&["run"]), 0, "false\nfalse\nfalse\nfalse\n");
}

#[test]
fn a_run_whose_tasks_are_all_suspended_does_not_wait_for_its_limit() {
    let folder = Folder::with("  taskSuspend(\"main~\")\n");
    ends(&folder.val3(&["run", "--until", "1000"]), 1, "");
    let end = events(&folder, &["--until", "1000"], "end");
    assert_eq!((&end[0]["t"], &end[0]["reason"]), (&0.004.into(), &"error".into()));
    folder.write("key.toml", "[[at]]\nt = 0\nkey = 97\n");
    let end = events(&folder, &["--script", "key.toml"], "end");
    assert_eq!(end[0]["t"], 0.004, "nobody waits until the key comes up");
    folder.write("operator.toml", "[[at]]\nt = 5\nstop = true\n");
    ends(&folder.val3(&["run", "--until", "1000", "--script", "operator.toml"]), 0, "");
}

/// The controller kills the remaining tasks, which does not count as handling their errors.
#[test]
fn an_error_is_not_handled_by_stopping_the_application() {
    let folder = failing("wait(false)");
    folder.write("operator.toml", "[[at]]\nt = 5\nstop = true\n");
    ends(&folder.val3(&["run", "--script", "operator.toml"]), 1, "stop\n");
}

#[test]
fn the_last_page_is_printed_with_its_title() {
    let folder = Folder::with("  title(\"Line 中\")\n  putln(\"parts: 中文\")\n  put(12)\n");
    let run = folder.val3(&["run", "--screen"]);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!((run.code, lines.len()), (0, 16), "{run:?}");
    assert_eq!(lines[0], format!("+Line 中{}+", "-".repeat(33)));
    assert_eq!(lines[1], format!("|parts: 中文{}|", " ".repeat(29)));
    assert_eq!(lines[2], format!("|12{}|", " ".repeat(38)));
    assert_eq!(lines[15], format!("+{}+", "-".repeat(40)));
    let beside_events = folder.val3(&["run", "--screen", "--events", "-"]);
    assert_eq!(beside_events.stderr, run.stdout);
    assert!(beside_events.stdout.lines().all(|line| line.starts_with('{')), "{beside_events:?}");
}

#[test]
fn the_cell_and_the_arguments_describe_the_controller() {
    let code = "  ? getVersion(\"ArmType\")\n  ? getVersion(\"Mounting\")\n  ? getLanguage()\n  ? getDate(\"%Y-%m-%d %H:%M:%S\")\n";
    let folder = Folder::with(code);
    ends(&folder.val3(&["run"]), 0, "tx2_90-S1\nfloor\nenglish\n2024-01-01 00:00:00\n");
    let entry = |name: &str, value: &str| format!("<String name=\"{name}\" value=\"{value}\"/>");
    let arm = [entry("arm", "rs60-S1-D20-L200"), entry("mount", "ceiling")].concat();
    folder.write("configs/arm.cfx", &format!("<arm>{arm}</arm>"));
    folder.write("configs/cell.cfx", &format!("<cell>{}</cell>", entry("language", "suomi")));
    let date = ["run", "--date", "2007-01-01T13:45:23"];
    ends(&folder.val3(&date), 0, "rs60-S1-D20-L200\nceiling\nsuomi\n2007-01-01 13:45:23\n");
    let run = folder.val3(&["run", "--time", "real", "--arm", "rs40"]);
    let year: u32 = run.stdout.split(['\n', '-']).nth(3).unwrap().parse().unwrap();
    assert!(run.stdout.starts_with("rs40\n") && year > 2024, "{run:?}");
    assert_eq!(folder.val3(&["run", "--date", "2007-02-30T00:00:00"]).code, 2);
}

#[test]
fn each_example_has_equal_events_in_two_runs() {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut ran = 0;
    for cell in ["palletiser", "faulty"] {
        for application in std::fs::read_dir(format!("{examples}/{cell}/usr/usrapp")).unwrap() {
            let folder = Folder::empty();
            let path = application.unwrap().path();
            let path = path.to_str().unwrap();
            let mut arguments = vec!["run", path, "--until", "20", "--events", "events.jsonl"];
            // The script is the host of the palletiser.
            let script = format!("{examples}/palletiser/boxes.toml");
            if path.ends_with("/palletiser") {
                arguments.extend(["--script", &script]);
            }
            let first = output_and_events(&folder, &arguments);
            assert_eq!(first, output_and_events(&folder, &arguments), "{path}");
            ran += usize::from(first.1.is_some_and(|events| events.contains("\"kind\":\"end\"")));
        }
    }
    assert!(ran > 0, "no example has run");
}

/// Exit code and output of a run, and its events if they were written. On a slow machine, the standard error output also
/// contains a note about the tasks that wait.
fn output_and_events(folder: &Folder, arguments: &[&str]) -> ((i32, String), Option<String>) {
    let run = folder.val3(arguments);
    let events = std::fs::read_to_string(folder.path().join("events.jsonl")).ok();
    ((run.code, run.stdout), events)
}

/// `val3 run … | head -3` ends although the application is endless.
#[test]
fn a_run_ends_when_its_output_is_closed() {
    let folder = Folder::with(ENDLESS);
    for arguments in [&["run"][..], &["run", "--events", "-"]] {
        let mut command = folder.command(arguments);
        let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().unwrap();
        let mut first = [0; 3];
        child.stdout.take().unwrap().read_exact(&mut first).unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(0));
    }
}

#[test]
fn a_line_without_link_can_be_connected() {
    let run = Folder::with("sio siHost\nsiHost=\"hello\"\n").val3(&["run"]);
    ends(&run, 1, "");
    assert!(run.stderr.contains("error[123]") && run.stderr.contains("--line"), "{run:?}");
    assert!(run.stderr.contains("^ `siHost` has no link\n"), "{run:?}");
}

#[test]
fn an_error_of_an_index_names_the_index_and_the_size() {
    let run = Folder::with("num nA[3]\nnum nI=3\nwhile nI>=0\nnA[nI]=nI\nendWhile\n").val3(&["run"]);
    ends(&run, 1, "");
    assert!(run.stderr.contains("^ the index is 3, and `nA` has the size 3\n"), "{run:?}");
}

#[test]
fn tasks_of_one_name_in_two_libraries_are_separate() {
    let library = "num nZero\npublic program go()\nbegin\ntaskCreate \"t\",10,divide()\nend\nprogram divide()\nbegin\n\
                   nZero=1/nZero\nend\n";
    let tidy = "public program tidy()\nbegin\ntaskKill(\"t\")\nend\n";
    let main = "library a \"first\"\nlibrary b \"second\"\nprogram start()\nbegin\ncall a:go()\ncall b:go()\ndelay(1)\n\
                call a:tidy()\nend\n";
    let folder = Folder::with(&format!("--- main\n{main}--- first\n{library}{tidy}--- second\n{library}"));
    ends(&folder.val3(&["run", "usrapp/main"]), 1, "");
}

#[test]
fn an_application_without_stop_does_not_run() {
    let folder =
        Folder::with("program start()\nbegin\n  ? \"hello\"\nend\nprogram other()\nbegin\n  ? \"other\"\nend\n");
    // `exact_command` does not add a program `stop`.
    let val3 = |args: &[&str]| crate::support::run(folder.exact_command(args));
    let run = val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
    assert!(run.stderr.contains("the program `start` but no program `stop`"), "{run:?}");
    assert!(run.stderr.contains("add a program `stop`, which may be empty"), "{run:?}");
    folder.write("configs/arm.cfx", "<arm><String name=\"arm\" value=\"tx90-S1\" /></arm>");
    let check = val3(&["check", "--format", "concise"]);
    assert!(check.stdout.contains("[V0534]"), "{check:?}");
    let run = val3(&["run", "--program", "other"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "other\n"), "another program needs no `stop`: {run:?}");
}
