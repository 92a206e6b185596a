//! Numbers, strings, arrays and collections, and the run-time errors at their lines (2.2 to 2.5, 3.1 to 3.4).

use expect_test::{Expect, expect};

use crate::host::check;

/// Checks the lines of `start`, which has the numbers 0 to 5 in `n0` to `n5`.
#[track_caller]
fn check_lines(data: &str, lines: &str, expected: Expect) {
    let text = format!(
        "{data}\nprogram start\nframe n20/t4/p4/v2\nnums n1=1, n2=2, n3=3, n4=4, n5=5, n6=-1, n7=0.4, n8=-0.6\n{lines}\nReturn\nend"
    );
    check(&text, expected);
}

#[test]
fn arithmetic() {
    check_lines(
        "",
        "line 1 Add n10 n2 n3 Instruction print (num n10)
         line 2 Subtract n10 n2 n3 Instruction print (num n10)
         line 3 Multiply n10 n2 n3 Instruction print (num n10)
         line 4 Divide n10 n3 n2 Instruction print (num n10)
         line 5 Remainder n10 n5 n3 Instruction print (num n10)
         line 6 Negate n10 n2 Instruction print (num n10)
         line 7 Function Max n10 n2 n3 n3 Instruction print (num n10)",
        expect![[r#"
            5
            -1
            6
            1.5
            2
            -2
            3
        "#]],
    );
}

#[test]
fn comparisons_make_truth_values() {
    check_lines(
        "",
        "line 1 Less n10 n2 n3 Instruction print (bool n10)
         line 2 LessEqual n10 n3 n2 Instruction print (bool n10)
         line 3 Equal n10 n2 n2 Instruction print (bool n10)
         line 4 NotEqual n10 n2 n2 Instruction print (bool n10)
         line 5 Not n10 n10 Instruction print (bool n10)
         line 6 TextEqual n10 \"a\" \"a\" Instruction print (bool n10)",
        expect![[r#"
            true
            false
            true
            false
            true
            true
        "#]],
    );
}

#[test]
fn division_by_0_is_an_error_at_its_line() {
    check_lines(
        "",
        "line 7 Instruction print (num n1)\nline 8 Divide n10 n1 n0",
        expect![[r#"
        1
        error 10 at row 8
    "#]],
    );
    check_lines(
        "",
        "line 7 Remainder n10 n1 n0",
        expect![[r#"
        error 10 at row 7
    "#]],
    );
}

#[test]
fn a_function_has_the_errors_of_its_instruction() {
    check_lines(
        "",
        "line 7 Function Sqrt n10 n6 n6 n6",
        expect![[r#"
        error 11 at row 7
    "#]],
    );
}

#[test]
fn a_loop_ends_beyond_its_limit() {
    check_lines(
        "",
        "line 1 Move n10 n1 Move n11 n5 Move n12 n2
         ForTest n10 n11 end
         body:
         line 2 Instruction print (num n10)
         ForNext n10 n11 body
         end:
         line 4 Instruction print (num n10)",
        expect![[r#"
            1
            3
            5
            7
        "#]],
    );
}

#[test]
fn a_loop_with_a_negative_step_counts_down() {
    check_lines(
        "",
        "line 1 Move n10 n3 Move n11 n2 Move n12 n6
         ForTest n10 n11 end
         body:
         line 2 Instruction print (num n10)
         ForNext n10 n11 body
         end:
         line 4 Instruction print (num n10)",
        expect![[r#"
            3
            2
            1
        "#]],
    );
}

#[test]
fn indexes_are_rounded() {
    check_lines(
        "data nData num[3] {10, 20, 30}",
        "line 1 LoadElement n10 $nData n7 Instruction print (num n10)
         line 2 Add n11 n7 n2 LoadElement n10 $nData n11 Instruction print (num n10)",
        expect![[r#"
            10
            30
        "#]],
    );
}

#[test]
fn an_index_beyond_the_size_is_an_error() {
    check_lines(
        "data nData num[3]",
        "line 5 LoadElement n10 $nData n3",
        expect![[r#"
        error 20 at row 5
    "#]],
    );
    check_lines(
        "data nData num[3]",
        "line 6 StoreElement $nData n3 n0",
        expect![[r#"
        error 20 at row 6
    "#]],
    );
}

#[test]
fn a_negative_index_is_an_error() {
    check_lines(
        "data nData num[3]",
        "line 5 LoadElement n10 $nData n8",
        expect![[r#"
        error 21 at row 5
    "#]],
    );
}

#[test]
fn arrays_of_several_dimensions() {
    check_lines(
        "data nGrid num[2, 3] {1, 2, 3, 4, 5, 6}\ndata nCube num[2, 2, 2]",
        "line 1 LoadElement2 n10 $nGrid n1 n2 Instruction print (num n10)
         line 2 StoreElement2 $nGrid n0 n1 n5 LoadElement2 n10 $nGrid n0 n1 Instruction print (num n10)
         line 3 Locate2 p0 $nGrid n1 n0 Load n10 p0 0 Instruction print (num n10)
         line 4 Move n10 n1 Move n11 n0 Move n12 n1 Locate3 p0 $nCube n10 Store p0 0 n5 Load n10 p0 0
         Instruction print (num n10)
         line 5 LoadElement2 n10 $nGrid n2 n0",
        expect![[r#"
            6
            5
            4
            5
            error 20 at row 5
        "#]],
    );
}

#[test]
fn collections_have_their_values_under_keys() {
    check_lines(
        "data nAges num[\"ann\", \"bob\"] {40, 50}",
        "line 1 LoadKey n10 $nAges \"bob\" Instruction print (num n10)
         line 2 StoreKey $nAges \"ann\" n5 LocateKey p0 $nAges \"ann\" Load n10 p0 0 Instruction print (num n10)
         line 3 TextMove t0 \"eve\" Instruction insert (slot $nAges[t0]) -> bool n10 Instruction print (bool n10)
         line 4 LoadKey n10 $nAges \"eve\" Instruction print (num n10)
         line 5 LoadKey n10 $nAges \"joe\"",
        expect![[r#"
            50
            5
            true
            0
            error 20 at row 5
        "#]],
    );
}

#[test]
fn a_text_keeps_its_first_128_bytes() {
    check_lines(
        "",
        "line 1 TextMove t0 \"0123456789abcdef\"
         line 2 Concatenate t0 t0 t0
         line 3 Concatenate t0 t0 t0
         line 4 Concatenate t0 t0 t0
         line 5 Concatenate t0 t0 \"x\"
         line 6 Instruction len (string t0) -> num n10 Instruction print (num n10)",
        expect![[r#"
            128
        "#]],
    );
}

#[test]
fn structures_are_copied_and_compared_with_all_fields() {
    check_lines(
        "data trA trsf[1] {(1 2 3 0 0 90)}\ndata trB trsf[1]",
        "line 1 Compare n10 trsf $trA $trB Instruction print (bool n10)
         line 2 Copy trsf $trB $trA
         line 3 Compare n10 trsf $trA $trB Instruction print (bool n10)
         line 4 LoadFirst n10 $trB 5 Instruction print (num n10)
         line 5 StoreFirst $trB 5 n0 LoadFirst n10 $trA 5 Instruction print (num n10)",
        expect![[r#"
            false
            true
            90
            90
        "#]],
    );
}

#[test]
fn values_of_user_types_are_copied_with_their_containers() {
    check_lines(
        "type Slot { sNames string[\"a\"] {\"x\"} }\ndata tA @Slot[1]\ndata tB @Slot[1]",
        "line 1 FirstField v0 $tA 0 LocateKey p0 v0 \"a\" TextMove p0 \"own\"
         line 2 Copy @Slot $tB $tA
         line 3 TextMove p0 \"later\"
         line 4 Instruction print (user $tB)
         line 5 Compare n10 @Slot $tB $tA Instruction print (bool n10)",
        expect![[r#"
            {"own"}
            false
        "#]],
    );
}

#[test]
fn an_error_in_a_called_program_is_at_the_line_of_that_program() {
    check_lines(
        "program divide\nframe n3\nline 21 Move n1 n0\nline 22 Divide n0 n1 n2\nReturn\nend",
        "line 5 Call divide ()",
        expect![[r#"
            error 10 at row 22
        "#]],
    );
}

#[test]
fn an_item_that_no_library_has_is_an_error_when_it_is_used() {
    check_lines(
        "library part \"Disk://part\"\nimport part nX data num[]",
        "line 1 Instruction print (num n1)\nline 2 LoadFirst n10 i0 0",
        expect![[r#"
            1
            error 80 at row 2
        "#]],
    );
}

#[test]
fn a_line_that_has_no_meaning_is_an_error() {
    check_lines(
        "",
        "line 3 Instruction invalid ()",
        expect![[r#"
        error 61 at row 3
    "#]],
    );
}
