//! The work of loading is proportional to the number of values: every value visits the same number of nodes in its
//! file.

use std::fmt::Write;

use val3_syntax::view::visits;

use crate::show::{project, workspace};

/// Types of s7 and s8, with the attributes of a value.
const VALUES: &[(&str, &str)] = &[
    ("num", r#"value="1""#),
    ("bool", r#"value="true""#),
    ("string", r#"value="a""#),
    ("dio", r#"link="BasicIO-1\%I0""#),
    ("aio", r#"link="a\b""#),
    ("sio", r#"link="Socket\a""#),
    ("trsf", r#"x="1""#),
    ("frame", r#"x="1" fatherId="fFirst[0]""#),
    ("tool", r#"x="1" fatherId="flange[0]" ioLink="valve1""#),
    ("pointRx", r#"x="1" fatherId="fFirst[0]""#),
    ("jointRx", r#"j1="1""#),
    ("configRx", r#"shoulder="lefty""#),
    ("mdesc", r#"vel="50""#),
    ("screen", ""),
    ("Slot", ""),
    (
        "Slot",
        r#"><Field name="fF" xsi:type="array" type="frame" size="1"><Value key="0" x="1" /></Field></Value><Value key="-1""#,
    ),
];

/// Types of s5 and s6, with their father and the content of a value.
const OLD_VALUES: &[(&str, &str, &str)] = &[
    ("num", "", r#"value="1""#),
    ("bool", "", r#"value="true""#),
    ("string", "", r#"value="a""#),
    ("dio", "", ""),
    ("trsf", "", r#"><trsfValue x="1" /></valueTrsf><valueTrsf index="-1""#),
    (
        "frame",
        r#"<fFather name="fFirst" fatherIndex="0" />"#,
        r#"><tfValue x="1" /></valueFrame><valueFrame index="-1""#,
    ),
    ("tool", r#"<tFather name="flange" fatherIndex="0" />"#, r#"><ttValue x="1" /></valueTool><valueTool index="-1""#),
    ("tool", "", r#"><io name="dGrip" ioIndex="0" /></valueTool><valueTool index="-1""#),
    (
        "point",
        r#"<pFather name="fFirst" fatherIndex="0" />"#,
        r#"><tpValue x="1" /></valuePoint><valuePoint index="-1""#,
    ),
    ("joint", "", r#"><jointValue j1="1" /></valueJoint><valueJoint index="-1""#),
    ("config", "", r#"><configValue shoulder="lefty" /></valueConfig><valueConfig index="-1""#),
    ("mdesc", "", r#"><mdescValue vel="20" /></valueMdesc><valueMdesc index="-1""#),
];

/// Compiles an application with these data, and returns the number of visited nodes and tokens.
fn visits_to_compile(listing: &str) -> u64 {
    let workspace = workspace(listing);
    let main = project(&workspace, "main");
    let before = visits();
    val3_compile::compile(&workspace.db, main).unwrap();
    visits() - before
}

fn collected(count: u32, value: impl Fn(u32) -> String) -> String {
    (0..count).fold(String::new(), |mut text, number| {
        text.push_str(&value(number));
        text
    })
}

fn listing(ty: &str, attributes: &str, count: u32) -> String {
    let values = collected(count, |key| format!(r#"<Value key="{key}" {attributes} />"#));
    let mut data = String::new();
    for (name, container) in [("xArray", "array"), ("xCollection", "collection")] {
        let size = if container == "array" { format!(r#"size="{count}""#) } else { String::new() };
        write!(
            data,
            r#"<Data name="{name}" access="private" xsi:type="{container}" type="{ty}" {size}>{values}</Data>"#
        )
        .unwrap();
    }
    format!(
        r#"type Slot "Disk://Slot/Slot.pjx"
return

=== main/main.dtx
<?xml version="1.0"?>
<Database><Datas><Data name="fFirst" access="private" xsi:type="array" type="frame" size="1" />{data}</Datas></Database>
=== Slot/Slot.dtx
<?xml version="1.0"?>
<Database><Datas><Data name="nN" access="public" xsi:type="array" type="num" size="1" />
<Data name="dI" access="public" xsi:type="array" type="dio" size="1"><Value key="0" link="a\b" /></Data>
<Data name="fF" access="public" xsi:type="array" type="frame" size="1"><Value key="0" fatherId="world[0]"/></Data></Datas></Database>
=== Slot/Slot.pjx
<?xml version="1.0"?>
<Project><Parameters version="s7.11" stackSize="5000" millimeterUnit="true" /><Programs /><Database><Data file="Slot.dtx" /></Database></Project>
"#
    )
}

fn old_listing(ty: &str, father: &str, content: &str, count: u32) -> String {
    let element = format!("value{}{}", ty[..1].to_uppercase(), &ty[1..]);
    let values = collected(count, |index| format!(r#"<{element} index="{index}" {content} />"#));
    format!(
        r#"version s6.8
return

=== main/main.dtx
<?xml version="1.0"?>
<dataList xmlns="DataNameSpace"><frameSection><frame name="fFirst" public="false"><valueFrame index="0" /></frame></frameSection>
<dioSection><dio name="dGrip" public="false" size="1" /></dioSection>
<{ty}Section><{ty} name="xAll" public="false">{father}{values}</{ty}></{ty}Section></dataList>
"#
    )
}

/// Checks that each additional value costs the same work.
#[track_caller]
fn check_proportion(what: &str, counts: [u32; 3], listing: impl Fn(u32) -> String) {
    let [few, some, many] = counts.map(|count| visits_to_compile(&listing(count)));
    let [first, second, third] = counts.map(u64::from);
    let (per_value, per_later_value) = ((some - few) / (second - first), (many - some) / (third - second));
    assert_eq!(per_value, per_later_value, "{what}: visits for each value, up to {second} and up to {third} values");
    assert!(per_value > 0, "{what}: the count of visits is off");
}

#[test]
#[cfg(debug_assertions)]
fn each_value_of_each_type_costs_the_same_work() {
    for (ty, attributes) in VALUES {
        check_proportion(ty, [100, 500, 2_000], |count| listing(ty, attributes, count));
    }
    for (ty, father, content) in OLD_VALUES {
        check_proportion(ty, [100, 500, 2_000], |count| old_listing(ty, father, content, count));
    }
}

#[test]
#[cfg(debug_assertions)]
fn many_values_cost_the_same_work_each() {
    check_proportion("num", [1_000, 16_000, 64_000], |count| listing("num", r#"value="1""#, count));
}
