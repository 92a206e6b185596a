//! Data: declarations, values, collections, user types, libraries.

use expect_test::expect;

use crate::support::check;

#[test]
fn declarations_differ_by_name() {
    let old = "num nA = 1\nstring sB[2]\nbool bGone = true\npublic num nType";
    let new = "num nA = 2\npublic string sB[3]\ndio dNew\npublic string nType";
    check(
        old,
        new,
        &expect![[r#"
            main  main/main.pjx
              Interface  no project file here names it
                ~ data nType  was num nType, is now string nType
                + data sB  string sB[]
              Data
                - bool bGone = true
                ~ nType  type num → string
                ~ sB  size 2 → 3, access private → public
                ~ nA  1 → 2
              Inputs and outputs
                + dio dNew

            1 application differs: 4 values, 1 input or output, 2 public items
        "#]],
    );
}

fn data(data: &str) -> String {
    format!(
        "cls()\n=== main/main.dtx\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>{data}</Datas></Database>"
    )
}

#[test]
fn collections_differ_by_key() {
    let old = data(
        "<Data name=\"nC\" access=\"private\" xsi:type=\"collection\" type=\"num\"><Value key=\"a\" value=\"1\"/>\
         <Value key=\"b\" value=\"2\"/></Data>",
    );
    let new = data(
        "<Data name=\"nC\" access=\"private\" xsi:type=\"collection\" type=\"num\"><Value key=\"b\" value=\"3\"/>\
         <Value key=\"c &amp; d\"/></Data>",
    );
    check(
        &old,
        &new,
        &expect![[r#"
            main  main/main.pjx
              Data
                - nC["a"]  = 1
                + nC["c & d"]
                ~ nC["b"]  2 → 3

            1 application differs: 3 values
        "#]],
    );
}

fn slot(size: u32, x: u32, weight: &str) -> String {
    data(&format!(
        "<Data name=\"tSlot\" access=\"public\" xsi:type=\"array\" type=\"Slot\" size=\"{size}\"><Value key=\"0\">\
         <Field name=\"pPick\" xsi:type=\"array\" type=\"pointRx\" size=\"1\"><Value key=\"0\" x=\"{x}\" fatherId=\"world[0]\"/>\
         </Field><Field name=\"nWeight\" xsi:type=\"array\" type=\"num\" size=\"1\">{weight}</Field></Value></Data>"
    ))
}

#[test]
fn fields_of_user_types_are_compared() {
    check(
        &slot(1, 10, ""),
        &slot(2, 12, "<Value key=\"0\" value=\"5\"/>"),
        &expect![[r#"
            main  main/main.pjx
              Points, frames and tools
                  Position        Moved  Turned  In world  Values
                ~ tSlot.pPick  2.000 mm          2.000 mm  x 10 → 12
              Data
                ~ tSlot  size 1 → 2
                ~ tSlot.nWeight  0 → 5

            1 application differs: 1 position, 1 value
        "#]],
    );
}

/// An application with a value of the user type `Slot`, whose weight is 5 at the start and whose part has 7 holes.
fn with_types(fields: &str) -> String {
    let value = format!(
        "<Data name=\"tSlot\" access=\"private\" xsi:type=\"array\" type=\"Slot\" size=\"2\"><Value key=\"1\">{fields}</Value></Data>"
    );
    format!(
        "type Slot \"Disk://Slot/Slot.pjx\"\n{}\n--- Slot\ntype Part \"Disk://Part/Part.pjx\"\npublic num nWeight = 5\n\
         public Part rPart\npublic num nFree[3]\n--- Part\npublic num nHoles = 7",
        data(&value)
    )
}

fn field(name: &str, ty: &str, value: &str) -> String {
    format!("<Field name=\"{name}\" xsi:type=\"array\" type=\"{ty}\" size=\"1\"><Value key=\"0\"{value}</Field>")
}

/// All fields of a `Slot` with their values in the file, as `libSave` writes them.
fn written(weight: u32, holes: u32) -> String {
    let holes = field("nHoles", "num", &format!(" value=\"{holes}\"/>"));
    let free =
        "<Field name=\"nFree\" xsi:type=\"array\" type=\"num\" size=\"3\"><Value key=\"2\" value=\"0\"/></Field>";
    let part = field("rPart", "Part", &format!(">{holes}</Value>"));
    field("nWeight", "num", &format!(" value=\"{weight}\"/>")) + &part + free
}

#[test]
fn a_written_initial_value_of_a_type_is_no_difference() {
    let same = &expect![[r#"
        no differences in 3 applications
    "#]];
    check(&with_types(""), &with_types(&written(5, 7)), same);
    check(&with_types(&written(5, 7)), &with_types(""), same);
}

#[test]
fn a_value_differs_from_the_initial_value_of_its_type() {
    check(
        &with_types(""),
        &with_types(&written(6, 8)),
        &expect![[r#"
            main  main/main.pjx
              Data
                ~ tSlot[1].nWeight  5 → 6
                ~ tSlot[1].rPart.nHoles  7 → 8

            1 application differs: 2 values
        "#]],
    );
    check(
        &with_types(&written(6, 7)),
        &with_types(""),
        &expect![[r#"
            main  main/main.pjx
              Data
                ~ tSlot[1].nWeight  6 → 5

            1 application differs: 1 value
        "#]],
    );
}

fn descriptor(values: &str) -> String {
    data(&format!(
        "<Data name=\"mFast\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\"><Value key=\"0\" {values}/></Data>"
    ))
}

#[test]
fn motion_descriptors_differ_by_field() {
    check(
        &descriptor("tmax=\"250\""),
        &descriptor("vel=\"50\" tmax=\"500.0\" blend=\"cartesian\""),
        &expect![[r#"
            main  main/main.pjx
              Data
                ~ mFast  vel 100 → 50, tvel 250 → 500, blend joint → Cartesian

            1 application differs: 1 value
        "#]],
    );
}

fn two_numbers(value: &str) -> String {
    data(&format!("<Data name=\"nA\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"2\">{value}</Data>"))
}

#[test]
fn defaults_and_numbers_may_be_written_in_several_ways() {
    let old = two_numbers("<Value key=\"0\" value=\"0\"/><Value key=\"1\" value=\"1.50\"/>");
    check(
        &old,
        &two_numbers("<Value key=\"1\" value=\"1.5\"/>"),
        &expect![[r#"
            no differences in 1 application
        "#]],
    );
}

#[test]
fn a_library_shows_its_interface() {
    let old = "
        library tray \"Disk://tray/tray.pjx\"
        call tray:reset()
        --- tray
        public num nCount
        public num nGone
        public program reset()
        begin
        end
        ";
    let new = "
        library tray \"Disk://tray2/tray.pjx\"
        library io \"Disk://io/io.pjx\"
        call tray:reset()
        --- tray
        public string nCount
        num nGone
        public program reset(bool x_bAll)
        begin
        end
        public program fill()
        begin
        end
        ";
    check(
        old,
        new,
        &expect![[r#"
            main  main/main.pjx
              Libraries
                + io  Disk://io/io.pjx
                ~ tray  Disk://tray/tray.pjx → Disk://tray2/tray.pjx

            tray  tray/tray.pjx
              Interface  used by main
                + program fill  fill()
                ~ program reset  was reset(), is now reset(bool)
                ~ data nCount  was num nCount, is now string nCount
                - data nGone  num nGone
              Programs
                + fill()  2 lines
                ~ reset(bool x_bAll)  same code
                    was reset()
              Data
                ~ nCount  type num → string
                ~ nGone  access public → private

            2 applications differ: 2 programs, 2 values, 2 libraries and types, 4 public items
        "#]],
    );
}
