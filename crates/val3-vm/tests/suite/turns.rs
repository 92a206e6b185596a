//! Turns of asynchronous tasks (5.4).

use expect_test::expect;

use crate::host::{Bench, check};

/// Adds a mark to the trace six times, in six lines.
const MARK: &str = r#"
data sTrace string[1]
program mark
    param x_sMark string t0
    frame t1
    line 1 Concatenate $sTrace $sTrace t0
    line 2 Concatenate $sTrace $sTrace t0
    line 3 Concatenate $sTrace $sTrace t0
    line 4 Concatenate $sTrace $sTrace t0
    line 5 Concatenate $sTrace $sTrace t0
    line 6 Concatenate $sTrace $sTrace t0
    Return
end
"#;

#[test]
fn a_turn_has_as_many_lines_as_the_priority() {
    check(
        &format!(
            r#"{MARK}
program start
    frame n4/t1
    nums n0=2, n1=3, n2=1, n3=1
    line 1 TextMove t0 "a" CreateTask "a" n0 mark (string t0)
    line 2 TextMove t0 "b" CreateTask "b" n1 mark (string t0)
    line 3 TextMove t0 "c" CreateTask "c" n2 mark (string t0)
    line 4 Instruction delay (num n3)
    line 5 Instruction print (string $sTrace)
    Return
end"#
        ),
        expect![[r#"
            aabbbcaabbbcaacccc
        "#]],
    );
}

#[test]
fn operations_within_a_line_do_not_count() {
    check(
        r#"
data sTrace string[1]
program long
    frame n1
    line 1 Concatenate $sTrace $sTrace "a" Add n0 n0 n0 Add n0 n0 n0 Add n0 n0 n0
    line 2 Concatenate $sTrace $sTrace "a" Add n0 n0 n0 Add n0 n0 n0 Add n0 n0 n0
    Return
end
program short
    line 1 Concatenate $sTrace $sTrace "b"
    line 2 Concatenate $sTrace $sTrace "b"
    Return
end
program start
    frame n1
    nums n0=1
    line 1 CreateTask "a" n0 long ()
    line 2 CreateTask "b" n0 short ()
    line 3 Instruction delay (num n0)
    line 4 Instruction print (string $sTrace)
    Return
end"#,
        expect![[r#"
            abab
        "#]],
    );
}

/// The task waits for another task in the middle of a turn.
#[test]
fn an_instruction_that_waits_ends_the_turn() {
    check(
        &format!(
            r#"{MARK}
program first
    frame n1
    line 1 Concatenate $sTrace $sTrace "1"
    line 2 Instruction delay (num n0)
    line 3 Concatenate $sTrace $sTrace "2"
    Return
end
program start
    frame n2/t1
    nums n0=100, n1=1
    line 1 TextMove t0 "a"
    line 2 CreateTask "f" n0 first ()
    line 3 CreateTask "a" n1 mark (string t0)
    line 4 Instruction delay (num n1)
    line 5 Instruction print (string $sTrace)
    Return
end"#
        ),
        expect![[r#"
            1a2aaaaa
        "#]],
    );
}

#[test]
fn a_wait_whose_condition_holds_keeps_the_turn() {
    check(
        &format!(
            r#"{MARK}
program first
    frame n1
    nums n0=1
    line 1 Concatenate $sTrace $sTrace "1"
    line 2 WaitUntil n0 retry
retry:
    line 3 Concatenate $sTrace $sTrace "2"
    Return
end
program start
    frame n2/t1
    nums n0=100, n1=1
    line 1 TextMove t0 "a"
    line 2 CreateTask "f" n0 first ()
    line 3 CreateTask "a" n1 mark (string t0)
    line 4 Instruction delay (num n1)
    line 5 Instruction print (string $sTrace)
    Return
end"#
        ),
        expect![[r#"
            12aaaaaa
        "#]],
    );
}

#[test]
fn tasks_run_in_the_order_of_their_creation() {
    check(
        r#"
data sTrace string[1]
program mark
    param x_sMark string t0
    frame n1/t1
    line 1 Concatenate $sTrace $sTrace t0
    line 2 Instruction delay (num n0)
    line 3 Concatenate $sTrace $sTrace t0
    line 4 Instruction delay (num n0)
    line 5 Concatenate $sTrace $sTrace t0
    Return
end
program start
    frame n3/t1
    nums n0=10, n1=0, n2=1
    line 1 TextMove t0 "z" CreateTask "z" n0 mark (string t0)
    line 2 TextMove t0 "a" CreateTask "a" n0 mark (string t0)
    line 3 Instruction delay (num n1)
    line 4 TextMove t0 "m" CreateTask "m" n0 mark (string t0)
    line 5 Instruction delay (num n2)
    line 6 Instruction print (string $sTrace)
    Return
end"#,
        expect![[r#"
            zazamzamm
        "#]],
    );
}

#[test]
fn a_task_that_ends_leaves_the_rest_of_its_turn_to_the_others() {
    check(
        &format!(
            r#"{MARK}
program short
    line 1 Concatenate $sTrace $sTrace "s"
    Return
end
program start
    frame n3/t1
    nums n0=100, n1=2, n2=1
    line 1 CreateTask "s" n0 short ()
    line 2 TextMove t0 "a" CreateTask "a" n1 mark (string t0)
    line 3 Instruction delay (num n2)
    line 4 Instruction print (string $sTrace)
    Return
end"#
        ),
        expect![[r#"
            saaaaaa
        "#]],
    );
}

#[test]
fn a_priority_is_a_number_from_1_to_100() {
    for (priority, expected) in
        [("0.4", "error 70 at row 1\n"), ("101", "error 70 at row 1\n"), ("1", "created\n"), ("100", "created\n")]
    {
        let text = format!(
            r#"
program work
    Return
end
program start
    frame n1/t1
    nums n0={priority}
    line 1 CreateTask "t" n0 work ()
    line 2 TextMove t0 "created"
    line 3 Instruction print (string t0)
    Return
end"#
        );
        assert_eq!(Bench::new(&text).run().host.record, expected, "{priority}");
    }
}

/// A task without competitors executes several turns in a row. A task that waits for a condition is checked in each
/// round.
#[test]
fn a_task_that_is_alone_has_the_same_turns_as_among_others() {
    let alone = record("Instruction delay (num n0)");
    assert!(alone.contains("-43\n") && alone.contains("\n44\n"), "{alone}");
    assert_eq!(alone, record("retry: LoadFirst n0 $bGo 0 WaitUntil n0 retry"));
}

/// Output of a run in which another task executes `wait`.
fn record(wait: &str) -> String {
    let text = format!(
        r#"
data bGo bool[1]
data n num[1]
program other
    frame n1
    nums n0=9
    line 1 {wait}
    Return
end
program late
    frame n3
    nums n1=1, n2=60
again:
    line 1 LoadFirst n0 $n 0 UnlessLess n0 n2 done
    line 2 Add n0 n0 n1 StoreFirst $n 0 n0
    line 3 Instruction print (num n0)
    Jump again
done:
    Return
end
program start
    frame n8
    nums n1=1, n2=60, n3=7, n4=5, n6=23
    line 1 CreateTask "other" n3 other ()
    line 2 Instruction delay (num n7)
count:
    line 3 LoadFirst n0 $n 0 Add n0 n0 n1 StoreFirst $n 0 n0 IfLess n0 n6 count
    line 4 CreateTask "late" n4 late ()
again:
    line 5 LoadFirst n0 $n 0 UnlessLess n0 n2 done
    line 6 Add n0 n0 n1 StoreFirst $n 0 n0
    line 7 Negate n5 n0 Instruction print (num n5)
    Jump again
done:
    line 8 StoreFirst $bGo 0 n1
    Return
end"#
    );
    Bench::new(&text).run().host.record
}
