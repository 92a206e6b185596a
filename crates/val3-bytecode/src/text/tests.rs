use expect_test::expect;

use super::{assemble, disassemble};

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
