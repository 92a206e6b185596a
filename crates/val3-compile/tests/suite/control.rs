//! Statements that jump, and their instruction lines (2.2.5).

use expect_test::{Expect, expect};

use crate::show::code;

fn check(code_lines: &str, expected: Expect) {
    let data = "num nX\nprogram start()\n  num i\n  bool b\n  string s\nbegin\n";
    expected.assert_eq(&code(&format!("{data}{code_lines}\nend")));
}

#[test]
fn conditions_jump_where_they_are_decided() {
    check(
        "if i>3 and nX!=4\ni=1\nelseIf i==2 or b\ni=2\nelse\ni=3\nendIf",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n7/t1
                nums n2=3, n4=4, n5=1, n6=2
            line 10
                UnlessLess n2 n0 L5
                LoadFirst n3 $nX 0
                IfEqual n3 n4 L5
            line 11
                Move n0 n5
                Jump L10
            L5:
            line 12
                IfEqual n0 n6 L7
                JumpUnless n1 L9
            L7:
            line 13
                Move n0 n6
                Jump L10
            L9:
            line 15
                Move n0 n2
            L10:
            closing 17 at 483 486
                Return
            end
        "#]],
    );
}

#[test]
fn negated_conditions_need_no_operation() {
    check(
        "if !(i<3)\ni=1\nendIf\nif b==false\ni=2\nendIf\nif !(b or i>=1)\ni=3\nendIf",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n5/t1
                nums n2=3, n3=1, n4=2
            line 10
                IfLess n0 n2 L2
            line 11
                Move n0 n3
            L2:
            line 13
                JumpIf n1 L4
            line 14
                Move n0 n4
            L4:
            line 16
                JumpIf n1 L7
                IfLessEqual n3 n0 L7
            line 17
                Move n0 n2
            L7:
            closing 19 at 494 497
                Return
            end
        "#]],
    );
}

#[test]
fn loops_are_compiled() {
    check(
        "while i<5\ni=i+1\nendWhile\ndo\ni=i-1\nuntil i<=0",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n5/t1
                nums n2=1, n3=5
                Jump L2
            L1:
            line 11
                Add n0 n0 n2
            L2:
            line 10
                IfLess n0 n3 L1
            L3:
            line 14
                Subtract n0 n0 n2
            line 15
                UnlessLessEqual n0 n4 L3
            closing 16 at 471 474
                Return
            end
        "#]],
    );
}

#[test]
fn the_counter_of_a_loop_may_be_any_variable() {
    check(
        "for i=1 to nX step -2\nb=true\nendFor",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n6/t1
                nums n4=1, n5=-2
            line 10
                LoadFirst n2 $nX 0
                Move n3 n5
                Move n0 n4
                ForTest n0 n2 L6
            L4:
            line 11
                Move n1 n4
                ForNext n0 n2 L4
            L6:
            closing 13 at 462 465
                Return
            end
        "#]],
    );
    check(
        "for nX=1 to 10\nb=true\nendFor",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n7/t1
                nums n2=10, n3=1, n5=1
            line 10
                Move n4 n5
                ForTest n4 n2 L7
            L2:
                StoreFirst $nX 0 n4
            line 11
                Move n1 n5
                LoadFirst n6 $nX 0
                Move n4 n6
                ForNextUp n4 n2 L2
            L7:
                StoreFirst $nX 0 n4
            closing 13 at 455 458
                Return
            end
        "#]],
    );
}

#[test]
fn cases_are_compared_one_after_the_other() {
    check(
        "switch i+1\ncase 1,2\nreturn\nbreak\ncase -3\ni=0\nbreak\ndefault\nb=true\nbreak\nendSwitch",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n7/t1
                nums n2=1, n4=2, n5=-3
            line 10
                Add n3 n0 n2
                IfEqual n3 n2 L5
                IfEqual n3 n4 L5
                IfEqual n3 n5 L8
                Jump L10
            L5:
            line 12
                Line
                Return
            closing 13 at 453 458
                Jump L12
            L8:
            line 15
                Move n0 n6
            closing 16 at 471 476
                Jump L12
            L10:
            line 18
                Move n1 n2
            closing 19 at 492 497
                Jump L12
            L12:
            closing 21 at 508 511
                Return
            end
        "#]],
    );
    check(
        "switch s\ncase \"a\"\ni=0\nbreak\nendSwitch",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n3/t1
            line 10
                IfTextEqual t0 "a" L2
                Jump L4
            L2:
            line 12
                Move n0 n2
            closing 13 at 448 453
                Jump L4
            L4:
            closing 15 at 464 467
                Return
            end
        "#]],
    );
}

#[test]
fn a_wait_evaluates_its_condition_again() {
    check(
        "wait(i>3 or b)\nb=watch(nX==2,i+1)\nwatch(b,0)",
        expect![[r#"
            program start
                file 0 stack 164
                local i num n0
                local b bool n1
                local s string n2/t0
                frame n10/t1
                nums n3=3, n4=1, n7=2
            line 10
                Line
            L1:
                Less n2 n3 n0
                JumpIf n2 L4
                Move n2 n1
            L4:
                WaitUntil n2 L1
            line 11
                Add n2 n0 n4
                Move n5 n2
            L7:
                LoadFirst n6 $nX 0
                Equal n8 n6 n7
                Watch n1 n8 n5 L7
            line 12
                Move n2 n9
            L11:
                Watch n5 n1 n2 L11
            closing 13 at 471 474
                Return
            end
        "#]],
    );
}
