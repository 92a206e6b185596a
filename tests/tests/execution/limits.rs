//! Limits on both sides: bytes of a string, values of a variable, characters of a name.

use expect_test::expect;

use crate::execution::{check, errors};

#[test]
fn a_string_has_128_bytes() {
    check(
        r#"
        string sText
        num nCount
        program start()
        begin
          for nCount=1 to 127
            sText=sText+"a"
          endFor
          ? len(sText)
          sText=sText+"b"
          ? len(sText)
          ? right(sText,2)
          sText=sText+"c"
          ? len(sText)
          ? right(sText,2)
          ? len(sText+sText)
          ? len(insert(sText,"c",0))
          ? right(insert(sText,"c",0),1)
        end
        "#,
        expect![[r#"
            127
            128
            ab
            128
            ab
            128
            128
            a
        "#]],
    );
}

#[test]
fn a_string_is_cut_at_a_character() {
    check(
        r#"
        string sText
        num nCount
        program start()
        begin
          for nCount=1 to 126
            sText=sText+"a"
          endFor
          ? right(sText+"é",1)
          sText=sText+"a"
          ? len(sText+"é")
          ? right(sText+"é",1)
          sText=""
          for nCount=1 to 64
            sText=sText+"é"
          endFor
          ? len(sText)
          ? len(sText+"é")
          ? len(sText+"e")
          sText=""
          for nCount=1 to 43
            sText=sText+"本"
          endFor
          ? len(sText)
          ? len(sText+"ab")
          ? len(sText+"abc")
        end
        "#,
        expect![[r#"
            é
            127
            a
            64
            64
            64
            42
            44
            44
        "#]],
    );
}

#[test]
fn the_name_of_a_task_has_15_characters() {
    errors(
        "string sName=\"abcdefghijklmnop\"",
        &["taskCreate left(sName,15),10,work()", "taskCreate sName,10,work()"],
        expect![[r#"
            -1 taskCreate left(sName,15),10,work()
            29 taskCreate sName,10,work()
        "#]],
    );
}

#[test]
fn a_variable_has_9999_values_up_to_s7_and_more_from_s8() {
    let grow =
        &["resize(nRow,1,9999)", "append(nRow)", "resize(nGrid,1,1000)", "resize(nGrid,2,9)", "resize(nGrid,2,10)"];
    errors(
        "num nRow[2]\nnum nGrid[1,1]",
        grow,
        expect![[r#"
            -1 resize(nRow,1,9999)
            40 append(nRow)
            -1 resize(nGrid,1,1000)
            -1 resize(nGrid,2,9)
            40 resize(nGrid,2,10)
        "#]],
    );
    errors(
        "version s8.3\nnum nRow[2]\nnum nGrid[1,1]",
        grow,
        expect![[r#"
            -1 resize(nRow,1,9999)
            -1 append(nRow)
            -1 resize(nGrid,1,1000)
            -1 resize(nGrid,2,9)
            -1 resize(nGrid,2,10)
        "#]],
    );
}
