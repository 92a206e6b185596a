//! Synchronous tasks (5.5, 5.6).

use expect_test::expect;

use crate::execution::check;

#[test]
fn a_period_comes_at_its_exact_time() {
    check(
        r#"
        bool bLate
        num nTimes
        program each()
        begin
          while true
            nTimes=nTimes+1
            delay(0)
          endWhile
        end
        program start()
        begin
          taskCreateSync "sup",0.02,bLate,each()
          delay(1.001)
          ? nTimes
          ? bLate
          taskKill("sup")
        end
        "#,
        expect![[r#"
            50
            false
        "#]],
    );
}

#[test]
fn a_period_is_rounded_down_to_4_ms() {
    check(
        r#"
        bool bLate
        num nA
        num nB
        program each(num& x_nTimes)
        begin
          while true
            x_nTimes=x_nTimes+1
            delay(0)
          endWhile
        end
        program start()
        begin
          taskCreateSync "a",0.011,bLate,each(nA)
          taskCreateSync "b",0.004,bLate,each(nB)
          delay(0.799)
          ? nA
          ? nB
          taskKill("a")
          taskKill("b")
        end
        "#,
        expect![[r#"
            99
            199
        "#]],
    );
}

#[test]
fn synchronous_tasks_interrupt_asynchronous_ones_in_order_of_creation() {
    check(
        r#"
        bool bLate
        bool bEnd
        string sTrace
        num nBusy
        program each(string x_sMark)
        begin
          while true
            sTrace=sTrace+x_sMark
            delay(0)
          endWhile
        end
        program busy()
        begin
          while !bEnd
            nBusy=nBusy+1
          endWhile
        end
        program start()
        begin
          taskCreateSync "z",0.008,bLate,each("z")
          taskCreateSync "a",0.008,bLate,each("a")
          taskCreateSync "m",0.004,bLate,each("m")
          taskCreate "busy",100,busy()
          wait(len(sTrace)>=15)
          bEnd=true
          taskKill("z")
          taskKill("a")
          taskKill("m")
          ? mid(sTrace,15,0)
        end
        "#,
        expect![[r#"
            mmzammzammzammz
        "#]],
    );
}

#[test]
fn a_cycle_has_3000_lines() {
    check(
        r#"
        bool bLate
        num nLines
        num nSeen
        program each()
        begin
          while true
            nLines=nLines+1
          endWhile
        end
        program start()
        begin
          taskCreateSync "s",1,bLate,each()
          wait(nLines>0)
          nSeen=nLines
          ? nSeen
          wait(nLines>nSeen)
          ? nLines-nSeen
          taskKill("s")
        end
        "#,
        expect![[r#"
            1500
            1500
        "#]],
    );
}

/// 3,000 lines of 2 µs have a duration of 6 ms.
#[test]
fn the_cycle_after_an_overrun_is_skipped() {
    check(
        r#"
        bool bLate
        num nCycle
        num nWork
        string sSeen[4]
        program each()
        begin
          while true
            sSeen[nCycle]=toString("",roundDown(clock()*250))+" "+toString("",sel(bLate,1,0))
            nCycle=nCycle+1
            if nCycle==2
              for nWork=1 to 2500
              endFor
            endIf
            delay(0)
          endWhile
        end
        program start()
        begin
          taskCreateSync "s",0.004,bLate,each()
          wait(nCycle==4)
          taskKill("s")
          ? sSeen[0]
          ? sSeen[1]
          ? sSeen[2]
          ? sSeen[3]
        end
        "#,
        expect![[r#"
            1 0
            2 0
            4 1
            5 0
        "#]],
    );
}

#[test]
fn a_wait_that_ends_is_seen_in_the_next_period() {
    check(
        r#"
        bool bLate
        bool bGo
        num nWhen
        program each()
        begin
          wait(bGo)
          nWhen=clock()
        end
        program start()
        begin
          taskCreateSync "s",0.1,bLate,each()
          delay(0.234)
          bGo=true
          wait(taskStatus("s")==-1)
          ? nWhen
        end
        "#,
        expect![[r#"
            0.3
        "#]],
    );
}

#[test]
fn there_are_two_periods_at_most() {
    check(
        r#"
        bool bLate
        program each()
        begin
          delay(10)
        end
        program start()
        begin
          taskCreateSync "a",0.02,bLate,each()
          taskCreateSync "b",0.1,bLate,each()
          taskCreateSync "c",0.023,bLate,each()
          taskKill("a")
          taskCreateSync "d",0.1,bLate,each()
          ? "one of the two"
          taskKill("c")
          taskCreateSync "e",0.5,bLate,each()
          ? "another, when the first is free"
          taskCreateSync "f",0.02,bLate,each()
          ? "never"
        end
        program stop()
        begin
        end
        "#,
        expect![[r#"
            one of the two
            another, when the first is free
            error 32
        "#]],
    );
}

#[test]
fn a_period_below_4_ms_is_4_ms_from_s8_on() {
    let program = |version: &str| {
        format!(
            "version {version}\nbool bLate\nnum nTimes\nprogram each()\nbegin\n  while true\n    nTimes=nTimes+1\n    \
             delay(0)\n  endWhile\nend\nprogram start()\nbegin\n  taskCreateSync \"a\",0.002,bLate,each()\n  \
             delay(0.799)\n  ? nTimes\n  taskKill(\"a\")\nend\n"
        )
    };
    check(
        &program("s7.11"),
        expect![[r#"
            error 70
        "#]],
    );
    check(
        &program("s8.15"),
        expect![[r#"
            199
        "#]],
    );
}

#[test]
fn the_variable_of_overruns_is_a_global_one() {
    check(
        r#"
        program each()
        begin
        end
        program start()
          bool l_bLate
        begin
          taskCreateSync "a",0.02,l_bLate,each()
        end
        "#,
        expect![[r#"
            error 70
        "#]],
    );
}

#[test]
fn a_synchronous_task_waits_in_steps_of_its_period() {
    check(
        r#"
        bool bLate
        bool bSeen
        program each()
        begin
          ? clock()
          delay(0.15)
          ? clock()
          bSeen=watch(false,0.31)
          ? clock()
        end
        program start()
        begin
          taskCreateSync "s",0.1,bLate,each()
          wait(taskStatus("s")==-1)
          ? bSeen
        end
        "#,
        expect![[r#"
            0.1
            0.3
            0.7
            false
        "#]],
    );
}

#[test]
fn after_an_error_a_synchronous_task_resumes_in_a_later_period() {
    check(
        r#"
        bool bLate
        num nZero
        program each()
        begin
          nZero=1/nZero
          ? clock()
        end
        program start()
        begin
          taskCreateSync "s",0.1,bLate,each()
          wait(taskStatus("s")==10)
          nZero=2
          delay(0.23)
          taskResume("s",0)
          wait(taskStatus("s")==-1)
          ? nZero
        end
        "#,
        expect![[r#"
            error 10
            0.4
            0.5
        "#]],
    );
}

#[test]
fn a_task_halted_in_a_period_does_not_run_in_it() {
    check(
        r#"
        bool bLate
        num nTimes
        program first()
        begin
          taskSuspend("b")
          taskKill("c")
          delay(0.35)
        end
        program each()
        begin
          nTimes=nTimes+1
        end
        program start()
        begin
          taskCreateSync "a",0.1,bLate,first()
          taskCreateSync "b",0.1,bLate,each()
          taskCreateSync "c",0.1,bLate,each()
          wait(taskStatus("a")==-1)
          ? nTimes
          ? taskStatus("b")
          taskKill("b")
        end
        "#,
        expect![[r#"
            0
            0
        "#]],
    );
}
