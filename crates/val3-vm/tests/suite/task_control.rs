//! Task states, and tasks that other tasks halt, resume and kill (5.1 to 5.3, 5.10).

use expect_test::{Expect, expect};

use crate::host::{Bench, check};

/// Programs that print the state of the task `work` and change it.
const CONTROL: &str = r#"
data nZero num[1]
program status
    frame n1/t1
    line 1 TextMove t0 "work" Instruction taskStatus (string t0) -> num n0 Instruction print (num n0)
    Return
end
program suspend
    frame t1
    line 1 TextMove t0 "work" Instruction taskSuspend (string t0)
    Return
end
program resume
    param x_nSkip num n0
    frame n1/t1
    line 1 TextMove t0 "work" Instruction taskResume (string t0, num n0)
    Return
end
program kill
    frame t1
    line 1 TextMove t0 "work" Instruction taskKill (string t0)
    Return
end
"#;

/// Fails while `$nZero` is 0, one second after its beginning.
const WORK: &str = r#"
program work
    frame n3
    nums n0=1
    line 11 Instruction delay (num n0)
    line 12 LoadFirst n1 $nZero 0 Divide n2 n0 n1
    line 13 Instruction clock () -> num n0 Instruction print (num n0)
    Return
end
"#;

#[track_caller]
fn check_control(start: &str, expected: Expect) {
    let text = format!(
        "{CONTROL}{WORK}program start\nframe n8/t1\nnums n0=10, n2=0.5, n3=1, n4=-1, n5=0.2, n6=2\n{start}\nReturn\nend"
    );
    check(&text, expected);
}

#[test]
fn a_task_that_does_not_exist_has_status_minus_1() {
    check_control(
        "line 1 Call status ()",
        expect![[r#"
        -1
    "#]],
    );
}

#[test]
fn a_task_that_runs_or_waits_has_status_1() {
    check_control(
        "line 1 CreateTask \"work\" n0 work ()
         line 2 Call status ()
         line 3 Instruction delay (num n2)
         line 4 Call status ()
         line 5 Call kill ()",
        expect![[r#"
            1
            1
        "#]],
    );
}

#[test]
fn a_halted_task_has_status_0() {
    check_control(
        "line 1 CreateTask \"work\" n0 work ()
         line 2 Call suspend ()
         line 3 Call status ()",
        expect![[r#"
            0
        "#]],
    );
}

#[test]
fn a_task_in_error_has_the_number_of_the_error_as_status() {
    check_control(
        "line 1 CreateTask \"work\" n0 work ()
         line 2 Instruction delay (num n6)
         line 3 Call status ()
         line 4 Call suspend ()
         line 5 Call status ()",
        expect![[r#"
            error 10 at row 12
            10
            10
        "#]],
    );
}

#[test]
fn a_task_that_has_ended_is_no_longer_there() {
    check_control(
        "line 1 StoreFirst $nZero 0 n3
         line 2 CreateTask \"work\" n0 work ()
         line 3 Instruction delay (num n6)
         line 4 Call status ()",
        expect![[r#"
            1
            -1
        "#]],
    );
}

/// The delay begins at 0 and ends one second later, although the task is halted during a part of the delay.
#[test]
fn a_halted_task_resumes_its_wait() {
    check_control(
        "line 1 StoreFirst $nZero 0 n3
         line 2 CreateTask \"work\" n0 work ()
         line 3 Instruction delay (num n2)
         line 4 Call suspend ()
         line 5 Instruction delay (num n5)
         line 6 Call resume (num n1)",
        expect![[r#"
            1
        "#]],
    );
}

#[test]
fn a_killed_task_is_gone_and_its_name_is_free() {
    check_control(
        "line 1 CreateTask \"work\" n0 work ()
         line 2 Call kill ()
         line 3 Call status ()
         line 4 CreateTask \"work\" n0 work ()
         line 5 Call status ()
         line 6 Call kill ()",
        expect![[r#"
            -1
            1
        "#]],
    );
}

#[test]
fn killing_a_task_that_does_not_exist_has_no_effect() {
    check_control(
        "line 1 Call kill ()\nline 2 Call status ()",
        expect![[r#"
        -1
    "#]],
    );
}

#[test]
fn halting_a_task_that_does_not_exist_is_an_error() {
    check_control(
        "line 2 Call suspend ()",
        expect![[r#"
        error 30 at row 1
    "#]],
    );
}

#[test]
fn resuming_a_task_that_does_not_exist_is_an_error() {
    check_control(
        "line 2 Call resume (num n1)",
        expect![[r#"
        error 30 at row 1
    "#]],
    );
}

#[test]
fn resuming_a_task_that_runs_has_no_effect() {
    check_control(
        "line 1 StoreFirst $nZero 0 n3
         line 2 CreateTask \"work\" n0 work ()
         line 3 Instruction delay (num n2)
         line 4 Call resume (num n3)",
        expect![[r#"
            1
        "#]],
    );
}

#[test]
fn a_task_that_halts_itself_can_be_resumed() {
    check(
        &format!(
            r#"{CONTROL}
program work
    frame n1
    nums n0=7
    line 11 Call suspend ()
    line 12 Instruction print (num n0)
    Return
end
program start
    frame n3
    nums n0=10, n2=0.1
    line 1 CreateTask "work" n0 work ()
    line 2 Instruction delay (num n2)
    line 3 Call status ()
    line 4 Call resume (num n1)
    Return
end"#
        ),
        expect![[r#"
            0
            7
        "#]],
    );
}

/// The task fails at the third of five lines, and resumes `skip` lines later.
fn resumed(skip: i32) -> String {
    let text = format!(
        r#"{CONTROL}
data sTrace string[1]
program work
    frame n3/t1
    nums n0=1
    line 11 Concatenate $sTrace $sTrace "1"
    line 12 Concatenate $sTrace $sTrace "2"
    line 13 LoadFirst n1 $nZero 0 Divide n2 n0 n1 Concatenate $sTrace $sTrace "3"
    line 14 Concatenate $sTrace $sTrace "4"
    line 15 Concatenate $sTrace $sTrace "5"
    line 16 Instruction print (string $sTrace)
    Return
end
program start
    frame n4
    nums n0=10, n1={skip}, n2=0.1, n3=1
    line 1 CreateTask "work" n0 work ()
    line 2 Instruction delay (num n2)
    line 3 StoreFirst $nZero 0 n3
    line 4 Call resume (num n1)
    Return
end"#
    );
    Bench::new(&text).run().host.record.replacen("error 10 at row 13\n", "", 1)
}

#[test]
fn a_failed_task_resumes_at_its_line() {
    assert_eq!(resumed(0), "12345\n");
}

#[test]
fn a_failed_task_resumes_at_a_later_line() {
    assert_eq!([1, 2].map(resumed), ["1245\n", "125\n"]);
}

#[test]
fn a_failed_task_resumes_at_an_earlier_line() {
    assert_eq!([-1, -2].map(resumed), ["122345\n", "1212345\n"]);
}

#[test]
fn a_task_that_resumes_after_its_last_line_ends() {
    assert_eq!(resumed(4), "");
}

#[test]
fn a_task_cannot_resume_where_its_program_has_no_line() {
    assert_eq!([-3, 5, -1000].map(resumed), ["error 90 at row 1\n"; 3]);
}

/// Creates a task with this name, and returns the error, if any.
fn created(name: &str) -> String {
    let text = format!(
        "program work\nReturn\nend\nprogram start\nframe n1\nnums n0=10\nline 1 CreateTask {name:?} n0 work ()\nReturn\nend"
    );
    Bench::new(&text).run().host.record
}

#[test]
fn a_name_has_1_to_15_letters_digits_and_underscores() {
    assert_eq!(["a", "aZ_09", "abcdefghijklmno"].map(created), [""; 3]);
    assert_eq!(["", "a b", "é", "abcdefghijklmnop"].map(created), ["error 29 at row 1\n"; 4]);
}

#[test]
fn two_tasks_of_one_name_are_an_error() {
    check_control(
        "line 1 CreateTask \"work\" n0 work ()\nline 2 CreateTask \"work\" n0 work ()",
        expect![[r#"
            error 31 at row 2
            error 10 at row 12
        "#]],
    );
}

#[test]
fn the_name_of_a_failed_task_is_not_free() {
    check_control(
        "line 1 CreateTask \"work\" n0 work ()
         line 2 Instruction delay (num n6)
         line 3 CreateTask \"work\" n0 work ()",
        expect![[r#"
            error 10 at row 12
            error 31 at row 3
        "#]],
    );
}

#[test]
fn a_local_variable_cannot_be_passed_to_a_task_by_reference() {
    check(
        r#"
program work
    param x_nValue num p0
    frame p1
    Return
end
program start
    frame n2
    nums n0=10
    line 1 CreateTask "work" n0 work (num n1)
    Return
end"#,
        expect![[r#"
            error 70 at row 1
        "#]],
    );
}

#[test]
fn a_task_keeps_the_values_that_it_was_given() {
    check(
        r#"
program work
    param x_nValue num n0
    param x_sText string t0
    frame n2/t1
    nums n1=1
    line 11 Instruction delay (num n1)
    line 12 Instruction print (num n0)
    line 13 Instruction print (string t0)
    Return
end
program start
    frame n2/t1
    nums n0=10, n1=3
    line 1 TextMove t0 "given" CreateTask "work" n0 work (num n1, string t0)
    line 2 Move n1 n0
    line 3 TextMove t0 "changed"
    Return
end"#,
        expect![[r#"
            3
            given
        "#]],
    );
}

#[test]
fn changes_of_tasks_are_reported_to_the_host() {
    let text = format!(
        "{CONTROL}{WORK}program start\nframe n4\nnums n0=10, n2=0.5, n3=2
         line 1 CreateTask \"work\" n0 work ()
         line 2 Call suspend ()
         line 3 Call resume (num n1)
         line 4 Instruction delay (num n3)
         line 5 Call kill ()
         Return\nend"
    );
    expect![[r#"
        start Created
        work Created
        work Halted
        work Resumed
        work Failed(Fault(10))
        work Killed
        start Ended
    "#]]
    .assert_eq(&Bench::new(&text).run().host.changes);
}
