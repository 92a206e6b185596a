//! Images of whole projects: source maps, old programs, limits.

use expect_test::expect;
use val3_compile::{CompileError, Limit};
use val3_lang::types::LengthUnit;

use crate::show::{image, program, project, workspace};

#[test]
fn lines_lead_to_the_source() {
    let listing =
        "num n\nif n==1\n  n=2\nelseIf n==2\n  n=3\nendIf\nfor n=1 to 3\n  put(n)\nendFor\ndo\n  n=4\nuntil n==4";
    let workspace = workspace(listing);
    let file = val3_analysis::items::project::program_files(&workspace.db, project(&workspace, "main"))[0];
    let text = file.text(&workspace.db);
    let image = image(listing);
    let start = program(&image, "start");
    let lines: Vec<String> = start
        .lines
        .iter()
        .map(|line| format!("{} {}\n", line.row, &text[line.range.start as usize..line.range.end as usize]))
        .collect();
    expect![[r#"
        5 if n==1
        6 n=2
        7 n==2
        8 n=3
        10 for n=1 to 3
        11 put(n)
        14 n=4
        15 n==4
    "#]]
    .assert_eq(&lines.concat());
    for line in &start.lines {
        let row = text.lines().nth(line.row as usize - 1).unwrap();
        assert!(row.contains(text[line.range.start as usize..].lines().next().unwrap()));
    }
}

#[test]
fn programs_of_the_old_dialect() {
    let listing = r#"
        version s6.8
        num nA[3]
        call old(nA[1],3)
        call old(4,nA)

        === main/old.pgx
        <?xml version="1.0"?>
        <programList xmlns="ProgramNameSpace"><program name="old" public="true"><description></description>
        <paramSection><param name="x_n" type="num" byVal="false" /><param name="x_m" type="num" byVal="true" /></paramSection>
        <localSection><local name="l_i" type="num" size="1" /></localSection>
        <source><code>begin
          if x_n&lt;1
            x_n[x_m]=l_i
          endIf
        end</code></source></program></programList>
    "#;
    let image = image(listing);
    let shown = format!(
        "start\n{}old\n{}",
        val3_bytecode::disassemble(program(&image, "start")),
        val3_bytecode::disassemble(program(&image, "old"))
    );
    expect![[r#"
        start
           1     0  Call program 0(Data(0) from n0, num n1)
           2     1  StoreFirst { container: Part(0), lane: 0, from: 2 }
                 2  LoadFirst { to: 3, container: Data(0), lane: 0 }
                 3  Call program 0(Part(0), num n3)
                 4  Return
        old
           1     0  LoadFirst { to: 2, container: View(0), lane: 0 }
                 1  UnlessLess { a: 2, b: 3, to: 3 }
           2     2  StoreElement { container: View(0), index: 0, from: 1 }
                 3  Return
    "#]]
    .assert_eq(&shown);
}

#[test]
fn a_project_is_its_programs_libraries_and_settings() {
    let image =
        image("version s8.3\nlibrary part \"Disk://part/part.pjx\" autoload=false\nreturn\n--- part\npublic num n");
    assert_eq!((image.name.as_str(), image.stack_size, image.version.major), ("main", 5000, 8));
    assert_eq!(image.libraries.len(), 1);
    assert!(!image.libraries[0].autoload);
    assert!(image.files[0].ends_with("/start.pgx"));
}

#[test]
fn the_length_unit_is_that_of_the_project_file() {
    let unit = |parameter: &str| {
        let listing = format!(
            "return\n=== main/main.pjx\n<Project xmlns=\"ProjectNameSpace\"><Parameters version=\"s7.11\" {parameter} />\
             <Programs><Program file=\"start.pgx\" /></Programs></Project>"
        );
        image(&listing).unit
    };
    assert_eq!(unit("millimeterUnit=\"false\""), LengthUnit::Inch);
    assert_eq!(unit("millimeterUnit=\"true\""), LengthUnit::Millimetre);
    assert_eq!(unit(""), LengthUnit::Millimetre);
}

#[test]
fn limits_are_errors_at_their_statement() {
    let data: String = (0..8193).map(|number| format!("num n{number}\n")).collect();
    let workspace = workspace(&format!("{data}return"));
    let found = val3_compile::compile(&workspace.db, project(&workspace, "main"));
    assert!(matches!(found, Err(CompileError { limit: Limit::Containers, .. })));
}
