use expect_test::expect;

use super::{assemble, disassemble};
use crate::{Image, ProgramRef};

fn error(text: &str) -> String {
    let shown = |error: super::AssemblyError| {
        format!("{:<24} {error}\n", text.lines().nth(error.line as usize - 1).unwrap_or(""))
    };
    assemble(text).map_err(shown).unwrap_err()
}

/// All parts of the image except programs.
const DECLARATIONS: &str = r#"image "odd name" "Disk://main/main.pjx"
version s8.3
unit inch
arm Rs
stack 800
file "Disk://main/start.pgx"
type "part:Slot" {
    nCount num[1] {7}
    sNames string["b", "a"] {"x\n\"y\"", _}
}
type Tray {
    tSlots @"part:Slot"[2, 3]
}
data public tTray @Tray[2] {_, (@"part:Slot"[1, 1] {(num[1] {7} string[])})}
data fFrame frame[1] {(1 2 3 0 0 90.5 world)}
data jStart joint arm Rs[1]
link 0 (1 0, 2 1) 3 0 port dio "BasicIO-1\\%I0"
link 1 () 0 0 father fTray "1,2" (fIn "0") of part
link 1 () 0 1 signal dOut "0" ()
library part "Disk://part/part.pjx" autoload
import part nX data num[,]
import part tell program (num, string[""]&)
import part gone missing
"#;

#[test]
fn everything_that_is_no_code_is_kept() {
    let image = assemble(DECLARATIONS).unwrap();
    assert_eq!(disassemble(&image), DECLARATIONS);
    assert_eq!((image.data.len(), image.links.len(), image.imports.len()), (3, 3, 3));
}

#[test]
fn callees_are_named_as_the_catalogue_names_them() {
    let text = "image \"\" \"\"\nversion s7.11\nstack 5000

program start
    file 0 stack 0
    Instruction sin (num n0) -> num n1
    Instruction insert#1 (slot c0[\"k\"], num n1)
    Instruction binary \"*\" trsf (trsf n0, trsf n6) -> trsf n12
    Instruction binary \"<\" joint arm Rs (joint n0, joint n6) -> bool n12
    Instruction unary \"!\" trsf (trsf n0) -> trsf n6
    Instruction assign bool dio (dio l0) -> bool n1
    Instruction print arm Rs (joint n0)
    Instruction missing \"part:gone\" ()
    Instruction lacking \"$odd\" (user c1+c2)
    Instruction invalid ()
end
";
    assert_eq!(disassemble(&assemble(text).unwrap()), text);
}

#[test]
fn lines_are_in_the_order_of_the_file() {
    let image = assemble("program start\nline 7 at 50 60\nJump on\non: line 6 at 40 49\nReturn\nend").unwrap();
    let lines = image.programs.iter().flat_map(|program| &program.lines);
    assert_eq!(lines.map(|line| (line.row, line.op)).collect::<Vec<_>>(), [(6, 1), (7, 0)]);
}

#[test]
fn errors_name_their_place_and_what_is_expected() {
    let declarations = [
        "imag main",
        "data nX num[2",
        "data nX nun[2]",
        "data tX @Slot[2]",
        "data s string[1] {\"a\n}",
        "data p point[1] {(1 2)}",
        "data c num[\"a\", \"a\"]",
        "program start",
    ];
    let code = [
        "  Add n0 n1",
        "  Jump là",
        "a: Return a: Return",
        "Call other ()",
        "LoadFirst n0 $nX 0",
        "LoadFirst n0 v8192 0",
        "Move n0 n65536",
        "Instruction sine (num n0)",
        "Instruction sin#7 (num n0)",
        "frame n2 nums n2=1",
        "Return line 3",
    ];
    let programs = code.map(|code| format!("program start\n{code}\nend"));
    let errors = declarations.into_iter().chain(programs.iter().map(String::as_str)).map(error);
    expect![[r#"
        imag main                1:1: `imag` begins no declaration
        data nX num[2            1:14: `,` is missing at the end of the text
        data nX nun[2]           1:9: `nun` is no type
        data tX @Slot[2]         1:10: there is no type `Slot`
        data s string[1] {"a     1:19: the quotation mark that ends this text is missing
        data p point[1] {(1 2)}  1:22: a value of this type has 9 numbers, 0 texts, 1 links and 0 containers
        data c num["a", "a"]     1:20: two of these keys are equal
        program start            1:14: an operation is missing at the end of the text
        end                      3:1: `end` is found where a number of the frame, such as `n0`, is expected
          Jump là                2:8: the label `là` is missing
        a: Return a: Return      2:11: this label is set twice
        Call other ()            2:6: there is no program `other`
        LoadFirst n0 $nX 0       2:15: there is no global data `nX`
        LoadFirst n0 v8192 0     2:14: the highest possible number here is 8191
        Move n0 n65536           2:9: `n65536` is found where a number of the frame, such as `n0`, is expected
        Instruction sine (num n0) 2:13: there is no instruction `sine`
        Instruction sin#7 (num n0) 2:17: `sin` has 1 forms, counted from 0
        frame n2 nums n2=1       2:18: the frame has 2 numbers
        end                      3:1: an operation is missing after the last `line` or `side`
    "#]]
    .assert_eq(&errors.collect::<String>());
}

#[test]
fn a_text_with_a_missing_part_is_an_image_or_an_error() {
    let text = format!("{DECLARATIONS}program start\nframe n2/t1\nnums n1=-2.5\na: line 1 at 2 3 Jump a\nend");
    for (at, _) in text.char_indices() {
        let (before, after) = text.split_at(at);
        for text in [before.to_owned(), after.to_owned(), before.to_owned() + &after[1..]] {
            if let Ok(image) = assemble(&text) {
                assert_eq!(assemble(&disassemble(&image)), Ok(image), "{text}");
            }
        }
    }
}

#[test]
fn names_and_texts_are_quoted_where_they_could_be_read_as_something_else() {
    for name in ["a b", "", "1st", "public", "ä", "a\"b", "a\\b", "a\nb"] {
        let image = Image { name: name.to_owned(), ..Image::default() };
        let text = disassemble(&image);
        assert!(text.starts_with("image \""), "{text}");
        assert_eq!(assemble(&text).unwrap().name, name);
    }
    let image = Image { name: "plain_1".to_owned(), ..Image::default() };
    assert!(disassemble(&image).starts_with("image plain_1 "));
}

#[test]
fn an_item_that_shares_its_name_is_written_as_a_number() {
    let text =
        "data nX num[1]\ndata nX num[2]\nprogram start\nframe n1\nLoadFirst n0 $nX 0\nLoadFirst n0 $1 0\nReturn\nend";
    let image = assemble(text).unwrap();
    let text = disassemble(&image);
    assert!(text.contains("LoadFirst n0 $nX 0\n    LoadFirst n0 $1 0\n"), "{text}");
    assert_eq!(assemble(&text), Ok(image));
}

#[test]
fn numbers_are_limited_by_their_place() {
    let errors =
        ["stack 4294967296", "stack -1", "data n num[1, 2, 3, 4]", "link 0 () 0 0 father f 1 ()", "arm Xx", "unit mm"];
    expect![[r#"
        stack 4294967296         1:7: `4294967296` is too large here
        stack -1                 1:7: `-1` is found where a number is expected
        data n num[1, 2, 3, 4]   1:22: one to three sizes are expected here
        link 0 () 0 0 father f 1 () 1:24: `1` is found where a text in quotation marks is expected
        arm Xx                   1:5: `Xx` is no arm
        unit mm                  1:6: `mm` is found where `inch` is expected
    "#]]
    .assert_eq(&errors.map(error).concat());
    assert_eq!(assemble("stack 4294967295").unwrap().stack_size, u32::MAX);
}

#[test]
fn a_string_has_at_most_128_bytes() {
    let data = |text: &str| format!("data s string[1] {{\"{text}\"}}");
    assert!(assemble(&data(&"a".repeat(128))).is_ok());
    assert!(error(&data(&"a".repeat(129))).contains("more than 128 bytes"));
}

#[test]
fn variables_of_all_places_and_containers_are_kept() {
    let text = "image \"\" \"\"
version s7.11
stack 5000

program public start
    file 0 stack 24
    param x_nValue num n1
    param x_sText string t0
    param x_dPort dio l1
    param x_pAt point n2/l0
    param x_nRef num p0
    param x_nList num[] v0
    param x_nGrid num[,] v1
    param x_nCube num[,,] v2
    param x_nMap num[\"\"] v3
    local l_nMany num[] c0
    frame n8/t1/l2/p1/v4
    nums n1=2.5, n7=-0.5
    container num[2, 3, 4] {1, _}
    container string[]
    Return
end
";
    let image = assemble(text).unwrap();
    assert_eq!(disassemble(&image), text);
    let program = &image.programs[0];
    assert_eq!((program.params.len(), program.variables.len(), program.frame.lanes.part), (9, 10, 2));
    assert_eq!(program.nums, [0.0, 2.5, 0.0, 0.0, 0.0, 0.0, 0.0, -0.5]);
}

#[test]
fn subscripts_and_offsets_are_kept() {
    let text = "image \"\" \"\"
version s7.11
stack 5000
data nX num[1]

program start
    file 0 stack 0
    frame n9/t9/p9
    Instruction insert#1 (slot $nX, num n1)
    Instruction insert#1 (slot $nX[n1], num n1)
    Instruction insert#1 (slot $nX[n1, n2], num n1)
    Instruction insert#1 (slot $nX[n1, n2, n3], num n1)
    Instruction insert#1 (slot $nX[t1], num n1)
    Instruction print (point p3+n6/l1)
    Instruction print (view i7 from n2, library 0)
    Return
end
";
    let text = text.replace(", library 0", "");
    assert_eq!(disassemble(&assemble(&text).unwrap()), text);
    let too_many = "data nX num[1] program start Instruction insert#1 (slot $nX[n1, n2, n3, n4]) end";
    assert!(error(too_many).contains("one to three indexes"), "{}", error(too_many));
}

#[test]
fn constants_are_listed_only_in_another_order_than_that_of_their_use() {
    let first = "program start frame t1 TextMove t0 \"a\" TextMove t0 \"b\" TextMove t0 \"a\" Return end";
    let image = assemble(first).unwrap();
    assert_eq!(image.programs[0].texts.len(), 2);
    assert!(!disassemble(&image).contains("texts"));
    let other = "program start frame t1 texts \"b\", \"a\", \"a\" TextMove t0 \"a\" TextMove t0 #2 Return end";
    let image = assemble(other).unwrap();
    let text = disassemble(&image);
    assert!(text.contains("texts \"b\", \"a\", \"a\"\n    TextMove t0 \"a\"\n    TextMove t0 #2\n"), "{text}");
    assert_eq!(assemble(&text), Ok(image));
}

#[test]
fn tasks_and_calls_name_programs_in_any_order() {
    let text = "image \"\" \"\"
version s7.11
stack 5000
library part \"Disk://part/part.pjx\"
import part tell program ()

program start
    file 0 stack 0
    frame n2/t1
    CreateTask t0 n0 other (num n1)
    CreateTask \"late\" n0 overrun n1 other ()
    Call import 0 ()
    Return
end

program other
    file 0 stack 0
    Return
end
";
    let image = assemble(text).unwrap();
    assert_eq!(disassemble(&image), text);
    assert_eq!(image.programs[0].tasks[1].call.program, ProgramRef::Own(1));
}

#[test]
fn comments_and_line_breaks_have_no_meaning() {
    let spread = "stack ; a size\n 7 ; the end";
    assert_eq!(assemble(spread), assemble("stack 7"));
    assert_eq!(assemble("file \"a;b\"").unwrap().files, ["a;b"]);
}
