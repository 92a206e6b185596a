//! Values that no file can contain: `libSave` returns a code and leaves the files unchanged (6.7).

use expect_test::{Expect, expect};
use val3_machine::event::EventKind;

use crate::cell::{Cell, run};

/// Runs `main`, and returns printed lines and messages of the log.
fn messages(cell: &Cell) -> String {
    let events = run(&mut cell.controller(), |_| {}).into_iter();
    let lines = events.filter_map(|event| match event.kind {
        EventKind::Print { text } | EventKind::Log { text, .. } => Some(format!("{text}\n")),
        _ => None,
    });
    lines.collect()
}

/// Checks a program that changes data of the library `part` and saves it.
#[track_caller]
fn check(code: &str, expected: Expect) {
    let cell = Cell::new(&format!(
        "library part \"Disk://part/part.pjx\"\nlibrary other \"Disk://other/other.pjx\" autoload=false\nprogram start()\n\
         begin\n{code}\n? part:libSave()\n? part:libSave(\"copy\")\n? other:libLoad(\"part\")\nend\n\
         --- part\npublic string sA\npublic num nA[3]\npublic trsf trA\npublic string sKeyed[\"\"]\n\
         --- other\npublic string sA\n"
    ));
    let before = cell.read("usrapp/part/part.dtx");
    expected.assert_eq(&messages(&cell));
    assert_eq!(cell.read("usrapp/part/part.dtx"), before);
    assert!(!cell.path("usrapp/copy").exists());
}

#[test]
fn control_characters() {
    check(
        "part:sA=chr(27)+\"x\"",
        expect![[r#"
        `sA[0]` contains the character U+001B, which a data file cannot contain: remove it before saving
        30
        `sA[0]` contains the character U+001B, which a data file cannot contain: remove it before saving
        30
        0
    "#]],
    );
    check(
        "insert(part:sKeyed[chr(1)])",
        expect![[r#"
        `sKeyed[�]` contains the character U+0001, which a data file cannot contain: remove it before saving
        30
        `sKeyed[�]` contains the character U+0001, which a data file cannot contain: remove it before saving
        30
        0
    "#]],
    );
}

#[test]
fn infinite_numbers() {
    check(
        "part:nA[1]=1e300*1e300",
        expect![[r#"
        a number of `nA[1]` is inf, which a data file cannot contain: set another value before saving
        30
        a number of `nA[1]` is inf, which a data file cannot contain: set another value before saving
        30
        0
    "#]],
    );
    check(
        "part:nA[2]=1e300*1e300\npart:trA.rz=part:nA[2]-part:nA[2]\npart:nA[2]=0",
        expect![[r#"
        a number of `trA[0]` is NaN, which a data file cannot contain: set another value before saving
        30
        a number of `trA[0]` is NaN, which a data file cannot contain: set another value before saving
        30
        0
    "#]],
    );
}

const OLD: &str = r#"
    version s6.8
    program start()
    begin
      link(pA[0],fA[0])
      ? libSave("one")
      link(pA[1],fA[0])
      append(pA)
      ? libSave("two")
    end

    === main/main.dtx
    <?xml version="1.0"?>
    <dataList xmlns="DataNameSpace">
    <frameSection><frame name="fA" public="false"><fFather alias="" name="world" fatherIndex="0" />
    <valueFrame index="0"><tfValue x="1" y="0" z="0" rx="0" ry="0" rz="0" /></valueFrame>
    <valueFrame index="1"><tfValue x="2" y="0" z="0" rx="0" ry="0" rz="0" /></valueFrame></frame></frameSection>
    <pointSection><point name="pA" public="false"><pFather alias="" name="fA" fatherIndex="1" />
    <valuePoint index="0"><tpValue x="7" y="0" z="0" rx="0" ry="0" rz="0" /><cpValue shoulder="righty" elbow="esame" wrist="wsame" /></valuePoint>
    <valuePoint index="1"><tpValue x="8" y="0" z="0" rx="0" ry="0" rz="0" /><cpValue shoulder="righty" elbow="esame" wrist="wsame" /></valuePoint></point></pointSection>
    </dataList>
"#;

/// Files of s5 and s6 contain one father for a variable.
#[test]
fn different_fathers_in_the_old_dialect() {
    let cell = Cell::new(OLD);
    expect![[r#"
        `pA[1]` and another value of its variable have different fathers, but files of s5 and s6 contain one father for the entire variable: link all values to `fA[0]`, or use two variables
        30
        0
    "#]].assert_eq(&messages(&cell));
    assert!(!cell.path("usrapp/one").exists());
    let saved = cell.read("usrapp/two/main.dtx");
    let father = saved.lines().find(|line| line.contains("pFather")).unwrap();
    expect![[r#"<pointSection><point name="pA" public="false"><pFather alias="" name="fA" fatherIndex="0" />"#]]
        .assert_eq(father.trim());
}

const OLD_LINKS: &str = r#"
    library io "Disk://io/io.pjx"
    version s6.8
    program start()
    begin
      ? libSave("before")
      dioLink(dA[0],io:dIn)
      ? libSave("one")
      dioLink(dA[1],io:dIn)
      dioLink(dB,io:dIn)
      ? libSave("three")
      ? io:libSave()
    end

    === main/main.dtx
    <?xml version="1.0"?>
    <dataList xmlns="DataNameSpace">
    <dioSection><dio name="dA" public="false" size="2" /><dio name="dB" public="false" size="1" /></dioSection>
    </dataList>
    === io/io.pjx
    <?xml version="1.0"?>
    <project xmlns="ProjectNameSpace"><parameters version="s6.8" stackSize="0" millimeterUnit="true" /><programSection />
    <dataSection><data file="io.dtx" /></dataSection><aliasSection /></project>
    === io/io.dtx
    <?xml version="1.0"?>
    <dataList xmlns="DataNameSpace"><dioSection><dio name="dIn" public="true" size="1" /></dioSection></dataList>
"#;

/// Files of s5 and s6 contain no links of inputs and outputs. The data of the library `io` have their links by name.
#[test]
fn new_links_in_the_old_dialect() {
    let cell = Cell::new(OLD_LINKS);
    expect![[r#"
        0
        `dA[0]` is saved without the link, because files of s5 and s6 contain no links of inputs, outputs and lines: set the link again after loading
        0
        `dA[0]` and 2 other values are saved without the link, because files of s5 and s6 contain no links of inputs, outputs and lines: set the link again after loading
        0
        0
    "#]].assert_eq(&messages(&cell));
}

/// All other texts are loaded as they were saved, as values and as keys.
#[test]
fn unusual_texts_are_loaded_again() {
    let texts = [
        "\" a \"",
        "\"a,b\"",
        "\"A\"",
        "\"a\"",
        "chr(9)",
        "chr(10)+\"x\"",
        "chr(13)",
        "chr(34)+\"<&>'\"",
        "\"]]>\"",
        "\"&#27;\"",
        "chr(133)",
        "chr(127)",
        "chr(160)",
        "chr(8232)",
        "chr(65279)",
        "chr(128512)",
        "\"0\"",
    ];
    let (mut change, mut show) = (String::new(), String::new());
    for text in texts {
        change += &format!("insert(part:sKeyed[{text}])\npart:sKeyed[{text}]={text}\n");
        show +=
            &format!("if isDefined(other:sKeyed[{text}])==false\n? {text}\nendIf\n? other:sKeyed[{text}]=={text}\n");
    }
    let cell = Cell::new(&format!(
        "library part \"Disk://part/part.pjx\"\nlibrary other \"Disk://other/other.pjx\" autoload=false\nprogram start()\n\
         begin\n{change}\n? part:libSave(\"copy\")\n? other:libLoad(\"copy\")\n? size(other:sKeyed)\n{show}\nend\n\
         --- part\npublic string sKeyed[\"\"]\n--- other\npublic string sKeyed[\"\"]\n"
    ));
    let loaded = messages(&cell);
    let same = "true\n".repeat(texts.len());
    assert_eq!(loaded, format!("0\n0\n{}\n{same}", texts.len()));
}
