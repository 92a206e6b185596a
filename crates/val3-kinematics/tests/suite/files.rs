//! Files and names of arms.

use val3_kinematics::{Arm, DEFAULT_SCARA, DEFAULT_SIX_AXIS};

use crate::arm;

const FILE: &str = r#"name = "mine"
kind = "six-axis"

[geometry]
a1 = 50
b = 50
c2 = 425
c3 = 425
c4 = 100

[axes]
min = [-180, -130, -145, -270, -115, -270]
max = [180, 147.5, 145, 270, 140, 270]
maximum_speed = [400, 400, 430, 540, 475, 760]
"#;

#[test]
fn every_shipped_file_is_an_arm_with_its_name() {
    assert!(Arm::names().count() >= 38);
    for name in Arm::names() {
        assert_eq!(arm(name).name(), name);
    }
    assert_eq!((arm(DEFAULT_SIX_AXIS).axes(), arm(DEFAULT_SCARA).axes()), (6, 4));
}

#[test]
fn an_arm_has_several_spellings() {
    for name in ["TX2-60L", "tx2_60l", "tx2-60l", "tx2_60l-S1", "TX2touch-60L", " Tx2-60L "] {
        assert_eq!(arm(name).name(), "TX2-60L", "{name}");
    }
    assert_eq!(Arm::by_settings("ts60-S1", Some("L200")).unwrap().name(), "TS60");
    assert_eq!(Arm::by_settings("ts60-S1", Some("L400")).unwrap().limits()[2].max, 400.0);
    assert_eq!(Arm::by_settings("ts2_60-S1", Some("L200")).unwrap().name(), "TS2-60");
    assert_eq!(Arm::by_settings("rs60-S1-D20-L200", None).unwrap().name(), "TS60");
    assert_eq!(Arm::by_settings("ts60-S1-D25-L200", None).unwrap().name(), "TS60");
    assert_eq!(Arm::by_settings("ts60-S1-D25-L400", None).unwrap().limits()[2].max, 400.0);
    assert_eq!(Arm::by_settings("ts60-S1-D25-L200", Some("L400")).unwrap().name(), "TS60-L400");
    assert_eq!(Arm::by_settings("tx2_40-S3", None).unwrap().name(), "TX2-40");
    assert_eq!(Arm::by_settings("tx2_40-S3", Some("INVALID")).unwrap().name(), "TX2-40");
}

#[test]
fn a_length_that_no_arm_has_is_unknown() {
    for name in ["TS60-L40", "ts2_40-L400", "TX2-60-L200"] {
        assert_eq!(Arm::by_name(name).unwrap_err().name, name);
    }
    assert_eq!(Arm::by_settings("ts60-S1", Some("L300")).unwrap_err().name, "ts60-L300");
}

#[test]
fn an_unknown_name_lists_the_known_ones() {
    let message = Arm::by_name("TX2-61").unwrap_err().to_string();
    assert!(message.starts_with("no arm has the name `TX2-61`; known arms: RX130B, "), "{message}");
}

#[test]
fn missing_values_follow_from_others() {
    let arm = Arm::from_toml(FILE).unwrap();
    assert_eq!((arm.name(), arm.axes(), arm.height()), ("mine", 6, 0.0));
    assert_eq!(
        (arm.nominal_speed(0), arm.nominal_acceleration(0), arm.nominal_deceleration(0)),
        (264.0, 1320.0, 1320.0)
    );
    assert_eq!(arm.nominal_speed(6), 0.0);
}

/// A complete file with measured times.
fn measured() -> String {
    let columns = "nominal_speed = [264, 264, 283, 356, 313, 501]\n\
                   acceleration = [1320, 1320, 1415, 1780, 1565, 2505]\n\
                   deceleration = [1320, 1320, 1415, 1780, 1565, 2505]\n";
    FILE.replace("kind =", "times = \"measured\"\nkind =") + columns
}

#[test]
fn times_are_those_of_a_model_unless_a_file_states_that_they_are_measured() {
    assert!(Arm::names().all(|name| !arm(name).has_measured_times()));
    assert!(!Arm::from_toml(FILE).unwrap().has_measured_times());
    assert!(Arm::from_toml(&measured()).unwrap().has_measured_times());
    assert!(!Arm::from_toml(&measured().replace("\"measured\"", "\"model\"")).unwrap().has_measured_times());
}

#[test]
fn measured_times_are_complete_and_no_choice_of_the_model() {
    let error = |text: &str| Arm::from_toml(text).unwrap_err().to_string();
    let messages = [
        error(&measured().replace("\nacceleration = [1320, 1320, 1415, 1780, 1565, 2505]", "")),
        error(&format!("model = [\"deceleration\"]\n{}", measured())),
        error(&measured().replace("\"measured\"", "\"guessed\"")),
    ];
    insta::assert_snapshot!(messages.join("\n"));
}

#[test]
fn nonsense_is_an_error_with_its_line() {
    let changes = [
        ("a1 = 50", "a1 = -50"),
        ("c2 = 425", "c2 = 0"),
        ("c2 = 425", "c2 = nan"),
        ("c2 = 425", "c2 = \"long\""),
        ("c2 = 425\n", ""),
        ("c2 = 425", "c2 = 425\nl1 = 100"),
        ("c2 = 425", "c2 = 425\nc5 = 100"),
        ("min = [-180", "min = [180"),
        ("max = [180, ", "max = ["),
        ("max = [180", "max = [inf"),
        ("maximum_speed = [400, 400", "maximum_speed = [400, 0"),
        ("maximum_speed = [400", "nominal_speed = [500, 1, 1, 1, 1, 1]\nmaximum_speed = [400"),
        ("max = [180, 147.5, 145, 270, 140, 270]\n", ""),
        ("name = \"mine\"", "name = \" \""),
        ("name = \"mine\"", "name = mine"),
        ("six-axis", "delta"),
        ("name = \"mine\"", "name = \"mine\"\nmodel = [\"speed\"]"),
        ("[axes]", "[payload]\nmaximum = -1\n[axes]"),
    ];
    let messages = changes.map(|(from, to)| {
        let error = Arm::from_toml(&FILE.replacen(from, to, 1)).unwrap_err();
        format!("{to:?}\n    {error}\n")
    });
    insta::assert_snapshot!(messages.concat());
}

#[test]
fn a_unit_may_have_narrower_limits() {
    let narrow = arm("RX160").with_limits(&[-99999.0, -90.0], &[99999.0, 200.0]).unwrap();
    assert_eq!((narrow.limits()[0].min, narrow.limits()[0].max), (-160.0, 160.0));
    assert_eq!((narrow.limits()[1].min, narrow.limits()[1].max), (-90.0, 137.5));
    assert_eq!(arm("RX160").with_limits(&[170.0], &[]).unwrap_err().axis, 1);
}

#[test]
fn a_turn_shift_brings_the_last_axis_to_the_reference() {
    for (name, axis, position, reference, shift) in
        [("TX2-90", 5, 720.0, 0.0, -720.0), ("TX2-90", 5, 100.0, -100.0, -360.0), ("TS2-60", 3, -400.0, 10.0, 360.0)]
    {
        let (mut joints, mut near) = ([0.0; 6], [0.0; 6]);
        (joints[axis], near[axis]) = (position, reference);
        assert_eq!(arm(name).turn_shift(&joints, &near), shift, "{name} at {position}");
    }
}
