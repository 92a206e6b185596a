//! One mistake, one finding: consequences of a fault are not reported.

use expect_test::expect;

use crate::show::faults;

const USE: &str = r#"
library part "Disk://part/part.pjx"
type Slot "Disk://Slot/Slot.pjx"
num nA
Slot tA
nA=part:nWeight
call part:grip(nA)
nA=tA.nCount
--- part
public num nWeight
public program grip(num x_n)
begin
end
--- Slot
public num nCount
"#;

/// Shows the faults of a sound workspace in which one file has another text.
fn with(path: &str, text: &str) -> String {
    faults(&format!("{USE}=== {path}\n{text}"))
}

#[test]
fn a_sound_workspace() {
    expect![[r#""#]].assert_eq(&faults(USE));
}

#[test]
fn a_project_file_that_is_no_project() {
    expect![[r#"
        part/part.pjx:1 `Projekt` WrongRoot { expected: Project, found: "Projekt" }
    "#]]
    .assert_eq(&with("part/part.pjx", "<Projekt />"));
}

#[test]
fn a_project_file_with_a_misspelt_list() {
    let text = r#"<Project><Programms><Program file="grip.pgx" /></Programms><Database /></Project>"#;
    expect![[r#"
        part/part.pjx:1 `Programms` UnexpectedElement { name: "Programms", parent: "Project" }
    "#]]
    .assert_eq(&with("part/part.pjx", text));
}

#[test]
fn a_library_without_its_alias() {
    let text = r#"<Project>
<Programs><Program file="start.pgx" /></Programs><Database><Data file="main.dtx" /></Database>
<Libraries><Library path="Disk://part/part.pjx" /></Libraries>
<Types><Type name="Slot" path="Disk://Slot/Slot.pjx" /></Types></Project>"#;
    expect![[r#"
        main/main.pjx:3 `Library` MissingAttribute { element: "Library", attribute: "alias", default: None, written: None }
    "#]]
    .assert_eq(&with("main/main.pjx", text));
}

#[test]
fn a_type_without_its_name() {
    let text = r#"<Project>
<Programs><Program file="start.pgx" /></Programs><Database><Data file="main.dtx" /></Database>
<Libraries><Library alias="part" path="Disk://part/part.pjx" /></Libraries>
<Types><Type path="Disk://Slot/Slot.pjx" /></Types></Project>"#;
    expect![[r#"
        main/main.pjx:4 `Type` MissingAttribute { element: "Type", attribute: "name", default: None, written: None }
    "#]]
    .assert_eq(&with("main/main.pjx", text));
}

#[test]
fn a_truncated_data_file_causes_no_further_faults() {
    let text = r#"<Database><Datas><Data name="nOther" access="public" xsi:type="array" type="num" size="1" />"#;
    expect![[r#""#]].assert_eq(&with("main/main.dtx", text));
    expect![[r#""#]].assert_eq(&with("part/part.dtx", text));
    expect![[r#""#]].assert_eq(&with("Slot/Slot.dtx", text));
}

#[test]
fn a_data_element_that_is_misspelt() {
    let text = r#"<Database><Datas><Date name="nA" access="public" xsi:type="array" type="num" size="1" /></Datas></Database>"#;
    expect![[r#"
        main/main.dtx:1 `Date` UnexpectedElement { name: "Date", parent: "Datas" }
    "#]]
    .assert_eq(&with("main/main.dtx", text));
}

#[test]
fn data_without_a_name_a_type_or_a_size() {
    let datas = |datas: &str| format!("<Database><Datas>{datas}</Datas></Database>");
    let slot = r#"<Data name="tA" access="private" xsi:type="array" type="Slot" size="1" />"#;
    for broken in [
        r#"<Data access="private" xsi:type="array" type="num" size="1" />"#,
        r#"<Data name="nA" access="private" xsi:type="array" size="1" />"#,
        r#"<Data name="nA" access="private" xsi:type="array" type="num" size="many" />"#,
        r#"<Data name="nA" access="private" xsi:type="array" type="nmu" size="1" />"#,
        r#"<Data name="nA" access="private" xsi:type="arry" type="num" size="1" />"#,
    ] {
        let found = with("main/main.dtx", &datas(&format!("{slot}{broken}")));
        assert_eq!(found.lines().count(), 1, "{broken}\n{found}");
    }
}

fn faults_without(lost: &str) -> String {
    let fixture = val3_test::Fixture::parse(USE);
    let files = fixture.files.into_iter().filter(|(path, _)| path != lost);
    let rooted = files.map(|(path, text)| (camino::Utf8PathBuf::from(val3_test::ROOT).join(path), text));
    let memory = val3_analysis::system::Memory::new(rooted);
    crate::show::faults_in(&val3_analysis::load::load(&memory, &[val3_test::ROOT.into()]).unwrap())
}

#[test]
fn files_that_are_not_there() {
    expect![[r#"
        main/main.pjx:11 `Disk://part/part.pjx` FileMissing { what: Library, path: "Disk://part/part.pjx" }
    "#]]
    .assert_eq(&faults_without("usrapp/part/part.pjx"));
    expect![[r#"
        part/part.pjx:8 `part.dtx` FileMissing { what: Data, path: "part.dtx" }
    "#]]
    .assert_eq(&faults_without("usrapp/part/part.dtx"));
    expect![[r#"
        part/part.pjx:5 `grip.pgx` FileMissing { what: Program, path: "grip.pgx" }
    "#]]
    .assert_eq(&faults_without("usrapp/part/grip.pgx"));
    expect![[r#"
        main/main.pjx:14 `Disk://Slot/Slot.pjx` FileMissing { what: Type, path: "Disk://Slot/Slot.pjx" }
    "#]]
    .assert_eq(&faults_without("usrapp/Slot/Slot.pjx"));
    expect![[r#"
        Slot/Slot.pjx:6 `Slot.dtx` FileMissing { what: Data, path: "Slot.dtx" }
    "#]]
    .assert_eq(&faults_without("usrapp/Slot/Slot.dtx"));
    expect![[r#"
        main/main.pjx:8 `main.dtx` FileMissing { what: Data, path: "main.dtx" }
    "#]]
    .assert_eq(&faults_without("usrapp/main/main.dtx"));
}

fn with_header(header: &str) -> String {
    format!(
        "num nA\nnum nG[2,2]\ncall grip(nA,nG)\n=== main/grip.pgx\n<Programs><Program {header}\
         <Code><![CDATA[begin\n  x_g[0,1]=x_n+l_n[1,1]\nend]]></Code></Program></Programs>"
    )
}

#[test]
fn headers_with_a_fault() {
    let n = r#"<Parameter name="x_n" type="num" xsi:type="element" />"#;
    let g = r#"<Parameter name="x_g" type="num" xsi:type="array" use="reference" dimensions="2" />"#;
    let l = r#"<Locals><Local name="l_n" type="num" xsi:type="array" size="2 2" /></Locals>"#;
    let sound = with_header(&format!(r#"name="grip"><Parameters>{n}{g}</Parameters>{l}"#));
    assert_eq!(faults(&sound), "");
    for (whole, broken) in [
        (r#"name="grip""#, r#"access="public""#),
        (r#"name="grip""#, r#"name="gripp""#),
        ("<Parameters>", "<Parametres>"),
        ("<Parameter ", "<Paramter "),
        (r#"name="x_n""#, ""),
        (r#"name="x_n" type="num""#, r#"name="x_n""#),
        (r#"name="x_n" type="num""#, r#"name="x_n" type="nmu""#),
        (r#"xsi:type="element""#, r#"xsi:type="elment""#),
        (r#"name="x_g" type="num" xsi:type="array""#, r#"name="x_g" type="num" xsi:type="arry""#),
        (r#"dimensions="2""#, r#"dimensions="two""#),
        (r#"name="l_n""#, ""),
        (r#"name="l_n" type="num""#, r#"name="l_n""#),
        (r#"size="2 2""#, r#"size="2 x""#),
        ("<Local ", "<Locl "),
        ("<Programs>", "<Programms>"),
    ] {
        let listing = sound.replacen(whole, broken, 1).replace(
            "</Parameters>",
            match broken {
                "<Parametres>" => "</Parametres>",
                _ => "</Parameters>",
            },
        );
        let listing = if broken == "<Programms>" { listing.replace("</Programs>", "</Programms>") } else { listing };
        let found = faults(&listing);
        assert_eq!(found.lines().count(), 1, "{whole} -> {broken}\n{found}");
    }
}
