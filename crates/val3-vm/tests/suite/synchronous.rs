//! Synchronous tasks (5.5, 5.6).

use expect_test::expect;

use crate::host::check;

/// A program that counts its periods.
const EACH: &str = r#"
data bLate bool[1]
data nTimes num[1]
program each
    frame n3
    nums n1=1
again:
    line 1 LoadFirst n0 $nTimes 0 Add n0 n0 n1 StoreFirst $nTimes 0 n0
    line 2 Instruction delay (num n2)
    line 3 Jump again
end
"#;

#[test]
fn a_task_runs_once_in_each_period() {
    check(
        &format!(
            r#"{EACH}
program start
    frame n2/t1
    nums n0=0.02, n1=1.001
    line 1 CreateTask "s" n0 overrun $bLate each ()
    line 2 Instruction delay (num n1)
    line 3 Instruction print (num $nTimes)
    line 4 Instruction print (bool $bLate)
    line 5 TextMove t0 "s" Instruction taskKill (string t0)
    Return
end"#
        ),
        expect![[r#"
            50
            false
        "#]],
    );
}

#[test]
fn a_period_is_rounded_down_to_whole_cycles() {
    check(
        &format!(
            r#"{EACH}
program start
    frame n2/t1
    nums n0=0.011, n1=0.799
    line 1 CreateTask "s" n0 overrun $bLate each ()
    line 2 Instruction delay (num n1)
    line 3 Instruction print (num $nTimes)
    line 4 TextMove t0 "s" Instruction taskKill (string t0)
    Return
end"#
        ),
        expect![[r#"
            99
        "#]],
    );
}

/// Programs that add a mark to the trace once in a period.
const MARK: &str = r#"
data bLate bool[1]
data sTrace string[1]
program mark
    param x_sMark string t0
    frame n1/t1
again:
    line 1 Concatenate $sTrace $sTrace t0
    line 2 Instruction delay (num n0)
    line 3 Jump again
end
"#;

#[test]
fn short_periods_come_first_then_the_order_of_creation() {
    check(
        &format!(
            r#"{MARK}
program start
    frame n3/t1
    nums n0=0.008, n1=0.004, n2=0.018
    line 1 TextMove t0 "z" CreateTask "z" n0 overrun $bLate mark (string t0)
    line 2 TextMove t0 "a" CreateTask "a" n0 overrun $bLate mark (string t0)
    line 3 TextMove t0 "m" CreateTask "m" n1 overrun $bLate mark (string t0)
    line 4 Instruction delay (num n2)
    line 5 Instruction print (string $sTrace)
    line 6 TextMove t0 "z" Instruction taskKill (string t0)
    line 7 TextMove t0 "a" Instruction taskKill (string t0)
    line 8 TextMove t0 "m" Instruction taskKill (string t0)
    Return
end"#
        ),
        expect![[r#"
            mmzammza
        "#]],
    );
}

#[test]
fn it_interrupts_an_asynchronous_task_between_two_lines() {
    check(
        &format!(
            r#"{MARK}
program start
    frame n4/t1
    nums n0=0.004, n1=1, n2=4500
    line 1 TextMove t0 "s" CreateTask "s" n0 overrun $bLate mark (string t0)
again:
    line 2 Add n3 n3 n1 IfLess n3 n2 again
    line 3 Instruction print (string $sTrace)
    line 4 TextMove t0 "s" Instruction taskKill (string t0)
    Return
end"#
        ),
        expect![[r#"
            ss
        "#]],
    );
}

#[test]
fn it_executes_3000_lines_in_a_period() {
    check(
        r#"
data bLate bool[1]
data nLines num[1]
program each
    frame n2
    nums n1=1
again:
    line 1 LoadFirst n0 $nLines 0 Add n0 n0 n1 StoreFirst $nLines 0 n0 Jump again
end
program start
    frame n2/t1
    nums n0=1, n1=1.5
    line 1 CreateTask "s" n0 overrun $bLate each ()
    line 2 Instruction delay (num n1)
    line 3 Instruction print (num $nLines)
    line 4 Instruction delay (num n0)
    line 5 Instruction print (num $nLines)
    line 6 TextMove t0 "s" Instruction taskKill (string t0)
    Return
end"#,
        expect![[r#"
            3000
            6000
        "#]],
    );
}

/// 2,500 lines take 5 ms, more than the period of 4 ms.
#[test]
fn the_period_after_an_overrun_is_left_out_and_the_next_one_reports_it() {
    check(
        r#"
data bLate bool[1]
program each
    frame n7
    nums n1=1, n2=2500, n3=2, n5=4
again:
    line 1 Instruction clock () -> num n0 Instruction print (num n0)
    line 2 Instruction print (bool $bLate)
    line 3 Add n6 n6 n1 UnlessEqual n6 n3 rest
work:
    line 4 Add n4 n4 n1 IfLess n4 n2 work
rest:
    line 5 Subtract n0 n0 n0 Instruction delay (num n0)
    line 6 IfLess n6 n5 again
    Return
end
program start
    frame n1
    nums n0=0.004
    line 1 CreateTask "s" n0 overrun $bLate each ()
    Return
end"#,
        expect![[r#"
            0.004
            false
            0.008
            false
            0.016
            true
            0.02
            false
        "#]],
    );
}

#[test]
fn a_third_period_is_an_error() {
    check(
        &format!(
            r#"{MARK}
program start
    frame n3/t1
    nums n0=0.02, n1=0.1, n2=0.024
    line 1 CreateTask "a" n0 overrun $bLate mark (string t0)
    line 2 CreateTask "b" n1 overrun $bLate mark (string t0)
    line 3 TextMove t0 "a" Instruction taskKill (string t0)
    line 4 CreateTask "c" n2 overrun $bLate mark (string t0)
    line 5 CreateTask "d" n1 overrun $bLate mark (string t0)
    line 6 TextMove t0 "b" Instruction taskKill (string t0)
    line 7 TextMove t0 "c" Instruction taskKill (string t0)
    line 8 TextMove t0 "d" Instruction taskKill (string t0)
    line 9 CreateTask "e" n0 overrun $bLate last ()
    line 10 CreateTask "f" n1 overrun $bLate last ()
    line 11 CreateTask "g" n2 overrun $bLate last ()
    Return
end
program last
    line 1 Return
end"#
        ),
        expect![[r#"
            error 32 at row 11
        "#]],
    );
}

#[test]
fn the_variable_of_overruns_has_to_be_global() {
    check(
        r#"
program each
    Return
end
program start
    frame n2
    nums n0=0.02
    line 1 CreateTask "s" n0 overrun n1 each ()
    Return
end"#,
        expect![[r#"
            error 70 at row 1
        "#]],
    );
}

#[test]
fn a_task_halted_by_an_earlier_one_has_no_turn_in_the_same_period() {
    check(
        r#"
data bLate bool[1]
data sTrace string[1]
program first
    frame t1
    line 1 Concatenate $sTrace $sTrace "a"
    line 2 TextMove t0 "b" Instruction taskSuspend (string t0)
    line 3 TextMove t0 "c" Instruction taskKill (string t0)
    Return
end
program mark
    line 1 Concatenate $sTrace $sTrace "x"
    Return
end
program start
    frame n2/t1
    nums n0=0.1, n1=0.35
    line 1 CreateTask "a" n0 overrun $bLate first ()
    line 2 CreateTask "b" n0 overrun $bLate mark ()
    line 3 CreateTask "c" n0 overrun $bLate mark ()
    line 4 Instruction delay (num n1)
    line 5 Instruction print (string $sTrace)
    line 6 TextMove t0 "b" Instruction taskStatus (string t0) -> num n0 Instruction print (num n0)
    Return
end"#,
        expect![[r#"
            a
            0
        "#]],
    );
}

#[test]
fn a_wait_is_checked_once_a_period() {
    check(
        r#"
data bLate bool[1]
data bGo bool[1]
program each
    frame n1
    line 1
retry: LoadFirst n0 $bGo 0 WaitUntil n0 retry
    line 2 Instruction clock () -> num n0 Instruction print (num n0)
    Return
end
program start
    frame n3
    nums n0=0.1, n1=0.234, n2=1
    line 1 CreateTask "s" n0 overrun $bLate each ()
    line 2 Instruction delay (num n1)
    line 3 StoreFirst $bGo 0 n2
    Return
end"#,
        expect![[r#"
            0.3
        "#]],
    );
}
