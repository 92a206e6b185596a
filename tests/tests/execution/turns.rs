//! Turns of asynchronous tasks (5.4).

use expect_test::expect;

use crate::execution::check;

#[test]
fn a_turn_has_as_many_lines_as_the_priority() {
    check(
        r#"
        string sTrace
        program mark(string x_sMark)
        begin
          sTrace=sTrace+x_sMark
          sTrace=sTrace+x_sMark
          sTrace=sTrace+x_sMark
          sTrace=sTrace+x_sMark
          sTrace=sTrace+x_sMark
          sTrace=sTrace+x_sMark
        end
        program start()
        begin
          taskCreate "a",2,mark("a")
          taskCreate "b",3,mark("b")
          taskCreate "c",1,mark("c")
          wait(taskStatus("a")==-1 and taskStatus("b")==-1 and taskStatus("c")==-1)
          ? sTrace
        end
        "#,
        expect![[r#"
            aabbbcaabbbcaacccc
        "#]],
    );
}

#[test]
fn comments_and_blank_lines_are_no_lines() {
    check(
        r#"
        string sTrace
        program sparse()
        begin
          sTrace=sTrace+"a"
          // a remark

          sTrace=sTrace+"a"

          sTrace=sTrace+"a"
          sTrace=sTrace+"a"
        end
        program dense()
        begin
          sTrace=sTrace+"b"
          sTrace=sTrace+"b"
          sTrace=sTrace+"b"
          sTrace=sTrace+"b"
        end
        program start()
        begin
          taskCreate "a",2,sparse()
          taskCreate "b",2,dense()
          wait(taskStatus("a")==-1 and taskStatus("b")==-1)
          ? sTrace
        end
        "#,
        expect![[r#"
            aabbaabb
        "#]],
    );
}

#[test]
fn the_start_task_has_ten_lines() {
    check(
        r#"
        string sTrace
        program other()
        begin
          sTrace=sTrace+"b"
          sTrace=sTrace+"b"
        end
        program start()
        begin
          taskCreate "b",1,other()
          sTrace=sTrace+"2"
          sTrace=sTrace+"3"
          sTrace=sTrace+"4"
          sTrace=sTrace+"5"
          sTrace=sTrace+"6"
          sTrace=sTrace+"7"
          sTrace=sTrace+"8"
          sTrace=sTrace+"9"
          sTrace=sTrace+"0"
          sTrace=sTrace+"1"
          ? sTrace
        end
        "#,
        expect![[r#"
            234567890b1
        "#]],
    );
}

/// Whether an instruction in the middle of a long turn allows another task to run.
#[track_caller]
fn passes_the_turn(data: &str, line: &str) -> bool {
    let listing = format!(
        r#"
{data}
string sTrace
program other()
begin
  while true
    if len(sTrace)<10
      sTrace=sTrace+"b"
    endIf
    delay(0)
  endWhile
end
program idle()
begin
  delay(1000)
end
program first()
begin
  sTrace=sTrace+"1"
  {line}
  sTrace=sTrace+"2"
end
program start()
begin
  taskCreate "c",1,idle()
  taskCreate "a",100,first()
  taskCreate "b",100,other()
  wait(find(sTrace,"2")>=0)
  taskKill("b")
  taskKill("c")
  ? left(sTrace,2)
end
"#
    );
    match val3_tests::running::Running::start(&listing).to_the_end().printed().as_str() {
        "12\n" => false,
        "1b\n" => true,
        other => panic!("{line}: {other}"),
    }
}

#[test]
fn instructions_that_wait_end_the_turn() {
    let lines = [
        "delay(0)",
        "delay(-1)",
        "delay(0.1)",
        "wait(len(sTrace)>3)",
        "bDone=watch(len(sTrace)>3,1)",
        "bDone=watch(false,0.1)",
        "setMutex(bDone)",
        "taskKill(\"c\")",
    ];
    for line in lines {
        let data = if line.starts_with("setMutex") { "bool bDone=true" } else { "bool bDone" };
        let line = line.replace("setMutex(bDone)", "bDone=watch(false,0)\n  setMutex(bDone)");
        assert!(passes_the_turn(data, &line), "{line}");
    }
}

#[test]
fn instructions_that_do_not_wait_keep_the_turn() {
    for line in ["wait(true)", "bDone=watch(true,1)", "setMutex(bDone)", "bDone=true", "taskSuspend(\"c\")"] {
        assert!(!passes_the_turn("bool bDone", line), "{line}");
    }
}

#[test]
fn a_task_created_late_comes_last() {
    check(
        r#"
        string sTrace
        program mark(string x_sMark)
        begin
          sTrace=sTrace+x_sMark
          delay(0)
          sTrace=sTrace+x_sMark
          delay(0)
          sTrace=sTrace+x_sMark
        end
        program start()
        begin
          taskCreate "z",10,mark("z")
          taskCreate "a",10,mark("a")
          delay(0)
          taskCreate "m",10,mark("m")
          wait(taskStatus("m")==-1)
          ? sTrace
        end
        "#,
        expect![[r#"
            zazamzamm
        "#]],
    );
}
