//! `val3 run` with things around the arm.

use expect_test::{Expect, expect};

use crate::support::Folder;

/// A move of 100 mm along the axis y in a straight line.
const CODE: &str = "\
joint jReady
point pEnd
mdesc mLine
frame fWall
program start()
begin
  link(pEnd,world)
  link(fWall,world)
  mLine.blend=off
  mLine.vel=100
  wait(isPowered())
  jReady={0,0,90,0,90,0}
  movej(jReady,flange,mLine)
  waitEndMove()
  pEnd=here(flange,world)
  pEnd.trsf.y=pEnd.trsf.y+100
  movel(pEnd,flange,mLine)
  waitEndMove()
end
";

/// A rod at the flange, and a wall that stands in a frame.
const CELL: &str = "\
[[object]]
name = \"rod\"
in = \"flange\"
capsule = { from = [0, 0, 0], to = [0, 0, 60], radius = 10 }

[[object]]
name = \"wall\"
in = \"fWall\"
box = { min = [300, WALL, -1000], max = [2000, 999, 320] }
";

/// A folder with the application and the wall at this y coordinate.
pub(crate) fn folder_with_wall(wall: f64) -> Folder {
    let folder = Folder::with(CODE);
    folder.write("val3.toml", "[run]\npower = true\n");
    folder.write("cell.toml", &CELL.replace("WALL", &wall.to_string()));
    folder
}

#[test]
fn a_contact_is_shown_with_its_line_and_fails() {
    let run = folder_with_wall(150.0).val3(&["run"]);
    expect![[r#"
        note: no arm is named: this run has a TX2-90; name yours with --arm, in val3.toml or in arm.cfx
        error: `link5` overlaps `wall` by 6.0 mm at 0.680 s, in move 2 (movel, start:15)
           ┌─ usrapp/main/start.pgx:15:3
           │
        15 │   movel(pEnd,flange,mLine)
           │   ^^^^^^^^^^^^^^^^^^^^^^^^ during the move of this line
           │
           = help: move one of them, or allow the pair in cell.toml: allow = [["link5", "wall", "the reason"]]

        error: `link6` overlaps `wall` by 28.0 mm at 0.676 s, in move 1 (movel, start:15)
           ┌─ usrapp/main/start.pgx:15:3
           │
        15 │   movel(pEnd,flange,mLine)
           │   ^^^^^^^^^^^^^^^^^^^^^^^^ during the move of this line
           │
           = help: move one of them, or allow the pair in cell.toml: allow = [["link6", "wall", "the reason"]]

        error: `rod` overlaps `wall` by 10.0 mm at 0.680 s, in move 2 (movel, start:15)
           ┌─ usrapp/main/start.pgx:15:3
           │
        15 │   movel(pEnd,flange,mLine)
           │   ^^^^^^^^^^^^^^^^^^^^^^^^ during the move of this line
           │
           = help: move one of them, or allow the pair in cell.toml: allow = [["rod", "wall", "the reason"]]

    "#]]
    .assert_eq(&run.stderr);
    assert_eq!(run.code, 1);
}

/// A tetrahedron with edges of 10 mm at the origin, as an STL file.
const CORNER: &str = "solid corner\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 10 0\n\
    endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 10\nvertex 10 0 0\nvertex 0 10 0\nendloop\n\
    endfacet\nendsolid corner\n";

#[test]
fn the_mesh_of_a_link_is_compared_in_place_of_its_capsule() {
    let folder = folder_with_wall(150.0);
    folder.write("link5.stl", CORNER);
    folder.write("val3.toml", "[run]\npower = true\nshapes = { link5 = \"link5.stl\" }\n");
    let run = folder.val3(&["run"]);
    assert!(!run.stderr.contains("`link5` overlaps"), "{}", run.stderr);
    folder.write("link5.stl", "solid nothing\nendsolid nothing\n");
    expect![[r#"
        error: cannot use `link5.stl`: it has no triangle
         --> val3.toml:3
          |
        3 | shapes = { link5 = "link5.stl" }
          |            ^^^^^
          help: name a mesh of the link, or remove the setting: the capsules of the arm are then compared
    "#]]
    .assert_eq(&folder.val3(&["run"]).stderr);
}

#[test]
fn a_near_miss_is_a_note() {
    let folder = folder_with_wall(200.0);
    folder.write("cell.toml", &format!("clearance = 45\n{}", CELL.replace("WALL", "200")));
    let run = folder.val3(&["run"]);
    expect![[r#"
        note: no arm is named: this run has a TX2-90; name yours with --arm, in val3.toml or in arm.cfx
        note: 4 near misses, the nearest: `link6` is 8.5 mm from `wall` at 0.680 s, in move 2 (movel, start:15)
    "#]]
    .assert_eq(&run.stderr);
    assert_eq!(run.code, 0);
}

/// An arm whose links have no shapes.
const BARE_ARM: &str = "name = \"bare\"\nkind = \"six-axis\"\n\
    [geometry]\na1 = 50\nb = 50\nc2 = 425\nc3 = 425\nc4 = 100\n\
    [axes]\nmin = [-180, -130, -145, -270, -115, -270]\nmax = [180, 147.5, 145, 270, 140, 270]\n\
    maximum_speed = [400, 400, 430, 540, 475, 760]\n";

#[test]
fn unknown_distances_are_noted() {
    let folder = folder_with_wall(200.0);
    folder.write("bare.toml", BARE_ARM);
    folder.write("val3.toml", "arm = \"bare.toml\"\n[run]\npower = true\n");
    folder.write(
        "cell.toml",
        "[[object]]\nname = \"wall\"\nin = \"fWall\"\nat = [1e5, 0, 0]\nbox = [1, 2, 3]\n\
                               [[object]]\nname = \"tray\"\nin = \"fElsewhere\"\nbox = [1, 2, 3]\n",
    );
    let run = folder.val3(&["run"]);
    expect![[r#"
        note: without `tray` of cell.toml: this application does not have their frames, tools or signals
        note: links of the arm `bare` have no shapes: their distances are unknown
    "#]]
    .assert_eq(&run.stderr);
}

#[test]
fn a_cell_can_be_chosen() {
    let folder = folder_with_wall(150.0);
    let code = |arguments: &[&str]| folder.val3(arguments).code;
    assert_eq!(code(&["run", "--cell", "none"]), 0);
    folder.write("far.toml", &CELL.replace("WALL", "300"));
    assert_eq!(code(&["run", "--cell", "far.toml"]), 0);
    folder.write("val3.toml", "[run]\npower = true\ncell = \"none\"\n");
    assert_eq!(code(&["run"]), 0);
    folder.write("val3.toml", "[run]\npower = true\ncell = \"far.toml\"\n");
    assert_eq!(code(&["run", "--cell", "cell.toml"]), 1);
}

#[test]
fn the_table_of_times_has_the_smallest_distances() {
    let run = folder_with_wall(200.0).val3(&["run", "--times"]);
    let table = run.stderr.split_once("  nearest by line\n").map_or(run.stderr.as_str(), |(_, table)| table);
    let table: String = table.lines().map(|line| format!("{}\n", line.trim())).collect();
    expect![[r#"
        8.51 mm at    0.680 s  start:15  link6 - wall
        88.25 mm at    0.488 s  start:11  link4 - wall
        nearest by pair
        8.51 mm at    0.680 s  link6 - wall
        17.66 mm at    0.680 s  link5 - wall
        22.19 mm at    0.680 s  link4 - wall
        40.00 mm at    0.680 s  rod - wall
        114.83 mm at    0.000 s  link2 - wall
        115.88 mm at    0.680 s  link3 - wall
        127.51 mm at    0.000 s  link1 - wall
    "#]]
    .assert_eq(&table);
}

#[test]
fn the_table_of_times_has_the_eight_nearest_pairs() {
    let folder = folder_with_wall(200.0);
    let cell = CELL.replace("WALL", "200");
    let (_, wall) = cell.split_once("\n\n").unwrap();
    folder.write("cell.toml", &format!("{cell}\n{}", wall.replace("\"wall\"", "\"other wall\"")));
    let run = folder.val3(&["run", "--times"]);
    let (_, table) = run.stderr.split_once("  nearest by pair\n").unwrap();
    assert_eq!(table.lines().count(), 9, "{table}");
    assert_eq!(table.lines().last(), Some("  and 6 more: `--times FILE` writes all"));
    folder.val3(&["run", "--times=times.json"]);
    let times: serde_json::Value = serde_json::from_str(&folder.read("times.json")).unwrap();
    assert_eq!(times["nearest"].as_array().unwrap().len(), 14);
}

#[test]
fn a_picture_has_the_smallest_distance_over_time() {
    let folder = folder_with_wall(200.0);
    folder.write("cell.toml", &format!("clearance = 45\n{}", CELL.replace("WALL", "200")));
    folder.val3(&["run", "--plot", "picture.svg"]);
    let picture = folder.read("picture.svg");
    assert!(picture.contains(">smallest distance (mm)<") && picture.contains(">clearance 45<"), "{picture}");
    assert!(picture.contains(">link6 - wall: 8.5 mm<"), "{picture}");
    folder.val3(&["run", "--cell", "none", "--plot", "empty.svg"]);
    assert!(!folder.read("empty.svg").contains("smallest distance"));
}

#[test]
fn the_record_has_each_encounter() {
    let folder = folder_with_wall(150.0);
    folder.val3(&["run", "--events", "events.jsonl"]);
    let events = folder.read("events.jsonl");
    let mut states = events.lines().filter(|line| line.contains("\"clearance\"") && line.contains("\"rod\""));
    assert!(states.next().unwrap().contains("\"contact\""), "{events}");
    assert!(states.next().unwrap().contains("\"clear\""), "{events}");
    let replay = folder.val3(&["run", "--replay", "events.jsonl"]);
    assert!(!replay.stderr.contains("differs"), "{}", replay.stderr);
}

#[track_caller]
fn refused(cell: &str, expected: &Expect) {
    let folder = Folder::with(CODE);
    folder.write("val3.toml", "[run]\npower = true\n");
    folder.write("cell.toml", cell);
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
    let root = folder.path().to_str().unwrap();
    expected.assert_eq(&run.stderr.replace(root, "FOLDER"));
}

#[test]
fn errors_of_a_cell_have_their_places() {
    refused(
        "clearence = 20\n",
        &expect![[r#"
        error: there is no setting `clearence`
         --> cell.toml:1
          |
        1 | clearence = 20
          | ^^^^^^^^^
          help: did you mean `clearance`?
    "#]],
    );
    refused(
        "[[object]]\nname = \"wall\"\nbocks = [1, 2, 3]\n",
        &expect![[r#"
        error: there is no setting `object[].bocks`
         --> cell.toml:3
          |
        3 | bocks = [1, 2, 3]
          | ^^^^^
          help: known settings: at, box, capsule, clearance, colour, cylinder, hull, in, mesh, name, shapes, sphere, unit
    "#]],
    );
    refused(
        "[[object]]\nname = \"wall\"\nbox = [1, 2]\n",
        &expect![[r#"
        error: three numbers are needed here, and there are 2
         --> cell.toml:3
          |
        3 | box = [1, 2]
          | ^^^
          help: write `[x, y, z]`
    "#]],
    );
    refused(
        "[[object]]\nname = \"wall\"\nin = \"fWal\"\nbox = [1, 2, 3]\n",
        &expect![[r#"
        error: there is no frame, tool or object `fWal`
         --> cell.toml:3
          |
        3 | in = "fWal"
          | ^^
          help: did you mean `fWall`?
    "#]],
    );
    refused(
        "[[object]]\nname = \"wall\"\nat = [0, -200, 0]\nmesh = \"../wall.stl\"\n",
        &expect![[r#"
            error: `../wall.stl` is not in the folder of this file
             --> cell.toml:4
              |
            4 | mesh = "../wall.stl"
              | ^^^^
              help: name an existing STL or GLB file of at most 32 MB, in the folder of this file or below
        "#]],
    );
    refused(
        "[[object]]\nname = \"wall\"\nmesh = \"wall.stl\"\n",
        &expect![[r#"
            error: cannot read `wall.stl`: it does not exist
             --> cell.toml:3
              |
            3 | mesh = "wall.stl"
              | ^^^^
              help: name an existing STL or GLB file of at most 32 MB, in the folder of this file or below
        "#]],
    );
}

#[cfg(unix)]
#[test]
fn a_mesh_is_not_read_through_a_link_out_of_the_folder() {
    let elsewhere = Folder::empty();
    elsewhere.write("wall.stl", "solid wall\nendsolid wall\n");
    let folder = Folder::with(CODE);
    folder.write("val3.toml", "");
    folder.write("cell.toml", "[[object]]\nname = \"wall\"\nmesh = \"wall.stl\"\n");
    std::os::unix::fs::symlink(elsewhere.path().join("wall.stl"), folder.path().join("wall.stl")).unwrap();
    let run = folder.val3(&["run"]);
    assert!(run.code == 2 && run.stderr.contains("`wall.stl` is not in the folder"), "{}", run.stderr);
}

#[test]
fn a_file_that_is_named_must_exist() {
    let run = Folder::with(CODE).val3(&["run", "--cell", "no.toml"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: cannot read `no.toml`: it does not exist
          help: name an existing file, or `none`
    "#]]
    .assert_eq(&run.stderr);
}

/// Smallest distances that coal 3.0.3 computes from the samples of the example's motion, in mm.
const PALLETISER: [(&str, &str, f64); 7] = [
    ("gripper", "conveyor belt", 119.31),
    ("gripper", "pallet", 200.0),
    ("link4", "conveyor belt", 204.98),
    ("link6", "conveyor belt", 220.72),
    ("link5", "conveyor belt", 221.54),
    ("gripper", "pedestal", 260.0),
    ("link4", "pedestal", 276.36),
];

#[test]
fn the_distances_of_the_palletiser_are_those_of_another_library() {
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/palletiser");
    let folder = Folder::empty();
    let (application, script) = (format!("{example}/usr/usrapp/palletiser"), format!("{example}/boxes.toml"));
    let run =
        folder.val3(&["run", &application, "--script", &script, "--until=11", "--until-ok", "--times=times.json"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let times: serde_json::Value = serde_json::from_str(&folder.read("times.json")).unwrap();
    let rows = times["nearest"].as_array().unwrap();
    for (a, b, expected) in PALLETISER {
        let row = rows.iter().find(|row| row["a"] == a && row["b"] == b).unwrap();
        let distance = row["distance"].as_f64().unwrap();
        assert!((distance - expected).abs() < 0.5, "{a} - {b}: {distance} instead of {expected}");
    }
}
