//! `delay`, `wait`, `watch` and `setMutex` (5.8 to 5.10).

use expect_test::expect;

use crate::host::check;

#[test]
fn a_delay_lasts_its_time() {
    check(
        r#"
program start
    frame n3
    nums n1=0.5, n2=0.003
    line 1 Instruction clock () -> num n0 Instruction print (num n0)
    line 2 Instruction delay (num n1)
    line 3 Instruction clock () -> num n0 Instruction print (num n0)
    line 4 Instruction delay (num n2)
    line 5 Instruction clock () -> num n0 Instruction print (num n0)
    Return
end"#,
        expect![[r#"
            0
            0.5
            0.503
        "#]],
    );
}

#[test]
fn a_wait_ends_when_another_task_makes_its_condition_true() {
    check(
        r#"
data bGo bool[1]
program signal
    frame n2
    nums n0=0.25, n1=1
    line 1 Instruction delay (num n0)
    line 2 StoreFirst $bGo 0 n1
    Return
end
program start
    frame n2
    nums n1=10
    line 1 CreateTask "s" n1 signal ()
    line 2
retry: LoadFirst n0 $bGo 0
    WaitUntil n0 retry
    line 3 Instruction clock () -> num n0 Instruction print (num n0)
    Return
end"#,
        expect![[r#"
            0.25
        "#]],
    );
}

/// Returns a program that calls `watch($bGo, seconds)` and prints the result and the time.
fn watch(seconds: &str) -> String {
    format!(
        r#"
data bGo bool[1]
program signal
    frame n2
    nums n0=0.25, n1=1
    line 1 Instruction delay (num n0)
    line 2 StoreFirst $bGo 0 n1
    Return
end
program start
    frame n4
    nums n1=10, n2={seconds}
    line 1 CreateTask "s" n1 signal ()
    line 2
retry: LoadFirst n0 $bGo 0
    Watch n3 n0 n2 retry
    line 3 Instruction print (bool n3)
    line 4 Instruction clock () -> num n0 Instruction print (num n0)
    Return
end"#
    )
}

#[test]
fn a_watch_is_true_when_its_condition_holds_in_time() {
    check(
        &watch("5"),
        expect![[r#"
        true
        0.25
    "#]],
    );
}

#[test]
fn a_watch_is_false_when_its_time_is_over() {
    check(
        &watch("0.1"),
        expect![[r#"
        false
        0.1
    "#]],
    );
}

#[test]
fn a_mutex_lets_one_task_at_a_time_pass() {
    check(
        r#"
data bScreen bool[1]
data sTrace string[1]
program fill
    param x_sMark string t0
    frame n2/t1
    nums n0=0.2
    line 1 Instruction setMutex (bool $bScreen)
    line 2 Concatenate $sTrace $sTrace t0
    line 3 Instruction delay (num n0)
    line 4 Concatenate $sTrace $sTrace t0
    line 5 StoreFirst $bScreen 0 n1
    Return
end
program start
    frame n2/t1
    nums n0=10, n1=1
    line 1 TextMove t0 "a" CreateTask "a" n0 fill (string t0)
    line 2 TextMove t0 "b" CreateTask "b" n0 fill (string t0)
    line 3 TextMove t0 "c" CreateTask "c" n0 fill (string t0)
    line 4 Instruction delay (num n1)
    line 5 Instruction print (string $sTrace)
    line 6 Instruction print (bool $bScreen)
    Return
end"#,
        expect![[r#"
            aabbcc
            false
        "#]],
    );
}

/// The manual's example (5.8): each task adds its mark, then waits for the two other tasks.
#[test]
fn tasks_that_synchronize_continue_together() {
    check(
        r#"
data n num[1]
data bSynch bool[1]
data sTrace string[1]
program work
    param x_sMark string t0
    param x_nTime num n0
    frame n9/t1
    nums n1=1, n2=3, n4=1, n7=2, n8=1
next:
    line 1 Instruction delay (num n0)
    line 2 Concatenate $sTrace $sTrace t0
    line 3 LoadFirst n5 $n 0 Add n5 n5 n1 StoreFirst $n 0 n5
    line 4
all: LoadFirst n5 $n 0 Equal n6 n5 n2 JumpIf n6 here LoadFirst n6 $bSynch 0
here: WaitUntil n6 all
    line 5 StoreFirst $bSynch 0 n1
    line 6 LoadFirst n5 $n 0 Subtract n5 n5 n1 StoreFirst $n 0 n5
    line 7
none: LoadFirst n5 $n 0 Equal n6 n5 n3 JumpIf n6 left LoadFirst n6 $bSynch 0 Not n6 n6
left: WaitUntil n6 none
    line 8 StoreFirst $bSynch 0 n3
    line 9 ForNextUp n4 n7 next
    Return
end
program start
    frame n5/t1
    nums n0=10, n1=0.3, n2=0.1, n3=0.2, n4=2
    line 1 TextMove t0 "a" CreateTask "a" n0 work (string t0, num n1)
    line 2 TextMove t0 "b" CreateTask "b" n0 work (string t0, num n2)
    line 3 TextMove t0 "c" CreateTask "c" n0 work (string t0, num n3)
    line 4 Instruction delay (num n4)
    line 5 Instruction print (string $sTrace)
    Return
end"#,
        expect![[r#"
            bcabca
        "#]],
    );
}
