//! Files of s5 and s6: another format for the same content.

use expect_test::expect;
use val3_analysis::infer;

use crate::show::{faults, program, project, workspace};

const PROJECT: &str = r#"=== main/main.pjx
<project xmlns="ProjectNameSpace" >
  <parameters version="s6.8" stackSize="5000" millimeterUnit="true" />
  <programSection><program file="start.pgx" /><program file="fill.pgx" /></programSection>
  <dataSection><data file="main.dtx" /></dataSection>
  <aliasSection><alias name="io" interface="io" autoload="true" password="" /></aliasSection>
</project>
=== main/main.dtx
<dataList xmlns="DataNameSpace" >
<boolSection><bool name="bA" public="true" size="1"><valueBool key="0" value="true" /></bool></boolSection>
<numSection><num name="nA" public="false" size="5" /></numSection>
<stringSection><string name="sA" public="false" size="1" /></stringSection>
<dioSection><dio name="dA" public="false" size="1" /><dio name="dB" public="false" size="1" /></dioSection>
<frameSection><frame name="world" public="true" size="1" /><frame name="fA" public="false" size="1">
<fFather alias="" name="world" fatherIndex="0" /></frame></frameSection>
<toolSection><tool name="flange" public="true" size="1" /></toolSection>
<jointRxSection><jointRx name="jA" public="false" size="1" /></jointRxSection>
<pointRxSection><pointRx name="pA" public="false" size="1"><pFather alias="" name="FATHER" fatherIndex="0" /></pointRx></pointRxSection>
</dataList>
=== main/fill.pgx
<programList xmlns="ProgramNameSpace" >
  <program name="fill" public="true" >
    <description></description>
    <paramSection><param name="x_n" type="num" byVal="true" /><param name="x_a" type="num" byVal="false" /></paramSection>
    <localSection><local name="l_i" type="num" size="1" /></localSection>
    <source><code>begin
  x_a=x_n
  x_a[2]=x_n
  call fill(l_i,x_a)
end
      </code></source>
  </program>
</programList>
--- io
public dio dStart
"#;

fn start(code: &str, father: &str) -> String {
    format!(
        "{}=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\" ><program name=\"start\" public=\"true\" ><description>\
         </description><paramSection /><localSection /><source><code>begin\n{code}\nend\n</code></source></program></programList>\n",
        PROJECT.replace("FATHER", father)
    )
}

#[test]
fn valid_code_of_both_dialects_is_accepted() {
    let code = "nA[1]=2\nif nA[0]&lt;1 and sA!=&quot;a&quot;\nendIf\ndA=dB\ndA=io:dStart\ncall fill(1,nA)\ncall \
                fill(nA,nA[1])\nmovej(jA,flange,{100,100,100,99999,99999,off,50,50})\npA=here(flange,world)";
    assert_eq!(faults(&start(code, "world")), "");
}

#[test]
fn faults_of_both_dialects_are_reported() {
    let code =
        "nA=sA\nsA=&quot;a&amp;b&quot;+1\ncall fill(1,2)\ncall fill(1,sA)\nnA[1,1]=1\nnB=1\ncall fil()\nio:dStop=true";
    expect![[r#"
        main/start.pgx:2 `sA` AssignmentType { target: "num", value: "string" }
        main/start.pgx:3 `&quot;a&amp;b&quot;+1` OperatorType { op: "+", left: Some("string"), right: "num" }
        main/start.pgx:5 `sA` ArgumentType { callee: "fill", parameter: "x_a", expected: ["num[]"], found: "string" }
            Declared main/fill.pgx:2 `fill`
        main/start.pgx:6 `nA` IndexCount { name: "nA", expected: 1, found: 2 }
            Declared main/main.dtx:3 `nA`
        main/start.pgx:7 `nB` UnknownName { name: "nB", near: Some("dB") }
        main/start.pgx:8 `fil` UnknownProgram { name: "fil", near: Some("fill"), is: None }
        main/start.pgx:9 `io:dStop` LibraryItemUnknown { alias: "io", item: "dStop", what: Data, near: None }
            Interface main/main.pjx:5 `io`
    "#]]
    .assert_eq(&faults(&start(code, "fA")));
}

#[test]
fn fathers() {
    expect![[r#"
        main/main.dtx:10 `fB` FatherMissing { father: "fB", near: Some("fA") }
        main/main.dtx:10 `flange` FatherKind { father: "flange", expected: "frame", found: "tool" }
    "#]]
    .assert_eq(&(faults(&start("nA=1", "fB")) + &faults(&start("nA=1", "flange"))));
}

#[test]
fn entities_in_strings_are_decoded() {
    let workspace = workspace(&start("sA=&quot;&lt;&amp;&gt;&quot;", "world"));
    let (db, main) = (&workspace.db, project(&workspace, "main"));
    let file = program(db, main, "start");
    let body = val3_analysis::body::body(db, file);
    let text = body.exprs().find_map(|(id, ..)| body.string(id));
    assert_eq!(text.as_deref(), Some("<&>"));
    assert!(infer::problems(db, main, file).is_empty());
}
