//! Images of complete projects: source maps, old programs, limits.

use expect_test::expect;
use val3_compile::{CompileError, CompileLimit};
use val3_lang::types::LengthUnit;

use crate::show::{image, program, project, text_of, workspace};

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
    expect![[r#"
        program start
            file 1 stack 16
            frame n4
            nums n0=1, n1=3, n2=4
            container num[1]
        line 5
            Call old (view $nA from n0, num n1)
        line 6
            StoreFirst c0 0 n2
            LoadFirst n3 $nA 0
            Call old (view c0, num n3)
        closing 7 at 242 245
            Return
        end
        program public old
            file 0 stack 48
            param x_n num[] v0
            param x_m num n0
            local l_i num n1
            frame n4/v1
            nums n3=1
        line 6
            LoadFirst n2 v0 0
            UnlessLess n2 n3 L3
        line 7
            StoreElement v0 n0 n1
        L3:
        closing 9 at 370 373
            Return
        end
    "#]]
    .assert_eq(&(text_of(&image, "start") + &text_of(&image, "old")));
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
    for (parameter, unit) in [
        ("millimeterUnit=\"false\"", LengthUnit::Inch),
        ("millimeterUnit=\"true\"", LengthUnit::Millimetre),
        ("", LengthUnit::Millimetre),
    ] {
        let listing = format!(
            "return\n=== main/main.pjx\n<Project xmlns=\"ProjectNameSpace\"><Parameters version=\"s7.11\" {parameter} />\
             <Programs><Program file=\"start.pgx\" /></Programs></Project>"
        );
        assert_eq!(image(&listing).unit, unit, "{parameter}");
    }
}

#[test]
fn limits_are_errors_at_their_statement() {
    let data: String = (0..8193).map(|number| format!("num n{number}\n")).collect();
    let workspace = workspace(&format!("{data}return"));
    let found = val3_compile::compile(&workspace.db, project(&workspace, "main"));
    assert!(matches!(found, Err(CompileError { limit: CompileLimit::Containers, .. })));
}
