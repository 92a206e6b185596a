//! Names and hiding (2.5.2).

use expect_test::expect;

use crate::show::{faults, types};

#[test]
fn locals_hide_parameters_hide_data() {
    let listing = r#"
        num nA
        string sB
        program start(bool x_b)
          string nA
          bool world
        begin
          nA="text"
          sB=nA
          x_b=world
        end
    "#;
    expect![[r#"
        nA: string
        sB: string | nA: string
        x_b: bool | world: bool
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn built_in_names() {
    let listing = r#"
        point pA
        frame fA
        tool tA
        bool bA
        pA=here(flange,world)
        tA=flange
        fA=world
        bA=true
        true=bA
        joint=1
    "#;
    expect![[r#"
        pA: pointRx | flange: tool | world: frame | here(flange,world): pointRx
        tA: tool | flange: tool
        fA: frame | world: frame
        bA: bool
        bA: bool
        joint: blend
        ! true: NotAssignable
        ! joint: NotAssignable
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn names_that_are_no_values() {
    let listing = r#"
        library part "Disk://part/part.pjx"
        type Slot "Disk://Slot/Slot.pjx"
        num nA
        nA=other
        nA=part
        nA=Slot
        nA=sin
        nA=nB
        nB=1
        program other()
        begin
        end
        --- part
        public num nX
        --- Slot
        public num nX
    "#;
    expect![[r#"
        main/start.pgx:5 `other` NotAValue { name: "other", is: Program }
        main/start.pgx:6 `part` NotAValue { name: "part", is: Library }
        main/start.pgx:7 `Slot` NotAValue { name: "Slot", is: Type }
        main/start.pgx:8 `sin` NotAValue { name: "sin", is: Instruction }
        main/start.pgx:9 `nB` UnknownName { name: "nB", near: Some("nA") }
    "#]]
    .assert_eq(&faults(listing));
}
