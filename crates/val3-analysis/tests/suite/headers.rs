//! Headers of programs: each fault, and a correct header at its limit.

use expect_test::expect;

use crate::show::faults;

fn program(head: &str, lists: &str) -> String {
    faults(&format!(
        "=== main/main.pjx\n<Project><Programs><Program file=\"run.pgx\" /></Programs></Project>\n=== main/run.pgx\n\
         <Programs>\n<Program {head}>{lists}<Code><![CDATA[begin\nend]]></Code></Program></Programs>"
    ))
}

#[test]
fn heads() {
    for fine in [r#"name="run""#, r#"name="RUN" access="public""#, r#"name="run" access="private""#] {
        assert_eq!(program(fine, ""), "", "{fine}");
    }
    let faulty = [
        program("", ""),
        program(r#"name="runs""#, ""),
        program(r#"name="r-n""#, ""),
        program(r#"name="run" access="Public""#, ""),
        program(r#"name="run""#, "<Parameter />"),
    ];
    expect![[r#"
        main/run.pgx:2 `Program` MissingAttribute { element: "Program", attribute: "name", default: None, written: None }
        main/run.pgx:2 `runs` ProgramNameMismatch { program: "runs", file: "run" }
        main/run.pgx:2 `r-n` InvalidName { name: "r-n" }
        main/run.pgx:2 `Public` InvalidAttribute { element: "Program", attribute: "access", value: "Public", expected: "`public` or `private`" }
        main/run.pgx:2 `Parameter` UnexpectedElement { name: "Parameter", parent: "Program" }
    "#]].assert_eq(&faulty.concat());
}

#[test]
fn parameters_and_locals() {
    let fine = r#"<Description><![CDATA[// text]]></Description><Parameters>
<Parameter name="x_a" type="num" use="value" xsi:type="element" dimensions="1" />
<Parameter name="x_b" type="joint" xsi:type="collection" use="reference" />
</Parameters><Locals><Local name="l_a" type="num" size="3 4 5" /></Locals>"#;
    assert_eq!(program(r#"name="run""#, fine), "");
    let by_value = r#"<Parameters><Parameter name="x_a" type="num" use="value" xsi:type="array" /></Parameters>"#;
    assert!(program(r#"name="run""#, by_value).contains("value: \"value\", expected: \"`reference`\""), "a container");
    let faulty = r#"<Parameters>
<Parameter name="x_a" type="num" use="ref" xsi:type="elem" dimensions="4" />
<Parameter name="x_a" type="num" />
<Parameter type="num" />
<Parameter name="x_b" />
<Param name="x_c" type="num" />
</Parameters><Locals>
<Local name="x_b" type="num" size="1" />
<Local name="l_a" type="number" size="1" />
<Local name="l_b" type="num" size="0" />
<Local name="l_c" type="num" size="1 2 3 4" />
<Local name="while" type="num" size="1" />
</Locals>"#;
    expect![[r#"
        main/run.pgx:5 `Parameter` MissingAttribute { element: "Parameter", attribute: "name", default: None, written: None }
        main/run.pgx:6 `Parameter` MissingAttribute { element: "Parameter", attribute: "type", default: None, written: None }
        main/run.pgx:7 `Param` UnexpectedElement { name: "Param", parent: "Parameters" }
        main/run.pgx:3 `elem` InvalidAttribute { element: "Parameter", attribute: "xsi:type", value: "elem", expected: "`element`, `array` or `collection`" }
        main/run.pgx:3 `ref` InvalidAttribute { element: "Parameter", attribute: "use", value: "ref", expected: "`value` or `reference`" }
        main/run.pgx:3 `4` InvalidAttribute { element: "Parameter", attribute: "dimensions", value: "4", expected: "`1`, `2` or `3`" }
        main/run.pgx:4 `x_a` DuplicateName { name: "x_a", what: Parameter }
            First main/run.pgx:3 `x_a`
        main/run.pgx:9 `x_b` DuplicateName { name: "x_b", what: Local }
            First main/run.pgx:6 `x_b`
        main/run.pgx:10 `number` UnknownType { name: "number", near: None }
        main/run.pgx:11 `0` InvalidSize { size: "0" }
        main/run.pgx:12 `1 2 3 4` InvalidSize { size: "1 2 3 4" }
        main/run.pgx:13 `while` ReservedName { name: "while" }
    "#]].assert_eq(&program(r#"name="run""#, faulty));
}

fn faults_of_program_file(text: &str) -> String {
    faults(&format!(
        "=== main/main.pjx\n<Project><Programs><Program file=\"run.pgx\" /></Programs></Project>\n=== main/run.pgx\n{text}"
    ))
}

#[test]
fn files_that_are_no_programs() {
    expect![[r#"
        main/run.pgx:1 `Database` WrongRoot { expected: Program, found: "Database" }
        main/run.pgx:1 `Programs` MissingElement { parent: "Programs", element: "Program" }
        main/main.pjx:1 `run.pgx` FileUnreadable { path: "run.pgx", reason: "it is empty; copy it again" }
    "#]]
    .assert_eq(
        &(faults_of_program_file("<Database />")
            + &faults_of_program_file("<Programs />")
            + &faults_of_program_file("")),
    );
}
