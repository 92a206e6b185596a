//! Libraries in memory, and tasks that are visible only where they were created (5.3, 6.2 to 6.7).

use expect_test::{Expect, expect};

use crate::host::Bench;

/// Checks the record when `application` runs with the autoload library `part`.
#[track_caller]
fn check(application: &str, library: &str, expected: Expect) {
    let application = format!("library part \"part\" autoload\n{application}");
    let bench = Bench::with_libraries(&application, &[&format!("image part \"part.pjx\"\n{library}")]);
    expected.assert_eq(&bench.run().host.record);
}

#[test]
fn data_of_a_library_are_shared_with_its_programs() {
    check(
        r#"
import part nX data num[]
import part show program ()
program start
    frame n2
    nums n1=8
    line 1 LoadFirst n0 i0 0 Instruction print (num n0)
    line 2 StoreFirst i0 0 n1
    line 3 Call import 1 ()
    Return
end"#,
        r#"
data public nX num[1] {7}
program public show
    frame n1
    line 11 LoadFirst n0 $nX 0 Instruction print (num n0)
    Return
end"#,
        expect![[r#"
            7
            8
        "#]],
    );
}

#[test]
fn a_program_of_a_library_takes_parameters() {
    check(
        r#"
import part twice program (num, num&)
program start
    frame n2
    nums n0=4
    line 1 Call import 0 (num n0, num n1)
    line 2 Instruction print (num n1)
    Return
end"#,
        r#"
program public twice
    param x_nValue num n0
    param x_nResult num p0
    frame n1/p1
    line 11 Add n0 n0 n0 Store p0 0 n0
    Return
end"#,
        expect![[r#"
            8
        "#]],
    );
}

#[test]
fn private_and_missing_items_are_errors_when_they_are_used() {
    for import in ["nPrivate", "nOther", "sPublic"] {
        check(
            &format!("import part {import} data num[]\nprogram start\nframe n1\nline 1 LoadFirst n0 i0 0\nReturn\nend"),
            "data nPrivate num[1]\ndata public sPublic string[1]",
            expect![["error 80 at row 1\n"]],
        );
    }
}

#[test]
fn an_error_in_a_library_is_at_its_line() {
    check(
        "import part fail program ()\nprogram start\nline 1 Call import 0 ()\nReturn\nend",
        "program public fail\nframe n2\nline 11 Line\nline 12 Divide n0 n0 n1\nReturn\nend",
        expect![[r#"
            error 10 at row 12
        "#]],
    );
}

#[test]
fn a_library_is_loaded_under_an_identifier_by_an_instruction() {
    let application = r#"
library part ""
import part nX data num[]
program start
    frame n2/t1
    line 1 TextMove t0 "other" Instruction libLoad (library part, string t0) -> num n1 Instruction print (num n1)
    line 2 TextMove t0 "second" Instruction libLoad (library part, string t0) -> num n1 Instruction print (num n1)
    line 3 LoadFirst n0 i0 0 Instruction print (num n0)
    Return
end"#;
    let libraries = ["image first \"\"\ndata public nX num[1] {1}", "image second \"\"\ndata public nX num[1] {2}"];
    expect![[r#"
        10
        0
        2
    "#]]
    .assert_eq(&Bench::with_libraries(application, &libraries).run().host.record);
}

/// Both create a task `own`. Only their own task is visible to each.
#[test]
fn a_task_is_visible_only_to_the_library_that_has_created_it() {
    let programs = r#"
program work
    frame n1
    nums n0=1
    line 21 Instruction delay (num n0)
    Return
end
program public create
    frame n1
    nums n0=10
    line 31 CreateTask "own" n0 work ()
    Return
end
program public status
    frame n1/t1
    line 41 TextMove t0 "own" Instruction taskStatus (string t0) -> num n0 Instruction print (num n0)
    Return
end
program public kill
    frame t1
    line 51 TextMove t0 "own" Instruction taskKill (string t0)
    Return
end"#;
    check(
        &format!(
            r#"
import part create program ()
import part status program ()
{programs}
program start
    line 1 Call import 0 ()
    line 2 Call status ()
    line 3 Call import 1 ()
    line 4 Call create ()
    line 5 Call status ()
    line 6 Call kill ()
    line 7 Call status ()
    line 8 Call import 1 ()
    Return
end"#
        ),
        programs,
        expect![[r#"
            -1
            1
            1
            -1
            1
        "#]],
    );
}

#[test]
fn halting_the_task_of_a_library_is_an_error() {
    check(
        r#"
import part create program ()
program start
    frame t1
    line 1 Call import 0 ()
    line 2 TextMove t0 "own" Instruction taskSuspend (string t0)
    Return
end"#,
        "program work\nline 21 Return\nend
         program public create\nframe n1\nnums n0=10\nline 31 CreateTask \"own\" n0 work ()\nReturn\nend",
        expect![[r#"
            error 30 at row 2
        "#]],
    );
}
