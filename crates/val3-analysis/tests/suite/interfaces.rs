//! Library identifiers: their interfaces, used items, and loaded libraries (6).

use expect_test::expect;

use crate::show::{faults, types};

#[test]
fn items_of_an_interface() {
    let listing = r#"
        library part "Disk://part/part.pjx"
        num nA
        point pA
        nA=part:nWeight[1]+part:nByName["a"]
        pA=part:pGrip
        part:nWeight[0]=1
        nA=part:pGrip.trsf.x
        call part:grip(nA,part:nWeight)
        --- part
        public num nWeight[2]
        public num nByName[""]
        public point pGrip
        public program grip(num x_n, num& x_a[])
        begin
        end
    "#;
    expect![[r#"
        nA: num | part:nWeight: num[] | part:nWeight[1]: num | part:nByName: num[""] | part:nByName["a"]: num | part:nWeight[1]+part:nByName["a"]: num
        pA: pointRx | part:pGrip: pointRx
        part:nWeight: num[] | part:nWeight[0]: num
        nA: num | part:pGrip: pointRx | part:pGrip.trsf: trsf | part:pGrip.trsf.x: num
        nA: num | part:nWeight: num[] | part:grip(nA,part:nWeight): ?
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn items_that_an_interface_lacks_are_reported() {
    let listing = r#"
        library part "Disk://part/part.pjx"
        num nA
        nA=prat:nWeight
        nA=part:nWieght
        nA=part:nSecret
        nA=part:grip
        call part:grib()
        call part:hide()
        call part:nWeight()
        call prat:grip()
        nA=part:grip()
        nA=part:nWeight["a"]
        call part:grip(1)
        nA=prat:size(nA)
        --- part
        public num nWeight[2]
        num nSecret
        public program grip()
        begin
        end
        program hide()
        begin
        end
    "#;
    expect![[r#"
        main/start.pgx:5 `prat:nWeight` UnknownLibrary { alias: "prat", near: Some("part") }
        main/start.pgx:6 `part:nWieght` LibraryItemUnknown { alias: "part", item: "nWieght", what: Data, near: Some("nWeight") }
            Interface main/main.pjx:11 `part`
        main/start.pgx:7 `part:nSecret` LibraryItemPrivate { alias: "part", item: "nSecret", what: Data }
            Declared part/part.dtx:5 `nSecret`
        main/start.pgx:8 `part:grip` NotAValue { name: "part:grip", is: Program }
        main/start.pgx:9 `part:grib` LibraryItemUnknown { alias: "part", item: "grib", what: Program, near: Some("grip") }
            Interface main/main.pjx:11 `part`
        main/start.pgx:10 `part:hide` LibraryItemPrivate { alias: "part", item: "hide", what: Program }
            Declared part/hide.pgx:3 `hide`
        main/start.pgx:11 `part:nWeight` LibraryItemUnknown { alias: "part", item: "nWeight", what: Program, near: None }
            Interface main/main.pjx:11 `part`
        main/start.pgx:13 `part:grip` UnknownInstruction { name: "part:grip", near: None, is: Some(Program) }
        main/start.pgx:14 `"a"` IndexType { name: "part:nWeight", expected: "num", found: "string" }
        main/start.pgx:15 `part:grip(1)` ArgumentCount { callee: "part:grip", expected: [0], found: 1, forms: ["grip()"] }
            Declared part/grip.pgx:3 `grip`
    "#]].assert_eq(&faults(listing));
}

/// Shows the faults of an application that loads `path` under an identifier and executes `use_`, with two libraries
/// next to the interface.
fn loads(path: &str, use_: &str) -> String {
    faults(&format!(
        r#"
library part "Disk://parts/box/box.pjx" autoload=false
string sName
num nA
bool bA
part:libLoad({path})
{use_}
--- parts/box
public num nWeight[2]
public point pGrip
num nSecret
public program grip(num x_n, num& x_a[])
begin
end
public program open()
begin
end
--- parts/bag
public num nWeight
public point pGrip
public program grip(num x_other, num& x_name[])
begin
end
--- parts/can
public string nWeight
num pGrip
public program grip(num& x_n, num& x_a[,])
begin
end
--- other
num nThing
"#
    ))
}

#[test]
fn a_suitable_library_is_accepted() {
    let used = "nA=part:nWeight[1]\npart:pGrip.trsf.x=1\ncall part:grip(1,nA)";
    assert_eq!(loads("\"Disk://parts/box\"", used), "");
    assert_eq!(loads("\"Disk://parts/bag\"", used), "");
    assert_eq!(loads("\"Disk://parts/BAG/bag.pjx\"", used), "");
    assert_eq!(loads("\"../parts/bag\"", used), "");
    assert_eq!(loads("\"USB0://parts/can\"", used), "");
    assert_eq!(loads("sName", used), "");
    assert_eq!(loads("\"Disk://\"+sName", "nA=part:nWeight"), "");
}

#[test]
fn an_unsuitable_library_is_reported() {
    let used = "nA=part:nWeight[1]\npart:pGrip.trsf.x=1\ncall part:grip(1,nA)";
    expect![[r#"
        main/start.pgx:5 `"Disk://parts/can"` ImplementationDifferent { alias: "part", library: "can", item: "grip", what: Program, expected: "grip(num x_n, num& x_a[])", found: "grip(num& x_n, num& x_a[,])" }
            Interface parts/box/grip.pgx:3 `grip`
            Implementation parts/can/grip.pgx:3 `grip`
        main/start.pgx:5 `"Disk://parts/can"` ImplementationDifferent { alias: "part", library: "can", item: "nWeight", what: Data, expected: "num nWeight[2]", found: "string nWeight" }
            Interface parts/box/box.dtx:4 `nWeight`
            Implementation parts/can/can.dtx:4 `nWeight`
        main/start.pgx:5 `"Disk://parts/can"` ImplementationPrivate { alias: "part", library: "can", item: "pGrip", what: Data }
            Interface parts/box/box.dtx:5 `pGrip`
            Implementation parts/can/can.dtx:5 `pGrip`
    "#]].assert_eq(&loads("\"Disk://parts/can\"", used));
}

#[test]
fn only_used_items_are_compared() {
    assert_eq!(loads("\"Disk://parts/can\"", "nA=1"), "");
    expect![[r#"
        main/start.pgx:5 `"Disk://parts/can"` ImplementationDifferent { alias: "part", library: "can", item: "nWeight", what: Data, expected: "num nWeight[2]", found: "string nWeight" }
            Interface parts/box/box.dtx:4 `nWeight`
            Implementation parts/can/can.dtx:4 `nWeight`
    "#]].assert_eq(&loads("\"Disk://parts/can\"", "nA=part:nWeight"));
    expect![[r#"
        main/start.pgx:5 `"Disk://parts/bag"` ImplementationMissing { alias: "part", library: "bag", items: [(Program, "open")] }
            Interface parts/box/open.pgx:3 `open`
    "#]].assert_eq(&loads("\"Disk://parts/bag\"", "call part:open()"));
}

#[test]
fn every_library_that_can_be_loaded_is_compared() {
    expect![[r#"
        main/start.pgx:5 `"Disk://parts/"+sName` ImplementationDifferent { alias: "part", library: "can", item: "nWeight", what: Data, expected: "num nWeight[2]", found: "string nWeight" }
            Interface parts/box/box.dtx:4 `nWeight`
            Implementation parts/can/can.dtx:4 `nWeight`
    "#]].assert_eq(&loads("\"Disk://parts/\"+sName", "nA=part:nWeight"));
    expect![[r#""#]].assert_eq(&loads("\"Disk://parts/b\"+sName", "nA=part:nWeight"));
}

#[test]
fn items_tested_with_libexist_are_accepted() {
    let data = "if part:libExist(\"pGrip\")\npart:pGrip.trsf.x=1\nendIf";
    assert_eq!(loads("\"Disk://parts/can\"", data), "");
    let program = "if part:libExist(\"open()\")\ncall part:open()\nendIf";
    assert_eq!(loads("\"Disk://parts/bag\"", program), "");
    let defined = "if isDefined(part:pGrip)\npart:pGrip.trsf.x=1\nendIf";
    assert_eq!(loads("\"Disk://parts/can\"", defined), "");
}

#[test]
fn unknown_paths_are_reported() {
    let faulty = ["\"Disk://parts/bux\"", "\"./parts/box\"", "\"parts/box/box.pjx.pjx\"", "\"\""];
    expect![[r#"
        main/start.pgx:5 `"Disk://parts/bux"` LibLoadPath("Disk://parts/bux")
        main/start.pgx:5 `"./parts/box"` LibLoadPath("./parts/box")
        main/start.pgx:5 `"parts/box/box.pjx.pjx"` LibLoadPath("parts/box/box.pjx.pjx")
        main/start.pgx:5 `""` LibLoadPath("")
    "#]]
    .assert_eq(&faulty.map(|path| loads(path, "nA=1")).concat());
}

#[test]
fn saved_libraries_need_not_exist() {
    let saved = |save: &str, load: &str| {
        faults(&format!(
            "library part \"Disk://part\"\nstring sA\n{save}\npart:libLoad({load})\n--- part\npublic num nWeight\n"
        ))
    };
    for (save, load) in [
        ("part:libSave(\"part2\")", "\"Disk://PART2\""),
        ("libSave(\"Disk://saved/main\")", "\"saved/main\""),
        ("part:libSave(\"./old\")", "\"Disk://main/old/old.pjx\""),
        ("part:libSave(\"parts/p\"+sA)", "\"parts/p7\""),
        ("part:libSave(\"parts/\"+sA+\"/box\")", "\"parts/a/box\""),
    ] {
        assert_eq!(saved(save, load), "", "{save}");
    }
    for save in ["part:libSave(\"part3\")", "part:libSave()", "part:libSave(sA)", "part:libSave(\"parts/p\"+sA)"] {
        assert!(saved(save, "\"part2\"").contains("LibLoadPath"), "{save}");
    }
    let of_library = "library part \"Disk://part\"\npart:libLoad(\"copy\")\n--- part\npublic program save()\nbegin\n  \
                      libSave(\"copy\")\nend\n";
    assert_eq!(faults(of_library), "");
}

fn faults_with_library(autoload: &str, line: &str) -> String {
    faults(&format!(
        "library part \"Disk://part\"{autoload}\nnum nA\nstring sA\n{line}\n--- part\npublic num nWeight\n"
    ))
}

#[test]
fn libraries_that_are_never_loaded_are_reported() {
    assert_eq!(faults_with_library("", "nA=part:nWeight"), "");
    assert_eq!(faults_with_library(" autoload=false", "nA=1"), "");
    assert_eq!(faults_with_library(" autoload=false", "part:libLoad(sA)\nnA=part:nWeight"), "");
    expect![[r#"
        main/main.pjx:11 `part` LibraryNeverLoaded { alias: "part" }
    "#]]
    .assert_eq(&faults_with_library(" autoload=false", "nA=part:nWeight"));
}

#[test]
fn types_of_libraries_are_the_same_by_path() {
    let listing = r#"
        library part "Disk://part"
        type Slot "Disk://types/Slot/Slot.pjx"
        Slot tA
        tA=part:tSlot
        call part:put(tA)
        --- part
        type Place "Disk://types/SLOT"
        public Place tSlot
        public program put(Place x_t)
        begin
        end
        --- types/Slot
        public num nA
    "#;
    assert_eq!(faults(listing), "");
}

fn library_file(file: &str) -> String {
    match file.to_lowercase().strip_suffix(".pgx") {
        Some(name) => format!(
            "<Programs><Program name=\"{name}\" access=\"public\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>"
        ),
        None => "<Database xmlns:xsi=\"x\"><Datas><Data name=\"nA\" access=\"public\" xsi:type=\"array\" type=\"num\" \
                 size=\"1\" /></Datas></Database>"
            .to_owned(),
    }
}

/// Shows the faults if an application uses `part` in two programs; `pjx` is the library's list, and `files` are in its
/// folder.
fn left_out(pjx: &str, files: &[&str]) -> String {
    let files: String = files.iter().map(|file| format!("=== part/{file}\n{}\n", library_file(file))).collect();
    faults(&format!(
        "library part \"Disk://part/part.pjx\"\n\nprogram start()\nbegin\ncall part:one()\npart:nA=1\ncall part:two()\n\
         part:libLoad(\"part\")\nend\n\nprogram more()\nbegin\npart:nA=part:nA+1\nend\n\n\
         === part/part.pjx\n<Project>{pjx}</Project>\n{files}"
    ))
}

#[test]
fn a_library_that_lists_nothing() {
    expect![[r#"
        main/main.pjx:12 `part` LibraryLeftOut { alias: "part", missing: ["nA", "one", "two"], unlisted: ["one.pgx", "part.dtx"], uses: 5 }
            List part/part.pjx:1 `Programs`
            Use main/more.pgx:5 `part:nA`
            Use main/more.pgx:5 `part:nA`
            Use main/start.pgx:5 `part:one`
            Use main/start.pgx:6 `part:nA`
            Use main/start.pgx:7 `part:two`
    "#]]
    .assert_eq(&left_out("<Programs /><Database />", &["one.pgx", "part.dtx"]));
    expect![[r#"
        main/main.pjx:12 `part` LibraryLeftOut { alias: "part", missing: ["nA", "one", "two"], unlisted: [], uses: 5 }
            List part/part.pjx:1 `Project`
            Use main/more.pgx:5 `part:nA`
            Use main/more.pgx:5 `part:nA`
            Use main/start.pgx:5 `part:one`
            Use main/start.pgx:6 `part:nA`
            Use main/start.pgx:7 `part:two`
    "#]]
    .assert_eq(&left_out("", &[]));
}

#[test]
fn a_library_with_a_fresh_project_file() {
    let fresh = "<Programs><Program file=\"start.pgx\" /></Programs><Database><Data file=\"part.dtx\" /></Database>";
    expect![[r#"
        main/main.pjx:12 `part` LibraryLeftOut { alias: "part", missing: ["one", "two"], unlisted: ["one.pgx"], uses: 2 }
            List part/part.pjx:1 `Programs`
            Use main/start.pgx:5 `part:one`
            Use main/start.pgx:7 `part:two`
    "#]]
    .assert_eq(&left_out(fresh, &["start.pgx", "one.pgx", "part.dtx"]));
}

#[test]
fn a_library_that_lists_a_part() {
    expect![[r#"
        main/main.pjx:12 `part` LibraryLeftOut { alias: "part", missing: ["one"], unlisted: ["ONE.PGX"], uses: 1 }
            List part/part.pjx:1 `Programs`
            Use main/start.pgx:5 `part:one`
        main/start.pgx:7 `part:two` LibraryItemUnknown { alias: "part", item: "two", what: Program, near: None }
            Interface main/main.pjx:12 `part`
    "#]]
    .assert_eq(&left_out(
        "<Programs><Program file=\"other.pgx\" /></Programs><Database><Data file=\"part.dtx\" /></Database>",
        &["ONE.PGX", "other.pgx", "part.dtx"],
    ));
    let listed = "<Programs><Program file=\"one.pgx\" /></Programs><Database><Data file=\"part.dtx\" /></Database>";
    expect![[r#"
        main/start.pgx:7 `part:two` LibraryItemUnknown { alias: "part", item: "two", what: Program, near: None }
            Interface main/main.pjx:12 `part`
    "#]]
    .assert_eq(&left_out(listed, &["one.pgx", "part.dtx", "old.dtx"]));
}
