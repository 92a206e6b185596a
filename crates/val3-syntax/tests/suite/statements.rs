//! Trees of all statements, expressions and special forms.

use expect_test::{Expect, expect};

use crate::show::tree;

#[track_caller]
fn check(lines: &str, expected: Expect) {
    expected.assert_eq(&tree(lines));
}

#[test]
fn calls() {
    check(
        "call p()\ncall lib:p(1, nA)\ncall P (x)",
        expect![[r#"
        (CALL_STMT call (CALL_EXPR (NAME_REF p) (ARG_LIST ( ))))
        (CALL_STMT call (CALL_EXPR (LIBRARY_PATH (NAME_REF lib) : (NAME_REF p)) (ARG_LIST ( (LITERAL 1) , (NAME_REF nA) ))))
        (CALL_STMT call (CALL_EXPR (NAME_REF P) (ARG_LIST ( (NAME_REF x) ))))
    "#]],
    );
}

#[test]
fn instructions() {
    check(
        "movej(pA, tGrip, mFast)\ntitle (\"x\")\nid:libLoad(\"Disk://a\")\n$exec(\"a=1\")\nn=lib:$libOpen()",
        expect![[r#"
        (EXPR_STMT (CALL_EXPR (NAME_REF movej) (ARG_LIST ( (NAME_REF pA) , (NAME_REF tGrip) , (NAME_REF mFast) ))))
        (EXPR_STMT (CALL_EXPR (NAME_REF title) (ARG_LIST ( (LITERAL "x") ))))
        (EXPR_STMT (CALL_EXPR (LIBRARY_PATH (NAME_REF id) : (NAME_REF libLoad)) (ARG_LIST ( (LITERAL "Disk://a") ))))
        (EXPR_STMT (CALL_EXPR (NAME_REF $exec) (ARG_LIST ( (LITERAL "a=1") ))))
        (ASSIGN_STMT (NAME_REF n) = (CALL_EXPR (LIBRARY_PATH (NAME_REF lib) : (NAME_REF $libOpen)) (ARG_LIST ( ))))
    "#]],
    );
}

#[test]
fn assignments() {
    check(
        "a=1\na[0].b = \"x\"\nlib:tT[\"k\"].tData[i].pP.config.shoulder=lefty\na=b=c=0",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF a) = (LITERAL 1))
        (ASSIGN_STMT (FIELD_EXPR (INDEX_EXPR (NAME_REF a) [ (LITERAL 0) ]) . (NAME_REF b)) = (LITERAL "x"))
        (ASSIGN_STMT (FIELD_EXPR (FIELD_EXPR (FIELD_EXPR (INDEX_EXPR (FIELD_EXPR (INDEX_EXPR (LIBRARY_PATH (NAME_REF lib) : (NAME_REF tT)) [ (LITERAL "k") ]) . (NAME_REF tData)) [ (NAME_REF i) ]) . (NAME_REF pP)) . (NAME_REF config)) . (NAME_REF shoulder)) = (NAME_REF lefty))
        (ASSIGN_STMT (NAME_REF a) = (ASSIGN_EXPR (NAME_REF b) = (ASSIGN_EXPR (NAME_REF c) = (LITERAL 0))))
    "#]],
    );
}

#[test]
fn conditions() {
    check(
        "if a\nb=1\nelseIf(c)\nelseIf d\nelse\nb=2\nendIf\nif(x) and y\nendIf",
        expect![[r#"
        (IF_STMT if (NAME_REF a)
          (BLOCK
            (ASSIGN_STMT (NAME_REF b) = (LITERAL 1)))
          (ELSE_IF_CLAUSE elseIf (PAREN_EXPR ( (NAME_REF c) ))
            (BLOCK))
          (ELSE_IF_CLAUSE elseIf (NAME_REF d)
            (BLOCK))
          (ELSE_CLAUSE else
            (BLOCK
              (ASSIGN_STMT (NAME_REF b) = (LITERAL 2)))) endIf)
        (IF_STMT if (BIN_EXPR (PAREN_EXPR ( (NAME_REF x) )) and (NAME_REF y))
          (BLOCK) endIf)
    "#]],
    );
}

#[test]
fn loops() {
    check(
        "while true\ndo\nx=1\nuntil(b)\nendWhile",
        expect![[r#"
        (WHILE_STMT while (LITERAL true)
          (BLOCK
            (DO_STMT do
              (BLOCK
                (ASSIGN_STMT (NAME_REF x) = (LITERAL 1))) until (PAREN_EXPR ( (NAME_REF b) )))) endWhile)
    "#]],
    );
}

#[test]
fn counted_loops() {
    check(
        "for i=0 to 9\nendFor\nfor a[0].n = n to -1 step -.5\nx=1\nendFor",
        expect![[r#"
        (FOR_STMT for (NAME_REF i) = (LITERAL 0) to (LITERAL 9)
          (BLOCK) endFor)
        (FOR_STMT for (FIELD_EXPR (INDEX_EXPR (NAME_REF a) [ (LITERAL 0) ]) . (NAME_REF n)) = (NAME_REF n) to (PREFIX_EXPR - (LITERAL 1)) step (PREFIX_EXPR - (LITERAL .5))
          (BLOCK
            (ASSIGN_STMT (NAME_REF x) = (LITERAL 1))) endFor)
    "#]],
    );
}

#[test]
fn switches() {
    check(
        "switch n\ncase 1\nx=1\nbreak\ncase 2, -3, lib:nEnum\nbreak\ndefault\nx=2\nbreak\nendSwitch\nswitch s\nendSwitch",
        expect![[r#"
            (SWITCH_STMT switch (NAME_REF n)
              (CASE_CLAUSE case (LITERAL 1)
                (BLOCK
                  (ASSIGN_STMT (NAME_REF x) = (LITERAL 1))) break)
              (CASE_CLAUSE case (LITERAL 2) , (PREFIX_EXPR - (LITERAL 3)) , (LIBRARY_PATH (NAME_REF lib) : (NAME_REF nEnum))
                (BLOCK) break)
              (DEFAULT_CLAUSE default
                (BLOCK
                  (ASSIGN_STMT (NAME_REF x) = (LITERAL 2))) break) endSwitch)
            (SWITCH_STMT switch (NAME_REF s) endSwitch)
        "#]],
    );
}

#[test]
fn lines_after_a_break_are_accepted() {
    check(
        "switch n\ncase 1\nbreak\nx=1\nif b\nendIf\ncase 2\nbreak\nendSwitch",
        expect![[r#"
        (SWITCH_STMT switch (NAME_REF n)
          (CASE_CLAUSE case (LITERAL 1)
            (BLOCK) break) (ASSIGN_STMT (NAME_REF x) = (LITERAL 1)) (IF_STMT if (NAME_REF b)
          (BLOCK) endIf)
          (CASE_CLAUSE case (LITERAL 2)
            (BLOCK) break) endSwitch)
    "#]],
    );
}

#[test]
fn tasks() {
    check(
        "taskCreate \"t\", 10, p(1)\ntaskCreate (sName[0]), 5, lib:p()\ntaskCreateSync \"s\", 0.02, bOver, p()",
        expect![[r#"
        (TASK_CREATE_STMT taskCreate (LITERAL "t") , (LITERAL 10) , (CALL_EXPR (NAME_REF p) (ARG_LIST ( (LITERAL 1) ))))
        (TASK_CREATE_STMT taskCreate (PAREN_EXPR ( (INDEX_EXPR (NAME_REF sName) [ (LITERAL 0) ]) )) , (LITERAL 5) , (CALL_EXPR (LIBRARY_PATH (NAME_REF lib) : (NAME_REF p)) (ARG_LIST ( ))))
        (TASK_CREATE_STMT taskCreateSync (LITERAL "s") , (LITERAL 0.02) , (NAME_REF bOver) , (CALL_EXPR (NAME_REF p) (ARG_LIST ( ))))
    "#]],
    );
}

#[test]
fn return_and_print() {
    check(
        "? \"x\"+n\n?p.trsf\nreturn",
        expect![[r#"
        (PRINT_STMT ? (BIN_EXPR (LITERAL "x") + (NAME_REF n)))
        (PRINT_STMT ? (FIELD_EXPR (NAME_REF p) . (NAME_REF trsf)))
        (RETURN_STMT return)
    "#]],
    );
}

#[test]
fn literals() {
    check(
        "x=12\nx=.5\nx=1.5e-16\nx=2E+3\nb=true\nb=FALSE\ns=\"\\\"\ns=\"// no comment\"\ns=\"\"",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF x) = (LITERAL 12))
        (ASSIGN_STMT (NAME_REF x) = (LITERAL .5))
        (ASSIGN_STMT (NAME_REF x) = (LITERAL 1.5e-16))
        (ASSIGN_STMT (NAME_REF x) = (LITERAL 2E+3))
        (ASSIGN_STMT (NAME_REF b) = (LITERAL true))
        (ASSIGN_STMT (NAME_REF b) = (LITERAL FALSE))
        (ASSIGN_STMT (NAME_REF s) = (LITERAL "\"))
        (ASSIGN_STMT (NAME_REF s) = (LITERAL "// no comment"))
        (ASSIGN_STMT (NAME_REF s) = (LITERAL ""))
    "#]],
    );
}

#[test]
fn structures() {
    check(
        "t={1,2,,3}\nif p.config=={lefty, , wfree}\nendIf\nf({100,{1,2}},{})",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF t) = (STRUCT_LITERAL { (LITERAL 1) , (LITERAL 2) , , (LITERAL 3) }))
        (IF_STMT if (BIN_EXPR (FIELD_EXPR (NAME_REF p) . (NAME_REF config)) == (STRUCT_LITERAL { (NAME_REF lefty) , , (NAME_REF wfree) }))
          (BLOCK) endIf)
        (EXPR_STMT (CALL_EXPR (NAME_REF f) (ARG_LIST ( (STRUCT_LITERAL { (LITERAL 100) , (STRUCT_LITERAL { (LITERAL 1) , (LITERAL 2) }) }) , (STRUCT_LITERAL { }) ))))
    "#]],
    );
}

#[test]
fn indexes_and_fields() {
    check(
        "x=a[1,2,3]\nx=c[\"key\"].trsf.rx\nx=f(a[0])[1].b",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF x) = (INDEX_EXPR (NAME_REF a) [ (LITERAL 1) , (LITERAL 2) , (LITERAL 3) ]))
        (ASSIGN_STMT (NAME_REF x) = (FIELD_EXPR (FIELD_EXPR (INDEX_EXPR (NAME_REF c) [ (LITERAL "key") ]) . (NAME_REF trsf)) . (NAME_REF rx)))
        (ASSIGN_STMT (NAME_REF x) = (FIELD_EXPR (INDEX_EXPR (CALL_EXPR (NAME_REF f) (ARG_LIST ( (INDEX_EXPR (NAME_REF a) [ (LITERAL 0) ]) ))) [ (LITERAL 1) ]) . (NAME_REF b)))
    "#]],
    );
}

#[test]
fn operators_bind_by_precedence() {
    check(
        "x=a or b and c xor d==e<f+g*h\nx=a*b+c<d!=e xor f and g or h",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (NAME_REF a) or (BIN_EXPR (NAME_REF b) and (BIN_EXPR (NAME_REF c) xor (BIN_EXPR (NAME_REF d) == (BIN_EXPR (NAME_REF e) < (BIN_EXPR (NAME_REF f) + (BIN_EXPR (NAME_REF g) * (NAME_REF h)))))))))
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (BIN_EXPR (BIN_EXPR (BIN_EXPR (BIN_EXPR (BIN_EXPR (BIN_EXPR (NAME_REF a) * (NAME_REF b)) + (NAME_REF c)) < (NAME_REF d)) != (NAME_REF e)) xor (NAME_REF f)) and (NAME_REF g)) or (NAME_REF h)))
    "#]],
    );
}

#[test]
fn equal_operators_group_from_the_left() {
    check(
        "x=a-b-c\nx=a/b%c*d\nx=a>=b<=c",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (BIN_EXPR (NAME_REF a) - (NAME_REF b)) - (NAME_REF c)))
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (BIN_EXPR (BIN_EXPR (NAME_REF a) / (NAME_REF b)) % (NAME_REF c)) * (NAME_REF d)))
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (BIN_EXPR (NAME_REF a) >= (NAME_REF b)) <= (NAME_REF c)))
    "#]],
    );
}

#[test]
fn unary_operators() {
    check(
        "x=a * -1\nx=!a.trsf*b.trsf\nx=-a[1]+-b\nx=!(a and !b)",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (NAME_REF a) * (PREFIX_EXPR - (LITERAL 1))))
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (PREFIX_EXPR ! (FIELD_EXPR (NAME_REF a) . (NAME_REF trsf))) * (FIELD_EXPR (NAME_REF b) . (NAME_REF trsf))))
        (ASSIGN_STMT (NAME_REF x) = (BIN_EXPR (PREFIX_EXPR - (INDEX_EXPR (NAME_REF a) [ (LITERAL 1) ])) + (PREFIX_EXPR - (NAME_REF b))))
        (ASSIGN_STMT (NAME_REF x) = (PREFIX_EXPR ! (PAREN_EXPR ( (BIN_EXPR (NAME_REF a) and (PREFIX_EXPR ! (NAME_REF b))) ))))
    "#]],
    );
}

#[test]
fn keywords_in_any_letter_case() {
    check(
        "IF a\nELSEIF b\nElse\nENDIF\nWhile a\nendwhile\nTaskCreate \"t\", 1, p()",
        expect![[r#"
        (IF_STMT IF (NAME_REF a)
          (BLOCK)
          (ELSE_IF_CLAUSE ELSEIF (NAME_REF b)
            (BLOCK))
          (ELSE_CLAUSE Else
            (BLOCK)) ENDIF)
        (WHILE_STMT While (NAME_REF a)
          (BLOCK) endwhile)
        (TASK_CREATE_STMT TaskCreate (LITERAL "t") , (LITERAL 1) , (CALL_EXPR (NAME_REF p) (ARG_LIST ( ))))
    "#]],
    );
}

#[test]
fn names_that_look_like_keywords() {
    check(
        "_x=$y\nendIfs=1\nx=iff\nthen=1\nnot=2\nx=begins",
        expect![[r#"
        (ASSIGN_STMT (NAME_REF _x) = (NAME_REF $y))
        (ASSIGN_STMT (NAME_REF endIfs) = (LITERAL 1))
        (ASSIGN_STMT (NAME_REF x) = (NAME_REF iff))
        (ASSIGN_STMT (NAME_REF then) = (LITERAL 1))
        (ASSIGN_STMT (NAME_REF not) = (LITERAL 2))
        (ASSIGN_STMT (NAME_REF x) = (NAME_REF begins))
    "#]],
    );
}
