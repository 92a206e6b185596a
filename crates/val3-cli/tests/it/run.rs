//! `val3 run`.

use crate::support::{FAULTY, Folder, Run};

/// An application that meets the error 10 in a task of its own, and what `start` does about it.
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
fn ends(run: &Run, code: i32, stdout: &str) {
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
fn an_error_nobody_cares_for_is_a_failure() {
    let run = failing("taskSuspend(\"divide\")").val3(&["run"]);
    ends(&run, 1, "");
    insta::assert_snapshot!(run.stderr);
}

#[test]
fn an_error_that_another_task_handles_is_none() {
    let handled = "taskKill(\"divide\")";
    ends(&failing(handled).val3(&["run"]), 0, "stop\n");
    let mended = "nZero=2\n  taskResume(\"divide\",0)";
    ends(&failing(mended).val3(&["run"]), 0, "stop\n");
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
fn events_are_equal_bytes_in_each_run() {
    let folder = Folder::with(ENDLESS);
    let first = folder.val3(&["run", "--until", "2.5", "--events", "-"]);
    let lines: Vec<&str> = first.stdout.lines().collect();
    assert_eq!((first.code, lines.len()), (3, 5), "{first:?}");
    assert!(lines[4].ends_with(r#""kind":"end","reason":"limit"}"#), "{first:?}");
    ends(&folder.val3(&["run", "--until", "2.5", "--events", "again.jsonl"]), 3, "1\n2\n3\n");
    assert_eq!(folder.read("again.jsonl"), first.stdout);
}

#[test]
fn another_program_may_begin() {
    let folder = failing("taskKill(\"divide\")");
    ends(&folder.val3(&["run", "--program", "stop"]), 0, "stop\nstop\n");
}

#[test]
fn a_script_and_keys_stand_for_people() {
    let folder = Folder::with("num nKey\nnKey=get()\n? nKey\nwait(nKey==4)\n? clock()\n");
    folder.write("people.toml", "[[at]]\nt = 2\nset = { nKey = 4 }\n");
    ends(&folder.val3(&["run", "--keys", "271", "--script", "people.toml"]), 0, "271\n2\n");
}

#[test]
fn wrong_usage() {
    let folder = Folder::with(ENDLESS);
    folder.write("bad.toml", "[[at]]\nt = 2\nsett = { nKey = 4 }\n");
    for (arguments, word) in [
        (&["run", "no/such"][..], "no/such"),
        (&["run", "--program", "nothing"], "nothing"),
        (&["run", "--until=-1"], "--until"),
        (&["run", "--script", "no.toml"], "no.toml"),
        (&["run", "--script", "bad.toml"], "sett"),
        (&["run", "--events", "no/such/x"], "no/such/x"),
        (&["run", "--monitor-speed", "101"], "101"),
    ] {
        let run = folder.val3(arguments);
        ends(&run, 2, "");
        assert!(run.stderr.contains(word), "{arguments:?} {run:?}");
    }
}

#[test]
fn an_application_starts_without_what_is_missing() {
    let folder = Folder::with(
        "library io \"Disk://io/io.pjx\"\nnum nValue\nprogram start()\nbegin\n  ? \"start\"\n  \
         nValue=$read(1)+1\n  ? io:nInput\nend",
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
    ends(&run, 2, "");
    insta::assert_snapshot!(run.stderr);
}

fn sum(from: u32) -> String {
    let parts: String = (from..from + 100).map(|number| format!("+{number}")).collect();
    format!("  n=n{parts}\n")
}

#[test]
fn a_line_without_link_can_be_connected() {
    let run = Folder::with("sio siHost\nsiHost=\"hello\"\n").val3(&["run"]);
    ends(&run, 1, "");
    assert!(run.stderr.contains("error[123]") && run.stderr.contains("--line"), "{run:?}");
}
