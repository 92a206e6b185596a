//! Project files: each fault, a correct file at its limit, and cycles.

use expect_test::expect;

use crate::show::faults;

fn project(lists: &str) -> String {
    faults(&format!(
        "=== main/main.pjx\n<Project>\n{lists}</Project>\n=== main/run.pgx\n<Programs><Program name=\"run\"><Code><![CDATA[begin\n\
         end]]></Code></Program></Programs>\n=== main/main.dtx\n<Database />\n--- part\npublic num nA\n"
    ))
}

#[test]
fn entries() {
    let fine = r#"<Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />
<Programs><Program file="RUN.pgx" /></Programs>
<Database><Data file="main.dtx" /></Database>
<Libraries><Library alias="part" path="Disk://Part/PART.pjx" autoload="false" password="" /></Libraries>
<Types><Type name="Part" path="../part" /></Types>"#;
    assert_eq!(project(fine), "");
    let faulty = r#"<Parameters version="version 7" />
<Programs><Program file="run.pgx" /><Program file="Run.pgx" /><Program file="rum.pgx" /><Program /><Data file="x" /></Programs>
<Database><Data file="other.dtx" /></Database>
<Libraries><Library alias="part" path="Disk://part" autoload="no" /><Library alias="part" path="part" />
<Library alias="a b" path="part" /><Library path="part" /><Library alias="none" /><Library alias="x" path="Disk://nowhere" />
</Libraries>
<Types><Type name="Part" path="./nowhere" /></Types>
<Other />"#;
    expect![[r#"
        main/main.pjx:3 `Program` MissingAttribute { element: "Program", attribute: "file", default: None, written: None }
        main/main.pjx:6 `Library` MissingAttribute { element: "Library", attribute: "alias", default: None, written: None }
        main/main.pjx:6 `Library` MissingAttribute { element: "Library", attribute: "path", default: None, written: None }
        main/main.pjx:3 `Data` UnexpectedElement { name: "Data", parent: "Programs" }
        main/main.pjx:9 `Other` UnexpectedElement { name: "Other", parent: "Project" }
        main/main.pjx:2 `version 7` InvalidAttribute { element: "Parameters", attribute: "version", value: "version 7", expected: "a version such as `s7.11.3`" }
        main/main.pjx:3 `Run.pgx` DuplicateEntry { what: Program, name: "Run.pgx" }
            First main/main.pjx:3 `run.pgx`
        main/main.pjx:3 `rum.pgx` FileMissing { what: Program, path: "rum.pgx" }
        main/main.pjx:4 `other.dtx` FileMissing { what: Data, path: "other.dtx" }
        main/main.pjx:5 `no` InvalidAttribute { element: "Library", attribute: "autoload", value: "no", expected: "`true` or `false`" }
        main/main.pjx:5 `part` DuplicateEntry { what: Library, name: "part" }
            First main/main.pjx:5 `part`
        main/main.pjx:6 `a b` InvalidName { name: "a b" }
        main/main.pjx:6 `Disk://nowhere` FileMissing { what: Library, path: "Disk://nowhere" }
        main/main.pjx:8 `./nowhere` FileMissing { what: Type, path: "./nowhere" }
    "#]].assert_eq(&project(faulty));
}

#[test]
fn another_root() {
    expect![[r#"
        main/main.pjx:1 `Programs` WrongRoot { expected: Project, found: "Programs" }
    "#]]
    .assert_eq(&faults("=== main/main.pjx\n<Programs />"));
}

#[test]
fn a_project_that_names_itself() {
    let listing = "=== main/main.pjx\n<Project><Libraries><Library alias=\"me\" path=\"Disk://main\" /></Libraries>\
                   <Types><Type name=\"Me\" path=\"./main.pjx\" /></Types></Project>";
    expect![[r#"
        main/main.pjx:1 `Disk://main` LibraryCircle { chain: ["main", "main"] }
        main/main.pjx:1 `./main.pjx` LibraryCircle { chain: ["main", "main"] }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn circles() {
    let listing = r#"
        library b "Disk://b"
        --- b
        library c "Disk://c"
        library d "Disk://d"
        --- c
        library b "Disk://b"
        --- d
        library main "Disk://main"
    "#;
    expect![[r#"
        b/b.pjx:9 `Disk://c` LibraryCircle { chain: ["b", "c", "b"] }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn one_library_under_many_aliases() {
    let listing = r#"
        library one "Disk://part"
        library two "Disk://part/part.pjx"
        library three "../PART/part.pjx"
        one:nA=two:nA+three:nA
        --- part
        public num nA
    "#;
    assert_eq!(faults(listing), "");
}

#[test]
fn a_type_or_library_listed_twice() {
    let lists = r#"<Libraries><Library alias="part" path="Disk://part" /><Library alias="part" path="Disk://nowhere" /></Libraries>
<Types><Type name="Part" path="Disk://gone" /><Type name="Part" path="Disk://gone" /></Types>
"#;
    expect![[r#"
        main/main.pjx:2 `part` DuplicateEntry { what: Library, name: "part" }
            First main/main.pjx:2 `part`
        main/main.pjx:3 `Disk://gone` FileMissing { what: Type, path: "Disk://gone" }
        main/main.pjx:3 `Part` DuplicateEntry { what: Type, name: "Part" }
            First main/main.pjx:3 `Part`
    "#]]
    .assert_eq(&project(lists));
}

fn faults_with_add_on_table(table: &str) -> String {
    faults(&format!("num nA\nnA=1\n=== /app/val3.One.anthro.cfx\n{table}\n=== /app/val3.One.scara.cfx\n<x />"))
}

#[test]
fn unreadable_add_on_table() {
    assert_eq!(faults_with_add_on_table("<Language />"), "");
    expect![[r#"
        main/main.pjx:2 `Project` CellFileUnreadable(UnreadableCellFile { path: "app/val3.One.anthro.cfx", reason: "the root element is not `Language` (at byte 0)" })
    "#]].assert_eq(&faults_with_add_on_table("<Table />"));
}
