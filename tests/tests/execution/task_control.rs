//! Tasks that other tasks halt, resume and kill (5.2, 5.10).

use expect_test::{Expect, expect};

use crate::execution::check;

#[test]
fn a_task_has_the_states_of_the_manual() {
    check(
        r#"
        num nZero
        program work()
        begin
          delay(1)
          nZero=1/nZero
        end
        program start()
        begin
          ? taskStatus("work")
          taskCreate "work",10,work()
          ? taskStatus("work")
          delay(0.5)
          ? taskStatus("work")
          taskSuspend("work")
          ? taskStatus("work")
          taskSuspend("work")
          taskResume("work",0)
          ? taskStatus("work")
          delay(1)
          ? taskStatus("work")
          ? help(taskStatus("work"))!=""
          taskSuspend("work")
          ? taskStatus("work")
          nZero=1
          taskResume("work",0)
          delay(0)
          ? taskStatus("work")
          taskKill("work")
          ? taskStatus("main~")
        end
        "#,
        expect![[r#"
            -1
            1
            1
            0
            1
            error 10
            10
            true
            10
            -1
            1
        "#]],
    );
}

/// A task stops at the third of five lines and resumes this number of lines later.
#[track_caller]
fn resumed(skip: &str, expected: Expect) {
    let listing = format!(
        r#"
string sTrace
num nZero
num nResume
program work()
begin
  sTrace=sTrace+"1"
  // no line

  sTrace=sTrace+"2"
  sTrace=sTrace+toString("",1/nZero)
  sTrace=sTrace+"4"

  sTrace=sTrace+"5"
end
program ask()
begin
  taskResume("work",{skip})
end
program start()
begin
  taskCreate "work",10,work()
  wait(taskStatus("work")==10)
  nZero=-0.5
  taskCreate "ask",10,ask()
  wait(taskStatus("ask")!=1)
  ? taskStatus("ask")
  wait(taskStatus("work")!=1)
  ? taskStatus("work")
  ? sTrace
  taskKill("work")
  taskKill("ask")
end
"#
    );
    check(&listing, expected);
}

#[test]
fn a_task_resumes_at_its_line() {
    resumed(
        "0",
        expect![[r#"
        error 10
        -1
        -1
        12-245
    "#]],
    );
}

#[test]
fn a_task_resumes_further_down() {
    resumed(
        "1",
        expect![[r#"
        error 10
        -1
        -1
        1245
    "#]],
    );
    resumed(
        "2",
        expect![[r#"
        error 10
        -1
        -1
        125
    "#]],
    );
}

#[test]
fn a_task_resumes_further_up() {
    resumed(
        "-1",
        expect![[r#"
        error 10
        -1
        -1
        122-245
    "#]],
    );
    resumed(
        "-2",
        expect![[r#"
        error 10
        -1
        -1
        1212-245
    "#]],
    );
}

#[test]
fn a_task_cannot_resume_outside_of_its_program() {
    resumed(
        "-3",
        expect![[r#"
        error 10
        error 90
        90
        10
        12
    "#]],
    );
    resumed(
        "3",
        expect![[r#"
        error 10
        -1
        -1
        12
    "#]],
    );
    resumed(
        "-4",
        expect![[r#"
        error 10
        error 90
        90
        10
        12
    "#]],
    );
    resumed(
        "4",
        expect![[r#"
        error 10
        error 90
        90
        10
        12
    "#]],
    );
    resumed(
        "-1000",
        expect![[r#"
        error 10
        error 90
        90
        10
        12
    "#]],
    );
}

#[test]
fn a_task_that_runs_is_not_resumed() {
    check(
        r#"
        string sTrace
        program work()
        begin
          sTrace=sTrace+"1"
          delay(1)
          sTrace=sTrace+"2"
        end
        program start()
        begin
          taskCreate "work",10,work()
          delay(0.5)
          taskResume("work",-1)
          wait(taskStatus("work")==-1)
          ? sTrace
        end
        "#,
        expect![[r#"
            12
        "#]],
    );
}

#[test]
fn a_halted_task_keeps_waiting() {
    check(
        r#"
        program work()
        begin
          delay(1)
          ? clock()
        end
        program start()
        begin
          taskCreate "work",10,work()
          delay(0.5)
          taskSuspend("work")
          delay(0.2)
          taskResume("work",0)
          wait(taskStatus("work")==-1)
          ? clock()
        end
        "#,
        expect![[r#"
            1
            1
        "#]],
    );
}

#[test]
fn a_killed_task_frees_its_name() {
    check(
        r#"
        program work(num x_nValue)
        begin
          delay(1)
          ? x_nValue
        end
        program start()
        begin
          taskCreate "work",10,work(1)
          taskKill("work")
          ? taskStatus("work")
          taskCreate "work",10,work(2)
          taskKill("nothing")
          wait(taskStatus("work")==-1)
        end
        "#,
        expect![[r#"
            -1
            2
        "#]],
    );
}

#[test]
fn a_task_halts_and_kills_itself() {
    check(
        r#"
        program work()
        begin
          taskSuspend("work")
          ? "resumed"
          taskKill("work")
          ? "never"
        end
        program start()
        begin
          taskCreate "work",10,work()
          delay(1)
          ? taskStatus("work")
          taskResume("work",1)
          delay(1)
          ? taskStatus("work")
        end
        "#,
        expect![[r#"
            0
            resumed
            -1
        "#]],
    );
}

#[test]
fn a_task_keeps_the_values_it_was_given() {
    check(
        r#"
        string sMessage
        program read(string& x_sMessage)
        begin
          delay(0.1)
          x_sMessage="read"
        end
        program late(num x_nValue)
        begin
          delay(1)
          ? x_nValue
        end
        program start()
          num l_nValue
        begin
          taskCreate "t1",10,read(sMessage)
          wait(taskStatus("t1")==-1)
          ? sMessage
          l_nValue=3
          taskCreate "t2",10,late(l_nValue+1)
          l_nValue=100
        end
        "#,
        expect![[r#"
            read
            4
        "#]],
    );
}

#[test]
fn lines_count_in_the_program_that_was_called() {
    check(
        r#"
        string sTrace
        num nZero
        program inner()
        begin
          sTrace=sTrace+"b"
          sTrace=sTrace+toString("",1/nZero)
          sTrace=sTrace+"c"
        end
        program work()
        begin
          sTrace=sTrace+"a"
          call inner()
          sTrace=sTrace+"d"
        end
        program start()
        begin
          taskCreate "work",10,work()
          wait(taskStatus("work")==10)
          taskResume("work",-1)
          wait(taskStatus("work")==10)
          taskResume("work",1)
          wait(taskStatus("work")==-1)
          ? sTrace
        end
        "#,
        expect![[r#"
            error 10
            error 10
            abbcd
        "#]],
    );
}

#[test]
fn a_line_within_a_block_can_be_resumed() {
    check(
        r#"
        num nZero
        num n
        string sTrace
        program work()
        begin
          sTrace=sTrace+toString("",1/nZero)
          if false
            sTrace=sTrace+"if"
          endIf
          for n=1 to 2
            sTrace=sTrace+toString("",n)
          endFor
        end
        program start()
        begin
          taskCreate "work",10,work()
          wait(taskStatus("work")==10)
          taskResume("work",2)
          wait(taskStatus("work")==-1)
          ? sTrace
        end
        "#,
        expect![[r#"
            error 10
            if12
        "#]],
    );
}

#[test]
fn the_start_task_can_be_controlled_by_others() {
    check(
        r#"
        program work()
        begin
          delay(1)
          ? taskStatus("main~")
          taskKill("main~")
          ? taskStatus("main~")
        end
        program start()
        begin
          taskCreate "work",10,work()
          delay(10)
          ? "never"
        end
        program stop()
        begin
          ? clock()
        end
        "#,
        expect![[r#"
            1
            -1
            1.004
        "#]],
    );
}

#[test]
fn a_failed_task_holds_its_name_and_can_be_killed() {
    check(
        r#"
        num nZero
        program work()
        begin
          nZero=1/nZero
        end
        program again()
        begin
          taskCreate "work",10,work()
        end
        program start()
        begin
          taskCreate "work",10,work()
          wait(taskStatus("work")!=1)
          taskCreate "again",10,again()
          wait(taskStatus("again")!=1)
          ? taskStatus("again")
          taskKill("work")
          taskResume("again",0)
          wait(taskStatus("again")!=1)
          ? taskStatus("again")
          taskKill("work")
        end
        "#,
        expect![[r#"
            error 10
            error 31
            31
            error 10
            -1
        "#]],
    );
}

#[test]
fn a_task_resumes_within_a_loop() {
    check(
        r#"
        num nZero
        program work()
          num l_nRound
        begin
          ? 1/nZero
          for l_nRound=5 to 7
            ? l_nRound
          endFor
          ? "behind"
        end
        program start()
        begin
          taskCreate "work",10,work()
          wait(taskStatus("work")!=1)
          taskResume("work",2)
        end
        "#,
        expect![[r#"
            error 10
            0
            1
            2
            3
            4
            5
            6
            7
            behind
        "#]],
    );
}
