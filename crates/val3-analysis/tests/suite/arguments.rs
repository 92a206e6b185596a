//! Arguments: by value, by reference, parts of arrays, whole containers (2.6).

use expect_test::expect;

use crate::show::faults;

/// Variables of the manual's examples.
const DATA: &str = r#"
string sMessage
string sSignalName
string sMessageName
string sMessageArray[30]
string s2dArray[20,20]
string s3dArray[10,10,10]
string sMessageColl[""]
num nOther
"#;

const PROGRAMS: &str = r#"
program byValue(string x_s)
begin
end
program byReference(string& x_s)
begin
end
program send1d(string& x_s[])
begin
end
program send2d(string& x_s[,])
begin
end
program send3d(string& x_s[,,])
begin
end
program sendColl(string& x_s[""])
begin
end
"#;

fn calls(lines: &str) -> String {
    faults(&format!("{DATA}{lines}{PROGRAMS}"))
}

#[test]
fn values_are_passed_by_value() {
    let fine = r#"
call byValue("Waiting for signal StartCycle")
call byValue("Waiting for signal"+sSignalName)
call byValue(sMessage)
call byValue(sMessageArray[23])
call byValue(sMessageArray)
call byValue(s2dArray[12,3])
call byValue(s3dArray[5,7,9])
call byValue(sMessageColl[sMessageName])
"#;
    expect![[r#""#]].assert_eq(&calls(fine));
}

#[test]
fn wrong_values_are_reported() {
    let wrong = r#"
call byValue(1)
call byValue(nOther)
call byValue(s2dArray)
call byValue(sMessageColl)
call byValue()
call byValue("a","b")
"#;
    expect![[r#"
        main/start.pgx:6 `1` ArgumentType { callee: "byValue", parameter: "x_s", expected: ["string"], found: "num" }
            Declared main/byValue.pgx:3 `byValue`
        main/start.pgx:7 `nOther` ArgumentType { callee: "byValue", parameter: "x_s", expected: ["string"], found: "num" }
            Declared main/byValue.pgx:3 `byValue`
        main/start.pgx:8 `s2dArray` IndexMissing { name: "s2dArray", ty: "string[,]" }
            Declared main/byValue.pgx:3 `byValue`
        main/start.pgx:9 `sMessageColl` IndexMissing { name: "sMessageColl", ty: "string[\"\"]" }
            Declared main/byValue.pgx:3 `byValue`
        main/start.pgx:10 `byValue()` ArgumentCount { callee: "byValue", expected: [1], found: 0, forms: ["byValue(string x_s)"] }
            Declared main/byValue.pgx:3 `byValue`
        main/start.pgx:11 `byValue("a","b")` ArgumentCount { callee: "byValue", expected: [1], found: 2, forms: ["byValue(string x_s)"] }
            Declared main/byValue.pgx:3 `byValue`
    "#]].assert_eq(&calls(wrong));
}

#[test]
fn elements_are_passed_by_reference() {
    let fine = r#"
call byReference(sMessage)
call byReference(sMessageArray[23])
call byReference(sMessageArray)
call byReference(s2dArray[12,3])
call byReference(s3dArray[5,7,9])
call byReference(sMessageColl[sMessageName])
"#;
    expect![[r#""#]].assert_eq(&calls(fine));
}

#[test]
fn wrong_element_references_are_reported() {
    let wrong = r#"
call byReference("Waiting for signal StartCycle")
call byReference("Waiting for signal"+sSignalName)
call byReference((sMessage))
call byReference(toString("",1))
call byReference(nOther)
call byReference(1)
call byReference(s2dArray)
"#;
    expect![[r#"
        main/start.pgx:6 `"Waiting for signal StartCycle"` VariableExpected { callee: "byReference", parameter: "x_s" }
            Declared main/byReference.pgx:3 `byReference`
        main/start.pgx:7 `"Waiting for signal"+sSignalName` VariableExpected { callee: "byReference", parameter: "x_s" }
            Declared main/byReference.pgx:3 `byReference`
        main/start.pgx:8 `(sMessage)` VariableExpected { callee: "byReference", parameter: "x_s" }
            Declared main/byReference.pgx:3 `byReference`
        main/start.pgx:9 `toString("",1)` VariableExpected { callee: "byReference", parameter: "x_s" }
            Declared main/byReference.pgx:3 `byReference`
        main/start.pgx:10 `nOther` ArgumentType { callee: "byReference", parameter: "x_s", expected: ["string"], found: "num" }
            Declared main/byReference.pgx:3 `byReference`
        main/start.pgx:11 `1` ArgumentType { callee: "byReference", parameter: "x_s", expected: ["string"], found: "num" }
            Declared main/byReference.pgx:3 `byReference`
        main/start.pgx:12 `s2dArray` IndexMissing { name: "s2dArray", ty: "string[,]" }
            Declared main/byReference.pgx:3 `byReference`
    "#]].assert_eq(&calls(wrong));
}

#[test]
fn containers_are_passed_by_reference() {
    let fine = r#"
call send2d(s2dArray)
call send3d(s3dArray)
call sendColl(sMessageColl)
call send1d(sMessageArray)
call send1d(sMessageArray[23])
call send1d(sMessage)
"#;
    expect![[r#""#]].assert_eq(&calls(fine));
}

#[test]
fn wrong_container_references_are_reported() {
    let wrong = r#"
call send1d("Waiting for signal StartCycle")
call send1d("Waiting for signal"+sSignalName)
call send1d(sMessageColl)
call send1d(s2dArray[12,3])
call send1d(s2dArray)
call sendColl(sMessage)
call sendColl(sMessageArray)
call send2d(s2dArray[12,3])
call send3d(s3dArray[5,7,9])
call sendColl(sMessageColl[sMessageName])
call send2d(s3dArray)
call send3d(s2dArray)
call send2d(sMessage)
call send1d(nOther)
"#;
    expect![[r#"
        main/start.pgx:6 `"Waiting for signal StartCycle"` VariableExpected { callee: "send1d", parameter: "x_s" }
            Declared main/send1d.pgx:3 `send1d`
        main/start.pgx:7 `"Waiting for signal"+sSignalName` VariableExpected { callee: "send1d", parameter: "x_s" }
            Declared main/send1d.pgx:3 `send1d`
        main/start.pgx:8 `sMessageColl` ContainerMismatch { callee: "send1d", parameter: "x_s", expected: "string[]", found: "string[\"\"]" }
            Declared main/send1d.pgx:3 `send1d`
        main/start.pgx:9 `s2dArray[12,3]` ContainerMismatch { callee: "send1d", parameter: "x_s", expected: "string[]", found: "string" }
            Declared main/send1d.pgx:3 `send1d`
        main/start.pgx:10 `s2dArray` ContainerMismatch { callee: "send1d", parameter: "x_s", expected: "string[]", found: "string[,]" }
            Declared main/send1d.pgx:3 `send1d`
        main/start.pgx:11 `sMessage` ContainerMismatch { callee: "sendColl", parameter: "x_s", expected: "string[\"\"]", found: "string" }
            Declared main/sendColl.pgx:3 `sendColl`
        main/start.pgx:12 `sMessageArray` ContainerMismatch { callee: "sendColl", parameter: "x_s", expected: "string[\"\"]", found: "string[]" }
            Declared main/sendColl.pgx:3 `sendColl`
        main/start.pgx:13 `s2dArray[12,3]` IndexNotAllowed { name: "s2dArray", ty: "string", callee: Some("send2d") }
            Declared main/send2d.pgx:3 `send2d`
        main/start.pgx:14 `s3dArray[5,7,9]` IndexNotAllowed { name: "s3dArray", ty: "string", callee: Some("send3d") }
            Declared main/send3d.pgx:3 `send3d`
        main/start.pgx:15 `sMessageColl[sMessageName]` IndexNotAllowed { name: "sMessageColl", ty: "string", callee: Some("sendColl") }
            Declared main/sendColl.pgx:3 `sendColl`
        main/start.pgx:16 `s3dArray` ContainerMismatch { callee: "send2d", parameter: "x_s", expected: "string[,]", found: "string[,,]" }
            Declared main/send2d.pgx:3 `send2d`
        main/start.pgx:17 `s2dArray` ContainerMismatch { callee: "send3d", parameter: "x_s", expected: "string[,,]", found: "string[,]" }
            Declared main/send3d.pgx:3 `send3d`
        main/start.pgx:18 `sMessage` ContainerMismatch { callee: "send2d", parameter: "x_s", expected: "string[,]", found: "string" }
            Declared main/send2d.pgx:3 `send2d`
        main/start.pgx:19 `nOther` ArgumentType { callee: "send1d", parameter: "x_s", expected: ["string[]"], found: "num" }
            Declared main/send1d.pgx:3 `send1d`
    "#]].assert_eq(&calls(wrong));
}

#[test]
fn fields_are_passed_by_reference() {
    let listing = r#"
        point pA
        point pB[2]
        call p(pA.trsf)
        call p(pB[1].trsf)
        call n(pA.trsf.x)
        call a(pA.trsf.x)
        call p(appro(pA,{0,0,0,0,0,0}).trsf)
        program p(trsf& x_tr)
        begin
        end
        program n(num& x_n)
        begin
        end
        program a(num& x_n[])
        begin
        end
    "#;
    expect![[r#"
        main/start.pgx:9 `appro(pA,{0,0,0,0,0,0}).trsf` VariableExpected { callee: "p", parameter: "x_tr" }
            Declared main/p.pgx:3 `p`
    "#]]
    .assert_eq(&faults(listing));
}
