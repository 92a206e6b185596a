use expect_test::{Expect, expect};

use super::*;
use crate::testing::MarkedListing;

/// Checks the code with its inlay hints inserted.
fn check_with(listing: &str, settings: InlayHintSettings, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let (db, file) = (marked.db(), marked.at().file);
    let mut text = file.text(db).to_string();
    let whole = TextRange::up_to(TextSize::of(text.as_str()));
    for hint in inlay_hints(db, file, whole, &settings).into_iter().rev() {
        let label =
            if hint.kind.is_before() { format!("‹{}›", hint.label) } else { format!(" ‹{}›", hint.label) };
        text.insert_str(usize::from(hint.offset), &label);
    }
    let code = text.split("begin\n").nth(1).unwrap().split("\nend").next().unwrap();
    expected.assert_eq(&format!("{code}\n"));
}

fn check(listing: &str, expected: Expect) {
    check_with(listing, InlayHintSettings::default(), expected);
}

/// Checks the declarations to which the hints link.
fn check_targets(listing: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let (db, file) = (marked.db(), marked.at().file);
    let settings = InlayHintSettings::default();
    let whole = TextRange::up_to(TextSize::of(file.text(db).as_ref()));
    let mut shown = String::new();
    for hint in inlay_hints(db, file, whole, &settings) {
        let at = FilePosition { file, offset: hint.offset };
        let target = inlay_hint_target(db, at, &hint.label, &settings);
        let place = |target: FileRange| format!("{} {}", target.file.path(db), &target.file.text(db)[target.range]);
        shown += &format!("{} -> {}\n", hint.label, target.map_or("nothing".to_owned(), place));
    }
    expected.assert_eq(&shown);
}

#[test]
fn hints_lead_to_declarations() {
    check_targets(
        MOVES,
        expect![[r#"
        in fTable[0] -> /cell/usr/usrapp/main/main.dtx fTable
        Cartesian, leave 12.5, reach 50 -> /cell/usr/usrapp/main/main.dtx mFast
        in fTable[0] -> /cell/usr/usrapp/main/main.dtx fTable
        off -> /cell/usr/usrapp/main/main.dtx mSlow
        joint, leave 50, reach 50 -> /cell/usr/usrapp/part/part.dtx mCarry
        jPosition: -> nothing
        joint -> nothing
        j1: -> nothing
        j2: -> nothing
        j3: -> nothing
        j4: -> nothing
        j5: -> nothing
        j6: -> nothing
    "#]],
    );
    check_targets(
        "call pick(1)$0\nprogram pick(num x_n)\nbegin\nend",
        expect![[r#"
        x_n: -> /cell/usr/usrapp/main/pick.pgx x_n
    "#]],
    );
    check_targets(
        "num nA\nnA=limit(nA,0,1)$0",
        expect![[r#"
        nMin: -> nothing
        nMax: -> nothing
    "#]],
    );
}

#[test]
fn literals_show_their_parameter() {
    check(
        "num nA\nnA=limit(nA,0,-10)$0\nnA=sin(30)\nputln(\"a\")",
        expect![[r#"
        nA=limit(nA,‹nMin:›0,‹nMax:›-10)
        nA=sin(30)
        putln("a")
    "#]],
    );
    check(
        "call pick(1,\"a\",nA)$0\nnum nA\nprogram pick(num x_n, string x_s, num x_m)\nbegin\nend",
        expect![[r#"
        call pick(‹x_n:›1,‹x_s:›"a",nA)
    "#]],
    );
    check(
        "taskCreate \"reader\",10,run(2)$0\nprogram run(num x_nStep)\nbegin\nend",
        expect![[r#"
        taskCreate ‹sName:›"reader",‹nPriority:›10,run(‹x_nStep:›2)
    "#]],
    );
}

#[test]
fn braces_show_their_type() {
    check(
        "point pA\npA=appro(pA,{0,0,-100,0,0,0})$0\npA={{0,0,0,0,0,0},{sfree,efree,wfree}}",
        expect![[r#"
            pA=appro(pA,‹trTransformation:›‹trsf›{‹x:›0,‹y:›0,‹z:›-100,‹rx:›0,‹ry:›0,‹rz:›0})
            pA=‹point›{‹trsf:›{‹x:›0,‹y:›0,‹z:›0,‹rx:›0,‹ry:›0,‹rz:›0},‹config:›{sfree,efree,wfree}}
        "#]],
    );
}

const MOVES: &str = "cls()$0\nmovej(pA,tGrip,mFast)\nmovel(pA,tGrip,mSlow)\nmovel(pB,tGrip,part:mCarry)\nmovej({0,0,0,0,0,0},tGrip,mMine)\nmMine.vel=3\ntool tGrip\nmdesc mMine\nlibrary part \"Disk://part/part.pjx\"\n--- part\npublic mdesc mCarry\n=== main/main.dtx\n<Database><Datas>\n<Data name=\"pA\" xsi:type=\"array\" type=\"pointRx\" size=\"1\"><Value key=\"0\" fatherId=\"fTable[0]\" /></Data>\n<Data name=\"pB\" xsi:type=\"array\" type=\"pointRx\" size=\"1\" />\n<Data name=\"fTable\" xsi:type=\"array\" type=\"frame\" size=\"1\" />\n<Data name=\"tGrip\" xsi:type=\"array\" type=\"tool\" size=\"1\" />\n<Data name=\"mFast\" xsi:type=\"array\" type=\"mdesc\" size=\"1\"><Value key=\"0\" blend=\"cartesian\" leave=\"12.5\" /></Data>\n<Data name=\"mSlow\" xsi:type=\"array\" type=\"mdesc\" size=\"1\"><Value key=\"0\" blend=\"off\" /></Data>\n<Data name=\"mMine\" xsi:type=\"array\" type=\"mdesc\" size=\"1\" />\n</Datas></Database>";

#[test]
fn moves_show_frame_and_blend() {
    check(
        MOVES,
        expect![[r#"
            cls()
            movej(pA ‹in fTable[0]›,tGrip,mFast ‹Cartesian, leave 12.5, reach 50›)
            movel(pA ‹in fTable[0]›,tGrip,mSlow ‹off›)
            movel(pB,tGrip,part:mCarry ‹joint, leave 50, reach 50›)
            movej(‹jPosition:›‹joint›{‹j1:›0,‹j2:›0,‹j3:›0,‹j4:›0,‹j5:›0,‹j6:›0},tGrip,mMine)
            mMine.vel=3
        "#]],
    );
}

#[test]
fn each_kind_can_be_switched_off() {
    let none = InlayHintSettings { parameter_names: false, literal_types: false, point_frames: false, blends: false };
    check_with(
        MOVES,
        none,
        expect![[r#"
        cls()
        movej(pA,tGrip,mFast)
        movel(pA,tGrip,mSlow)
        movel(pB,tGrip,part:mCarry)
        movej({0,0,0,0,0,0},tGrip,mMine)
        mMine.vel=3
    "#]],
    );
    check_with(
        MOVES,
        InlayHintSettings { blends: true, ..none },
        expect![[r#"
        cls()
        movej(pA,tGrip,mFast ‹Cartesian, leave 12.5, reach 50›)
        movel(pA,tGrip,mSlow ‹off›)
        movel(pB,tGrip,part:mCarry ‹joint, leave 50, reach 50›)
        movej({0,0,0,0,0,0},tGrip,mMine)
        mMine.vel=3
    "#]],
    );
}

#[test]
fn only_hints_in_the_range_are_returned() {
    let marked = MarkedListing::new("num nA\nnA=limit(nA,0,1)\nnA=limit(nA,2,3)$0");
    let at = marked.at();
    let line = TextRange::new(at.offset - TextSize::of("nA=limit(nA,2,3)"), at.offset);
    let hints = inlay_hints(marked.db(), at.file, line, &InlayHintSettings::default());
    assert_eq!(hints.len(), 2);
}
