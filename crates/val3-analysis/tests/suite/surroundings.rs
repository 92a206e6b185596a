//! `cell.toml`: faults, meshes as inputs, and the scene that checks share.

use camino::Utf8PathBuf;
use expect_test::{Expect, expect};
use salsa::Setter as _;
use val3_analysis::db::{File, Sources};
use val3_analysis::load::{Workspace, load, names_meshes_alike};
use val3_analysis::surroundings::{cell_faults, scene};
use val3_analysis::system::Memory;
use val3_test::{Fixture, ROOT};

const APPLICATION: &str = "frame fPallet\ntool tGrip\nnum nA\nlibrary part \"Disk://part/part.pjx\"\ncls()\n\
    --- part\npublic frame fNest\n--- other\nframe fOther\nprogram start()\nbegin\n  cls()\nend\n\
    === /val3.toml\narm = \"tx2-60l\"\n";

/// An application without libraries, with the signals of its data and of a tool.
const WITH_SIGNALS: &str = r#"
cls()

=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="aVacuum" access="private" xsi:type="array" type="aio" size="1">
      <Value key="0" link="ModbusSrv-0\Modbus-Word\Vacuum" />
    </Data>
    <Data name="tGrip" access="private" xsi:type="array" type="tool" size="1">
      <Value key="0" fatherId="flange[0]" ioLink="valve1" />
    </Data>
  </Datas>
</Database>

=== /val3.toml
arm = "tx2-60l"
"#;

/// A square in mm, as an STL file.
const PLATE: &str = "solid plate\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 100 0 0\nvertex 0 100 0\n\
    endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 100 100 0\nvertex 0 100 0\nvertex 100 0 0\nendloop\n\
    endfacet\nendsolid plate\n";

/// A tetrahedron with edges of 50 mm, as an STL file.
const CORNER: &str = "solid corner\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 50 0 0\nvertex 0 50 0\n\
    endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 50\nvertex 50 0 0\nvertex 0 50 0\nendloop\n\
    endfacet\nendsolid corner\n";

fn system(listing: &str, files: &[(&str, &str)]) -> Memory {
    let fixture = Fixture::parse(listing);
    let listed = fixture.files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
    Memory::new(listed.chain(files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), (*text).to_owned()))))
}

fn loaded(system: &Memory) -> Workspace {
    load(system, &[Utf8PathBuf::from(ROOT)]).unwrap()
}

fn cell_file(workspace: &Workspace) -> File {
    let files = Sources::get(&workspace.db).files(&workspace.db);
    *files.values().find(|file| file.path(&workspace.db).ends_with("cell.toml")).unwrap()
}

fn faults(listing: &str, cell: &str) -> String {
    let workspace = loaded(&system(listing, &[("cell.toml", cell)]));
    let found = cell_faults(&workspace.db, cell_file(&workspace), true);
    let shown = found
        .into_iter()
        .map(|fault| format!("{}: {} ({})\n", &fault.text[fault.range.clone()], fault.message, fault.help));
    shown.collect()
}

#[track_caller]
fn check(cell: &str, expected: Expect) {
    expected.assert_eq(&faults(APPLICATION, cell));
}

#[test]
fn a_cell_without_faults_has_none() {
    let thing =
        |name: &str, carrier: &str| format!("[[object]]\nname = \"{name}\"\nin = \"{carrier}\"\nbox = [1, 2, 3]\n");
    let cell = ["world", "base", "link6", "fPallet", "tGrip", "part:fNest", "fOther", "a"].iter().zip('a'..);
    check(&cell.map(|(carrier, name)| thing(&name.to_string(), carrier)).collect::<String>(), expect![[""]]);
}

#[test]
fn faults_are_those_of_a_run() {
    check(
        "clearence = 1",
        expect![[r#"
        clearence: there is no setting `clearence` (did you mean `clearance`?)
    "#]],
    );
    check(
        "[[object]]\nname = \"a\"\nin = \"link7\"\nbox = [1, 2, 3]",
        expect![[r#"
        in: the arm has no `link7` (its links are `link1` to `link6`)
    "#]],
    );
    check(
        "[[object]]\nname = \"a\"\nmesh = \"rack.stl\"",
        expect![[r#"
            mesh: cannot read `rack.stl`: it does not exist (name an existing STL or GLB file of at most 32 MB, in the folder of this file or below)
        "#]],
    );
    check(
        "[[object]]\nname = \"a\"\nmesh = \"../rack.stl\"",
        expect![[r#"
            mesh: `../rack.stl` is not in the folder of this file (name an existing STL or GLB file of at most 32 MB, in the folder of this file or below)
        "#]],
    );
    check(
        "[[object]]\nname = \"a\"\nbox = [1, 2",
        expect![[r#"
        : this is not TOML: unclosed array, expected `]` ()
    "#]],
    );
}

#[test]
fn a_carrier_that_no_application_has_is_a_fault() {
    check(
        "[[object]]\nname = \"a\"\nin = \"fPalet\"\nbox = [1, 2, 3]",
        expect![[r#"
        in: there is no frame, tool or object `fPalet` (did you mean `fPallet`?)
    "#]],
    );
    check(
        "[[object]]\nname = \"a\"\nin = \"nA\"\nbox = [1, 2, 3]",
        expect![[r#"
        in: there is no frame, tool or object `nA` (write `world`, `base`, `flange`, `link1`, or a name of the application or of this file)
    "#]],
    );
}

#[test]
fn a_carrier_of_an_application_that_is_not_loaded_is_no_fault() {
    let cell = "[[object]]\nname = \"a\"\nin = \"fElsewhere\"\nbox = [1, 2, 3]";
    let workspace = loaded(&system(APPLICATION, &[("cell.toml", cell)]));
    assert_eq!(cell_faults(&workspace.db, cell_file(&workspace), false), []);
}

/// A sensor with this input.
fn sensor(io: &str) -> String {
    format!("[[sensor]]\nname = \"stop\"\nbeam = {{ from = [0, 0, 0], to = [0, 0, 9] }}\nio = '{io}'\n")
}

#[test]
fn signals_are_those_of_the_cell_and_of_the_data() {
    let gripper = |values: &str| format!("[[gripper]]\ntool = \"tGrip\"\n{values}\n");
    let known = gripper("holding = { 'ModbusSrv-0\\Modbus-Word\\Vacuum' = 100 }");
    assert_eq!(faults(WITH_SIGNALS, &known), "");
    let reports = |cell: &str, message: &str| {
        let found = faults(WITH_SIGNALS, cell);
        assert!(found.contains(message), "{found}");
    };
    reports(
        &gripper("empty = { 'ModbusSrv-0\\Modbus-Word\\Vacum' = 1 }"),
        "there is no input or output `ModbusSrv-0\\Modbus-Word\\Vacum` (did you mean `ModbusSrv-0\\Modbus-Word\\Vacuum`?)",
    );
    reports(&gripper("empty = { 'ModbusSrv-0\\Modbus-Word\\Vacuum' = true }"), "is analog, and true is no number");
    reports(&sensor("valve1"), "`valve1` is an output, which only programs write (name an input)");
    reports(&sensor("Vacuum"), "`Vacuum` is analog (name a digital input)");
}

#[test]
fn a_library_may_link_further_signals() {
    assert_eq!(faults(APPLICATION, &sensor("Board\\%I0")), "");
}

#[test]
fn a_mesh_is_read_once_and_again_when_it_is_stale() {
    let cell = "[[object]]\nname = \"plate\"\nmesh = \"plate.stl\"\n";
    let first = system(APPLICATION, &[("cell.toml", cell), ("plate.stl", PLATE)]);
    let mut workspace = loaded(&first);
    let mesh = |workspace: &Workspace| {
        let project = workspace.projects.iter().find(|project| !project.meshes(&workspace.db).is_empty()).unwrap();
        project.meshes(&workspace.db)[0].mesh.clone()
    };
    assert_eq!(mesh(&workspace).unwrap().triangles.len(), 2);
    assert_eq!(cell_faults(&workspace.db, cell_file(&workspace), true), []);
    let second = system(APPLICATION, &[("cell.toml", cell)]);
    let paths = [Utf8PathBuf::from(ROOT)];
    workspace.refresh(&second, &paths, &|_| false);
    assert!(mesh(&workspace).is_ok(), "it is known");
    workspace.refresh(&second, &paths, &|key| key.ends_with("plate.stl"));
    assert_eq!(mesh(&workspace).unwrap_err(), "cannot read `plate.stl`: it does not exist");
}

#[test]
fn meshes_of_links_are_read_from_the_settings() {
    let cell = "[[object]]\nname = \"plate\"\nbox = [1, 2, 3]\n";
    let faults = |shapes: &str| {
        let listing = format!("{APPLICATION}[run]\nshapes = {{ {shapes} }}\n");
        let workspace =
            loaded(&system(&listing, &[("cell.toml", cell), ("plate.stl", PLATE), ("arm/corner.stl", CORNER)]));
        let found = cell_faults(&workspace.db, cell_file(&workspace), true);
        let project = workspace.projects.iter().find(|project| project.surroundings(&workspace.db).is_some()).unwrap();
        assert_eq!(scene(&workspace.db, *project).is_some(), found.is_empty());
        let shown = found.into_iter().map(|fault| format!("{}: {} ({})\n", fault.path, fault.message, fault.help));
        shown.collect::<String>()
    };
    assert_eq!(faults("link6 = \"arm/corner.stl\""), "");
    let found = [faults("link7 = \"plate.stl\""), faults("link6 = \"plate.stl\""), faults("base = \"other.stl\"")];
    expect![[r#"
        /cell/usr/val3.toml: the arm has no `link7` (its parts are `base` and `link1` to `link6`)
        /cell/usr/val3.toml: `plate.stl` is no shape: the points are in one plane and enclose nothing (name a mesh of the link, or remove the setting: the capsules of the arm are then compared)
        /cell/usr/val3.toml: cannot read `other.stl`: it does not exist (name a mesh of the link, or remove the setting: the capsules of the arm are then compared)
    "#]].assert_eq(&found.concat());
}

#[test]
fn a_mesh_of_a_link_is_no_way_out_of_the_folder_of_a_cell() {
    let listing = format!("{APPLICATION}[run]\ncell = \"sub/cell.toml\"\nshapes = {{ link6 = \"arm/corner.stl\" }}\n");
    let cell = "[[object]]\nname = \"corner\"\nmesh = \"../arm/corner.stl\"\n";
    let system = system(&listing, &[("sub/cell.toml", cell), ("arm/corner.stl", CORNER)]);
    let mut workspace = loaded(&system);
    for _ in 0..2 {
        let faults = cell_faults(&workspace.db, cell_file(&workspace), true);
        let messages: Vec<&str> = faults.iter().map(|fault| fault.message.as_str()).collect();
        assert_eq!(messages, ["`../arm/corner.stl` is not in the folder of this file"]);
        // The second load knows the mesh of the link.
        workspace.refresh(&system, &[Utf8PathBuf::from(ROOT)], &|_| false);
    }
}

#[test]
fn an_edit_that_names_another_mesh_loads_the_workspace_again() {
    let mesh = |name: &str| format!("[[object]]\nname = \"a\"\nshapes = [{{ mesh = \"{name}\" }}]\n");
    assert!(names_meshes_alike(&mesh("a.stl"), &format!("clearance = 3\n{}", mesh("a.stl"))));
    assert!(!names_meshes_alike(&mesh("a.stl"), &mesh("b.stl")));
}

#[test]
fn the_scene_changes_with_the_file_and_not_with_programs() {
    let cell = "[[object]]\nname = \"a\"\nbox = [1, 2, 3]\n";
    let mut workspace = loaded(&system(APPLICATION, &[("cell.toml", cell)]));
    let project = *workspace.projects.iter().find(|project| project.surroundings(&workspace.db).is_some()).unwrap();
    let before = scene(&workspace.db, project).clone().unwrap();
    let program = *Sources::get(&workspace.db)
        .files(&workspace.db)
        .values()
        .find(|file| file.path(&workspace.db).ends_with("main/start.pgx"))
        .unwrap();
    let text = program.text(&workspace.db).replace("cls()", "cls() ");
    program.set_text(&mut workspace.db).to(text.into());
    assert!(*scene(&workspace.db, project) == Some(before.clone()));
    let file = cell_file(&workspace);
    file.set_text(&mut workspace.db).to("[[object]]\nname = \"b\"\nbox = [1, 2, 3]\n".into());
    let after = scene(&workspace.db, project).clone().unwrap();
    assert!(after != before && after.scene().has_body("b"));
    file.set_text(&mut workspace.db).to("[[object]]\n".into());
    assert!(scene(&workspace.db, project).is_none());
}
