//! Attributes, namespaces and required elements of all kinds of files. Misspelt and missing ones are reported there,
//! not in the code that uses the declaration.

use expect_test::expect;

use crate::data::datas;
use crate::show::faults;

#[test]
fn attributes_of_data() {
    let shown = datas(
        r#"
<Data name="nA" acess="private" xsi:type="array" type="num" size="1" />
<Data name="nB" access="private" xsi:type="array" type="num" szie="3"><Value key="2" value="1" /></Data>
<Data name="nC" access="private" xsi:type="array" type="num" />
<Data name="nD" access="private" xsi:type="collection" type="num" />
<Data nmae="nE" access="private" xsi:type="array" type="num" size="1" />
<Data name="nF" access="private" xsi:type="array" type="num" size="1" colour="red" Size="2" xmlns:my="m" my:own="1" />"#,
    );
    expect![[r#"
        main/main.dtx:3 `acess` MissingAttribute { element: "Data", attribute: "access", default: Some("private"), written: Some("acess") }
        main/main.dtx:4 `szie` MissingAttribute { element: "Data", attribute: "size", default: Some("1"), written: Some("szie") }
        main/main.dtx:5 `Data` MissingAttribute { element: "Data", attribute: "size", default: Some("1"), written: None }
        main/main.dtx:7 `nmae` MissingAttribute { element: "Data", attribute: "name", default: None, written: Some("nmae") }
        main/main.dtx:8 `colour` UnknownAttribute { element: "Data", attribute: "colour", near: None }
        main/main.dtx:8 `Size` UnknownAttribute { element: "Data", attribute: "Size", near: None }
    "#]].assert_eq(&shown);
}

#[test]
fn attributes_of_values() {
    let shown = datas(
        r#"
<Data name="nA" access="private" xsi:type="array" type="num" size="2"><Value kye="0" value="1" />
<Value key="1" valeu="1" /></Data>
<Data name="tA" access="private" xsi:type="array" type="Slot" size="1"><Value key="0" x="1">
<Field name="nCount" xsi:type="array" typ="num" size="2" /></Value></Data>"#,
    );
    expect![[r#"
        main/main.dtx:6 `typ` MissingAttribute { element: "Field", attribute: "type", default: None, written: Some("typ") }
        main/main.dtx:3 `kye` MissingAttribute { element: "Value", attribute: "key", default: None, written: Some("kye") }
        main/main.dtx:4 `valeu` UnknownValueAttribute { ty: "num", attribute: "valeu", near: Some("value") }
        main/main.dtx:5 `x` UnknownAttribute { element: "Value", attribute: "x", near: None }
    "#]].assert_eq(&shown);
}

fn faults_with_data(data: &str) -> String {
    faults(&format!(
        "nA[2]=1\nnA[\"key\"]=1\nnA[1,1]=\"text\"\nnA=part:nB\ncall part:run()\n=== main/main.dtx\n<Database><Datas>\n{data}\n\
         </Datas></Database>\n=== part/part.pjx\n<Project><Programs><Program file=\"run.pgx\" /></Programs><Database>\
         <Data file=\"part.dtx\" /></Database></Project>\n=== part/part.dtx\n<Database><Datas>\n<Data name=\"nB\" \
         acces=\"public\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n</Datas></Database>\n=== part/run.pgx\n<Programs>\n\
         <Program name=\"run\" acces=\"public\"><Code><![CDATA[begin\nend]]></Code></Program>\n</Programs>\n\
         === main/main.pjx\n<Project><Programs><Program file=\"start.pgx\" /></Programs><Database><Data file=\"main.dtx\" />\
         </Database><Libraries><Library alias=\"part\" path=\"Disk://part\" /></Libraries></Project>"
    ))
}

#[test]
fn a_wrong_attribute_adds_no_fault_in_the_code() {
    expect![[r#"
        main/main.dtx:2 `Data` MissingAttribute { element: "Data", attribute: "size", default: Some("1"), written: None }
        part/part.dtx:2 `acces` MissingAttribute { element: "Data", attribute: "access", default: Some("private"), written: Some("acces") }
        part/run.pgx:2 `acces` UnknownAttribute { element: "Program", attribute: "acces", near: Some("access") }
    "#]].assert_eq(&faults_with_data(r#"<Data name="nA" access="private" xsi:type="array" type="num" />"#));
    expect![[r#"
        main/main.dtx:2 `Data` MissingAttribute { element: "Data", attribute: "xsi:type", default: Some("array"), written: None }
        part/part.dtx:2 `acces` MissingAttribute { element: "Data", attribute: "access", default: Some("private"), written: Some("acces") }
        part/run.pgx:2 `acces` UnknownAttribute { element: "Program", attribute: "acces", near: Some("access") }
    "#]].assert_eq(&faults_with_data(r#"<Data name="nA" access="private" type="num" size="1" />"#));
}

/// Returns the faults of a program file.
fn program(text: &str) -> String {
    faults(&format!(
        "=== main/main.pjx\n<Project><Programs><Program file=\"run.pgx\" /></Programs></Project>\n=== main/run.pgx\n{text}"
    ))
}

#[test]
fn programs() {
    let code = "<Code><![CDATA[begin\nend]]></Code>";
    let faulty = [
        format!("<Programs><Program name=\"run\" Access=\"public\">{code}</Program></Programs>"),
        format!(
            "<Programs><Program name=\"run\"><Parameters><Parameter name=\"x_n\" type=\"num\" us=\"reference\" />\
             </Parameters><Locals><Local name=\"l_n\" type=\"num\" dimensions=\"1\" /></Locals>{code}</Program></Programs>"
        ),
        "<Programs><Program name=\"run\" /></Programs>".to_owned(),
        "<Programs><Program name=\"run\"><Cod>begin end</Cod></Program></Programs>".to_owned(),
        "<Programs><Porgram name=\"run\" /></Programs>".to_owned(),
        "<programList><program name=\"run\" pulbic=\"true\"><source></source></program></programList>".to_owned(),
        "<programList><program name=\"run\"><paramSection><param name=\"a\" type=\"num\" byval=\"true\" /></paramSection>\
         </program></programList>"
            .to_owned(),
    ];
    expect![[r#"
        main/run.pgx:1 `Access` UnknownAttribute { element: "Program", attribute: "Access", near: Some("access") }
        main/run.pgx:1 `us` UnknownAttribute { element: "Parameter", attribute: "us", near: Some("use") }
        main/run.pgx:1 `dimensions` UnknownAttribute { element: "Local", attribute: "dimensions", near: None }
        main/run.pgx:1 `Program` MissingElement { parent: "Program", element: "Code" }
        main/run.pgx:1 `Cod` UnexpectedElement { name: "Cod", parent: "Program" }
        main/run.pgx:1 `Porgram` UnexpectedElement { name: "Porgram", parent: "Programs" }
        main/run.pgx:1 `pulbic` UnknownAttribute { element: "program", attribute: "pulbic", near: Some("public") }
        main/run.pgx:1 `source` MissingElement { parent: "source", element: "code" }
        main/run.pgx:1 `byval` UnknownAttribute { element: "param", attribute: "byval", near: Some("byVal") }
        main/run.pgx:1 `program` MissingElement { parent: "program", element: "source" }
    "#]]
    .assert_eq(&faulty.map(|text| program(&text)).concat());
    let fine = "<programList xmlns=\"ProgramNameSpace\"><program name=\"run\" public=\"true\"><source><code>begin\nend\
                </code></source></program></programList>";
    assert_eq!(program(fine), "");
}

fn program_with_namespaces(space: &str, of_parameters: &str) -> String {
    program(&format!(
        "<Programs xmlns=\"{space}\"><Program name=\"run\"><Parameters xmlns=\"{of_parameters}\" /><Code><![CDATA[begin\n\
         end]]></Code></Program></Programs>"
    ))
}

#[test]
fn namespaces() {
    let [run, parameters] = ["Program/2", "Param/1"].map(|part| format!("http://www.staubli.com/robotics/VAL3/{part}"));
    assert_eq!(program_with_namespaces(&run, &parameters), "");
    expect![[r#"
        main/run.pgx:1 `ProgramNameSpace` Namespace { element: "Programs", found: "ProgramNameSpace", expected: "http://www.staubli.com/robotics/VAL3/Program/2" }
        main/run.pgx:1 `http://www.staubli.com/robotics/VAL3/Program/2` Namespace { element: "Parameters", found: "http://www.staubli.com/robotics/VAL3/Program/2", expected: "http://www.staubli.com/robotics/VAL3/Param/1" }
    "#]].assert_eq(&(program_with_namespaces("ProgramNameSpace", &parameters) + &program_with_namespaces(&run, &run)));
}

#[test]
fn old_data_and_projects() {
    let shown = faults(
        "=== main/main.pjx\n<project xmlns=\"ProjectNameSpace/2\"><parameters version=\"\" />\n<dataSection><data file=\"main.dtx\" />\
         </dataSection>\n<aliasSection><alias name=\"step\" interface=\"io\" autolod=\"true\" /></aliasSection></project>\n\
         === main/main.dtx\n<dataList xmlns=\"DataNameSpace\"><numSection>\n<num name=\"nA\" pubic=\"true\" privilege=\"0\">\
         <valueNum index=\"0\" value=\"3\" /></num>\n<num nam=\"nB\" /></numSection></dataList>\n--- io\npublic dio dA",
    );
    expect![[r#"
        main/main.pjx:1 `ProjectNameSpace/2` Namespace { element: "project", found: "ProjectNameSpace/2", expected: "ProjectNameSpace" }
        main/main.pjx:3 `autolod` UnknownAttribute { element: "alias", attribute: "autolod", near: Some("autoload") }
        main/main.pjx:1 `` InvalidAttribute { element: "parameters", attribute: "version", value: "", expected: "a version such as `s7.11.3`" }
        main/main.pjx:3 `step` ReservedName { name: "step" }
        main/main.dtx:2 `pubic` UnknownAttribute { element: "num", attribute: "pubic", near: Some("public") }
        main/main.dtx:3 `nam` MissingAttribute { element: "num", attribute: "name", default: None, written: Some("nam") }
    "#]].assert_eq(&shown);
}

#[test]
fn paths() {
    let shown = faults(
        "=== main/main.pjx\n<Project><Parameters /><Programs><Program file=\"sub\\run.pgx\" /></Programs><Libraries>\n\
         <Library alias=\"a\" path=\"Disc://part/part.pjx\" />\n<Library alias=\"b\" path=\"Disk:\\\\part\\part.pjx\" />\n\
         <Library alias=\"c\" path=\"usb0://part\" />\n<Library alias=\"d\" path=\"disk://part\" />\n</Libraries></Project>\n\
         --- part\npublic num nA",
    );
    expect![[r#"
        main/main.pjx:1 `Parameters` MissingAttribute { element: "Parameters", attribute: "version", default: Some("s7.11"), written: None }
        main/main.pjx:1 `sub\run.pgx` PathSeparator { path: "sub\\run.pgx" }
        main/main.pjx:2 `Disc://part/part.pjx` UnresolvedPath { what: Library, path: "Disc://part/part.pjx", root: "Disc", near: Some("Disk") }
        main/main.pjx:3 `Disk:\\part\part.pjx` PathSeparator { path: "Disk:\\\\part\\part.pjx" }
        main/main.pjx:4 `usb0://part` UnresolvedPath { what: Library, path: "usb0://part", root: "usb0", near: None }
    "#]].assert_eq(&shown);
}
